// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/commission/commissioning.h"

#include "device/write_meaning.h"
#include "report/commission_report.h"
#include "session/commission/commission_labels.h"
#include "session/snapshot/safety_snapshot.h"

#include <QDir>
#include <QFileInfo>
#include <QStandardPaths>

#include <atomic>
#include <mutex>

namespace session {
constexpr auto drainInterval = std::chrono::milliseconds(40);

/// Filled on the job's thread, emptied on the main thread: the latest counts.
struct Commissioning::Live {
    std::atomic<jobs::CommissionAnswer> answer = jobs::CommissionAnswer::None;
    std::atomic<bool> canceled = false; ///< before it began
    std::mutex mutex;
    std::optional<jobs::CommissionView> view{};
    std::optional<results::CommissionBatch> batch{};

    void show(const jobs::CommissionView& now)
    {
        answer = jobs::CommissionAnswer::None; // an answer belongs to the question that was shown
        const std::lock_guard lock(mutex);
        view = now;
    }
    void show(const results::CommissionBatch& now)
    {
        const std::lock_guard lock(mutex);
        batch = now;
    }
};

Commissioning::Commissioning(Workbench& workbench, QObject* parent)
    : QObject(parent)
    , m_workbench(workbench)
    , m_post(std::make_shared<GuardedPoster>(m_mainQueue))
{
    m_drainTimer.setInterval(drainInterval);
    connect(&m_drainTimer, &QTimer::timeout, this, &Commissioning::drain);
}

Commissioning::~Commissioning()
{
    m_post->close();
    if (m_running)
        m_live->canceled = true; // the workbench ends its task when it closes
}

void Commissioning::drain()
{
    std::optional<jobs::CommissionView> view;
    std::optional<results::CommissionBatch> batch;
    {
        const std::lock_guard lock(m_live->mutex);
        view.swap(m_live->view);
        batch.swap(m_live->batch);
    }
    if (batch) {
        m_filesAccepted = true;
        m_batch = std::move(*batch);
        Q_EMIT batchChanged();
    }
    if (view) {
        m_view = std::move(*view);
        Q_EMIT changed();
    }
}

namespace {
base::Result<void> takeTemplate(jobs::CommissionSpec& spec, const QString& file)
{
    if (file.isEmpty())
        return {};
    auto snapshot = snapshot::loadSnapshot(file);
    if (!snapshot)
        return tl::unexpected(snapshot.error());
    spec.settings = std::move(*snapshot);
    spec.templateName = QFileInfo(file).fileName();
    return {};
}
} // namespace

bool Commissioning::start(const jobs::CommissionSpec& spec, const QString& csvPath,
                          const QString& templateFile)
{
    if (m_running || m_workbench.link().state() != LinkState::Open)
        return false;
    m_running = true;
    m_view = {};
    if (m_csvPath != csvPath) {
        m_csvPath = csvPath;
        m_batch = {};
        Q_EMIT batchChanged();
    }
    m_filesAccepted = false;
    m_baud = spec.baud;
    ++m_checkNumber; // a check that is still running comes too late
    m_live = std::make_shared<Live>();
    const auto live = m_live;
    Task task;
    task.name = QStringLiteral("commission");
    task.isLongRunning = true;
    task.quiet = true;
    task.work = [=](TaskContext& context) mutable -> base::Result<void> {
        if (live->canceled)
            return base::fail(base::ErrorCode::Stopped, QStringLiteral("commission"));
        jobs::CommissionSpec order = spec;
        if (const auto taken = takeTemplate(order, templateFile); !taken)
            return taken;
        auto batch = results::openCommissionBatch(csvPath);
        if (!batch)
            return tl::unexpected(batch.error());
        batch->program = programName();
        live->show(*batch);
        jobs::CommissionCallbacks callbacks;
        callbacks.onChange = [live](const jobs::CommissionView& view) { live->show(view); };
        callbacks.onBatch = [&] { live->show(*batch); };
        callbacks.answer = [live] { return live->answer.exchange(jobs::CommissionAnswer::None); };
        callbacks.save = [](const device::Context& with, device::Servo& servo) {
            return saveSafetySnapshot(with, servo, history::SnapshotReason::Commission);
        };
        CommissionLabels names;
        callbacks.onNewServo = [&names](const device::Servo& servo) {
            return names.servoFound(servo);
        };
        callbacks.name = [&names](const device::Servo& servo, const QString& label, bool another) {
            return names.setLabel(servo, label, another);
        };
        const auto end = jobs::commission(context.device, order, *batch, csvPath, callbacks);
        live->show(*batch);
        return end ? base::Result<void>() : tl::unexpected(end.error());
    };
    task.guard = this;
    task.done = [this](const TaskCompletion& end) { finish(end); };
    m_drainTimer.start();
    m_workbench.tasks().perform(0, std::move(task));
    Q_EMIT started();
    return true;
}

void Commissioning::finish(const TaskCompletion& end)
{
    m_drainTimer.stop();
    drain();
    m_running = false;
    const bool stopped = end.error && end.error->code == base::ErrorCode::Stopped;
    if (m_filesAccepted && (!end.error || stopped))
        restartSearch();
    Q_EMIT finished(stopped ? std::nullopt : end.error);
}

/// The servos of the list were disconnected, or have another ID now.
void Commissioning::restartSearch()
{
    jobs::ScanSpec spec;
    std::set<int> rates{m_workbench.link().baud()};
    if (m_workbench.link().canSetBaud()) {
        if (m_baud > 0)
            rates.insert(m_baud);
        for (const ServoRef ref : m_workbench.registry().order())
            rates.insert(m_workbench.registry().servo(ref)->servo.baud);
        spec.bauds.assign(rates.begin(), rates.end());
    }
    m_workbench.search().start(spec);
}

namespace {
struct FileCheckResult {
    results::CommissionBatch batch;
    CommissionFileCheck files;
};

FileCheckResult checkFilesAt(const catalog::Catalog& catalog, const QString& csvPath,
                             const QString& templateFile)
{
    FileCheckResult seen;
    if (!csvPath.isEmpty()) {
        auto batch = results::openCommissionBatch(csvPath);
        if (batch)
            seen.batch = std::move(*batch);
        else
            seen.files.batchError = batch.error();
    }
    if (!templateFile.isEmpty()) {
        const auto settings = snapshot::loadSnapshot(templateFile);
        if (settings)
            seen.files.dangerous = dangerousKeys(catalog, *settings);
        else
            seen.files.templateError = settings.error();
    }
    return seen;
}
} // namespace

void Commissioning::checkFiles(const QString& csvPath, const QString& templateFile)
{
    if (m_running)
        return;
    const int number = ++m_checkNumber;
    m_fileThread.start([=, this, post = m_post, catalog = m_workbench.catalog()] {
        auto seen = std::make_shared<FileCheckResult>(checkFilesAt(catalog, csvPath, templateFile));
        post->post([=, this] {
            if (number != m_checkNumber || m_running)
                return;
            m_csvPath = csvPath;
            m_batch = std::move(seen->batch);
            m_files = std::move(seen->files);
            Q_EMIT batchChanged();
            Q_EMIT filesChecked();
        });
    });
}

namespace {
bool isAngleLimit(const catalog::Register& reg)
{
    return reg.role == catalog::Role::MinAngle || reg.role == catalog::Role::MaxAngle;
}

bool canRemoveAngleLimits(const catalog::Profile& profile, const snapshot::Snapshot& settings)
{
    device::RegisterValues items;
    for (const snapshot::SnapshotRegister& row : settings.registers) {
        if (const catalog::Register* reg = profile.find(row.key); reg != nullptr && row.raw)
            items.push_back({reg, *row.raw});
    }
    return device::canRemoveAngleLimits(profile, items);
}
} // namespace

QStringList dangerousKeys(const catalog::Catalog& catalog, const snapshot::Snapshot& settings)
{
    const QStringList firmware = settings.servo.firmware.split(QLatin1Char('.'));
    const auto profileOf = [&](const catalog::ModelEntry& model) {
        return catalog.profileFor(model, firmware.value(0).toInt(), firmware.value(1).toInt());
    };
    // Of an unknown model: the registers that are dangerous in any model.
    std::vector<catalog::ProfilePtr> profiles;
    if (const catalog::ModelEntry* model = catalog.model(settings.servo.model)) {
        profiles.push_back(profileOf(*model));
    } else {
        for (const catalog::ModelEntry& one : catalog.models())
            profiles.push_back(profileOf(one));
    }
    QStringList keys;
    for (const snapshot::SnapshotRegister& row : settings.registers) {
        const bool dangerous =
            std::any_of(profiles.begin(), profiles.end(), [&](const catalog::ProfilePtr& one) {
                const catalog::Register* reg = one ? one->find(row.key) : nullptr;
                return reg != nullptr && !reg->identity && reg->writable() &&
                       (device::alwaysNeedsConsent(*reg) ||
                        (isAngleLimit(*reg) && canRemoveAngleLimits(*one, settings)));
            });
        if (dangerous && row.raw)
            keys.append(row.key);
    }
    return keys;
}

QString defaultBatchPath(const QDate& today)
{
    const QString documents = QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation);
    const bool ownPlace = !qEnvironmentVariableIsEmpty("SERVODESK_DATA_DIR");
    const QDir folder(ownPlace                   ? dataFolder()
                      : QDir(documents).exists() ? documents
                                                 : QDir::homePath());
    const QString stem = QStringLiteral("servodesk-batch-%1").arg(today.toString(Qt::ISODate));
    QString path = folder.filePath(stem + QStringLiteral(".csv"));
    const auto foreign = [](const QString& csv) {
        return QFileInfo::exists(csv) && !QFileInfo::exists(results::commissionStatePath(csv));
    };
    for (int n = 2; foreign(path); ++n)
        path = folder.filePath(QStringLiteral("%1-%2.csv").arg(stem).arg(n));
    return path;
}

