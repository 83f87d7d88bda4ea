// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/guide/setuprecord.h"

#include <QLocale>

using namespace Qt::StringLiterals;

namespace {

const char *stateWord(SetupResult::State state)
{
    using enum SetupResult::State;
    switch (state) {
    case Done: return "done";
    case Poor: return "to be done again";
    case Skipped: return "left out";
    case Failed: return "failed";
    case Open: break;
    }
    return "not done";
}

QString row(const QString &left, const QString &right)
{
    return u"<tr><td>%1</td><td align=\"right\">%2</td></tr>\n"_s.arg(left.toHtmlEscaped(),
                                                                      right.toHtmlEscaped());
}

QString stepHtml(const SetupStepSpec &spec, const SetupResult &result, const SetupWords &words,
                 const std::function<QString(const QString &)> &labelOf, const SetupValueWords &valueOf)
{
    QString html = u"<h2>%1: %2</h2>\n"_s.arg(words(spec.action.label),
                                              setupStateWord(result.state, words).toHtmlEscaped());
    if (result.at.isValid())
        html += u"<p class=\"when\">%1 UTC</p>\n"_s.arg(result.at.toUTC().toString(u"yyyy-MM-dd hh:mm"_s));
    for (const QString &key : result.remarks) {
        if (const SetupRemarkSpec *remark = findSetupRemark(key))
            html += u"<p>%1</p>\n"_s.arg(words(remark->text).toHtmlEscaped());
    }
    if (!result.why.isEmpty())
        html += u"<p>%1</p>\n"_s.arg(result.why.toHtmlEscaped());
    QString rows;
    for (const SetupFigure &figure : result.figures)
        rows += row(setupFigureLabel(figure, words), setupFigureText(figure));
    for (const SetupChange &change : result.changes)
        rows += row(labelOf(change.key), setupChangeText(change, valueOf));
    if (!rows.isEmpty())
        html += u"<table width=\"100%\">\n%1</table>\n"_s.arg(rows);
    return html;
}

}  // namespace

QString setupStateWord(SetupResult::State state, const SetupWords &words)
{
    return words(stateWord(state));
}

std::span<const char *const> setupCertificateWords()
{
    static constexpr std::array kWords{
        "Set-up of a gimbal",
        "Board",
        "Firmware",
        "Serial number",
        "done",
        "to be done again",
        "left out",
        "failed",
        "not done",
        "Figures are as they were measured; behind an arrow stands what was before. What is left out "
        "was neither measured nor set."};
    return kWords;
}

QString setupCertificate(const SetupRecord &record, const std::vector<SetupStep> &steps,
                         const SetupWords &words, const std::function<QString(const QString &key)> &labelOf,
                         const SetupValueWords &valueOf, const QString &note)
{
    const auto all = setupCertificateWords();
    const BoardIdentity &board = record.identity();
    QString html = u"<!DOCTYPE html>\n<html><head><meta charset=\"utf-8\"><title>%1</title>\n"
                   "<style>body { font-family: sans-serif; max-width: 44em; } td { padding: 2px 8px 2px 0; } "
                   "h2 { margin-bottom: 0; } .when { color: #666; margin-top: 0; }</style></head>\n<body>\n"
                   "<h1>%1</h1>\n<table>\n"_s.arg(words(all[0]));
    html += row(words(all[1]), board.model) + row(words(all[2]), board.firmware)
        + row(words(all[3]), board.serial) + u"</table>\n"_s;
    if (!note.isEmpty())
        html += u"<p><b>%1</b></p>\n"_s.arg(note.toHtmlEscaped());
    for (const SetupStep step : steps)
        html += stepHtml(setupStep(step), record.result(step), words, labelOf, valueOf);
    return html + u"<p>%1</p>\n</body></html>\n"_s.arg(words(all.back()).toHtmlEscaped());
}
