// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/html_page.h"

#include "report/fonts.h"

#include <QRegularExpression>

#include <algorithm>
#include <cmath>

namespace report {
namespace {
const char* const css = R"(
body { font-family: "ServoDesk Text", "ServoDesk Signs", "Noto Sans", "Noto Sans CJK SC",
  "Segoe UI", "Microsoft YaHei", sans-serif; font-size: 14px; color: #1f2328;
  background: #ffffff; margin: 24px auto; max-width: 1100px; padding: 0 16px; }
h1 { font-size: 24px; margin: 8px 0; }
h2 { font-size: 19px; margin: 28px 0 8px; border-bottom: 1px solid #d0d7de; }
h3 { font-size: 15px; margin: 18px 0 6px; }
table { border-collapse: collapse; margin: 6px 0 12px; width: auto; }
th, td { border: 1px solid #d0d7de; padding: 3px 8px; text-align: left; vertical-align: top; }
th { background: #f3f5f7; font-weight: 600; }
td.n { text-align: right; font-variant-numeric: tabular-nums; }
.verdict { font-weight: 700; white-space: nowrap; }
.pass { color: #1a7f37; } .warn { color: #8a5a00; } .fail { color: #b3261e; } .none { color: #57606a; }
.overall { font-size: 24px; border: 1px solid; border-left-width: 8px; border-radius: 6px;
  padding: 8px 16px; margin: 8px 0; }
.simulated { display: inline-block; border: 2px dashed #8a5a00; color: #8a5a00; font-weight: 700;
  padding: 4px 12px; margin: 8px 0; }
.user { white-space: pre-wrap; overflow-wrap: anywhere; }
.wide { overflow-x: auto; }
.pair { display: flex; flex-wrap: wrap; column-gap: 24px; }
.pair > div { flex: 1 1 360px; }
svg { max-width: 100%; height: auto; }
summary { cursor: pointer; font-weight: 600; }
@media screen and (prefers-color-scheme: dark) {
  body { color: #e6e8ec; background: #202329; }
  h2 { border-color: #4b515c; }
  th, td { border-color: #4b515c; }
  th { background: #2f333b; }
  .pass { color: #57c278; } .warn { color: #f0b04c; } .fail { color: #ff8a80; }
  .none { color: #a3abb8; }
  .simulated { color: #f0b04c; border-color: #f0b04c; }
  svg { border-radius: 6px; }
}
@media print {
  body { margin: 0; max-width: none; font-size: 11px; }
  .switch { display: none; }
  h2, h3 { break-after: avoid; }
  tr, svg { break-inside: avoid; }
  .wide { overflow: visible; }
  th { print-color-adjust: exact; -webkit-print-color-adjust: exact; }
}
)";

const char* const switchCss = R"(
#lang-en:checked ~ main .zh, #lang-zh:checked ~ main .en { display: none; }
)";

// QTextDocument takes CSS pixels for pixels of the printer, so paper is measured in points.
const char* const paperCss = R"(
body { font-size: 8pt; color: #1f2328; }
h1 { font-size: 16pt; }
h2 { font-size: 12pt; }
h3 { font-size: 9pt; }
td, th { font-size: 7pt; padding-left: 3px; padding-right: 3px; }
td span { font-size: 7pt; }
.many td, .many th, .many span { font-size: 6pt; }
th { background-color: #f3f5f7; }
.verdict { font-weight: 700; }
.pass { color: #1a7f37; }
.warn { color: #8a5a00; }
.fail { color: #b3261e; }
.none { color: #57606a; }
.overall { font-size: 14pt; }
.simulated { color: #8a5a00; font-weight: 700; font-size: 10pt; }
.user { white-space: pre-wrap; }
)";

/// A browser goes by the style sheet instead.
const char* const paperTable = "width=\"100%\" border=\"1\" cellspacing=\"0\" cellpadding=\"1\" "
                               "style=\"border-collapse: collapse; border-color: #d0d7de\"";

/// Or a limit, or the dash in place of one. Also if a span of one language comes first.
bool isNumber(const QString& cell)
{
    static const QRegularExpression number(QStringLiteral("^(<[^>]*>)*(-?\\d|–$|&[lg]t; \\d)"));
    return number.match(cell).hasMatch();
}

QString withoutZeros(double value, int decimals)
{
    QString text = QString::number(value, 'f', decimals);
    if (decimals > 0) {
        while (text.endsWith(u'0'))
            text.chop(1);
        if (text.endsWith(u'.'))
            text.chop(1);
    }
    return text == QStringLiteral("-0") ? QStringLiteral("0") : text;
}

QString radio(const char* language, const char* name, bool checked)
{
    return QStringLiteral("<input class=\"switch\" type=\"radio\" name=\"lang\" id=\"lang-%1\"%3/> "
                          "<label class=\"switch\" for=\"lang-%1\" lang=\"%1\">%2</label>\n")
        .arg(QString::fromLatin1(language), QString::fromUtf8(name),
             checked ? QStringLiteral(" checked=\"checked\"") : QString());
}
} // namespace

QString escaped(const QString& text)
{
    QString clean;
    clean.reserve(text.size());
    for (qsizetype i = 0; i < text.size(); ++i) {
        const QChar one = text[i];
        const bool pair =
            one.isHighSurrogate() && i + 1 < text.size() && text[i + 1].isLowSurrogate();
        if (pair) {
            clean += one;
            clean += text[++i];
            continue;
        }
        const char16_t code = one.unicode();
        const bool allowed =
            (code >= 0x20 && code < 0xfffe && !one.isSurrogate()) || code == u'\n' || code == u'\t';
        if (allowed)
            clean += one;
    }
    return clean.toHtmlEscaped();
}

QString userText(const QString& text)
{
    return QStringLiteral("<span class=\"user\">") + escaped(text) + QStringLiteral("</span>");
}

QString figure(double value)
{
    const double size = std::abs(value);
    return withoutZeros(value, size >= 999.5 ? 0 : size >= 9.995 ? 1 : 2);
}

QString figure(double value, std::initializer_list<std::optional<double>> limits)
{
    const double shown = figure(value).toDouble();
    const bool misleads = std::any_of(limits.begin(), limits.end(), [&](const auto& limit) {
        return limit &&
               ((shown > *limit) != (value > *limit) || (shown < *limit) != (value < *limit));
    });
    return misleads ? exactNumber(value) : figure(value);
}

QString exactNumber(double value)
{
    return withoutZeros(value, 3);
}

QString localTime(const QDateTime& at)
{
    const QDateTime local = at.toLocalTime();
    QString text = local.toString(QStringLiteral("yyyy-MM-dd HH:mm:ss")) + QStringLiteral(" UTC");
    const int minutes = local.offsetFromUtc() / 60;
    if (minutes != 0)
        text += (minutes < 0 ? QStringLiteral("-") : QStringLiteral("+")) +
                QTime(0, 0).addSecs(std::abs(minutes) * 60).toString(QStringLiteral("HH:mm"));
    return text;
}

QString HtmlWriter::span(const char* element, const catalog::Text& text) const
{
    if (m_language != ReportLanguage::Both || text.en == text.zh)
        return escaped(text.in(m_language == ReportLanguage::Chinese));
    return QStringLiteral(
               "<%1 class=\"en\" lang=\"en\">%2</%1><%1 class=\"zh\" lang=\"zh\">%3</%1>")
        .arg(QString::fromLatin1(element), escaped(text.en), escaped(text.zh));
}

QString HtmlWriter::htmlText(const catalog::Text& text) const
{
    return span("span", text);
}

QString HtmlWriter::htmlInSvg(const catalog::Text& text) const
{
    return span("tspan", text);
}

QString HtmlWriter::attributeText(const catalog::Text& text) const
{
    if (m_language == ReportLanguage::Both)
        return escaped(text.en + QStringLiteral(" / ") + text.zh);
    return escaped(text.in(m_language == ReportLanguage::Chinese));
}

QString HtmlWriter::heading(int level, const catalog::Text& text) const
{
    return QStringLiteral("<h%1>%2</h%1>\n").arg(level).arg(htmlText(text));
}

QString HtmlWriter::paragraph(const catalog::Text& text) const
{
    return QStringLiteral("<p>") + htmlText(text) + QStringLiteral("</p>\n");
}

QString HtmlWriter::optional(std::optional<double> value, const catalog::Text& otherwise) const
{
    return value && std::isfinite(*value) ? figure(*value) : htmlText(otherwise);
}

QString table(const QStringList& headings, const std::vector<QStringList>& rows, bool isWide)
{
    QString text =
        QStringLiteral("<div class=\"wide\"><table%1 %2>\n<thead><tr>")
            .arg(isWide ? QStringLiteral(" class=\"many\"") : QString(), QLatin1String(paperTable));
    for (const QString& heading : headings)
        text += QStringLiteral("<th>") + heading + QStringLiteral("</th>");
    text += QStringLiteral("</tr></thead>\n<tbody>\n");
    for (const QStringList& row : rows) {
        text += QStringLiteral("<tr>");
        for (const QString& cell : row) {
            text += isNumber(cell) ? QStringLiteral("<td class=\"n\" align=\"right\">")
                                   : QStringLiteral("<td>");
            text += cell + QStringLiteral("</td>");
        }
        text += QStringLiteral("</tr>\n");
    }
    return text + QStringLiteral("</tbody></table></div>\n");
}

QString sideBySide(const HtmlWriter& htmlWriter, const QString& left, const QString& right)
{
    if (htmlWriter.language() == ReportLanguage::Both)
        return QStringLiteral("<div class=\"pair\"><div>") + left +
               QStringLiteral("</div>\n<div>") + right + QStringLiteral("</div></div>\n");
    return QStringLiteral("<table width=\"100%\"><tr><td width=\"50%\">") + left +
           QStringLiteral("</td><td width=\"50%\">") + right +
           QStringLiteral("</td></tr></table>\n");
}

QString keyValueTable(const std::vector<QStringList>& rows)
{
    QString text = QStringLiteral("<table %1><tbody>\n").arg(QLatin1String(paperTable));
    for (const QStringList& row : rows)
        text += QStringLiteral("<tr><th align=\"left\">") + row.value(0) +
                QStringLiteral("</th><td>") + row.value(1) + QStringLiteral("</td></tr>\n");
    return text + QStringLiteral("</tbody></table>\n");
}

QString page(const HtmlWriter& htmlWriter, const catalog::Text& title, const QString& body,
             bool chinese)
{
    const bool both = htmlWriter.language() == ReportLanguage::Both;
    QString text = QStringLiteral(
        "<!DOCTYPE html>\n<html xmlns=\"http://www.w3.org/1999/xhtml\" lang=\"%1\">\n<head>\n"
        "<meta charset=\"utf-8\"/>\n"
        "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; "
        "style-src 'unsafe-inline'; img-src data:; font-src data:\"/>\n"
        "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"/>\n"
        "<link rel=\"icon\" href=\"data:,\"/>\n");
    text = text.arg(chinese ? QStringLiteral("zh") : QStringLiteral("en"));
    text += QStringLiteral("<title>") + escaped(title.in(chinese)) + QStringLiteral("</title>\n") +
            QStringLiteral("<style>") +
            (both ? embeddedFonts() + QString::fromUtf8(css) + QString::fromUtf8(switchCss)
                  : QString::fromUtf8(paperCss)) +
            QStringLiteral("</style>\n</head>\n<body>\n");
    if (both)
        text += radio("en", "English", !chinese) + radio("zh", "中文", chinese);
    return text + QStringLiteral("<main>\n") + body + QStringLiteral("</main>\n</body>\n</html>\n");
}
} // namespace report
