// SPDX-License-Identifier: GPL-3.0-or-later
#include "history/sweep_reevaluation.h"

#include "history/history_file.h"
#include "history/run_text.h"
#include "results/sweep_json.h"
#include "results/sweep_verdict.h"

namespace history {
namespace {
const QString versionKey = QStringLiteral("sweep-verdicts");
const QString version =
    QStringLiteral("2"); ///< results/sweep_verdict.h, since it gives none to a stop

/// Reading the legs of a long run takes too long and is needed only where its path has limits of
/// its own: other verdicts follow from the end of the run. The test is at the start of the text.
bool needsReading(const QByteArray& start)
{
    for (const results::SweepShape shape :
         {results::SweepShape::Sine, results::SweepShape::Random}) {
        if (start.contains("\"shape\": \"" + results::sweepShapeName(shape).toLatin1() + '"'))
            return true;
    }
    return false;
}

base::Result<std::optional<results::SweepRun>> storedRun(const HistoryFile& file, qint64 number)
{
    const auto start = file.run(
        QStringLiteral("SELECT data, (SELECT COUNT(*) FROM run_texts WHERE run = ?) FROM run_texts "
                       "WHERE run = ? ORDER BY part LIMIT 1"),
        {number, number});
    if (!start)
        return tl::unexpected(start.error());
    if (start->rows.empty())
        return std::nullopt;
    const QVariantList& first = start->rows.front();
    if (first.value(1).toInt() > 1 && !needsReading(qUncompress(first.value(0).toByteArray())))
        return std::nullopt;
    const auto text = runText(file, number);
    if (!text)
        return tl::unexpected(text.error());
    auto run = results::decodeSweepRun(*text);
    return run ? std::optional(std::move(*run)) : std::nullopt;
}

/// Correct rows stay unchanged, so that they are not sent to a server again.
base::Result<void> updateVerdict(const HistoryFile& file, qint64 number,
                                 const results::SweepRun& run)
{
    const QString overallGrade = results::gradeName(run.verdict());
    const auto head =
        file.run(QStringLiteral("UPDATE runs SET verdict = ? WHERE number = ? AND verdict <> ?"),
                 {overallGrade, number, overallGrade});
    if (!head)
        return tl::unexpected(head.error());
    for (const results::SweepServo& servo : run.servos) {
        const QString grade = results::gradeName(servo.verdict);
        const auto row = file.run(QStringLiteral("UPDATE run_servos SET verdict = ? WHERE run = ? "
                                                 "AND id = ? AND verdict <> ?"),
                                  {grade, number, servo.parameters.servo.id, grade});
        if (!row)
            return tl::unexpected(row.error());
    }
    return {};
}

base::Result<void> reevaluateAll(const HistoryFile& file)
{
    const auto runs = file.run(
        QStringLiteral("SELECT number FROM runs WHERE kind = 'sweep' AND verdict <> 'fail' OR "
                       "kind = 'sweep' AND ended <> 'finished' ORDER BY number"));
    if (!runs)
        return tl::unexpected(runs.error());
    for (const QVariantList& row : runs->rows) {
        const qint64 number = row.value(0).toLongLong();
        const auto run = storedRun(file, number);
        if (!run)
            return tl::unexpected(run.error());
        if (!*run)
            continue;
        if (const auto judged = updateVerdict(file, number, **run); !judged)
            return judged;
    }
    const auto marked = file.run(QStringLiteral("INSERT INTO about (name, value) VALUES (?, ?)"),
                                 {versionKey, version});
    return marked ? base::Result<void>() : tl::unexpected(marked.error());
}
} // namespace

base::Result<void> reevaluateStoredSweeps(const HistoryFile& file)
{
    const auto done = [&]() -> base::Result<bool> {
        const auto found =
            file.run(QStringLiteral("SELECT value FROM about WHERE name = ?"), {versionKey});
        if (!found)
            return tl::unexpected(found.error());
        return !found->rows.empty();
    };
    const auto before = done();
    if (!before)
        return tl::unexpected(before.error());
    if (*before)
        return {};
    return file.transaction([&]() -> base::Result<void> {
        const auto meanwhile = done(); // by another program
        if (!meanwhile)
            return tl::unexpected(meanwhile.error());
        return *meanwhile ? base::Result<void>() : reevaluateAll(file);
    });
}
} // namespace history
