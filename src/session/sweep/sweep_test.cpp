// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/sweep/sweep_test.h"

#include "jobs/sweep/sweep_statistics.h"
#include "session/paths.h"
#include "session/snapshot/safety_snapshot.h"
#include "session/sweep/sweep_report.h"

#include <QDir>

#include <atomic>
#include <mutex>

namespace session {
using namespace std::chrono_literals;
using base::Duration;
using base::ErrorCode;

namespace {
constexpr auto sampleInterval = 33ms;
constexpr std::size_t storeBudget = std::size_t(32) << 20;

/// "2026-11-22_061500_ID1-2.readings.csv" in the folder of the tests.
QString readingsFile(const results::SweepRun& run)
{
    QStringList ids;
    for (const results::SweepServo& servo : run.servos)
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
    std::atomic<bool> canceled = false; ///< before it began
    std::mutex mutex;
    std::vector<Reading> readings{};
    std::vector<std::pair<std::size_t, results::SweepLeg>> legs{};
    std::optional<jobs::SweepProgress> progress{};
    std::optional<results::SweepRun> startedRun{};
    QString path{}; ///< of the readings
    std::vector<ServoRef> servos{};
};

/// What the job leaves behind. Filled on its thread, read when it has ended.
struct SweepTest::Ending {
    std::shared_ptr<jobs::SweepRecording> recording{};
    std::optional<results::SweepRun> run{};
    QString path{};
    std::vector<jobs::UnreleasedTorque> unreleasedTorque{};
};

SweepTest::SweepTest(Workbench& workbench, QObject* parent)
    : QObject(parent)
    , m_workbench(workbench)
    , m_leftovers(workbench, QStringLiteral("sweep-left"))
    , m_store(storeBudget)
{
    connect(&m_leftovers, &TestLeftovers::changed, this, &SweepTest::leftoversChanged);
    m_drainTimer.setInterval(sampleInterval);
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
    all.insert(all.end(), context.otherServos.begin(), context.otherServos.end());
    return all;
}

SweepPreview previewServo(TaskContext& context, device::Servo& servo,
                          const results::SweepSpec& spec, const results::SweepLimits& limits)
{
    SweepPreview preview;
    auto estimate = jobs::estimateSweep(context.device, servo, spec, limits);
    if (estimate)
        preview.estimate = std::move(*estimate);
    else
        preview.error = estimate.error();
    preview.proposed = jobs::proposedRange(servo);
    return preview;
}
} // namespace

void SweepTest::preview(const SweepTestRequest& request)
{
    if (m_running || request.servos.empty())
        return;
    const int number = ++m_previewNumber;
    const auto found = std::make_shared<std::vector<SweepPreview>>();
    Task task;
    task.name = QStringLiteral("sweep");
    task.quiet = true;
    task.otherServos.assign(request.servos.begin() + 1, request.servos.end());
    task.work = [found, request](TaskContext& context) -> base::Result<void> {
        const auto servos = allOf(context);
        for (std::size_t i = 0; i < servos.size(); ++i) {
            found->push_back(previewServo(context, *servos[i], request.spec, request.limits[i]));
            found->back().servo = request.servos[i];
        }
        return {};
    };
    task.guard = this;
    task.done = [this, found, number, request](const TaskCompletion& end) {
        if (number != m_previewNumber)
            return;
        if (end.error) // no servo was asked
            found->assign(1, SweepPreview{request.servos.front(), {}, end.error});
        Q_EMIT previewReady(*found);
    };
    m_workbench.tasks().perform(request.servos.front(), std::move(task));
}

namespace {
base::Result<results::SweepRun> drive(TaskContext& context, const jobs::SweepRequest& request,
                                      const jobs::SweepCallbacks& watch)
{
    const auto all = allOf(context);
    std::vector<device::Servo> servos;
    for (const device::Servo* servo : all)
        servos.push_back(*servo);
    auto run = jobs::sweep(context.device, servos, request, watch);
    for (std::size_t i = 0; i < all.size(); ++i)
        *all[i] = std::move(servos[i]);
    return run;
}

/// For the list of servos: IdentityMismatch of the one that another servo has replaced.
base::Result<void> replacedServoError(const results::SweepRun& run)
{
    if (run.end != results::SweepEnd::ServoReplaced)
        return {};
    return base::fail(ErrorCode::IdentityMismatch, QStringLiteral("sweep"), {}, run.endedBy);
}
} // namespace

jobs::SweepCallbacks SweepTest::callbacksFor(const std::shared_ptr<Live>& live,
                                             const std::shared_ptr<Ending>& ending,
                                             const jobs::ProgressFn& progress)
{
    jobs::SweepCallbacks callbacks;
    callbacks.onBegin = [live, ending](const results::SweepRun& run) {
        return beginRecording(*live, *ending, run);
    };
    callbacks.onSample = [live, ending](std::size_t servo, const jobs::SweepSample& sample,
                                        double goal, int leg) {
        ending->recording->add(servo, sample, goal, leg);
        const std::lock_guard lock(live->mutex);
        live->readings.push_back(
            {servo, sample.at, sample.answered ? sample.position : std::nullopt, goal});
    };
    callbacks.onGoal = [ending](std::size_t servo, int leg, Duration at) {
        ending->recording->goal(servo, leg, at);
    };
    callbacks.onLeg = [live](std::size_t servo, const results::SweepLeg& leg) {
        const std::lock_guard lock(live->mutex);
        live->legs.emplace_back(servo, leg);
    };
    callbacks.onUnreleasedTorque = [ending](const jobs::UnreleasedTorque& left) {
        ending->unreleasedTorque.push_back(left);
    };
    callbacks.onProgress = [live, progress](const jobs::SweepProgress& done) {
        progress({done.fraction, done.remaining});
        const std::lock_guard lock(live->mutex);
        live->progress = done;
    };
    return callbacks;
}

/// On the job's thread, before anything moves. The error of a readings file that cannot be written.
std::optional<base::Error> SweepTest::beginRecording(Live& live, Ending& ending,
                                                     const results::SweepRun& run)
{
    ending.path = readingsFile(run);
    QDir().mkpath(QFileInfo(ending.path).absolutePath());
    auto recording = jobs::SweepRecording::start(run, ending.path);
    if (!recording)
        return recording.error();
    ending.recording = std::move(*recording);
    const std::lock_guard lock(live.mutex);
    live.startedRun = run;
    live.path = ending.path;
    return std::nullopt;
}

/// On the job's thread, until the test has ended.
base::Result<void> SweepTest::runJob(TaskContext& context, const jobs::SweepRequest& request,
                                     const std::shared_ptr<Live>& live,
                                     const std::shared_ptr<Ending>& ending)
{
    if (live->canceled)
        return base::fail(ErrorCode::Stopped, QStringLiteral("sweep"));
    auto run = drive(context, request, callbacksFor(live, ending, context.progress));
    if (ending->recording)
        ending->recording->finish();
    if (!run)
        return tl::unexpected(run.error());
    ending->run = std::move(*run);
    return replacedServoError(*ending->run);
}

bool SweepTest::start(const SweepTestRequest& request)
{
    const auto gone = [this](ServoRef ref) { return m_workbench.registry().servo(ref) == nullptr; };
    if (m_running || request.servos.empty() ||
        std::any_of(request.servos.begin(), request.servos.end(), gone))
        return false;
    m_running = true;
    ++m_previewNumber; // the result of a preview under way is not wanted any more
    m_progress = {};
    m_leftovers.clear();
    m_live = std::make_shared<Live>();
    m_live->servos = request.servos;
    const auto ending = std::make_shared<Ending>();
    jobs::SweepRequest jobRequest{request.spec, request.limits, programName(),
                                  m_workbench.link().isSimulated()};
    jobRequest.switchMode = request.switchMode;

    Task task;
    task.name = QStringLiteral("sweep");
    task.effect = Effect::Moves;
    task.savesTable = request.switchMode;
    task.isLongRunning = true;
    task.holdsTorqueAfterwards = !request.spec.releaseAtEnd;
    task.quiet = true;
    task.otherServos.assign(request.servos.begin() + 1, request.servos.end());
    task.work = [jobRequest, live = m_live, ending](TaskContext& context) {
        return runJob(context, jobRequest, live, ending);
    };
    task.guard = this;
    task.done = [this, ending](const TaskCompletion& end) { finish(*ending, end); };
    m_drainTimer.start();
    m_workbench.tasks().perform(request.servos.front(), std::move(task));
    return true;
}

void SweepTest::stop()
{
    if (!m_running)
        return;
    m_live->canceled = true;
    m_workbench.tasks().stopTest();
}

void SweepTest::openCurves()
{
    m_store.clear();
    for (const jobs::SweepCurves& old : m_curves) {
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
    std::vector<std::pair<std::size_t, results::SweepLeg>> legs;
    std::optional<jobs::SweepProgress> progress;
    std::optional<results::SweepRun> startedRun;
    {
        const std::lock_guard lock(m_live->mutex);
        readings.swap(m_live->readings);
        legs.swap(m_live->legs);
        progress.swap(m_live->progress);
        startedRun.swap(m_live->startedRun);
        if (startedRun)
            m_readingsPath = m_live->path;
    }
    if (startedRun) {
        m_run = std::move(startedRun);
        m_servos = m_live->servos;
        m_startedAt = readings.empty() ? m_workbench.now() : readings.front().at;
        openCurves();
        Q_EMIT started();
    }
    for (const Live::Reading& reading : readings) {
        jobs::appendReading(m_store, m_curves.at(reading.servo), reading.at, reading.position,
                            reading.goal);
    }
    for (auto& [servo, leg] : legs)
        m_run->servos[servo].legs.push_back(leg);
    if (progress) {
        m_progress = *progress;
        Q_EMIT progressChanged();
    }
    if (!readings.empty())
        Q_EMIT samplesAdded();
    if (!legs.empty())
        Q_EMIT legsAdded();
}

void SweepTest::finish(Ending& ending, const TaskCompletion& end)
{
    drain();
    m_drainTimer.stop();
    m_live.reset();
    m_running = false;
    m_leftovers.setLeftovers(std::move(ending.unreleasedTorque), end.notices);
    if (ending.recording) // else the test before is still here to be saved
        m_recording = ending.recording;
    if (ending.run) {
        m_run = std::move(ending.run);
        if (m_recording && m_recording->failure())
            Q_EMIT saveFailed(*m_recording->failure());
        Q_EMIT finished();
    } else {
        Q_EMIT failed(end.error.value_or(base::Error{ErrorCode::Stopped, QStringLiteral("sweep")}));
    }
}

std::vector<results::SweepMetric> SweepTest::metrics(std::size_t servo) const
{
    if (!m_run || servo >= m_run->servos.size())
        return {};
    const results::SweepServo& tested = m_run->servos[servo];
    if (!m_running)
        return tested.metrics;
    const auto first = tested.legs.empty() ? std::nullopt : tested.legs.front().temperatureMax;
    return jobs::sweepMetrics(tested.legs, tested.errors, first,
                              jobs::referencePath(m_run->spec, tested.axis));
}

void SweepTest::save(const QString& path, bool chinese)
{
    const auto format = sweepFormatOf(path);
    if (m_running || !m_run || !m_recording || !format)
        return;
    const auto write = [this, path, chinese, format,
                        run = std::make_shared<results::SweepRun>(*m_run), recording = m_recording,
                        readings = m_readingsPath] {
        auto written = saveSweepReport(*run, *recording, *format, chinese, path);
        if (written)
            written = copySweepReadings(readings, path);
        m_mainQueue.post([this, path, written] {
            if (written)
                Q_EMIT saved(path);
            else
                Q_EMIT saveFailed(written.error());
        });
    };
    QMetaObject::invokeMethod(&m_writer, write, Qt::QueuedConnection);
}
} // namespace session
