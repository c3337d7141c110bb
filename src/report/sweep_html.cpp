// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/sweep_html.h"

#include "files/text_file.h"
#include "report/sweep_text.h"

namespace report {
QByteArray sweepHtml(const results::SweepRun& run, const std::vector<SweepSeries>& series,
                     bool chinese)
{
    const HtmlWriter htmlWriter(ReportLanguage::Both);
    const QString body = sweepBody(htmlWriter, run, series, [](const QString& svg) { return svg; });
    return page(htmlWriter, sweepTexts().title, body, chinese).toUtf8();
}

base::Result<void> saveSweepHtml(const results::SweepRun& run,
                                 const std::vector<SweepSeries>& series, bool chinese,
                                 const QString& path)
{
    return files::saveTextFile(QStringLiteral("save-report"), sweepHtml(run, series, chinese),
                               path);
}
} // namespace report
