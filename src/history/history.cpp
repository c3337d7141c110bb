// SPDX-License-Identifier: GPL-3.0-or-later
// Reading is in history_read.cpp.
#include "history/history.h"

#include "history/history_file.h"
#include "history/history_query.h"
#include "results/step_json.h"
#include "results/sweep_json.h"
#include "results/sweep_verdict.h"

#include <QDir>
#include <QFileInfo>

#include <algorithm>

namespace history {
namespace {
constexpr qsizetype pieceSize = qsizetype(1) << 20; ///< before it is compressed

QVariantList testValues(const TestRun& head)
{
    return {newUuid(),
            nonNull(head.kind),
            head.at.toMSecsSinceEpoch(),
            nonNull(head.program),
            nonNull(head.port),
            head.simulated,
            results::gradeName(head.verdict),
            nonNull(head.end),
            nonNull(head.operatorName),
            nonNull(head.note),
            qint64(head.length.count())};
}

QVariantList testValues(std::int64_t number, int place, const TestServo& servo)
{
    return {qint64(number),
            place,
            servo.id,
            nonNull(servo.model),
            nonNull(servo.map),
            nonNull(servo.firmware),
            results::gradeName(servo.verdict),
            nonNull(servo.label),
            servo.reference};
}

/// Collects pieces of text into parts of one size.
class CompressedParts {
public:
    CompressedParts(const HistoryFile& file, std::int64_t number)
        : m_file(file)
        , m_number(number)
    {}

    bool add(const QByteArray& piece)
    {
        m_text += piece;
        return m_text.size() < pieceSize || flush();
    }

    base::Result<void> finish()
    {
        flush();
        return m_failure ? base::Result<void>(tl::unexpected(*m_failure)) : base::Result<void>();
    }

private:
    bool flush()
    {
        if (m_failure || m_text.isEmpty())
            return !m_failure;
        const auto done =
            m_file.run(QStringLiteral("INSERT INTO run_texts (run, part, data) VALUES (?, ?, ?)"),
                       {qint64(m_number), m_part++, qCompress(m_text)});
        if (!done)
            m_failure = done.error();
        m_text.clear();
        return !m_failure;
    }

