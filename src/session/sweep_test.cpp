// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/sweep_test.h"

#include "jobs/sweep_meter.h"
#include "session/paths.h"
#include "session/safety_snapshot.h"
#include "session/sweep_report.h"

#include <QDir>

#include <atomic>
#include <mutex>

namespace session {
using namespace std::chrono_literals;
using base::Duration;
using base::ErrorCode;

namespace {
constexpr auto drainEvery = 33ms;
constexpr std::size_t storeBudget = std::size_t(32) << 20;

/// "2026-11-22_061500_ID1-2.readings.csv" in the folder of the tests.
QString readingsFile(const record::SweepRun& run)
{
    QStringList ids;
    for (const record::SweepServo& servo : run.servos)
        ids.append(QString::number(servo.parameters.servo.id));
    const QString stamp = run.at.toLocalTime().toString(QStringLiteral("yyyy-MM-dd_HHmmss"));
    return QDir(dataFolder())
        .filePath(QStringLiteral("tests/%1_ID%2.readings.csv")
                      .arg(stamp, ids.mid(0, 8).join(QLatin1Char('-'))));
}
} // namespace

/// Filled on the job's thread, emptied on the main thread.
struct SweepTest::Live {
    struct Reading {
        std::size_t servo = 0;
        Duration at{};
        std::optional<double> position{};
        double goal = 0;
    };
    std::atomic<bool> cancelled = false; ///< before it began
    std::mutex mutex;
    std::vector<Reading> readings{};
    std::vector<std::pair<std::size_t, record::SweepLeg>> legs{};
    std::optional<jobs::SweepProgress> progress{};
    std::optional<record::SweepRun> begun{};
    QString path{}; ///< of the readings
    std::vector<ServoRef> servos{};
};

/// What the job leaves behind. Filled on its thread, looked at when it has ended.
struct SweepTest::Ending {
    std::shared_ptr<jobs::SweepRecording> recording{};
    std::optional<record::SweepRun> run{};
    QString path{};
    std::vector<jobs::TorqueLeft> torqueLeft{};
};

SweepTest::SweepTest(Desk& desk, QObject* parent)
    : QObject(parent)
    , m_desk(desk)
    , m_left(desk, QStringLiteral("sweep-left"))
    , m_store(storeBudget)
{
    connect(&m_left, &TestLeft::changed, this, &SweepTest::leftChanged);
    m_drainTimer.setInterval(drainEvery);
    connect(&m_drainTimer, &QTimer::timeout, this, &SweepTest::drain);
    m_writer.moveToThread(&m_files);
    m_files.start();
}

SweepTest::~SweepTest()
{
    m_files.quit();
    m_files.wait(); // what is being written is whole afterwards
}

namespace {
std::vector<device::Servo*> allOf(const TaskContext& context)
{
    std::vector<device::Servo*> all{&context.servo};
    all.insert(all.end(), context.others.begin(), context.others.end());
    return all;
}

SweepLook lookAt(TaskContext& context, device::Servo& servo, const record::SweepSpec& spec,
                 const record::SweepLimits& limits)
{
    SweepLook look;
    auto outlook = jobs::lookAtSweep(context.device, servo, spec, limits);
    if (outlook)
        look.outlook = std::move(*outlook);
    else
        look.error = outlook.error();
    look.proposed = jobs::proposedRange(servo);
    return look;
}
} // namespace

void SweepTest::look(const SweepTestOrder& order)
{
    if (m_running || order.servos.empty())
        return;
    const int number = ++m_looks;
    const auto found = std::make_shared<std::vector<SweepLook>>();
    Task task;
    task.name = QStringLiteral("sweep");
    task.quiet = true;
    task.others.assign(order.servos.begin() + 1, order.servos.end());
    task.work = [found, order](TaskContext& context) -> base::Result<void> {
        const auto servos = allOf(context);
        for (std::size_t i = 0; i < servos.size(); ++i) {
            found->push_back(lookAt(context, *servos[i], order.spec, order.limits[i]));
            found->back().servo = order.servos[i];
        }
        return {};
    };
    task.guard = this;
    task.done = [this, found, number, order](const TaskEnd& end) {
        if (number != m_looks)
            return;
        if (end.error) // not one of them was asked
            found->assign(1, SweepLook{order.servos.front(), {}, end.error});
        Q_EMIT looked(*found);
    };
    m_desk.perform(order.servos.front(), std::move(task));
}

namespace {
base::Result<record::SweepRun> drive(TaskContext& context, const jobs::SweepOrder& order,
                                     const jobs::SweepWatch& watch)
{
    const auto all = allOf(context);
    std::vector<device::Servo> servos;
    for (const device::Servo* servo : all)
        servos.push_back(*servo);
    auto run = jobs::sweep(context.device, servos, order, watch);
    for (std::size_t i = 0; i < all.size(); ++i)
        *all[i] = std::move(servos[i]);
    return run;
}

/// For the list of servos: IdentityDiffers of the one that was found exchanged.
base::Result<void> exchangeIn(const record::SweepRun& run)
{
    if (run.end != record::SweepEnd::Exchanged)
        return {};
    return base::fail(ErrorCode::IdentityDiffers, QStringLiteral("sweep"), {}, run.endedBy);
}
} // namespace

bool SweepTest::start(const SweepTestOrder& order)
{
    const auto gone = [this](ServoRef ref) { return m_desk.servo(ref) == nullptr; };
    if (m_running || order.servos.empty() ||
        std::any_of(order.servos.begin(), order.servos.end(), gone))
        return false;
    m_running = true;
    ++m_looks; // what is still being looked at does not matter any more
    m_progress = {};
    m_left.forget();
    m_live = std::make_shared<Live>();
    m_live->servos = order.servos;
    const auto live = m_live;
    const auto ending = std::make_shared<Ending>();

    jobs::SweepOrder wanted{order.spec, order.limits, programName(), m_desk.simulated()};
    wanted.switchMode = order.switchMode;
    jobs::SweepWatch watch;
    watch.onBegin = [live, ending](const record::SweepRun& run) -> std::optional<base::Error> {
        ending->path = readingsFile(run);
        QDir().mkpath(QFileInfo(ending->path).absolutePath());
        auto made = jobs::SweepRecording::start(run, ending->path);
        if (!made)
            return made.error();
        ending->recording = std::move(*made);
        const std::lock_guard lock(live->mutex);
        live->begun = run;
        live->path = ending->path;
        return std::nullopt;
    };
    watch.onSample = [live, ending](std::size_t servo, const jobs::SweepSample& sample, double goal,
                                    int leg) {
        ending->recording->add(servo, sample, goal, leg);
        const std::lock_guard lock(live->mutex);
        live->readings.push_back(
            {servo, sample.at, sample.answered ? sample.position : std::nullopt, goal});
    };
    watch.onGoal = [ending](std::size_t servo, int leg, Duration at) {
        ending->recording->goal(servo, leg, at);
    };
    watch.onLeg = [live](std::size_t servo, const record::SweepLeg& leg) {
        const std::lock_guard lock(live->mutex);
        live->legs.emplace_back(servo, leg);
    };
    watch.onTorqueLeft = [ending](const jobs::TorqueLeft& left) {
        ending->torqueLeft.push_back(left);
    };
    watch.onProgress = [live](const jobs::SweepProgress& progress) {
        const std::lock_guard lock(live->mutex);
        live->progress = progress;
    };

    Task task;
    task.name = QStringLiteral("sweep");
    task.effect = Effect::Moves;
    task.savesTable = order.switchMode;
    task.lasting = true;
    task.holdsAfterwards = !order.spec.releaseAtEnd;
    task.quiet = true;
    task.others.assign(order.servos.begin() + 1, order.servos.end());
    task.work = [wanted, watch, live, ending](TaskContext& context) -> base::Result<void> {
        if (live->cancelled)
            return base::fail(ErrorCode::Stopped, QStringLiteral("sweep"));
        auto run = drive(context, wanted, watch);
        if (ending->recording)
            ending->recording->finish();
        if (!run)
            return tl::unexpected(run.error());
        ending->run = std::move(*run);
        return exchangeIn(*ending->run);
    };
    task.guard = this;
    task.done = [this, ending](const TaskEnd& end) { finish(*ending, end); };
    m_drainTimer.start();
    m_desk.perform(order.servos.front(), std::move(task));
    return true;
}

void SweepTest::stop()
{
    if (!m_running)
        return;
    m_live->cancelled = true;
    m_desk.stopTest();
}

void SweepTest::openCurves()
{
    m_store.clear();
    for (const Curves& old : m_curves) {
        m_store.close(old.position);
        m_store.close(old.goal);
    }
    m_curves.clear();
    for (std::size_t i = 0; i < m_run->servos.size(); ++i)
        m_curves.push_back({m_store.open(), m_store.open()});
}

void SweepTest::drain()
{
    if (!m_live)
        return;
    std::vector<Live::Reading> readings;
    std::vector<std::pair<std::size_t, record::SweepLeg>> legs;
    std::optional<jobs::SweepProgress> progress;
    std::optional<record::SweepRun> begun;
    {
        const std::lock_guard lock(m_live->mutex);
        readings.swap(m_live->readings);
        legs.swap(m_live->legs);
        progress.swap(m_live->progress);
        begun.swap(m_live->begun);
        if (begun)
            m_readingsPath = m_live->path;
    }
    if (begun) {
        m_run = std::move(begun);
        m_servos = m_live->servos;
        m_startedAt = readings.empty() ? m_desk.now() : readings.front().at;
        openCurves();
        Q_EMIT began();
    }
    for (const Live::Reading& reading : readings) {
        const Curves& curves = m_curves.at(reading.servo);
        if (reading.position) {
            m_store.append(curves.position, reading.at, *reading.position);
            m_store.append(curves.goal, reading.at, reading.goal);
        } else {
            m_store.gap(curves.position);
            m_store.gap(curves.goal);
        }
    }
    for (auto& [servo, leg] : legs)
        m_run->servos[servo].legs.push_back(leg);
    if (progress) {
        m_progress = *progress;
        Q_EMIT progressed();
    }
    if (!readings.empty())
        Q_EMIT grown();
    if (!legs.empty())
        Q_EMIT legged();
}

void SweepTest::finish(Ending& ending, const TaskEnd& end)
{
    drain();
    m_drainTimer.stop();
    m_live.reset();
    m_running = false;
    m_left.take(std::move(ending.torqueLeft), end.notices);
    if (ending.recording) // else the test before is still here to be saved
        m_recording = ending.recording;
    if (ending.run) {
        m_run = std::move(ending.run);
        if (m_recording && m_recording->failure())
            Q_EMIT saveFailed(*m_recording->failure());
        Q_EMIT ended();
    } else {
        Q_EMIT failed(end.error.value_or(base::Error{ErrorCode::Stopped, QStringLiteral("sweep")}));
    }
}

std::vector<record::SweepMetric> SweepTest::figures(std::size_t servo) const
{
    if (!m_run || servo >= m_run->servos.size())
        return {};
    const record::SweepServo& tested = m_run->servos[servo];
    if (!m_running)
        return tested.metrics;
    const auto first = tested.legs.empty() ? std::nullopt : tested.legs.front().temperatureMax;
    return jobs::sweepMetrics(tested.legs, tested.errors, first,
                              jobs::followedPath(m_run->spec, tested.axis));
}

void SweepTest::save(const QString& path, bool chinese)
{
    const auto format = sweepFormatOf(path);
    if (m_running || !m_run || !m_recording || !format)
        return;
    const auto write = [this, path, chinese, format,
                        run = std::make_shared<record::SweepRun>(*m_run), recording = m_recording,
                        readings = m_readingsPath] {
        auto written = saveSweepReport(*run, *recording, *format, chinese, path);
        if (written)
            written = copySweepReadings(readings, path);
        m_inbox.post([this, path, written] {
            if (written)
                Q_EMIT saved(path);
            else
                Q_EMIT saveFailed(written.error());
        });
    };
    QMetaObject::invokeMethod(&m_writer, write, Qt::QueuedConnection);
}
} // namespace session
