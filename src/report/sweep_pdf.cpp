// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/sweep_pdf.h"

#include "files/text_file.h"
#include "report/paper.h"
#include "report/sweep_text.h"

namespace report {
namespace {
/// So many fit below the histogram on one page.
constexpr std::size_t maxLegs = 36;
/// So few fit on the first page of a servo, and their distribution says nothing.
constexpr std::size_t fewLegs = 8;

/// Two pages at most.
QStringList servoSections(const HtmlWriter& htmlWriter, const results::SweepRun& run,
                          const results::SweepServo& servo, const std::vector<SweepSeries>& series,
                          const EmbedChart& place)
{
    const QString first =
        servoFigures(htmlWriter, run, servo) + positionPart(htmlWriter, servo, series, place);
    const QString legs = worstLegsPart(htmlWriter, servo, maxLegs);
    if (servo.legs.size() <= fewLegs)
        return {first + legs};
    return {first, errorsPart(htmlWriter, servo, place) + legs};
}
} // namespace

QByteArray sweepPdf(const results::SweepRun& run, const std::vector<SweepSeries>& series,
                    bool chinese)
{
    const HtmlWriter htmlWriter(chinese ? ReportLanguage::Chinese : ReportLanguage::English);
    const SweepTexts& words = sweepTexts();
    PaperCharts charts;
    const auto place = [&](const QString& svg) { return charts.add(svg); };
    QStringList sections{
        verdictPart(htmlWriter, run) +
        sideBySide(htmlWriter, testPart(htmlWriter, run), benchPart(htmlWriter, run)) +
        busPart(htmlWriter, run) + htmlWriter.paragraph(words.gradingNote) +
        htmlWriter.paragraph(words.hysteresisNote) + htmlWriter.paragraph(words.paperNote)};
    for (const results::SweepServo& servo : run.servos)
        sections << servoSections(htmlWriter, run, servo, series, place);
    for (QString& section : sections)
        section = page(htmlWriter, words.title, section, chinese);
    return paperPdf(sections, charts, {words.title.in(chinese), run.program, localTime(run.at)});
}

base::Result<void> saveSweepPdf(const results::SweepRun& run,
                                const std::vector<SweepSeries>& series, bool chinese,
                                const QString& path)
{
    return files::saveTextFile(QStringLiteral("save-report"), sweepPdf(run, series, chinese), path);
}
} // namespace report