void Commissioning::stop()
{
    if (!m_running)
        return;
    m_live->canceled = true;
    m_workbench.tasks().stopTest();
}

void Commissioning::submitAnswer(jobs::CommissionAnswer answer)
{
    if (m_running && m_view.step == jobs::CommissionStep::Confirm)
        m_live->answer = answer;
}

bool Commissioning::hasHotplugQueue() const
{
    return m_workbench.link().connection() != nullptr &&
           m_workbench.link().connection()->hasHotplugQueue();
}

void Commissioning::saveReport(const QString& path, bool chinese)
{
    m_fileThread.start(
        [=, this, batch = m_batch, name = QFileInfo(m_csvPath).fileName(), post = m_post] {
            const auto saved = report::saveCommissionReport(batch, name, chinese, path);
            post->post([=, this] {
                if (saved)
                    Q_EMIT reportSaved(path);
                else
                    Q_EMIT saveFailed(saved.error());
            });
        });
}

std::size_t Commissioning::pendingServoCount() const
{
    return m_workbench.link().connection() != nullptr
               ? m_workbench.link().connection()->pendingServoCount()
               : 0;
}

void Commissioning::connectNext()
{
    if (m_workbench.link().connection() != nullptr)
        (void)m_workbench.link().connection()->connectNext();
}

void Commissioning::unplug()
{
    if (m_workbench.link().connection() != nullptr)
        m_workbench.link().connection()->unplugAll();
}
} // namespace session
