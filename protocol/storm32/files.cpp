// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/storm32/files.h"

#include "protocol/base/filefault.h"
#include "protocol/base/hexbytes.h"
#include "protocol/storm32/parametertables.h"

#include <QMap>
#include <QRegularExpression>

#include <algorithm>

using namespace Qt::StringLiterals;

namespace storm32 {

namespace {

constexpr std::array<int, 3> kLayouts{95, 89, 78};  // the newest of two that fit equally well
constexpr qsizetype kLargestText = 256 * 1024;
constexpr qsizetype kMaxShown = 40;  // characters of what is not understood

struct Entry
{
    int raw = 0;
    QString shown;
    int line = 0;
};

struct Entries
{
    QMap<QString, Entry> values;
    QByteArray scripts;
};

std::shared_ptr<const ParameterSet> parametersOfLayout(int layout)
{
    return std::make_shared<ParameterSet>(parameterRows(), blocksOf(layout), layout, Capabilities());
}

BoardIdentity identityOf(int layout)
{
    BoardIdentity identity;
    identity.family = u"storm32"_s;
    identity.model = u"STorM32"_s;
    identity.firmware = u"layout %1"_s.arg(layout);
    identity.firmwareNumber = layout;
    return identity;
}

// Names under which earlier versions of this program saved settings of layout 89.
constexpr std::pair<const char *, const char *> kFormerNames[] = {{"Yaw Pan LPF", "Yaw Pan Deadband LPF"}};

// The entry of a parameter, under its name or a former one.
QMap<QString, Entry>::const_iterator find(const QMap<QString, Entry> &values, const QString &name)
{
    auto it = values.constFind(name);
    for (const auto &[now, former] : kFormerNames) {
        if (it == values.cend() && name == QLatin1String(now))
            it = values.constFind(QLatin1String(former));
    }
    return it;
}

Result<Entries> parse(const QByteArray &text)
{
    static const QRegularExpression kHead(u"^\\s*%\\w+\\s*=\\s*\\(\\s*$"_s);
    static const QRegularExpression kValue(
        u"^\\s*'([^']*)'\\s*=>\\s*\\[\\s*(-?\\d+)\\s*,\\s*'([^']*)'\\s*,?\\s*\\]\\s*,?\\s*$"_s);
    static const QRegularExpression kText(
        u"^\\s*'([^']*)'\\s*=>\\s*\\[\\s*'([^']*)'\\s*,?\\s*\\]\\s*,?\\s*$"_s);
    static const QRegularExpression kEntryName(u"^'([^']*)'\\s*=>"_s);
    static const QRegularExpression kEnd(u"^\\s*\\)\\s*;\\s*$"_s);
    if (text.size() > kLargestText)
        return fileFailure({.problem = FileProblem::TooLarge, .kind = FileKind::Settings});
    Entries entries;
    QMap<QString, int> lineOf;
    bool open = false;
    int number = 0;
    const QStringList lines = QString::fromLatin1(text).split(u'\n');
    const auto wrong
        = [&](FileProblem problem, const QString &key, const QString &value, const QString &expected) {
              // A last line without its end was still being written.
              const bool isCutOff = open && number == lines.size();
              return fileFailure({.problem = isCutOff ? FileProblem::Truncated : problem,
                                  .kind = FileKind::Settings,
                                  .line = number,
                                  .key = isCutOff ? QString() : key,
                                  .value = isCutOff ? QString() : value.left(kMaxShown),
                                  .expected = isCutOff ? QString() : expected});
          };
    for (const QString &line : lines) {
        ++number;
        const QString content = line.trimmed();
        if (content.isEmpty() || content.startsWith(u'#'))
            continue;
        if (!open) {
            if (!kHead.match(content).hasMatch())
                return wrong(FileProblem::OtherKind, {}, content, {});
            open = true;
            continue;
        }
        if (kEnd.match(content).hasMatch())
            return entries;
        if (const auto named = kEntryName.match(content); named.hasMatch()) {
            const QString name = named.captured(1).trimmed();
            if (const int first = lineOf.value(name); first > 0)
                return wrong(FileProblem::Doubled, name, {}, QString::number(first));
            lineOf.insert(name, number);
        }
        if (const auto value = kValue.match(content); value.hasMatch()) {
            const QString name = value.captured(1).trimmed();
            const int raw = value.captured(2).toInt();
            if (raw < -32768 || raw > 65535)
                return wrong(FileProblem::OutOfRange, name, value.captured(2), u"-32768 to 65535"_s);
            entries.values.insert(name, {raw, value.captured(3).trimmed(), number});
            continue;
        }
        const auto named = kText.match(content);
        if (!named.hasMatch())
            return wrong(FileProblem::BadValue, {}, content, u"'NAME' => [ NUMBER , 'TEXT' ],"_s);
        if (named.captured(1) != u"Scripts"_s) {
            entries.values.insert(named.captured(1).trimmed(),
                                  {-1, named.captured(2), number});  // a text that belongs to no parameter
            continue;
        }
        const auto bytes = bytesFromHex(named.captured(2));
        if (!bytes || bytes->size() > kScriptArea)
            return wrong(FileProblem::BadValue, u"Scripts"_s, named.captured(2),
                         u"%1 B (hex)"_s.arg(kScriptArea));
        entries.scripts = bytes->leftJustified(kScriptArea, char(0xFF));
    }
    if (!open)
        return fileFailure({.problem = FileProblem::Empty, .kind = FileKind::Settings});
    return fileFailure({.problem = FileProblem::Truncated,
                        .kind = FileKind::Settings,
                        .line = lineOfByte(text.trimmed(), text.size()),
                        .said = u"the end ');' is missing"_s});
}

// The number that a choice's text stands for in this layout; the file's own number if the text is not known.
int believed(const ParameterSpec &spec, const Entry &entry, int layout)
{
    if (spec.row->kind != ValueKind::Choice)
        return spec.row->wire == WireType::I16 ? int(std::int16_t(entry.raw)) : entry.raw & 0xFFFF;
    for (const Choice &choice : spec.choices(layout)) {
        if (entry.shown.compare(QString::fromUtf8(choice.name), Qt::CaseInsensitive) == 0)
            return choice.value;
    }
    return entry.raw;
}

// How well a layout fits: two points for each name it knows, one less for each name that is missing, out of
// range, or whose number and text do not match. Empty: it knows no name.
std::optional<int> fit(const Entries &entries, const ParameterSet &set)
{
    int points = 0;
    bool any = false;
    for (const ParameterSpec &spec : set.all()) {
        const auto it = find(entries.values, originalName(spec));
        if (it == entries.values.cend()) {
            --points;
            continue;
        }
        any = true;
        points += 2;
        if (!spec.isInRange(spec.row->wire == WireType::I16 ? int(std::int16_t(it->raw)) : it->raw))
            --points;
        if (spec.row->kind != ValueKind::Choice || it->shown.isEmpty())
            continue;
        const auto choices = spec.choices(set.firmware());
        const bool same = std::any_of(choices.begin(), choices.end(), [&](const Choice &choice) {
            return choice.value == it->raw
                && it->shown.compare(QString::fromUtf8(choice.name), Qt::CaseInsensitive) == 0;
        });
        if (!same)
            --points;
    }
    return any ? std::optional(points) : std::nullopt;
}

}  // namespace

Result<ForeignSettings> readSettings(const QByteArray &text)
{
    const auto entries = parse(text);
    if (!entries)
        return tl::unexpected(entries.error());
    std::shared_ptr<const ParameterSet> best;
    std::optional<int> points;
    for (const int layout : kLayouts) {
        const auto set = parametersOfLayout(layout);
        if (const auto here = fit(*entries, *set); here && (!points || *here > *points)) {
            points = here;
            best = set;
        }
    }
    if (!best)
        return fileFailure({.problem = FileProblem::OtherKind,
                            .kind = FileKind::Settings,
                            .said = u"no entry is a parameter of this family"_s});
    const int layout = best->firmware();
    ForeignSettings settings;
    settings.configuration = Configuration(identityOf(layout), best);
    QByteArray words(2 * wordsOf(layout), '\0');
    QMap<QString, Entry> left = entries->values;
    for (const ParameterSpec &spec : best->all()) {
        const QString name = originalName(spec);
        const auto it = find(entries->values, name);
        if (it == entries->values.cend())
            settings.missing.append(spec.key);
        const double raw = it == entries->values.cend() ? spec.defaultRaw : believed(spec, *it, layout);
        if (!spec.isInRange(raw))
            return fileFailure({.problem = FileProblem::OutOfRange,
                                .kind = FileKind::Settings,
                                .line = it->line,
                                .key = name,
                                .value = spec.format(raw),
                                .expected = spec.allowedText()});
        spec.write(words, raw);
        if (it != entries->values.cend())
            left.remove(it.key());
    }
    settings.unknown = left.keys();
    settings.configuration.setBlock({0, Parameters}, words);
    if (!entries->scripts.isEmpty())
        settings.configuration.setBlock({0, Scripts}, entries->scripts);
    else if (const BlockSpec *scripts = best->block(Scripts))
        settings.missing.append(QLatin1String(scripts->data));
    return settings;
}

Result<QByteArray> writeSettings(const Configuration &configuration)
{
    if (configuration.isEmpty() || !isKnownLayout(configuration.parameters().firmware()))
        return failure(ErrorCode::Unsupported, u"only parameters with names can be saved in this file"_s);
    QByteArray text = "%SettingsHash = (\n";
    for (const ParameterSpec &spec : configuration.parameters().all()) {
        const auto raw = configuration.raw(spec, 0);
        if (!raw)
            continue;
        QString shown = spec.format(*raw);
        for (const Choice &choice : spec.choices(configuration.parameters().firmware())) {
            if (spec.row->kind == ValueKind::Choice && choice.value == *raw)
                shown = QString::fromUtf8(choice.name);
        }
        if (spec.row->kind != ValueKind::Choice && *spec.row->unit)
            shown += u' ' + QString::fromUtf8(spec.row->unit);
        text += u"  '%1' => [ %2 , '%3' ],\n"_s.arg(originalName(spec))
                    .arg(int(*raw) & 0xFFFF)
                    .arg(shown)
                    .toLatin1();
    }
    if (const QByteArray scripts = configuration.block({0, Scripts}); !scripts.isEmpty())
        text += "  'Scripts' => [ '" + scripts.toHex().toUpper() + "' ],\n";
    return text + ");\n";
}

Result<SensorCalibration> readCalibration(const QByteArray &text)
{
    FileFault fault{.kind = FileKind::Calibration};
    const auto failed = [&fault](FileProblem problem) {
        fault.problem = problem;
        return fileFailure(fault);
    };
    if (text.size() > kLargestText)
        return failed(FileProblem::TooLarge);
    if (text.trimmed().isEmpty())
        return failed(FileProblem::Empty);
    struct Line
    {
        QString text;
        int number = 0;
    };
    QMap<QString, Line> lines;
    int count = 0;
    int records = 0;
    for (const QString &line : QString::fromLatin1(text).split(u'\n')) {
        ++count;
        const qsizetype colon = line.indexOf(u':');
        const QString key = line.left(colon).trimmed();
        if (key.startsWith(u"RECORD#"_s))
            ++records;
        if (colon <= 0 || records > 1)  // of several records, use the first
            continue;
        if (const auto first = lines.constFind(key); first != lines.cend()) {
            fault.key = key;
            fault.line = count;
            fault.expected = QString::number(first->number);
            return failed(FileProblem::Doubled);
        }
        lines.insert(key, {line.mid(colon + 1).trimmed(), count});
    }
    if (std::none_of(lines.keyBegin(), lines.keyEnd(),
                     [](const QString &key) { return key.startsWith(u"IMU"_s) || key.startsWith(u"AX"_s); }))
        return failed(FileProblem::OtherKind);
    SensorCalibration calibration;
    const auto number = [&](const QString &key, const QString &allowed) -> Result<int> {
        const Line line = lines.value(key);
        fault.key = key;
        fault.line = line.number;
        fault.value = line.text.left(kMaxShown);
        fault.expected = allowed;
        bool ok = false;
        const int value = line.text.toInt(&ok);
        if (!lines.contains(key)) {
            const bool isCutOff = !text.endsWith('\n');
            fault.expected.clear();
            fault.line = isCutOff ? count : 0;
            return failed(isCutOff ? FileProblem::Truncated : FileProblem::MissingEntry);
        }
        if (!ok)
            return failed(FileProblem::BadValue);
        if (value < -32768 || value > 32767)
            return failed(FileProblem::OutOfRange);
        return value;
    };
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const QChar letter = u"XYZ"[axis];
        const auto zero = number(u"A%1ZERO"_s.arg(letter), u"-32768 to 32767"_s);
        const auto scale = number(u"A%1SCALE"_s.arg(letter), u"-32768 to 32767, not 0"_s);
        for (const auto *value : {&zero, &scale}) {
            if (!*value)
                return tl::unexpected(value->error());
        }
        if (*scale == 0)
            return failed(FileProblem::OutOfRange);
        calibration.zero[axis] = *zero;
        calibration.scale[axis] = *scale;
    }
    calibration.method = lines.value(u"CALIBRATIONMETHOD"_s).text;
    calibration.temperature = lines.value(u"TEMPERATURE"_s).text.section(u' ', 0, 0).toDouble();
    return calibration;
}

QByteArray writeCalibration(const SensorCalibration &calibration)
{
    QString text = u"IMUNAME: Imu\nIMUTYPE: MPU6050\nIMUSETTINGS: 0\nRECORD#1: 1\n"_s;
    for (const auto &[values, name] :
         {std::pair{&calibration.zero, u"ZERO"_s}, {&calibration.scale, u"SCALE"_s}}) {
        for (std::size_t axis = 0; axis < 3; ++axis)
            text += u"A%1%2: %3\n"_s.arg(QChar(u"XYZ"[axis])).arg(name).arg((*values)[axis]);
    }
    text += u"CALIBRATIONMETHOD: %1\nTEMPERATURE: %2\nRAW:\n"_s.arg(calibration.method)
                .arg(calibration.temperature, 0, 'f', 2);
    return text.toLatin1();
}

}  // namespace storm32