    const HistoryFile& m_file;
    std::int64_t m_number;
    int m_part = 0;
    QByteArray m_text;
    std::optional<base::Error> m_failure;
};

QString fallbackPath(const QString& historyPath, const QString& kind, const QDateTime& at)
{
    const QString name =
        kind + QLatin1Char('-') + at.toUTC().toString(QStringLiteral("yyyyMMdd-HHmmss-zzz"));
    const QDir folder = QFileInfo(historyPath).absoluteDir();
    QString path = folder.filePath(name + QStringLiteral(".json"));
    for (int i = 2; QFile::exists(path); ++i)
        path = folder.filePath(QStringLiteral("%1-%2.json").arg(name).arg(i));
    return path;
}
} // namespace

base::Result<std::unique_ptr<History>> History::open(const QString& path,
                                                     std::chrono::milliseconds timeout)
{
    auto file = HistoryFile::open(path, timeout);
    if (!file)
        return tl::unexpected(file.error());
    return std::unique_ptr<History>(new History(std::move(*file)));
}

History::History(std::unique_ptr<HistoryFile> file)
    : m_file(std::move(file))
{}

History::~History() = default;

base::Result<void> History::addParts(const TestRun& head, std::int64_t number,
                                     const std::function<void(const files::TextSink&)>& write)
{
    int place = 0;
    for (const TestServo& servo : head.servos) {
        const auto added = m_file->run(
            QStringLiteral("INSERT INTO run_servos (run, place, id, model, map, firmware, verdict, "
                           "label, reference) VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?)"),
            testValues(number, place++, servo));
        if (!added)
            return tl::unexpected(added.error());
    }
    place = 0;
    for (const QString& path : head.files) {
        const auto added =
            m_file->run(QStringLiteral("INSERT INTO run_files (run, place, path) VALUES (?, ?, ?)"),
                        {qint64(number), place++, nonNull(path)});
        if (!added)
            return tl::unexpected(added.error());
    }
    CompressedParts parts(*m_file, number);
    write([&](const QByteArray& piece) { return parts.add(piece); });
    return parts.finish();
}

base::Result<std::int64_t> History::add(const TestRun& head,
                                        const std::function<void(const files::TextSink&)>& write)
{
    std::int64_t number = 0;
    const auto done = m_file->transaction([&]() -> base::Result<void> {
        const auto added = m_file->run(
            QStringLiteral("INSERT INTO runs (uuid, kind, at, program, port, simulated, verdict, "
                           "ended, operator, note, length) "
                           "VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)"),
            testValues(head));
        if (!added)
            return tl::unexpected(added.error());
        number = added->insertedId;
        return addParts(head, number, write);
    });
    if (!done)
        return tl::unexpected(done.error());
    return number;
}

base::Result<std::int64_t> History::add(const results::SweepRun& run, const QStringList& files)
{
    TestRun head = toTestRun(run);
    head.files = files;
    return add(head, [&](const files::TextSink& sink) { results::writeSweepRun(run, sink); });
}

base::Result<std::int64_t> History::add(const results::StepRun& run, const QStringList& files)
{
    TestRun head = toTestRun(run);
    head.files = files;
    return add(head,
               [&](const files::TextSink& sink) { sink(results::encodeStepRuns({run}, {})); });
}

base::Result<void> History::change(const QString& sql, const QVariantList& values,
                                   std::int64_t number)
{
    const auto done = m_file->run(sql, values);
    if (!done)
        return tl::unexpected(done.error());
    if (done->changed < 1)
        return base::fail(base::ErrorCode::BadArgument, QStringLiteral("history"),
                          QStringLiteral("no test run %1").arg(qint64(number)));
    return {};
}

base::Result<void> History::remove(std::int64_t number)
{
    return change(QStringLiteral("DELETE FROM runs WHERE number = ?"), {qint64(number)}, number);
}

base::Result<void> History::setLabel(std::int64_t number, int servo, const QString& label)
{
    return change(QStringLiteral("UPDATE run_servos SET label = ? WHERE run = ? AND id = ?"),
                  {nonNull(label), qint64(number), servo}, number);
}

base::Result<void> History::setNote(std::int64_t number, const QString& note)
{
    return change(QStringLiteral("UPDATE runs SET note = ? WHERE number = ?"),
                  {nonNull(note), qint64(number)}, number);
}

base::Result<void> History::setReference(std::int64_t number, int servo, bool reference)
{
    return m_file->transaction([&]() -> base::Result<void> {
        if (reference) {
            const auto tested = run(number);
            if (!tested)
                return tl::unexpected(tested.error());
            if (!canBeReference(*tested))
                return base::fail(base::ErrorCode::Refused, QStringLiteral("history"),
                                  QStringLiteral("unfinished-reference"));
            const auto& servos = tested->servos;
            if (std::any_of(servos.begin(), servos.end(), [&](const TestServo& one) {
                    return one.id == servo && !canBeReference(*tested, one);
                }))
                return base::fail(base::ErrorCode::Refused, QStringLiteral("history"),
                                  QStringLiteral("failed-reference"), servo);
            const auto cleared = m_file->run(
                QStringLiteral("UPDATE run_servos SET reference = 0 WHERE reference = 1 AND model "
                               "= (SELECT model FROM run_servos WHERE run = ? AND id = ?)"),
                {qint64(number), servo});
            if (!cleared)
                return tl::unexpected(cleared.error());
        }
        return change(
            QStringLiteral("UPDATE run_servos SET reference = ? WHERE run = ? AND id = ?"),
            {reference, qint64(number), servo}, number);
    });
}

bool canBeReference(const TestRun& run)
{
    const auto end = results::sweepEndFromName(run.end);
    return end && canBeReference(*end);
}

bool canBeReference(const TestRun& run, const TestServo& servo)
{
    return canBeReference(run) && servo.verdict != results::Grade::Fail;
}

TestRun toTestRun(const results::SweepRun& run)
{
    TestRun head;
    head.at = run.at;
    head.program = run.program;
    head.port = run.port;
    head.simulated = run.simulated;
    head.verdict = run.verdict();
    head.end = results::sweepEndName(run.end);
    head.operatorName = run.spec.operatorName;
    head.note = run.spec.note;
    head.length = run.length;
    for (const results::SweepServo& servo : run.servos) {
        const snapshot::SnapshotServo& identity = servo.parameters.servo;
        head.servos.push_back({identity.id, identity.model, identity.map, identity.firmware,
                               servo.verdict, servo.parameters.label, false});
    }
    return head;
}

/// The length of a response is that of its readings.
TestRun toTestRun(const results::StepRun& run)
{
    TestRun head;
    head.kind = QStringLiteral("step");
    head.at = run.at;
    head.program = run.program;
    head.port = run.port;
    head.simulated = run.simulated;
    head.end = results::sweepEndName(run.end);
    head.operatorName = run.spec.operatorName;
    head.note = run.spec.note;
    for (const results::StepResponse& response : run.responses)
        head.length += response.samples.empty() ? base::Duration{} : response.samples.back().at;
    const snapshot::SnapshotServo& identity = run.parameters.servo;
    head.servos.push_back({identity.id, identity.model, identity.map, identity.firmware,
                           results::Grade::NotMeasured, run.parameters.label, false});
    return head;
}

namespace {
template <typename Run, typename Save>
SavedRun saveRunOrFile(const QString& historyPath, const Run& run, const QStringList& files,
                       std::chrono::milliseconds timeout, const QString& kind, const Save& save)
{
    SavedRun kept;
    const auto history = History::open(historyPath, timeout);
    const auto number = history ? (*history)->add(run, files)
                                : base::Result<std::int64_t>(tl::unexpected(history.error()));
    if (number) {
        kept.number = *number;
        return kept;
    }
    kept.trouble = number.error();
    const QString beside = fallbackPath(historyPath, kind, run.at);
    if (save(beside))
        kept.file = beside;
    return kept;
}
} // namespace

SavedRun saveRun(const QString& historyPath, const results::SweepRun& run, const QStringList& files,
                 std::chrono::milliseconds timeout)
{
    return saveRunOrFile(
        historyPath, run, files, timeout, QStringLiteral("sweep"),
        [&](const QString& path) { return results::saveSweepRun(run, path).has_value(); });
}

SavedRun saveRun(const QString& historyPath, const results::StepRun& run, const QStringList& files,
                 std::chrono::milliseconds timeout)
{
    return saveRunOrFile(
        historyPath, run, files, timeout, QStringLiteral("step"),
        [&](const QString& path) { return results::saveStepRuns({run}, {}, path).has_value(); });
}
} // namespace history
