// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/base/responsecsv.h"

#include "protocol/base/filefault.h"

#include <algorithm>
#include <cmath>

using namespace Qt::StringLiterals;

namespace {

constexpr std::size_t kMax = 10'000'000;

std::optional<float> number(QByteArrayView text)
{
    bool ok = false;
    const float value = text.trimmed().toFloat(&ok);
    return ok && std::isfinite(value) ? std::optional(value) : std::nullopt;
}

}  // namespace

Result<void> writeResponseCsv(QIODevice &file, std::span<const float> in, std::span<const float> out,
                              double rate)
{
    QByteArray text = "# " + QByteArray::number(rate, 'g', 10) + " samples/s\nin;out\n";
    for (std::size_t i = 0; i < std::min(in.size(), out.size()); ++i)
        text += QByteArray::number(double(in[i]), 'g', 8) + ';' + QByteArray::number(double(out[i]), 'g', 8)
            + '\n';
    if (file.write(text) != text.size())
        return tl::unexpected(systemError(file, FileKind::Measurement, true));
    return {};
}

Result<ResponseSamples> readResponseCsv(const QByteArray &text, double assumedRate)
{
    ResponseSamples samples;
    samples.rate = assumedRate;
    samples.rateAssumed = true;
    qsizetype begin = 0;
    for (int line = 1; begin < text.size(); ++line) {
        const qsizetype found = text.indexOf('\n', begin);
        const qsizetype end = found < 0 ? text.size() : found;
        const QByteArrayView row = QByteArrayView(text).sliced(begin, end - begin).trimmed();
        begin = end + 1;
        if (row.isEmpty())
            continue;
        if (row.front() == '#') {
            const QByteArrayView words = row.sliced(1).trimmed();
            const qsizetype blank = words.indexOf(' ');
            const auto rate = number(blank < 0 ? words : words.first(blank));
            if (rate && *rate >= 1.0F && *rate <= 1e6F) {
                samples.rate = double(*rate);
                samples.rateAssumed = false;
            }
            continue;
        }
        qsizetype cut = -1;
        for (const char separator : {';', '\t', ','}) {
            if (cut < 0)
                cut = row.indexOf(separator);
        }
        const auto in = cut < 0 ? std::nullopt : number(row.first(cut));
        const auto out = cut < 0 ? std::nullopt : number(row.sliced(cut + 1));
        if (!in || !out) {
            if (samples.in.empty() && line <= 3)
                continue;  // a heading
            // A last line without its end was still being written.
            const bool isCutOff = found < 0 && !samples.in.empty();
            return fileFailure({.problem = isCutOff ? FileProblem::Truncated : FileProblem::BadValue,
                                .kind = FileKind::Measurement,
                                .line = line,
                                .value = QString::fromUtf8(row.first(std::min<qsizetype>(40, row.size()))),
                                .expected = u"NUMBER;NUMBER"_s});
        }
        if (samples.in.size() == kMax)
            return fileFailure({.problem = FileProblem::TooLarge,
                                .kind = FileKind::Measurement,
                                .said = u"more than %1 lines"_s.arg(kMax)});
        samples.in.push_back(*in);
        samples.out.push_back(*out);
    }
    if (samples.in.empty())
        return fileFailure({.problem = text.trimmed().isEmpty() ? FileProblem::Empty : FileProblem::OtherKind,
                            .kind = FileKind::Measurement,
                            .said = u"no line with two numbers, in;out"_s});
    if (!(samples.rate > 0))
        return fileFailure(
            {.problem = FileProblem::MissingEntry,
             .kind = FileKind::Measurement,
             .key = u"# samples/s"_s,
             .said = u"the file does not state its rate; begin it with a line such as '# 1000 samples/s'"_s});
    return samples;
}
