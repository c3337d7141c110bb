// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/alarm_log.h"
#include "cli/commands.h"
#include "cli/input/arguments.h"
#include "cli/output/report_text.h"
#include "cli/output/watch_view.h"
#include "cli/run.h"
#include "cli/translate.h"
#include "recording/csv_writer.h"
#include "text/notice_text.h"

#include <cmath>

namespace cli {
namespace {
constexpr double defaultRate = 20;

/// The document, written while the readings come in: a watch may last for hours.
class JsonStream {
public:
    JsonStream(Console& console, const QString& port, const std::vector<jobs::WatchColumn>& columns)
        : m_console(console)
    {
        Json::Array names;
        for (const jobs::WatchColumn& column : columns)
            names.push_back(Json::object().add("key", column.key).add("unit", column.unit));
        put("{\n  \"port\": " + Json(port).compact() +
            ",\n  \"columns\": " + Json(std::move(names)).compact() + ",\n  \"rows\": [");
    }

    void add(const jobs::WatchRow& row, const catalog::Profile* profile)
    {
        if (!m_start)
            m_start = row.at;
        Json::Array values;
        for (const auto& value : row.values)
            values.emplace_back(value);
        Json json = Json::object();
        json.add("time_us", std::int64_t{(row.at - *m_start).count()}).add("id", row.id);
        if (row.answered)
            json.add("status", jsonAlarms(row.status, profile)).add("values", std::move(values));
        else
            json.add("error", base::errorName(base::ErrorCode::NoReply));
        put((m_first ? "\n    " : ",\n    ") + json.compact());
        m_first = false;
    }

    /// `last` is the summary, or why it ended early.
    void finish(const char* name, const Json& last)
    {
        put("\n  ],\n  \"" + QByteArray(name) + "\": " + last.compact() + "\n}\n");
    }

private:
    void put(const QByteArray& text)
    {
        if (m_console.isJson())
            m_console.write(text);
    }

    Console& m_console;
    std::optional<base::Duration> m_start;
    bool m_first = true;
};

base::Result<jobs::WatchSpec> timesOf(const Values& values)
{
    jobs::WatchSpec spec;
    const QString rate = values.option("--rate").value_or(QString::number(defaultRate));
    if (rate != QLatin1String("max")) {
        const auto hertz = parsePositive(rate);
        if (!hertz)
            return tl::unexpected(hertz.error());
        spec.period = base::Duration(std::llround(1e6 / *hertz));
    }
    if (const auto length = values.option("--duration")) {
        const auto seconds = parsePositive(*length);
        if (!seconds)
            return tl::unexpected(seconds.error());
        spec.length = base::Duration(std::llround(1e6 * *seconds));
    }
    return spec;
}

base::Result<std::unique_ptr<recording::CsvWriter>> openCsv(const Values& values,
                                                            const jobs::WatchSpec& spec)
{
    const auto file = values.option("--csv");
    if (!file)
        return std::unique_ptr<recording::CsvWriter>();
    std::vector<recording::CsvColumn> columns;
    for (const jobs::WatchColumn& column : jobs::watchColumns(spec))
        columns.push_back({column.key, column.unit});
    return recording::CsvWriter::create(*file, columns);
}

/// Hands each reading to whoever wants it.
class Sink {
public:
    Sink(Run& run, const jobs::WatchSpec& spec, std::unique_ptr<recording::CsvWriter> csv,
         const QString& port)
        : m_console(run.console())
        , m_csv(std::move(csv))
        , m_view(run.console(), spec, m_csv != nullptr)
        , m_json(run.console(), port, jobs::watchColumns(spec))
        , m_alarms(run.console(), spec.servos)
    {
        for (const device::Servo& servo : spec.servos)
            m_profiles[servo.id] = servo.profile;
    }

    base::Result<void> take(const jobs::WatchRow& row)
    {
        m_view.add(row);
        m_json.add(row, m_profiles[row.id].get());
        if (row.answered)
            m_alarms.addStatus(row.id, row.status, QDateTime::currentDateTimeUtc());
        if (m_console.writeError())
            return base::fail(base::ErrorCode::Stopped, QStringLiteral("watch"));
        if (m_csv == nullptr || !row.answered)
            return {};
        return m_csv->write(row.at, row.id, row.values);
    }

    /// However the watch has ended.
    void ended() { m_alarms.finish(); }

    void finish(Run& run, const jobs::WatchReport& report)
    {
        m_view.finish();
        Json json = Json::object();
        json.add("readings", std::int64_t(report.rows))
            .add("missed", std::int64_t(report.missed))
            .add("elapsed_ms", std::int64_t(report.elapsed.count() / 1000));
        m_json.finish("summary", json);
        const double seconds = std::chrono::duration<double>(report.elapsed).count();
        m_console.print(
            translate("cli", "%n reading(s) in %1 s, %2 missed", nullptr, int(report.rows))
                .arg(seconds, 0, 'f', 2)
                .arg(report.missed) +
            QLatin1Char('\n') + run.takeNotices());
    }

    /// The document has begun, so the error becomes a part of it.
    base::Result<Exit> fail(const base::Error& error)
    {
        m_json.finish("error", jsonError(error));
        if (m_console.isJson())
            return exitCode(error.code);
        return tl::unexpected(error);
    }

private:
    Console& m_console;
    std::unique_ptr<recording::CsvWriter> m_csv;
    WatchView m_view;
    JsonStream m_json;
    AlarmLog m_alarms;
    std::map<int, catalog::ProfilePtr> m_profiles;
};

base::Result<Exit> runWatch(Run& run, const Values& values)
{
    const auto ids = parseIds(values.arguments("ID"));
    if (!ids)
        return tl::unexpected(ids.error());
    auto spec = timesOf(values);
    if (!spec)
        return tl::unexpected(spec.error());
    for (const int id : *ids) {
        auto servo = run.servoWithSettings(id);
        if (!servo)
            return tl::unexpected(servo.error());
        spec->servos.push_back(std::move(*servo));
    }
    auto csv = openCsv(values, *spec);
    if (!csv)
        return tl::unexpected(csv.error());
    const auto context = run.context();
    Sink sink(run, *spec, std::move(*csv), context->bus.portName());
    const auto report =
        jobs::watch(*context, *spec, [&sink](const jobs::WatchRow& row) { return sink.take(row); });
    sink.ended();
    if (run.console().writeError())
        return Exit::File;
    if (!report)
        return sink.fail(report.error());
    sink.finish(run, *report);
    return report->rows == 0 && report->missed > 0 ? Exit::NoReply : Exit::Success;
}
} // namespace

Command watchCommand()
{
    return {
        "watch",
        QT_TRANSLATE_NOOP("cli", "read servo feedback continuously"),
        {{"ID", QT_TRANSLATE_NOOP("cli", "servo IDs: 1 2 3, 1-6 or 1,3"), 1, many}},
        {{"--rate", QT_TRANSLATE_NOOP("cli", "readings per second for each servo (default: 20)"),
          "HZ|max"},
         {"--duration",
          QT_TRANSLATE_NOOP("cli", "end after this many seconds (default: run until Ctrl-C)"), "S"},
         {"--csv", QT_TRANSLATE_NOOP("cli", "write the readings to a file"), "FILE"}},
        runWatch};
}
} // namespace cli
