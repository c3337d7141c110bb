// SPDX-License-Identifier: GPL-3.0-or-later
// The history besides the test runs, for the window: pages of lists, labels, exports, and what only
// a history server knows.
#include "session/history/history_service.h"

namespace session {
using history::History;
using history::HistoryFilter;
using history::HistoryServer;

namespace {
history::SavedRun
outcomeOf(const QString& path,
          const std::function<base::Result<void>(const history::HistoryLog&)>& action)
{
    const auto history = History::open(path);
    const auto done =
        history ? action((*history)->log()) : base::Result<void>(tl::unexpected(history.error()));
    history::SavedRun kept;
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

void HistoryService::saveAlarm(const base::ServoIdentity& identity, const AlarmChange& change)
{
    saveLater(
        [=](const QString& path) {
            return outcomeOf(path, [&](const history::HistoryLog& log) {
                return recordAlarm(log, identity, change);
            });
        },
        Kind::Other);
}

void HistoryService::saveRecording(const history::HistoryRecording& recording,
                                   const std::vector<base::ServoIdentity>& servos)
{
    saveLater(
        [=](const QString& path) {
            return outcomeOf(path, [&](const history::HistoryLog& log) {
                return withoutValue(log.addRecording(recording, servos));
            });
        },
        Kind::Other);
}

void HistoryService::saveHistorySnapshot(SharedSnapshot snapshot, history::SnapshotReason reason,
                                         const QString& file)
{
    saveLater(
        [snapshot = std::move(snapshot), reason, file](const QString& path) {
            return outcomeOf(path, [&](const history::HistoryLog& log) {
                return withoutValue(log.addSnapshot(*snapshot, reason, file));
            });
        },
        Kind::Other);
}

void HistoryService::servos(const HistoryFilter& filter, QObject* context,
                            Answer<std::vector<history::HistoryServo>> answer)
{
    query([filter](History& history) { return history.log().servos(filter); }, context,
          std::move(answer));
}

void HistoryService::writes(const HistoryFilter& filter, QObject* context,
                            Answer<std::vector<history::HistoryWrite>> answer)
{
    query([filter](History& history) { return history.log().writes(filter); }, context,
          std::move(answer));
}

void HistoryService::countWrites(const HistoryFilter& filter, QObject* context,
                                 Answer<std::int64_t> answer)
{
    query([filter](History& history) { return history.log().countWrites(filter); }, context,
          std::move(answer));
}

void HistoryService::writtenKeys(std::optional<std::int64_t> servo, QObject* context,
                                 Answer<QStringList> answer)
{
    query([servo](History& history) { return history.log().writtenKeys(servo); }, context,
          std::move(answer));
}

void HistoryService::snapshots(const HistoryFilter& filter, QObject* context,
                               Answer<std::vector<history::HistorySnapshot>> answer)
{
    query([filter](History& history) { return history.log().snapshots(filter); }, context,
          std::move(answer));
}

void HistoryService::loadSnapshot(std::int64_t number, QObject* context,
                                  Answer<SharedSnapshot> answer)
{
    query(
        [number](History& history) -> base::Result<SharedSnapshot> {
            auto snapshot = history.log().snapshot(number);
            if (!snapshot)
                return tl::unexpected(snapshot.error());
            return std::make_shared<const snapshot::Snapshot>(std::move(*snapshot));
        },
        context, std::move(answer));
}

void HistoryService::tableAt(const catalog::Catalog& catalog, std::int64_t servo,
                             const QDateTime& at, QObject* context,
                             Answer<history::TableState> answer)
{
    // A copy shares what it was loaded with.
    query([models = catalog, servo,
           at](History& history) { return history::tableAt(history.file(), models, servo, at); },
          context, std::move(answer));
}

void HistoryService::alarms(const HistoryFilter& filter, QObject* context,
                            Answer<std::vector<history::HistoryAlarm>> answer)
{
    query([filter](History& history) { return history.log().alarms(filter); }, context,
          std::move(answer));
}

void HistoryService::recordings(const HistoryFilter& filter, QObject* context,
                                Answer<std::vector<history::HistoryRecording>> answer)
{
    query([filter](History& history) { return history.log().recordings(filter); }, context,
          std::move(answer));
}

void HistoryService::exportTo(const QString& path, bool csv,
                              const std::vector<history::HistoryKind>& kinds,
                              const HistoryFilter& filter, QObject* context,
                              Answer<std::int64_t> answer)
{
    query(
        [=](History& history) -> base::Result<std::int64_t> {
            if (!csv)
                return history::exportHistoryJson(history, kinds, filter, path);
            if (kinds.size() != 1)
                return base::fail(base::ErrorCode::BadArgument, QStringLiteral("export"),
                                  QStringLiteral("CSV takes one kind"));
            return history::exportHistoryCsv(history, kinds.front(), filter, path,
                                             files::CsvReader::Spreadsheet);
        },
        context, std::move(answer));
}

void HistoryService::loadStep(std::int64_t number, QObject* context, Answer<SharedStep> answer)
{
    query(
        [number](History& history) -> base::Result<SharedStep> {
            auto run = history.step(number);
            if (!run)
                return tl::unexpected(run.error());
            return std::make_shared<const results::StepRun>(std::move(*run));
        },
        context, std::move(answer));
}

void HistoryService::setServoLabel(std::int64_t servo, const QString& label)
{
    change([=](History& history) { return history.log().setLabel(servo, label); });
}

void HistoryService::setSnapshotNote(std::int64_t number, const QString& label, const QString& note)
{
    change([=](History& history) { return history.log().setSnapshotNote(number, label, note); });
}

void HistoryService::remove(const std::vector<std::int64_t>& numbers)
{
    change([numbers](History& history) {
        return eachOf(numbers, [&](std::int64_t one) { return history.remove(one); });
    });
}

void HistoryService::removeSnapshots(const std::vector<std::int64_t>& numbers)
{
    change([numbers](History& history) {
        return eachOf(numbers, [&](std::int64_t one) { return history.log().removeSnapshot(one); });
    });
}

void HistoryService::benches(QObject* context, Answer<std::vector<history::HistoryBench>> answer)
{
    using Benches = std::vector<history::HistoryBench>;
    query(
        [](History& history) -> base::Result<Benches> {
            const auto* server = dynamic_cast<const HistoryServer*>(&history.file());
            return server == nullptr ? Benches() : server->benches();
        },
        context, std::move(answer));
}

void HistoryService::benchNames(const QString& table, const std::vector<std::int64_t>& numbers,
                                QObject* context, Answer<QMap<qint64, QString>> answer)
{
    using Names = QMap<qint64, QString>;
    query(
        [table, numbers](History& history) -> base::Result<Names> {
            const auto* server = dynamic_cast<const HistoryServer*>(&history.file());
            return server == nullptr ? Names() : server->benchNames(table, numbers);
        },
        context, std::move(answer));
}
} // namespace session
