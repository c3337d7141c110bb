// SPDX-License-Identifier: GPL-3.0-or-later
// The history besides the test runs, for the window: pages of lists, labels, exports.
#include "session/archive.h"

namespace session {
using record::History;
using record::HistoryFilter;

namespace {
record::KeptRun outcomeOf(const QString& path,
                          const std::function<base::Result<void>(const record::HistoryLog&)>& deed)
{
    const auto history = History::open(path);
    const auto done =
        history ? deed((*history)->log()) : base::Result<void>(tl::unexpected(history.error()));
    record::KeptRun kept;
    if (!done)
        kept.trouble = done.error();
    return kept;
}

base::Result<void> eachOf(const std::vector<std::int64_t>& numbers,
                          const std::function<base::Result<void>(std::int64_t)>& deed)
{
    for (const std::int64_t number : numbers) {
        if (const auto done = deed(number); !done)
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

void Archive::keepAlarm(const base::ServoIdentity& who, const QString& key, bool derived, bool came,
                        const QDateTime& at)
{
    keepLater(
        [=](const QString& path) {
            return outcomeOf(path, [&](const record::HistoryLog& log) {
                return came ? log.alarmCame(who, key, derived, at) : log.alarmWent(who, key, at);
            });
        },
        Kind::Other);
}

void Archive::keepRecording(const record::HistoryRecording& recording,
                            const std::vector<base::ServoIdentity>& servos)
{
    keepLater(
        [=](const QString& path) {
            return outcomeOf(path, [&](const record::HistoryLog& log) {
                return withoutValue(log.addRecording(recording, servos));
            });
        },
        Kind::Other);
}

void Archive::keepSnapshot(SharedSnapshot snapshot, record::SnapshotReason reason,
                           const QString& file)
{
    keepLater(
        [snapshot = std::move(snapshot), reason, file](const QString& path) {
            return outcomeOf(path, [&](const record::HistoryLog& log) {
                return withoutValue(log.addSnapshot(*snapshot, reason, file));
            });
        },
        Kind::Other);
}

void Archive::servos(const HistoryFilter& filter, QObject* context,
                     Answer<std::vector<record::HistoryServo>> answer)
{
    ask<std::vector<record::HistoryServo>>(
        [filter](History& history) { return history.log().servos(filter); }, context,
        std::move(answer));
}

void Archive::writes(const HistoryFilter& filter, QObject* context,
                     Answer<std::vector<record::HistoryWrite>> answer)
{
    ask<std::vector<record::HistoryWrite>>(
        [filter](History& history) { return history.log().writes(filter); }, context,
        std::move(answer));
}

void Archive::countWrites(const HistoryFilter& filter, QObject* context,
                          Answer<std::int64_t> answer)
{
    ask<std::int64_t>([filter](History& history) { return history.log().countWrites(filter); },
                      context, std::move(answer));
}

void Archive::writtenKeys(std::optional<std::int64_t> servo, QObject* context,
                          Answer<QStringList> answer)
{
    ask<QStringList>([servo](History& history) { return history.log().writtenKeys(servo); },
                     context, std::move(answer));
}

void Archive::snapshots(const HistoryFilter& filter, QObject* context,
                        Answer<std::vector<record::HistorySnapshot>> answer)
{
    ask<std::vector<record::HistorySnapshot>>(
        [filter](History& history) { return history.log().snapshots(filter); }, context,
        std::move(answer));
}

void Archive::loadSnapshot(std::int64_t number, QObject* context, Answer<SharedSnapshot> answer)
{
    ask<SharedSnapshot>(
        [number](History& history) -> base::Result<SharedSnapshot> {
            auto snapshot = history.log().snapshot(number);
            if (!snapshot)
                return tl::unexpected(snapshot.error());
            return std::make_shared<const record::Snapshot>(std::move(*snapshot));
        },
        context, std::move(answer));
}

void Archive::tableAt(const catalog::Catalog& catalog, std::int64_t servo, const QDateTime& at,
                      QObject* context, Answer<record::TablePoint> answer)
{
    // A copy shares what it was loaded with.
    ask<record::TablePoint>(
        [models = catalog, servo, at](History& history) {
            return record::tableAt(history.file(), models, servo, at);
        },
        context, std::move(answer));
}

void Archive::alarms(const HistoryFilter& filter, QObject* context,
                     Answer<std::vector<record::HistoryAlarm>> answer)
{
    ask<std::vector<record::HistoryAlarm>>(
        [filter](History& history) { return history.log().alarms(filter); }, context,
        std::move(answer));
}

void Archive::recordings(const HistoryFilter& filter, QObject* context,
                         Answer<std::vector<record::HistoryRecording>> answer)
{
    ask<std::vector<record::HistoryRecording>>(
        [filter](History& history) { return history.log().recordings(filter); }, context,
        std::move(answer));
}

void Archive::exportTo(const QString& path, bool csv, const std::vector<record::HistoryKind>& kinds,
                       const HistoryFilter& filter, QObject* context, Answer<std::int64_t> answer)
{
    ask<std::int64_t>(
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

void Archive::loadStep(std::int64_t number, QObject* context, Answer<SharedStep> answer)
{
    ask<SharedStep>(
        [number](History& history) -> base::Result<SharedStep> {
            auto run = history.step(number);
            if (!run)
                return tl::unexpected(run.error());
            return std::make_shared<const record::StepRun>(std::move(*run));
        },
        context, std::move(answer));
}

void Archive::setServoLabel(std::int64_t servo, const QString& label)
{
    change([=](History& history) { return history.log().setLabel(servo, label); });
}

void Archive::anotherServo(std::int64_t servo, const QString& label)
{
    change([=](History& history) { return withoutValue(history.log().another(servo, label)); });
}

void Archive::setSnapshotNote(std::int64_t number, const QString& label, const QString& note)
{
    change([=](History& history) { return history.log().setSnapshotNote(number, label, note); });
}

void Archive::removeSnapshots(const std::vector<std::int64_t>& numbers)
{
    change([numbers](History& history) {
        return eachOf(numbers, [&](std::int64_t one) { return history.log().removeSnapshot(one); });
    });
}

void Archive::removeRecordings(const std::vector<std::int64_t>& numbers)
{
    change([numbers](History& history) {
        return eachOf(numbers,
                      [&](std::int64_t one) { return history.log().removeRecording(one); });
    });
}
} // namespace session
