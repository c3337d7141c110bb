// SPDX-License-Identifier: GPL-3.0-or-later
#include "history/history.h"
#include "history/history_file.h"
#include "history/run_text.h"
#include "results/step_json.h"
#include "results/sweep_json.h"
#include "results/sweep_verdict.h"

#include <map>

namespace history {
namespace {
const QString runColumns =
    QStringLiteral("number, uuid, kind, at, program, port, simulated, verdict, "
                   "ended, operator, note, length");

results::Grade readGrade(const QVariant& value)
{
    return results::gradeFromName(value.toString()).value_or(results::Grade::NotMeasured);
}

TestRun readRunRow(const QVariantList& row)
{
    TestRun run;
    int column = 0;
    run.number = row.value(column++).toLongLong();
    run.uuid = row.value(column++).toString();
    run.kind = row.value(column++).toString();
    run.at = QDateTime::fromMSecsSinceEpoch(row.value(column++).toLongLong(), Qt::UTC);
    run.program = row.value(column++).toString();
    run.port = row.value(column++).toString();
    run.simulated = row.value(column++).toBool();
    run.verdict = readGrade(row.value(column++));
    run.end = row.value(column++).toString();
    run.operatorName = row.value(column++).toString();
    run.note = row.value(column++).toString();
    run.length = base::Duration(row.value(column++).toLongLong());
    return run;
}

TestServo readTestServo(const QVariantList& row)
{
    return {row.value(1).toInt(),    row.value(2).toString(), row.value(3).toString(),
            row.value(4).toString(), readGrade(row.value(5)), row.value(6).toString(),
            row.value(7).toBool()};
}

/// A list has no figures, but it has the end of the run. With several servos it does not know
/// which of them caused the end: then only the run itself has the verdict.
void applyEndToVerdict(TestRun& run)
{
    const auto end = results::sweepEndFromName(run.end);
    if (!end || run.kind != QLatin1StringView("sweep"))
        return;
    for (TestServo& servo : run.servos)
        servo.verdict = results::gradeAfter(*end, servo.verdict, run.servos.size() == 1);
    run.verdict = results::gradeAfter(*end, run.verdict, true);
}

/// Matches the text that the user typed anywhere.
QString likePattern(QString text)
{
    text.replace(u'\\', QStringLiteral("\\\\"))
        .replace(u'%', QStringLiteral("\\%"))
        .replace(u'_', QStringLiteral("\\_"));
    return u'%' + text + u'%';
}

/// The conditions of a filter, and the values that go with them.
struct RunConditions {
    QStringList conditions;
    QVariantList values;

