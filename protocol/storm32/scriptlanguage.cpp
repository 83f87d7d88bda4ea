// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/storm32/scriptlanguage.h"

#include "protocol/storm32/parametertables.h"

#include <algorithm>

using namespace Qt::StringLiterals;

namespace storm32 {

namespace {

// A file only tells the layout; the firmware's number is assumed to be close to it.
ScriptContext contextOf(const Configuration &configuration)
{
    const int layout = configuration.parameters().firmware();
    const int firmware = configuration.identity().extra.value(u"firmware"_s, layout).toInt();
    return scriptContext(configuration.parameters(), firmware);
}

class Language final : public ScriptLanguage
{
public:
    [[nodiscard]] int block() const override { return Scripts; }
    [[nodiscard]] int count() const override { return kScriptCount; }
    [[nodiscard]] QString inputKey(int script) const override { return u"script%1.input"_s.arg(script + 1); }
    [[nodiscard]] QString suffix() const override { return u"scr"_s; }

    [[nodiscard]] QString text(const Configuration &configuration, int script) const override
    {
        return scriptText(areaOf(configuration), script, contextOf(configuration));
    }

    [[nodiscard]] std::vector<Line> listing(const Configuration &configuration, int script) const override
    {
        std::vector<Line> lines;
        for (const ScriptLine &line : disassemble(areaOf(configuration), script, contextOf(configuration)))
            lines.push_back({line.offset, line.text});
        return lines;
    }

    [[nodiscard]] std::pair<int, int> used(const Configuration &configuration) const override
    {
        int bytes = 0;
        for (int script = 0; script < kScriptCount; ++script) {
            const auto lines = disassemble(areaOf(configuration), script, contextOf(configuration));
            bytes += lines.empty() ? 0 : lines.back().offset + lines.back().size + 1;  // including its end
        }
        return {bytes, kScriptArea - kScriptCount};
    }

    [[nodiscard]] CompiledScripts compile(const Configuration &configuration,
                                          const QStringList &texts) const override
    {
        std::array<QString, kScriptCount> all;
        std::copy_n(texts.begin(), std::min<qsizetype>(texts.size(), kScriptCount), all.begin());
        std::array<bool, kScriptCount> held{};
        for (int script = 0; script < kScriptCount; ++script)
            held[std::size_t(script)] = all[std::size_t(script)] == text(configuration, script);
        return compileScripts(all, contextOf(configuration), held);
    }

    [[nodiscard]] QStringList words(const Configuration &configuration) const override
    {
        const ScriptContext context = contextOf(configuration);
        QStringList words = scriptWords(context.firmware);
        for (const ScriptParameter &parameter : context.parameters)
            words.append(u'"' + parameter.name + u'"');
        return words;
    }

private:
    static QByteArray areaOf(const Configuration &configuration) { return configuration.block({0, Scripts}); }
};

}  // namespace

std::shared_ptr<const ScriptLanguage> scriptLanguage()
{
    return std::make_shared<Language>();
}

}  // namespace storm32
