// SPDX-License-Identifier: GPL-3.0-or-later
#include "record/rejudge.h"

#include "record/history_file.h"
#include "record/sweep_json.h"
#include "record/sweep_verdict.h"

namespace record {
namespace {
const QString mark = QStringLiteral("sweep-verdicts");
const QString rule = QStringLiteral("2"); ///< record/sweep_verdict.h, since it gives none to a stop

/// Only what fits into one piece is read again: a night's worth of legs is not worth the wait, and
/// its lists go by its end.
base::Result<std::optional<SweepRun>> storedRun(const HistoryFile& file, qint64 number)
{
    const auto parts =
        file.run(QStringLiteral("SELECT COUNT(*) FROM run_texts WHERE run = ?"), {number});
    if (!parts)
        return tl::unexpected(parts.error());
    if (parts->rows.empty() || parts->rows.front().value(0).toInt() != 1)
        return std::nullopt;
    const auto text =
        file.run(QStringLiteral("SELECT data FROM run_texts WHERE run = ?"), {number});
    if (!text)
        return tl::unexpected(text.error());
    if (text->rows.empty())
        return std::nullopt;
    auto run = decodeSweepRun(qUncompress(text->rows.front().value(0).toByteArray()));
    return run ? std::optional(std::move(*run)) : std::nullopt;
}

/// Rows that are right already stay untouched, so that no copy of them is sent again.
base::Result<void> judgeAnew(const HistoryFile& file, qint64 number, const SweepRun& run)
{
    const QString whole = gradeName(run.verdict());
    const auto head =
        file.run(QStringLiteral("UPDATE runs SET verdict = ? WHERE number = ? AND verdict <> ?"),
                 {whole, number, whole});
    if (!head)
        return tl::unexpected(head.error());
    for (const SweepServo& servo : run.servos) {
        const QString grade = gradeName(servo.verdict);
        const auto row = file.run(QStringLiteral("UPDATE run_servos SET verdict = ? WHERE run = ? "
                                                 "AND id = ? AND verdict <> ?"),
                                  {grade, number, servo.parameters.servo.id, grade});
        if (!row)
            return tl::unexpected(row.error());
    }
    return {};
}

base::Result<void> judgeAll(const HistoryFile& file)
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
        if (const auto judged = judgeAnew(file, number, **run); !judged)
            return judged;
    }
    const auto marked =
        file.run(QStringLiteral("INSERT INTO about (name, value) VALUES (?, ?)"), {mark, rule});
    return marked ? base::Result<void>() : tl::unexpected(marked.error());
}
} // namespace

base::Result<void> rejudgeStoredSweeps(const HistoryFile& file)
{
    const auto done = [&]() -> base::Result<bool> {
        const auto found =
            file.run(QStringLiteral("SELECT value FROM about WHERE name = ?"), {mark});
        if (!found)
            return tl::unexpected(found.error());
        return !found->rows.empty();
    };
    const auto before = done();
    if (!before)
        return tl::unexpected(before.error());
    if (*before)
        return {};
    return file.together([&]() -> base::Result<void> {
        const auto meanwhile = done(); // by another program
        if (!meanwhile)
            return tl::unexpected(meanwhile.error());
        return *meanwhile ? base::Result<void>() : judgeAll(file);
    });
}
} // namespace record
