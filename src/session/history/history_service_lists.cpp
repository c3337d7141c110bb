// SPDX-License-Identifier: GPL-3.0-or-later
// The history besides the test runs, for the window: pages of lists, labels, exports.
#include "session/history/history_service.h"

namespace session {
using record::History;
using record::HistoryFilter;

namespace {
record::SavedRun
outcomeOf(const QString& path,
          const std::function<base::Result<void>(const record::HistoryLog&)>& action)
{
    const auto history = History::open(path);
    const auto done =
        history ? action((*history)->log()) : base::Result<void>(tl::unexpected(history.error()));
    record::SavedRun kept;
    if (!done)
        kept.trouble = done.error();
    return kept;
}

base::Result<void> eachOf(const std::vector<std::int64_t>& numbers,
                          const std::function<base::Result<void>(std::int64_t)>& action)
{
    for (const std::int64_t number : numbers) {
        if (const auto done = action(number); !done)
            return done;
    }
    return {};
}

template <typename T>
base::Result<void> withoutValue(const base::Result<T>& result)
{
    return result ? base::Result<void>() : tl::unexpected(result.error());
}
} // namespace

void HistoryService::saveAlarm(const base::ServoIdentity& identity, const QString& key,
                               bool derived, bool came, const QDateTime& at)
{
    saveLater(
        [=](const QString& path) {
            return outcomeOf(path, [&](const record::HistoryLog& log) {
                return came ? log.recordAlarmStart(identity, key, derived, at)
                            : log.recordAlarmEnd(identity, key, at);
            });
        },
        Kind::Other);
}

void HistoryService::saveRecording(const record::HistoryRecording& recording,
                                   const std::vector<base::ServoIdentity>& servos)
{
    saveLater(
        [=](const QString& path) {
            return outcomeOf(path, [&](const record::HistoryLog& log) {
                return withoutValue(log.addRecording(recording, servos));
            });
        },
        Kind::Other);
}

void HistoryService::saveHistorySnapshot(SharedSnapshot snapshot, record::SnapshotReason reason,
                                         const QString& file)
{
    saveLater(
        [snapshot = std::move(snapshot), reason, file](const QString& path) {
            return outcomeOf(path, [&](const record::HistoryLog& log) {
                return withoutValue(log.addSnapshot(*snapshot, reason, file));
            });
        },
        Kind::Other);
}

void HistoryService::servos(const HistoryFilter& filter, QObject* context,
                            Answer<std::vector<record::HistoryServo>> answer)
{
    query<std::vector<record::HistoryServo>>(
        [filter](History& history) { return history.log().servos(filter); }, context,
        std::move(answer));
}

void HistoryService::writes(const HistoryFilter& filter, QObject* context,
                            Answer<std::vector<record::HistoryWrite>> answer)
{
    query<std::vector<record::HistoryWrite>>(
        [filter](History& history) { return history.log().writes(filter); }, context,
        std::move(answer));
}

void HistoryService::countWrites(const HistoryFilter& filter, QObject* context,
                                 Answer<std::int64_t> answer)
{
    query<std::int64_t>([filter](History& history) { return history.log().countWrites(filter); },
                        context, std::move(answer));
}

void HistoryService::writtenKeys(std::optional<std::int64_t> servo, QObject* context,
                                 Answer<QStringList> answer)
{
    query<QStringList>([servo](History& history) { return history.log().writtenKeys(servo); },
                       context, std::move(answer));
}

void HistoryService::snapshots(const HistoryFilter& filter, QObject* context,
                               Answer<std::vector<record::HistorySnapshot>> answer)
{
    query<std::vector<record::HistorySnapshot>>(
        [filter](History& history) { return history.log().snapshots(filter); }, context,
        std::move(answer));
}

void HistoryService::loadSnapshot(std::int64_t number, QObject* context,
                                  Answer<SharedSnapshot> answer)
{
    query<SharedSnapshot>(
        [number](History& history) -> base::Result<SharedSnapshot> {
            auto snapshot = history.log().snapshot(number);
            if (!snapshot)
                return tl::unexpected(snapshot.error());
            return std::make_shared<const record::Snapshot>(std::move(*snapshot));
        },
        context, std::move(answer));
}

void HistoryService::tableAt(const catalog::Catalog& catalog, std::int64_t servo,
                             const QDateTime& at, QObject* context,
                             Answer<record::TableState> answer)
{
    // A copy shares what it was loaded with.
    query<record::TableState>(
        [models = catalog, servo, at](History& history) {
            return record::tableAt(history.file(), models, servo, at);
        },
        context, std::move(answer));
}

void HistoryService::alarms(const HistoryFilter& filter, QObject* context,
                            Answer<std::vector<record::HistoryAlarm>> answer)
{
    query<std::vector<record::HistoryAlarm>>(
        [filter](History& history) { return history.log().alarms(filter); }, context,
        std::move(answer));
}

void HistoryService::recordings(const HistoryFilter& filter, QObject* context,
                                Answer<std::vector<record::HistoryRecording>> answer)
{
    query<std::vector<record::HistoryRecording>>(
        [filter](History& history) { return history.log().recordings(filter); }, context,
        std::move(answer));
}

void HistoryService::exportTo(const QString& path, bool csv,
                              const std::vector<record::HistoryKind>& kinds,
                              const HistoryFilter& filter, QObject* context,
                              Answer<std::int64_t> answer)
{
    query<std::int64_t>(
        [=](History& history) -> base::Result<std::int64_t> {
            if (!csv)
                return record::exportHistoryJson(history, kinds, filter, path);
            if (kinds.size() != 1)
                return base::fail(base::ErrorCode::BadArgument, QStringLiteral("export"),
                                  QStringLiteral("CSV takes one kind"));
            return record::exportHistoryCsv(history, kinds.front(), filter, path);
        },
        context, std::move(answer));
}

void HistoryService::loadStep(std::int64_t number, QObject* context, Answer<SharedStep> answer)
{
    query<SharedStep>(
        [number](History& history) -> base::Result<SharedStep> {
            auto run = history.step(number);
            if (!run)
                return tl::unexpected(run.error());
            return std::make_shared<const record::StepRun>(std::move(*run));
        },
        context, std::move(answer));
}

void HistoryService::setServoLabel(std::int64_t servo, const QString& label)
{
    change([=](History& history) { return history.log().setLabel(servo, label); });
}

void HistoryService::anotherServo(std::int64_t servo, const QString& label)
{
    change(
        [=](History& history) { return withoutValue(history.log().assignToOther(servo, label)); });
}

void HistoryService::setSnapshotNote(std::int64_t number, const QString& label, const QString& note)
{
    change([=](History& history) { return history.log().setSnapshotNote(number, label, note); });
}

void HistoryService::removeSnapshots(const std::vector<std::int64_t>& numbers)
{
    change([numbers](History& history) {
        return eachOf(numbers, [&](std::int64_t one) { return history.log().removeSnapshot(one); });
    });
}

void HistoryService::removeRecordings(const std::vector<std::int64_t>& numbers)
{
    change([numbers](History& history) {
        return eachOf(numbers,
                      [&](std::int64_t one) { return history.log().removeRecording(one); });
    });
}
} // namespace session
