// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/commissioning.h"

#include "session/commission_names.h"
#include "session/safety_snapshot.h"

#include <QDir>
#include <QFileInfo>
#include <QStandardPaths>

#include <atomic>
#include <mutex>

namespace session {
constexpr auto drainEvery = std::chrono::milliseconds(40);

/// Filled on the job's thread, emptied on the main thread: the latest counts.
struct Commissioning::Live {
    std::atomic<jobs::CommissionAnswer> answer = jobs::CommissionAnswer::None;
    std::atomic<bool> cancelled = false; ///< before it began
    std::mutex mutex;
    std::optional<jobs::CommissionView> view{};
    std::optional<record::CommissionBatch> batch{};

    void show(const jobs::CommissionView& now)
    {
        answer = jobs::CommissionAnswer::None; // a click belongs to what was shown
        const std::lock_guard lock(mutex);
        view = now;
    }
    void show(const record::CommissionBatch& now)
    {
        const std::lock_guard lock(mutex);
        batch = now;
    }
};

Commissioning::Commissioning(Desk& desk, QObject* parent)
    : QObject(parent)
    , m_desk(desk)
    , m_post(std::make_shared<LoosePost>(m_inbox))
{
    m_drainTimer.setInterval(drainEvery);
    connect(&m_drainTimer, &QTimer::timeout, this, &Commissioning::drain);
}

Commissioning::~Commissioning()
{
    m_post->close();
    if (m_running)
        m_live->cancelled = true; // the desk ends its task when it closes
}

void Commissioning::drain()
{
    std::optional<jobs::CommissionView> view;
    std::optional<record::CommissionBatch> batch;
    {
        const std::lock_guard lock(m_live->mutex);
        view.swap(m_live->view);
        batch.swap(m_live->batch);
    }
    if (batch) {
        m_begun = true;
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
    auto snapshot = record::loadSnapshot(file);
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
    if (m_running || m_desk.state() != LinkState::Open)
        return false;
    m_running = true;
    m_view = {};
    m_csvPath = csvPath;
    m_batch = {};
    m_begun = false;
    m_baud = spec.baud;
    ++m_looks; // what is still being looked at comes too late
    m_live = std::make_shared<Live>();
    const auto live = m_live;
    Task task;
    task.name = QStringLiteral("commission");
    task.lasting = true;
    task.quiet = true;
    task.work = [=](TaskContext& context) mutable -> base::Result<void> {
        if (live->cancelled)
            return base::fail(base::ErrorCode::Stopped, QStringLiteral("commission"));
        jobs::CommissionSpec order = spec;
        if (const auto taken = takeTemplate(order, templateFile); !taken)
            return taken;
        auto batch = record::openCommissionBatch(csvPath);
        if (!batch)
            return tl::unexpected(batch.error());
        batch->program = programName();
        live->show(*batch);
        jobs::CommissionHooks hooks;
        hooks.onChange = [live](const jobs::CommissionView& view) { live->show(view); };
        hooks.onBatch = [&] { live->show(*batch); };
        hooks.answer = [live] { return live->answer.exchange(jobs::CommissionAnswer::None); };
        hooks.save = [](const device::Context& with, device::Servo& servo) {
            return saveSafetySnapshot(with, servo, record::SnapshotReason::Commission);
        };
        CommissionNames names;
        hooks.meet = [&names](const device::Servo& servo) { return names.meet(servo); };
        hooks.name = [&names](const device::Servo& servo, const QString& label, bool another) {
            return names.name(servo, label, another);
        };
        const auto end = jobs::commission(context.device, order, *batch, csvPath, hooks);
        live->show(*batch);
        return end ? base::Result<void>() : tl::unexpected(end.error());
    };
    task.guard = this;
    task.done = [this](const TaskEnd& end) { finish(end); };
    m_drainTimer.start();
    m_desk.perform(0, std::move(task));
    Q_EMIT began();
    return true;
}

void Commissioning::finish(const TaskEnd& end)
{
    m_drainTimer.stop();
    drain();
    m_running = false;
    const bool stopped = end.error && end.error->code == base::ErrorCode::Stopped;
    if (m_begun && (!end.error || stopped))
        searchAnew();
    Q_EMIT ended(stopped ? std::nullopt : end.error);
}

/// Whoever was in the list has been unplugged, or answers elsewhere now.
void Commissioning::searchAnew()
{
    jobs::ScanSpec spec;
    std::set<int> rates{m_desk.baud()};
    if (m_desk.hasBaud()) {
        if (m_baud > 0)
            rates.insert(m_baud);
        for (const ServoRef ref : m_desk.servos())
            rates.insert(m_desk.servo(ref)->servo.baud);
        spec.bauds.assign(rates.begin(), rates.end());
    }
    m_desk.search(spec);
}

namespace {
struct Looked {
    record::CommissionBatch batch;
    CommissionFiles files;
};

Looked lookAt(const catalog::Catalog& catalog, const QString& csvPath, const QString& templateFile)
{
    Looked seen;
    if (!csvPath.isEmpty()) {
        auto batch = record::openCommissionBatch(csvPath);
        if (batch)
            seen.batch = std::move(*batch);
        else
            seen.files.batchError = batch.error();
    }
    if (!templateFile.isEmpty()) {
        const auto settings = record::loadSnapshot(templateFile);
        if (settings)
            seen.files.dangerous = dangerousKeys(catalog, *settings);
        else
            seen.files.templateError = settings.error();
    }
    return seen;
}
} // namespace

void Commissioning::look(const QString& csvPath, const QString& templateFile)
{
    if (m_running)
        return;
    const int number = ++m_looks;
    m_lookThread.start([=, this, post = m_post, catalog = m_desk.catalog()] {
        auto seen = std::make_shared<Looked>(lookAt(catalog, csvPath, templateFile));
        post->post([=, this] {
            if (number != m_looks || m_running)
                return;
            m_csvPath = csvPath;
            m_batch = std::move(seen->batch);
            m_files = std::move(seen->files);
            Q_EMIT batchChanged();
            Q_EMIT looked();
        });
    });
}

QStringList dangerousKeys(const catalog::Catalog& catalog, const record::Snapshot& settings)
{
    const QStringList firmware = settings.servo.firmware.split(QLatin1Char('.'));
    const auto profileOf = [&](const catalog::ModelEntry& model) {
        return catalog.profileFor(model, firmware.value(0).toInt(), firmware.value(1).toInt());
    };
    // Of a model nobody knows: what is dangerous in any.
    std::vector<catalog::ProfilePtr> profiles;
    if (const catalog::ModelEntry* model = catalog.model(settings.servo.model)) {
        profiles.push_back(profileOf(*model));
    } else {
        for (const catalog::ModelEntry& one : catalog.models())
            profiles.push_back(profileOf(one));
    }
    QStringList keys;
    for (const record::SnapshotRegister& row : settings.registers) {
        const bool dangerous =
            std::any_of(profiles.begin(), profiles.end(), [&row](const catalog::ProfilePtr& one) {
                const catalog::Register* reg = one ? one->find(row.key) : nullptr;
                return reg != nullptr && reg->dangerous && !reg->identity && reg->writable();
            });
        if (dangerous && row.raw)
            keys.append(row.key);
    }
    return keys;
}

QString proposedBatch(const QDate& today)
{
    const QString documents = QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation);
    const bool ownPlace = !qEnvironmentVariableIsEmpty("SERVODESK_DATA_DIR");
    const QDir folder(ownPlace                   ? dataFolder()
                      : QDir(documents).exists() ? documents
                                                 : QDir::homePath());
    const QString stem = QStringLiteral("servodesk-batch-%1").arg(today.toString(Qt::ISODate));
    QString path = folder.filePath(stem + QStringLiteral(".csv"));
    const auto foreign = [](const QString& csv) {
        return QFileInfo::exists(csv) && !QFileInfo::exists(record::commissionStatePath(csv));
    };
    for (int n = 2; foreign(path); ++n)
        path = folder.filePath(QStringLiteral("%1-%2.csv").arg(stem).arg(n));
    return path;
}

void Commissioning::stop()
{
    if (!m_running)
        return;
    m_live->cancelled = true;
    m_desk.stopTest();
}

void Commissioning::answer(jobs::CommissionAnswer answer)
{
    if (m_running && m_view.step == jobs::CommissionStep::Confirm)
        m_live->answer = answer;
}

bool Commissioning::hasBag() const
{
    return m_desk.connection() != nullptr && m_desk.connection()->hasBag();
}

std::size_t Commissioning::inBag() const
{
    return m_desk.connection() != nullptr ? m_desk.connection()->inBag() : 0;
}

void Commissioning::plugNext()
{
    if (m_desk.connection() != nullptr)
        (void)m_desk.connection()->plugNext();
}

void Commissioning::unplug()
{
    if (m_desk.connection() != nullptr)
        m_desk.connection()->unplugAll();
}
} // namespace session
