// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/report_file.h"

#include "files/text_file.h"
#include "report/paper.h"

#include <QFileInfo>

namespace report {
namespace {
QByteArray html(const ReportHead& head, const ReportBody& body, bool chinese)
{
    const HtmlWriter htmlWriter(ReportLanguage::Both);
    const auto asItIs = [](const QString& svg) { return svg; };
    return page(htmlWriter, head.title, body(htmlWriter, asItIs), chinese).toUtf8();
}

QByteArray pdf(const ReportHead& head, const ReportBody& body, bool chinese)
{
    const HtmlWriter htmlWriter(chinese ? ReportLanguage::Chinese : ReportLanguage::English);
    PaperCharts charts;
    const auto place = [&charts](const QString& svg) { return charts.add(svg); };
    const QString section = page(htmlWriter, head.title, body(htmlWriter, place), chinese);
    return paperPdf({section}, charts, {head.title.in(chinese), head.program, localTime(head.at)});
}
} // namespace

QString endingOf(const QString& path)
{
    return QFileInfo(path).suffix().toLower();
}

bool isReportPath(const QString& path)
{
    return endingOf(path) == QLatin1String("html") || endingOf(path) == QLatin1String("pdf");
}

base::Result<void> saveReport(const ReportHead& head, const ReportBody& body, bool chinese,
                              const QString& path)
{
    return files::saveTextFile(QStringLiteral("save-report"),
                               endingOf(path) == QLatin1String("pdf") ? pdf(head, body, chinese)
                                                                      : html(head, body, chinese),
                               path);
}
} // namespace report
