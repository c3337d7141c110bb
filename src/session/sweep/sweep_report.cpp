// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/sweep/sweep_report.h"

#include "report/sweep_html.h"
#include "report/sweep_pdf.h"
#include "results/sweep_csv.h"
#include "results/sweep_json.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>

#include <limits>

namespace session {
namespace {
constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
constexpr int chartColumns = 1000; ///< two readings in each: its lowest and its highest

double secondsOf(base::Duration span)
{
    return std::chrono::duration<double>(span).count();
}

report::SweepSeries seriesOf(const results::SweepRun& run, const jobs::SweepRecording& readings,
                             std::size_t servo)
{
    report::SweepSeries series{run.servos[servo].parameters.servo.id};
    const recording::SampleStore& store = readings.store();
    const auto span = store.span(readings.positions(servo));
    if (!span)
        return series;
    std::vector<recording::SampleColumn> columns;
    store.columns(readings.positions(servo), *span, chartColumns, columns);
    for (const recording::SampleColumn& column : columns) {
        const auto at = [&](base::Duration instant, double position) {
            const auto goal = store.at(readings.goals(servo), instant);
            series.samples.push_back(
                {secondsOf(instant - span->from), position, goal ? goal->value : unknown});
        };
        if (column.gapBefore)
            at(column.from, unknown);
        const bool rising = column.first <= column.last;
        at(column.from, rising ? column.min : column.max);
        if (column.to > column.from)
            at(column.to, rising ? column.max : column.min);
    }
    return series;
}
} // namespace

std::optional<SweepFormat> sweepFormatOf(const QString& path)
{
    const QString end = QFileInfo(path).suffix().toLower();
    if (end == QLatin1String("html"))
        return SweepFormat::Html;
    if (end == QLatin1String("pdf"))
        return SweepFormat::Pdf;
    if (end == QLatin1String("json"))
        return SweepFormat::Json;
    if (end == QLatin1String("csv"))
        return SweepFormat::Csv;
    return std::nullopt;
}

QString sweepReadingsPath(const QString& report)
{
    const QString end = QFileInfo(report).suffix();
    return report.chopped(end.size()) + QStringLiteral("readings.csv");
}

base::Result<void> copySweepReadings(const QString& from, const QString& report)
{
    const QString to = sweepReadingsPath(report);
    if (from.isEmpty() || QDir::cleanPath(from) == QDir::cleanPath(to))
        return {};
    const QString part = to + QStringLiteral(".part");
    QFile::remove(part);
    const bool written = QFile::copy(from, part) && (!QFile::exists(to) || QFile::remove(to)) &&
                         QFile::rename(part, to);
    if (!written) {
        QFile::remove(part);
        return base::fail(base::ErrorCode::FileUnwritable, QStringLiteral("sweep"), to);
    }
    return {};
}

base::Result<void> saveSweepReport(const results::SweepRun& run,
                                   const jobs::SweepRecording& readings, SweepFormat format,
                                   bool chinese, const QString& path)
{
    if (format == SweepFormat::Json)
        return results::saveSweepRun(run, path);
    if (format == SweepFormat::Csv)
        return results::saveSweepLegs(run, path);
    std::vector<report::SweepSeries> series;
    for (std::size_t i = 0; i < run.servos.size(); ++i)
        series.push_back(seriesOf(run, readings, i));
    return format == SweepFormat::Pdf ? report::saveSweepPdf(run, series, chinese, path)
                                      : report::saveSweepHtml(run, series, chinese, path);
}
} // namespace session
