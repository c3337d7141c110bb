// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/snapshot/snapshots.h"

#include "jobs/restore/restore_many.h"
#include "jobs/restore/take_snapshot.h"
#include "report/report_file.h"
#include "report/snapshot_report.h"
#include "session/snapshot/safety_snapshot.h"
#include "snapshot/factory_snapshot.h"
#include "snapshot/snapshot_template.h"

namespace session {
namespace {
base::Result<OpenedFile> openFile(const QString& path)
{
    auto snapshot = snapshot::loadSnapshot(path);
    if (snapshot)
        return OpenedFile{
            path, std::make_shared<const snapshot::Snapshot>(std::move(*snapshot)), {}};
    if (snapshot.error().code == base::ErrorCode::FileFormat) {
        if (auto bundle = snapshot::loadBundle(path))
            return OpenedFile{
                path, {}, std::make_shared<const snapshot::Bundle>(std::move(*bundle))};
        else if (path.endsWith(QLatin1StringView(".bundle.json")))
            return tl::unexpected(bundle.error());
    }
    return tl::unexpected(snapshot.error());
}
} // namespace

Snapshots::Snapshots(Workbench& workbench, HistoryService& historyService, QObject* parent)
    : QObject(parent)
    , m_workbench(workbench)
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
    if (m_taking || m_workbench.registry().servo(servo) == nullptr)
        return;
    const auto found = std::make_shared<snapshot::Snapshot>();
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
            m_historyService.saveHistorySnapshot(snapshot, history::SnapshotReason::Manual);
            Q_EMIT snapshotTaken(snapshot, {});
            return;
        }
        saveInBackground(
            [snapshot, path = request.path] { return snapshot::saveSnapshot(*snapshot, path); },
            [this, snapshot, path = request.path] { Q_EMIT snapshotTaken(snapshot, path); },
            [this, snapshot, path = request.path](bool written) {
                m_historyService.saveHistorySnapshot(snapshot, history::SnapshotReason::Manual,
                                                     written ? path : QString());
            });
    };
    setTaking(true);
    m_workbench.tasks().perform(servo, std::move(task));
}

void Snapshots::takeAll(const SnapshotRequest& request)
{
    if (m_taking)
        return;
    const auto servos = std::make_shared<std::vector<device::Servo>>();
    for (const ServoRef ref : m_workbench.registry().order()) {
        const ServoEntry* entry = m_workbench.registry().servo(ref);
        if (entry->servo.profile &&
            (!m_workbench.link().canSetBaud() || entry->servo.baud == m_workbench.link().baud()))
            servos->push_back(entry->servo);
    }
    const auto found = std::make_shared<snapshot::Bundle>();
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
            [bundle, path = request.path] { return snapshot::saveBundle(*bundle, path); },
            [this, bundle, path = request.path] { Q_EMIT bundleTaken(bundle, path); },
            [this, bundle, path = request.path](bool written) {
                for (const snapshot::Snapshot& one : bundle->servos)
                    m_historyService.saveHistorySnapshot(
                        std::make_shared<const snapshot::Snapshot>(one),
                        history::SnapshotReason::Bundle, written ? path : QString());
            });
    };
    setTaking(true);
    m_workbench.tasks().perform(0, std::move(task));
}

SharedSnapshot Snapshots::currentSnapshot(ServoRef servo) const
{
    const ServoEntry* entry = m_workbench.registry().servo(servo);
    if (entry == nullptr || !entry->servo.profile)
        return nullptr;
    return std::make_shared<const snapshot::Snapshot>(
        jobs::snapshotOf(entry->servo, programName()));
}

SharedSnapshot Snapshots::factorySnapshot(const snapshot::Snapshot& like) const
{
    const auto profile = snapshot::profileOf(like, m_workbench.catalog());
    return profile ? std::make_shared<const snapshot::Snapshot>(snapshot::factorySnapshot(*profile))
                   : nullptr;
}

base::Result<SharedSnapshot> Snapshots::toTemplate(const snapshot::Snapshot& from,
                                                   const QStringList& keys,
                                                   const SnapshotRequest& request) const
{
    auto made = snapshot::makeTemplate(from, keys);
    if (!made)
        return tl::unexpected(made.error());
    made->label = request.label;
    made->note = request.note;
    return std::make_shared<const snapshot::Snapshot>(std::move(*made));
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

void Snapshots::save(SharedSnapshot snapshot, const QString& path, bool chinese)
{
    saveInBackground(
        [snapshot = std::move(snapshot), catalog = m_workbench.catalog(), path, chinese] {
            if (report::isReportPath(path))
                return report::saveSnapshotReport(*snapshot, catalog, chinese, path);
            return path.endsWith(QLatin1StringView(".csv"), Qt::CaseInsensitive)
                       ? snapshot::saveSnapshotCsv(*snapshot, path)
                       : snapshot::saveSnapshot(*snapshot, path);
        },
        [this, path] { Q_EMIT saved(path); });
}

void Snapshots::save(std::vector<snapshot::RestoreResult> results, const QString& path)
{
    saveInBackground(
        [results = std::move(results), path] {
            return snapshot::saveRestoreResults(results, path, files::CsvReader::Spreadsheet);
        },
        [this, path] { Q_EMIT saved(path); });
}
} // namespace session
