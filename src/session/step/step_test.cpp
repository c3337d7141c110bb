// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/step/step_test.h"

#include "jobs/step/step_advice.h"
#include "report/step_html.h"
#include "results/step_json.h"
#include "session/snapshot/safety_snapshot.h"

#include <QFileInfo>

#include <atomic>
#include <cmath>
#include <mutex>

namespace session {
using base::ErrorCode;
using namespace std::chrono_literals;

namespace {
constexpr auto drainInterval = 50ms;

bool isSameMotion(const record::StepRun& one, const record::StepRun& other)
{
    const double way = std::abs(one.axis.to - one.axis.from);
    return std::abs(way - std::abs(other.axis.to - other.axis.from)) <= 1;
}

bool holds(const std::vector<device::WriteItem>& items,
           const std::vector<device::WriteItem>& wanted)
{
    return items.size() == wanted.size() &&
           std::equal(items.begin(), items.end(), wanted.begin(),
                      [](const device::WriteItem& a, const device::WriteItem& b) {
                          return a.key == b.key && a.raw == b.raw;
                      });
}

/// Keys and values that a report says were written, in the order of the order.
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

/// Filled on the job's thread, emptied on the main thread; `run` is looked at when it has ended.
struct StepTest::Live {
    std::atomic<bool> canceled = false; ///< before it began
    std::mutex mutex{};
    std::vector<record::StepResponse> responses{};
    std::optional<jobs::SweepProgress> progress{};
    std::optional<record::StepRun> run{};
    std::vector<record::StepAdvice> advice{};
    std::vector<jobs::UnreleasedTorque> unreleasedTorque{};
    std::vector<base::JournalItem> trial{}; ///< what it has changed
};

StepTest::StepTest(Desk& desk, QObject* parent)
    : QObject(parent)
    , m_desk(desk)
{
    m_drainTimer.setInterval(drainInterval);
    connect(&m_drainTimer, &QTimer::timeout, this, [this] {
        if (m_job)
            drain(*m_job);
    });
    connect(&desk, &Desk::eventOccurred, this, &StepTest::happened);
}

bool StepTest::start(const StepTestRequest& request)
{
    if (m_running || m_desk.servo(request.servo) == nullptr)
        return false;
    if (request.servo != m_servo)
        clear();
    m_servo = request.servo;
    m_running = true;
    m_progress = {};
    m_live.clear();
    m_unreleasedTorque.clear();
    m_unrevertedItems.clear();
    m_liveSpec = request.spec;
    m_job = std::make_shared<Live>();
    const auto live = m_job;
    jobs::StepRequest wanted{request.spec, programName(), m_desk.isSimulated(), request.switchMode};
    jobs::StepCallbacks watch;
    watch.onResponse = [live](const record::StepResponse& response) {
        const std::lock_guard lock(live->mutex);
        live->responses.push_back(response);
    };
    watch.onProgress = [live](const jobs::SweepProgress& progress) {
        const std::lock_guard lock(live->mutex);
        live->progress = progress;
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
    task.work = [wanted, watch, live](TaskContext& context) -> base::Result<void> {
        if (live->canceled)
            return base::fail(ErrorCode::Stopped, QStringLiteral("step"));
        auto run = jobs::stepResponse(context.device, context.servo, wanted, watch);
        if (!run)
            return tl::unexpected(run.error());
        live->advice = jobs::adviseStep(*run, *context.servo.profile);
        live->run = std::move(*run);
        if (live->run->end == record::SweepEnd::ServoReplaced) // the list is to learn it
            return base::fail(ErrorCode::IdentityMismatch, QStringLiteral("step"), {},
                              context.servo.id);
        return {};
    };
    task.guard = this;
    task.done = [this, live](const TaskCompletion& end) { finish(*live, end); };
    m_drainTimer.start();
    m_desk.perform(request.servo, std::move(task));
    return true;
}

void StepTest::stop()
{
    if (!m_running)
        return;
    m_job->canceled = true;
    m_desk.stopTest();
}

void StepTest::drain(Live& live)
{
    std::vector<record::StepResponse> responses;
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
    for (record::StepResponse& response : responses)
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
    // The first one of the servo's own values is what the others are held against: it stays.
    if (m_runs.size() > maxRuns)
        m_runs.erase(m_runs.begin() + (m_runs.front().spec.trial.empty() ? 1 : 0));
    Q_EMIT finished();
}

const record::StepRun* StepTest::previousRun() const
{
    const record::StepRun* any = nullptr;
    for (std::size_t i = m_runs.size(); i-- > 1;) {
        const record::StepRun& earlier = m_runs[i - 1];
        if (!isSameMotion(earlier, m_runs.back()))
            continue;
        if (earlier.spec.trial.empty())
            return &earlier;
        any = any == nullptr ? &earlier : any;
    }
    return any;
}

void StepTest::clear()
{
    m_runs.clear();
    m_advice.clear();
    m_servo = m_running ? m_servo : 0;
}

void StepTest::accept(ServoRef servo, const std::vector<record::StepGain>& gains)
{
    const ServoEntry* entry = m_desk.servo(servo);
    if (entry == nullptr || !entry->servo.profile || m_writing)
        return;
    AcceptedGains accepted{servo};
    for (const record::StepGain& gain : gains) {
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
    m_desk.write(servo, {accepted.after});
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
    m_desk.write(servo, {items});
    Q_EMIT acceptedChanged();
}

/// What was really kept can be taken back; what was taken back is forgotten.
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

namespace {
base::Result<void> write(const std::vector<record::StepRun>& runs,
                         const std::vector<record::StepAdvice>& advice, const QString& path,
                         bool chinese)
{
    const QString end = QFileInfo(path).suffix().toLower();
    if (end == QLatin1StringView("json"))
        return record::saveStepRuns(runs, advice, path);
    if (end == QLatin1StringView("csv"))
        return record::saveStepSamples(runs, path);
    return report::saveStepHtml(runs, advice, chinese, path);
}
} // namespace

void StepTest::save(const QString& path, bool chinese)
{
    if (m_runs.empty())
        return;
    m_files.start([this, runs = m_runs, advice = m_advice, path, chinese] {
        const auto written = write(runs, advice, path, chinese);
        m_mainQueue.post([this, written, path] {
            if (written)
                Q_EMIT saved(path);
            else
                Q_EMIT saveFailed(written.error());
        });
    });
}
} // namespace session