    void add(const char* condition, const QVariant& value)
    {
        conditions.append(QString::fromLatin1(condition));
        values.append(value);
    }
};

RunConditions toConditions(const RunFilter& filter)
{
    RunConditions sqlConditions;
    if (!filter.kind.isEmpty())
        sqlConditions.add("kind = ?", filter.kind);
    if (!filter.model.isEmpty())
        sqlConditions.add("number IN (SELECT run FROM run_servos WHERE lower(model) = lower(?))",
                          filter.model);
    if (!filter.firmware.isEmpty())
        sqlConditions.add("number IN (SELECT run FROM run_servos WHERE firmware = ?)",
                          filter.firmware);
    if (filter.id)
        sqlConditions.add("number IN (SELECT run FROM run_servos WHERE id = ?)", *filter.id);
    if (filter.from.isValid())
        sqlConditions.add("at >= ?", filter.from.toMSecsSinceEpoch());
    if (filter.until.isValid())
        sqlConditions.add("at < ?", filter.until.toMSecsSinceEpoch());
    if (!filter.text.isEmpty()) {
        sqlConditions.add(
            R"((lower(note) LIKE lower(?) ESCAPE '\' OR lower(operator) LIKE lower(?) ESCAPE '\' )"
            R"(OR lower(port) LIKE lower(?) ESCAPE '\' OR number IN (SELECT run FROM run_servos WHERE )"
            R"(lower(model) LIKE lower(?) ESCAPE '\' OR lower(firmware) LIKE lower(?) ESCAPE '\' )"
            R"(OR lower(label) LIKE lower(?) ESCAPE '\')))",
            likePattern(filter.text));
        for (int i = 0; i < 5; ++i)
            sqlConditions.values.append(likePattern(filter.text));
    }
    return sqlConditions;
}

base::Error noSuchRun(std::int64_t number)
{
    return {base::ErrorCode::BadArgument, QStringLiteral("history"),
            QStringLiteral("no test run %1").arg(qint64(number))};
}
} // namespace

/// `whereClause` follows FROM runs. One query each for the servos and files of all runs.
base::Result<std::vector<TestRun>> History::read(const QString& whereClause,
                                                 const QVariantList& values) const
{
    const auto heads =
        m_file->run(QStringLiteral("SELECT %1 FROM runs ").arg(runColumns) + whereClause, values);
    if (!heads)
        return tl::unexpected(heads.error());
    std::vector<TestRun> runs;
    std::map<std::int64_t, std::size_t> places;
    for (const QVariantList& row : heads->rows) {
        places[row.value(0).toLongLong()] = runs.size();
        runs.push_back(readRunRow(row));
    }
    const QString fromClause = QStringLiteral(" WHERE run IN (SELECT number FROM runs ") +
                               whereClause + QStringLiteral(") ORDER BY run, place");
    const auto forEachRow = [&](const QString& what, const auto& take) -> base::Result<void> {
        const auto rows = m_file->run(what + fromClause, values);
        if (!rows)
            return tl::unexpected(rows.error());
        for (const QVariantList& row : rows->rows) {
            // Another program may have added one in between.
            if (const auto place = places.find(row.value(0).toLongLong()); place != places.end())
                take(runs[place->second], row);
        }
        return {};
    };
    if (const auto read = forEachRow(
            QStringLiteral("SELECT run, id, model, map, firmware, verdict, label, reference "
                           "FROM run_servos"),
            [](TestRun& run, const QVariantList& row) {
                run.servos.push_back(readTestServo(row));
            });
        !read)
        return tl::unexpected(read.error());
    if (const auto read = forEachRow(QStringLiteral("SELECT run, path FROM run_files"),
                                     [](TestRun& run, const QVariantList& row) {
                                         run.files.append(row.value(1).toString());
                                     });
        !read)
        return tl::unexpected(read.error());
    for (TestRun& run : runs)
        applyEndToVerdict(run);
    return runs;
}

base::Result<std::vector<TestRun>> History::runs(const RunFilter& filter) const
{
    RunConditions sqlConditions = toConditions(filter);
    QString whereClause;
    if (!sqlConditions.conditions.isEmpty())
        whereClause =
            QStringLiteral("WHERE ") + sqlConditions.conditions.join(QStringLiteral(" AND "));
    sqlConditions.values.append(filter.limit);
    return read(whereClause + QStringLiteral(" ORDER BY at DESC, number DESC LIMIT ?"),
                sqlConditions.values);
}

base::Result<TestRun> History::run(std::int64_t number) const
{
    const auto found = read(QStringLiteral("WHERE number = ?"), {qint64(number)});
    if (!found)
        return tl::unexpected(found.error());
    if (found->empty())
        return tl::unexpected(noSuchRun(number));
    return found->front();
}

base::Result<QByteArray> runText(const HistoryFile& file, std::int64_t number)
{
    const auto rows = file.run(QStringLiteral("SELECT data FROM run_texts WHERE run = ? "
                                              "ORDER BY part"),
                               {qint64(number)});
    if (!rows)
        return tl::unexpected(rows.error());
    QByteArray text;
    if (rows->rows.empty())
        return tl::unexpected(noSuchRun(number));
    for (const QVariantList& row : rows->rows)
        text += qUncompress(row.value(0).toByteArray());
    return text;
}

base::Result<QByteArray> History::text(std::int64_t number) const
{
    return runText(*m_file, number);
}

base::Result<results::SweepRun> History::sweep(std::int64_t number) const
{
    const auto head = run(number);
    if (!head)
        return tl::unexpected(head.error());
    const auto fullText = text(number);
    if (!fullText)
        return tl::unexpected(fullText.error());
    auto sweep = results::decodeSweepRun(*fullText);
    if (!sweep)
        return sweep;
    sweep->spec.note = head->note;
    const std::size_t count = std::min(head->servos.size(), sweep->servos.size());
    for (std::size_t i = 0; i < count; ++i)
        sweep->servos[i].parameters.label = head->servos[i].label;
    return sweep;
}

base::Result<results::StepRun> History::step(std::int64_t number) const
{
    const auto head = run(number);
    if (!head)
        return tl::unexpected(head.error());
    const auto fullText = text(number);
    if (!fullText)
        return tl::unexpected(fullText.error());
    auto runs = results::decodeStepRuns(*fullText);
    if (!runs)
        return tl::unexpected(runs.error());
    if (runs->empty())
        return tl::unexpected(noSuchRun(number));
    results::StepRun step = std::move(runs->front());
    step.spec.note = head->note;
    if (!head->servos.empty())
        step.parameters.label = head->servos.front().label;
    return step;
}

base::Result<std::optional<ReferenceServo>> History::reference(const QString& model) const
{
    const auto row =
        m_file->run(QStringLiteral("SELECT run, id FROM run_servos WHERE model = ? AND "
                                   "reference = 1 ORDER BY run DESC LIMIT 1"),
                    {model});
    if (!row)
        return tl::unexpected(row.error());
    if (row->rows.empty())
        return std::nullopt;
    const int id = row->rows.front().value(1).toInt();
    auto found = run(row->rows.front().value(0).toLongLong());
    if (!found)
        return tl::unexpected(found.error());
    for (const TestServo& servo : found->servos) {
        if (servo.id == id)
            return ReferenceServo{*found, servo};
    }
    return std::nullopt;
}
} // namespace history
