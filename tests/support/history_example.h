// SPDX-License-Identifier: GPL-3.0-or-later
// A bench's history with something of every kind in it, and what its lists say without the numbers
// that each database gives by itself, so that a copy can be held against it. The test's thread.
#pragma once

#include "history/history.h"
#include "history/history_journal.h"
#include "unit/results/sweep_example.h"

#include <QTemporaryDir>

namespace history_example {
using namespace std::chrono_literals;

/// `folder` goes with it.
struct Bench {
    QTemporaryDir folder;
    QString path = folder.filePath(QStringLiteral("history.sqlite"));
    history::HistoryJournal journal{path, QStringLiteral("ServoDesk 0.1.0")};

    std::unique_ptr<history::History> open() const
    {
        return std::move(history::History::open(path).value());
    }
};

inline void requireOk(const base::Result<void>& done)
{
    if (!done)
        qFatal("%s", qPrintable(done.error().detail));
}

inline base::ServoIdentity servo(int id, const char* model = "STS3215")
{
    base::ServoIdentity identity{
        id, 9, 3, 3, 10, QStringLiteral("sts-sms"), QStringLiteral("/dev/ttyUSB0"), 1000000};
    identity.model = QString::fromLatin1(model);
    return identity;
}

/// Two registers; `outcome` empty: interrupted.
inline QString write(history::HistoryJournal& journal, int id, std::int64_t value,
                     const char* outcome = "done")
{
    base::Intent intent;
    intent.lockOpened = true;
    intent.servo = servo(id);
    intent.items = {{QStringLiteral("min_angle"), 9, -12, value},
                    {QStringLiteral("max_angle"), 11, 4095, value + 1000}};
    const QString uuid = journal.begin(intent).value();
    if (*outcome == '\0')
        return uuid;
    base::IntentResult end{QString::fromLatin1(outcome), QStringLiteral("O'Neill\\ ?")};
    end.items = {{QStringLiteral("min_angle"), value, QStringLiteral("kept")},
                 {QStringLiteral("max_angle"), {}, QStringLiteral("mismatch")}};
    requireOk(journal.end(uuid, end));
    return uuid;
}

inline snapshot::Snapshot snapshot(int id, const char* note)
{
    snapshot::Snapshot snapshot;
    snapshot.program = QStringLiteral("ServoDesk 0.1.0");
    snapshot.at = QDateTime({2026, 5, 1}, {8, id % 60, 3}, Qt::UTC);
    snapshot.note = QString::fromUtf8(note);
    snapshot.port = QStringLiteral("/dev/ttyUSB0");
    snapshot.baud = 1000000;
    snapshot.servo = {id,
                      QStringLiteral("STS3215"),
                      QStringLiteral("9.3"),
                      QStringLiteral("3.10"),
                      QStringLiteral("sts-sms"),
                      QStringLiteral("feetech")};
    snapshot.registers = {{QStringLiteral("min_angle"), 9, -12, -1.05, QStringLiteral("deg")}};
    return snapshot;
}

/// Something of every kind.
inline void fill(Bench& bench)
{
    for (int i = 0; i < 5; ++i)
        write(bench.journal, 1 + i % 3, i);
    write(bench.journal, 2, 77, "failed");
    write(bench.journal, 3, 78, "");
    requireOk(bench.journal.saveServoValues(servo(1), QStringLiteral("limits"), {1, -2}));
    const auto history = bench.open();
    const history::HistoryLog log = history->log();
    (void)log.addSnapshot(snapshot(1, "磨损 'worn'"), history::SnapshotReason::Automatic).value();
    (void)log.addSnapshot(snapshot(7, ""), history::SnapshotReason::Manual).value();
    const QDateTime at({2026, 5, 2}, {9, 0, 0, 250}, Qt::UTC);
    requireOk(log.recordAlarmStart(servo(2), QStringLiteral("overload"), false, at));
    requireOk(log.recordAlarmEnd(servo(2), QStringLiteral("overload"), at.addSecs(9)));
    requireOk(log.recordAlarmStart(servo(1), QStringLiteral("voltage"), true, at.addSecs(1)));
    history::HistoryRecording recording;
    recording.at = at;
    recording.length = 12s;
    recording.file = QStringLiteral("/tmp/r.csv");
    recording.rows = 4711;
    recording.port = QStringLiteral("/dev/ttyUSB0");
    (void)log.addRecording(recording, {servo(1), servo(3)}).value();
    (void)history->add(sweep_example::finishedRun(), {QStringLiteral("/tmp/r.html")}).value();
}

// --- the lists as text, newest first ---

inline QString isoText(const QDateTime& at)
{
    return at.toString(Qt::ISODateWithMs);
}

inline QStringList writes(const history::History& history,
                          const history::HistoryFilter& filter = {})
{
    QStringList lines;
    const auto all = history.log().writes(filter).value();
    for (const history::HistoryWrite& one : all)
        lines << QStringLiteral("%1/%2 %3 %4 %5 %6 %7 %8@%9")
                         .arg(one.intentUuid)
                         .arg(one.place)
                         .arg(one.servoId)
                         .arg(one.model, one.label, isoText(one.at), base::intentKindName(one.kind))
                         .arg(one.key)
                         .arg(one.address) +
                     QStringLiteral(" %1→%2 %3 %4 %5 %6 %7 %8 %9")
                         .arg(one.oldRaw)
                         .arg(one.newRaw.value_or(-1))
                         .arg(one.readBack ? QString::number(*one.readBack) : QString())
                         .arg(one.outcome, one.detail, one.port)
                         .arg(one.baud)
                         .arg(one.program)
                         .arg(one.temporary);
    return lines;
}

inline QStringList servos(const history::History& history,
                          const history::HistoryFilter& filter = {})
{
    QStringList lines;
    const auto all = history.log().servos(filter).value();
    for (const history::HistoryServo& one : all)
        lines << QStringLiteral("%1 %2 %3 %4 %5 %6 %7")
                         .arg(one.uuid)
                         .arg(one.identity.id)
                         .arg(one.identity.model, one.identity.map, one.label,
                              isoText(one.lastWrite), one.identity.port) +
                     (one.current ? QStringLiteral(" current") : QString());
    return lines;
}

inline QStringList snapshots(const history::History& history,
                             const history::HistoryFilter& filter = {})
{
    QStringList lines;
    const auto all = history.log().snapshots(filter).value();
    for (const history::HistorySnapshot& one : all)
        lines << QStringLiteral("%1 %2 %3 %4 %5 %6 %7 %8")
                         .arg(one.uuid)
                         .arg(one.servoId)
                         .arg(one.model, one.firmware, one.label, one.note,
                              history::snapshotReasonName(one.reason))
                         .arg(one.registers) +
                     QString::fromUtf8(
                         snapshot::encodeSnapshot(history.log().snapshot(one.number).value()));
    return lines;
}

inline QStringList alarms(const history::History& history,
                          const history::HistoryFilter& filter = {})
{
    QStringList lines;
    const auto all = history.log().alarms(filter).value();
    for (const history::HistoryAlarm& one : all)
        lines << QStringLiteral("%1 %2 %3 %4 %5 %6")
                     .arg(one.uuid)
                     .arg(one.servoId)
                     .arg(one.key)
                     .arg(one.derived)
                     .arg(isoText(one.at), isoText(one.clearedAt));
    return lines;
}

inline QStringList recordings(const history::History& history,
                              const history::HistoryFilter& filter = {})
{
    QStringList lines;
    const auto all = history.log().recordings(filter).value();
    for (const history::HistoryRecording& one : all) {
        QString line = QStringLiteral("%1 %2 %3 %4 %5")
                           .arg(one.uuid, isoText(one.at), one.file)
                           .arg(one.rows)
                           .arg(qint64(one.length.count()));
        for (const auto& servo : one.servos)
            line += QStringLiteral(" %1:%2:%3").arg(servo.id).arg(servo.model, servo.label);
        lines << line;
    }
    return lines;
}

inline QStringList runs(const history::History& history, const history::RunFilter& filter = {})
{
    QStringList lines;
    const auto all = history.runs(filter).value();
    for (const history::TestRun& one : all) {
        QString line = QStringLiteral("%1 %2 %3 %4 %5")
                           .arg(one.uuid, one.kind, isoText(one.at), one.operatorName, one.note) +
                       one.files.join(u',');
        for (const history::TestServo& servo : one.servos)
            line += QStringLiteral(" %1:%2:%3:%4")
                        .arg(servo.id)
                        .arg(servo.model, servo.label)
                        .arg(servo.reference);
        lines << line << QString::fromUtf8(history.text(one.number).value());
    }
    return lines;
}

/// Everything there is to see.
inline QStringList everything(const history::History& history)
{
    return servos(history) + writes(history) + snapshots(history) + alarms(history) +
           recordings(history) + runs(history) + history.log().writtenKeys().value();
}
} // namespace history_example
