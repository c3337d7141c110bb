// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/snapshot/snapshots.h"

#include "jobs/restore/restore_many.h"
#include "jobs/restore/take_snapshot.h"
#include "session/snapshot/safety_snapshot.h"
#include "snapshot/factory_snapshot.h"
#include "snapshot/snapshot_template.h"

namespace session {
namespace {
base::Result<OpenedFile> openFile(const QString& path)
{
    auto snapshot = record::loadSnapshot(path);
    if (snapshot)
        return OpenedFile{path, std::make_shared<const record::Snapshot>(std::move(*snapshot)), {}};
    if (snapshot.error().code == base::ErrorCode::FileFormat) {
        if (auto bundle = record::loadBundle(path))
            return OpenedFile{path, {}, std::make_shared<const record::Bundle>(std::move(*bundle))};
        else if (path.endsWith(QLatin1StringView(".bundle.json")))
            return tl::unexpected(bundle.error());
    }
    return tl::unexpected(snapshot.error());
}
} // namespace

Snapshots::Snapshots(Desk& desk, HistoryService& historyService, QObject* parent)
    : QObject(parent)
    , m_desk(desk)
    , m_historyService(historyService)
{}

void Snapshots::setTaking(bool taking)
{
    m_taking = taking;
    Q_EMIT takingChanged();
}

/// Files wait for their disk on the archive's thread.
void Snapshots::saveInBackground(std::function<base::Result<void>()> write,
                                 std::function<void()> then, std::function<void(bool written)> keep)
{
    m_historyService.runInOrder(
        std::move(write), this,
        [this, then = std::move(then), keep = std::move(keep)](const base::Result<void>& done) {
            if (keep)
                keep(done.has_value());
            if (done)
                then();
            else
                Q_EMIT failed(done.error());
        });
}

void Snapshots::take(ServoRef servo, const SnapshotRequest& request)
{
    if (m_taking || m_desk.servo(servo) == nullptr)
        return;
    const auto found = std::make_shared<record::Snapshot>();
    Task task;
    task.name = QStringLiteral("snapshot");
    task.quiet = true;
    task.work = [request, found](TaskContext& context) -> base::Result<void> {
        auto snapshot = jobs::takeSnapshot(context.device, context.servo, programName());
        if (!snapshot)
            return tl::unexpected(snapshot.error());
        *found = std::move(*snapshot);
        found->label = request.label;
        found->note = request.note;
        return {};
    };
    task.guard = this;
    task.done = [this, request, found](const TaskCompletion& end) {
        setTaking(false);
        if (end.error) {
            Q_EMIT failed(*end.error);
            return;
        }
        const SharedSnapshot snapshot = found;
        if (request.path.isEmpty()) {
            m_historyService.saveHistorySnapshot(snapshot, record::SnapshotReason::Manual);
            Q_EMIT snapshotTaken(snapshot, {});
            return;
        }
        saveInBackground(
            [snapshot, path = request.path] { return record::saveSnapshot(*snapshot, path); },
            [this, snapshot, path = request.path] { Q_EMIT snapshotTaken(snapshot, path); },
            [this, snapshot, path = request.path](bool written) {
                m_historyService.saveHistorySnapshot(snapshot, record::SnapshotReason::Manual,
                                                     written ? path : QString());
            });
    };
    setTaking(true);
    m_desk.perform(servo, std::move(task));
}

void Snapshots::takeAll(const SnapshotRequest& request)
{
    if (m_taking)
        return;
    const auto servos = std::make_shared<std::vector<device::Servo>>();
    for (const ServoRef ref : m_desk.servos()) {
        const ServoEntry* entry = m_desk.servo(ref);
        if (entry->servo.profile && (!m_desk.canSetBaud() || entry->servo.baud == m_desk.baud()))
            servos->push_back(entry->servo);
    }
    const auto found = std::make_shared<record::Bundle>();
    Task task;
    task.name = QStringLiteral("snapshot");
    task.quiet = true;
    task.work = [request, servos, found](TaskContext& context) -> base::Result<void> {
        auto bundle = jobs::takeBundle(context.device, *servos, programName(), context.progress);
        if (!bundle)
            return tl::unexpected(bundle.error());
        *found = std::move(*bundle);
        found->label = request.label;
        found->note = request.note;
        return {};
    };
    task.guard = this;
    task.done = [this, request, found](const TaskCompletion& end) {
        setTaking(false);
        if (end.error) {
            Q_EMIT failed(*end.error);
            return;
        }
        const SharedBundle bundle = found;
        saveInBackground(
            [bundle, path = request.path] { return record::saveBundle(*bundle, path); },
            [this, bundle, path = request.path] { Q_EMIT bundleTaken(bundle, path); },
            [this, bundle, path = request.path](bool written) {
                for (const record::Snapshot& one : bundle->servos)
                    m_historyService.saveHistorySnapshot(
                        std::make_shared<const record::Snapshot>(one),
                        record::SnapshotReason::Bundle, written ? path : QString());
            });
    };
    setTaking(true);
    m_desk.perform(0, std::move(task));
}

SharedSnapshot Snapshots::currentSnapshot(ServoRef servo) const
{
    const ServoEntry* entry = m_desk.servo(servo);
    if (entry == nullptr || !entry->servo.profile)
        return nullptr;
    return std::make_shared<const record::Snapshot>(jobs::snapshotOf(entry->servo, programName()));
}

SharedSnapshot Snapshots::factorySnapshot(const record::Snapshot& like) const
{
    const auto profile = record::profileOf(like, m_desk.catalog());
    return profile ? std::make_shared<const record::Snapshot>(record::factorySnapshot(*profile))
                   : nullptr;
}

base::Result<SharedSnapshot> Snapshots::toTemplate(const record::Snapshot& from,
                                                   const QStringList& keys,
                                                   const SnapshotRequest& request) const
{
    auto made = record::makeTemplate(from, keys);
    if (!made)
        return tl::unexpected(made.error());
    made->label = request.label;
    made->note = request.note;
    return std::make_shared<const record::Snapshot>(std::move(*made));
}

void Snapshots::open(const QString& path)
{
    const auto found = std::make_shared<OpenedFile>();
    saveInBackground(
        [path, found]() -> base::Result<void> {
            auto opened = openFile(path);
            if (!opened)
                return tl::unexpected(opened.error());
            *found = std::move(*opened);
            return {};
        },
        [this, found] { Q_EMIT fileOpened(*found); });
}

void Snapshots::save(SharedSnapshot snapshot, const QString& path)
{
    saveInBackground(
        [snapshot = std::move(snapshot), path] {
            return path.endsWith(QLatin1StringView(".csv"), Qt::CaseInsensitive)
                       ? record::saveSnapshotCsv(*snapshot, path)
                       : record::saveSnapshot(*snapshot, path);
        },
        [this, path] { Q_EMIT saved(path); });
}

void Snapshots::save(std::vector<record::RestoreResult> results, const QString& path)
{
    saveInBackground(
        [results = std::move(results), path] { return record::saveRestoreResults(results, path); },
        [this, path] { Q_EMIT saved(path); });
}
} // namespace session
