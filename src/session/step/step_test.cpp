// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/step/step_test.h"

#include "jobs/step/step_advice.h"
#include "report/step_report.h"
#include "session/snapshot/safety_snapshot.h"

#include <atomic>
#include <cmath>
#include <mutex>

namespace session {
using base::ErrorCode;
using namespace std::chrono_literals;

namespace {
constexpr auto responseInterval = 50ms;

bool holds(const std::vector<device::WriteItem>& items,
           const std::vector<device::WriteItem>& wanted)
{
    return items.size() == wanted.size() &&
           std::equal(items.begin(), items.end(), wanted.begin(),
                      [](const device::WriteItem& a, const device::WriteItem& b) {
                          return a.key == b.key && a.raw == b.raw;
                      });
}

/// Whether the event reports a write of these keys and values.
bool written(const Event& event, const std::vector<device::WriteItem>& wanted)
{
    if (!event.report)
        return false;
    std::vector<device::WriteItem> items;
    for (const device::WriteItem& item : wanted) {
        for (const device::WriteResult& result : event.report->writes) {
            if (result.key == item.key)
                items.push_back({result.key, result.newRaw});
        }
    }
    return holds(items, wanted);
}
} // namespace

/// Filled on the job's thread, emptied on the main thread; `run` is read when it has ended.
struct StepTest::Live {
    std::atomic<bool> canceled = false; ///< before it began
    std::mutex mutex{};
    std::vector<results::StepResponse> responses{};
    std::optional<jobs::SweepProgress> progress{};
    std::optional<results::StepRun> run{};
    std::vector<results::StepAdvice> advice{};
    std::vector<jobs::UnreleasedTorque> unreleasedTorque{};
    std::vector<base::JournalItem> trial{}; ///< the changes of the trial
};

StepTest::StepTest(Workbench& workbench, QObject* parent)
    : QObject(parent)
    , m_workbench(workbench)
{
    m_drainTimer.setInterval(responseInterval);
    connect(&m_drainTimer, &QTimer::timeout, this, [this] {
        if (m_job)
            drain(*m_job);
    });
    connect(&workbench, &Workbench::eventOccurred, this, &StepTest::happened);
}

bool StepTest::start(const StepTestRequest& request)
{
    if (m_running || m_workbench.registry().servo(request.servo) == nullptr)
        return false;
    if (request.servo != m_servo)
        clearMeasured();
    m_servo = request.servo;
    m_running = true;
    m_progress = {};
    m_live.clear();
    m_unreleasedTorque.clear();
    m_unrevertedItems.clear();
    m_liveSpec = request.spec;
    m_job = std::make_shared<Live>();
    const auto live = m_job;
    jobs::StepRequest wanted{request.spec, programName(), m_workbench.link().isSimulated(),
                             request.switchMode};
    jobs::StepCallbacks watch;
    watch.onResponse = [live](const results::StepResponse& response) {
        const std::lock_guard lock(live->mutex);
        live->responses.push_back(response);
    };
    watch.onTrial = [live](const std::vector<base::JournalItem>& trial) { live->trial = trial; };
    watch.onUnreleasedTorque = [live](const jobs::UnreleasedTorque& left) {
        live->unreleasedTorque.push_back(left);
    };
    Task task;
    task.name = QStringLiteral("step-response");
    task.effect = Effect::Moves;
    task.savesTable = request.switchMode || !request.spec.trial.empty();
    task.isLongRunning = true;
    task.holdsTorqueAfterwards = true;
    task.quiet = true;
    task.work = [wanted, watch, live](TaskContext& context) mutable -> base::Result<void> {
        if (live->canceled)
            return base::fail(ErrorCode::Stopped, QStringLiteral("step"));
        watch.onProgress = [live, report = context.progress](const jobs::SweepProgress& progress) {
            report({progress.fraction});
            const std::lock_guard lock(live->mutex);
            live->progress = progress;
        };
        auto run = jobs::stepResponse(context.device, context.servo, wanted, watch);
        if (!run)
            return tl::unexpected(run.error());
        live->advice = jobs::adviseStep(*run, *context.servo.profile);
        live->run = std::move(*run);
        if (live->run->end == results::SweepEnd::ServoReplaced) // for the list of servos
            return base::fail(ErrorCode::IdentityMismatch, QStringLiteral("step"), {},
                              context.servo.id);
        return {};
    };
    task.guard = this;
    task.done = [this, live](const TaskCompletion& end) { finish(*live, end); };
    m_drainTimer.start();
    m_workbench.tasks().perform(request.servo, std::move(task));
    return true;
}

void StepTest::stop()
{
    if (!m_running)
        return;
    m_job->canceled = true;
    m_workbench.tasks().stopTest();
}

void StepTest::drain(Live& live)
{
    std::vector<results::StepResponse> responses;
    std::optional<jobs::SweepProgress> progress;
    {
        const std::lock_guard lock(live.mutex);
        responses.swap(live.responses);
        progress.swap(live.progress);
    }
    if (progress) {
        m_progress = *progress;
        Q_EMIT progressChanged();
    }
    if (responses.empty())
        return;
    for (results::StepResponse& response : responses)
        m_live.push_back(std::move(response));
    Q_EMIT responsesAdded();
}

void StepTest::finish(Live& live, const TaskCompletion& end)
{
    drain(live);
    m_drainTimer.stop();
    m_job.reset();
    m_running = false;
    m_live.clear();
    m_unreleasedTorque = std::move(live.unreleasedTorque);
    if (live.run && !live.run->isReverted)
        m_unrevertedItems = std::move(live.trial);
    if (!live.run) {
        Q_EMIT failed(end.error.value_or(base::Error{ErrorCode::Stopped, QStringLiteral("step")}));
        return;
    }
    m_runs.push_back(std::move(*live.run));
    m_advice = std::move(live.advice);
    // The first one with the servo's own values stays: the others are compared with it.
    const auto first = m_runs.begin() + std::ptrdiff_t(m_openedNumbers.size());
    if (std::size_t(m_runs.end() - first) > maxRuns)
        m_runs.erase(first + (first->spec.trial.empty() ? 1 : 0));
    Q_EMIT finished();
}

void StepTest::openStored(const std::vector<StoredStep>& stored)
{
    m_runs.erase(m_runs.begin(), m_runs.begin() + std::ptrdiff_t(m_openedNumbers.size()));
    if (m_runs.empty())
        m_advice = stored.empty()
                       ? std::vector<results::StepAdvice>()
                       : jobs::adviseStoredStep(*stored.back().run, m_workbench.catalog());
    m_openedNumbers.clear();
    for (const StoredStep& one : stored) {
        m_runs.insert(m_runs.begin() + std::ptrdiff_t(m_openedNumbers.size()), *one.run);
        m_openedNumbers.push_back(one.number);
    }
    Q_EMIT storedOpened();
}

const results::StepRun* StepTest::previousRun() const
{
    const std::size_t opened = m_openedNumbers.size();
    for (std::size_t i = std::min(opened, m_runs.size() - (opened > 0 ? 1 : 0)); i-- > 0;) {
        if (results::isSameMotion(m_runs[i], m_runs.back()))
            return &m_runs[i];
    }
    const results::StepRun* any = nullptr;
    for (std::size_t i = m_runs.size(); i-- > opened + 1;) {
        const results::StepRun& earlier = m_runs[i - 1];
        if (!results::isSameMotion(earlier, m_runs.back()))
            continue;
        if (earlier.spec.trial.empty())
            return &earlier;
        any = any == nullptr ? &earlier : any;
    }
    return any;
}

void StepTest::clear()
{
    m_openedNumbers.clear();
    m_runs.clear();
    clearMeasured();
}

void StepTest::clearMeasured()
{
    m_runs.resize(m_openedNumbers.size());
    m_advice = m_runs.empty() ? std::vector<results::StepAdvice>()
                              : jobs::adviseStoredStep(m_runs.back(), m_workbench.catalog());
    m_servo = m_running ? m_servo : 0;
}

void StepTest::accept(ServoRef servo, const std::vector<results::StepGain>& gains)
{
    const ServoEntry* entry = m_workbench.registry().servo(servo);
    if (entry == nullptr || !entry->servo.profile || m_writing)
        return;
    AcceptedGains accepted{servo};
    for (const results::StepGain& gain : gains) {
        const auto now = entry->servo.raw(gain.key);
        if (!now || *now == gain.raw)
            continue;
        accepted.before.push_back({gain.key, *now});
        accepted.after.push_back({gain.key, gain.raw});
    }
    if (accepted.after.empty())
        return;
    m_writing = accepted;
    m_reverting = false;
    m_workbench.writes().write(servo, {accepted.after});
    Q_EMIT acceptedChanged();
}

std::vector<device::WriteItem> StepTest::previousValues(ServoRef servo) const
{
    for (auto accepted = m_accepted.rbegin(); accepted != m_accepted.rend(); ++accepted) {
        if (accepted->servo == servo)
            return accepted->before;
    }
    return {};
}

void StepTest::revert(ServoRef servo)
{
    const auto items = previousValues(servo);
    if (items.empty() || m_writing)
        return;
    m_writing = AcceptedGains{servo, {}, items};
    m_reverting = true;
    m_workbench.writes().write(servo, {items});
    Q_EMIT acceptedChanged();
}

/// A write that succeeded can be reverted; a reverted one is removed.
void StepTest::happened(const Event& event)
{
    if (!m_writing || event.kind != Event::Kind::Written || event.servo != m_writing->servo)
        return;
    if (!event.error && !written(event, m_writing->after))
        return; // another write of this servo
    const AcceptedGains ended = *std::exchange(m_writing, std::nullopt);
    const bool good = !event.error && event.report && event.report->isSuccessful();
    if (good && !m_reverting) {
        m_accepted.push_back(ended);
    } else if (good) {
        const auto last =
            std::find_if(m_accepted.rbegin(), m_accepted.rend(),
                         [&](const AcceptedGains& one) { return one.servo == ended.servo; });
        if (last != m_accepted.rend())
            m_accepted.erase(std::next(last).base());
    }
    Q_EMIT acceptedChanged();
}

void StepTest::save(const QString& path, bool chinese)
{
    if (m_runs.empty())
        return;
    m_files.start([this, runs = m_runs, advice = m_advice, path, chinese] {
        const auto written = report::saveStepReport(runs, advice, chinese, path);
        m_mainQueue.post([this, written, path] {
            if (written)
                Q_EMIT saved(path);
            else
                Q_EMIT saveFailed(written.error());
        });
    });
}
} // namespace session
