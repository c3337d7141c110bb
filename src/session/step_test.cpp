// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/step_test.h"

#include "jobs/step_advice.h"
#include "record/step_json.h"
#include "report/step_html.h"
#include "session/safety_snapshot.h"

#include <QFileInfo>

#include <atomic>
#include <cmath>
#include <mutex>

namespace session {
using base::ErrorCode;
using namespace std::chrono_literals;

namespace {
constexpr auto drainEvery = 50ms;

bool sameWay(const record::StepRun& one, const record::StepRun& other)
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
    std::atomic<bool> cancelled = false; ///< before it began
    std::mutex mutex{};
    std::vector<record::StepResponse> responses{};
    std::optional<jobs::SweepProgress> progress{};
    std::optional<record::StepRun> run{};
    std::vector<record::StepAdvice> advice{};
    std::vector<jobs::TorqueLeft> torqueLeft{};
    std::vector<base::JournalItem> trial{}; ///< what it has changed
};

StepTest::StepTest(Desk& desk, QObject* parent)
    : QObject(parent)
    , m_desk(desk)
{
    m_drainTimer.setInterval(drainEvery);
    connect(&m_drainTimer, &QTimer::timeout, this, [this] {
        if (m_job)
            drain(*m_job);
    });
    connect(&desk, &Desk::happened, this, &StepTest::happened);
}

bool StepTest::start(const StepTestOrder& order)
{
    if (m_running || m_desk.servo(order.servo) == nullptr)
        return false;
    if (order.servo != m_servo)
        forget();
    m_servo = order.servo;
    m_running = true;
    m_progress = {};
    m_live.clear();
    m_torqueLeft.clear();
    m_trialLeft.clear();
    m_liveSpec = order.spec;
    m_job = std::make_shared<Live>();
    const auto live = m_job;
    jobs::StepOrder wanted{order.spec, programName(), m_desk.simulated(), order.switchMode};
    jobs::StepWatch watch;
    watch.onResponse = [live](const record::StepResponse& response) {
        const std::lock_guard lock(live->mutex);
        live->responses.push_back(response);
    };
    watch.onProgress = [live](const jobs::SweepProgress& progress) {
        const std::lock_guard lock(live->mutex);
        live->progress = progress;
    };
    watch.onTrial = [live](const std::vector<base::JournalItem>& trial) { live->trial = trial; };
    watch.onTorqueLeft = [live](const jobs::TorqueLeft& left) { live->torqueLeft.push_back(left); };
    Task task;
    task.name = QStringLiteral("step-response");
    task.effect = Effect::Moves;
    task.savesTable = order.switchMode || !order.spec.trial.empty();
    task.lasting = true;
    task.holdsAfterwards = true;
    task.quiet = true;
    task.work = [wanted, watch, live](TaskContext& context) -> base::Result<void> {
        if (live->cancelled)
            return base::fail(ErrorCode::Stopped, QStringLiteral("step"));
        auto run = jobs::stepResponse(context.device, context.servo, wanted, watch);
        if (!run)
            return tl::unexpected(run.error());
        live->advice = jobs::adviseStep(*run, *context.servo.profile);
        live->run = std::move(*run);
        if (live->run->end == record::SweepEnd::Exchanged) // the list is to learn it
            return base::fail(ErrorCode::IdentityDiffers, QStringLiteral("step"), {},
                              context.servo.id);
        return {};
    };
    task.guard = this;
    task.done = [this, live](const TaskEnd& end) { finish(*live, end); };
    m_drainTimer.start();
    m_desk.perform(order.servo, std::move(task));
    return true;
}

void StepTest::stop()
{
    if (!m_running)
        return;
    m_job->cancelled = true;
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
        Q_EMIT progressed();
    }
    if (responses.empty())
        return;
    for (record::StepResponse& response : responses)
        m_live.push_back(std::move(response));
    Q_EMIT responded();
}

void StepTest::finish(Live& live, const TaskEnd& end)
{
    drain(live);
    m_drainTimer.stop();
    m_job.reset();
    m_running = false;
    m_live.clear();
    m_torqueLeft = std::move(live.torqueLeft);
    if (live.run && !live.run->putBack)
        m_trialLeft = std::move(live.trial);
    if (!live.run) {
        Q_EMIT failed(end.error.value_or(base::Error{ErrorCode::Stopped, QStringLiteral("step")}));
        return;
    }
    m_runs.push_back(std::move(*live.run));
    m_advice = std::move(live.advice);
    // The first one of the servo's own values is what the others are held against: it stays.
    if (m_runs.size() > mostRuns)
        m_runs.erase(m_runs.begin() + (m_runs.front().spec.trial.empty() ? 1 : 0));
    Q_EMIT ended();
}

const record::StepRun* StepTest::before() const
{
    const record::StepRun* any = nullptr;
    for (std::size_t i = m_runs.size(); i-- > 1;) {
        const record::StepRun& earlier = m_runs[i - 1];
        if (!sameWay(earlier, m_runs.back()))
            continue;
        if (earlier.spec.trial.empty())
            return &earlier;
        any = any == nullptr ? &earlier : any;
    }
    return any;
}

void StepTest::forget()
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
    Kept kept{servo};
    for (const record::StepGain& gain : gains) {
        const auto now = entry->servo.raw(gain.key);
        if (!now || *now == gain.raw)
            continue;
        kept.before.push_back({gain.key, *now});
        kept.after.push_back({gain.key, gain.raw});
    }
    if (kept.after.empty())
        return;
    m_writing = kept;
    m_writingBack = false;
    m_desk.write(servo, {kept.after});
    Q_EMIT keptChanged();
}

std::vector<device::WriteItem> StepTest::earlier(ServoRef servo) const
{
    for (auto kept = m_kept.rbegin(); kept != m_kept.rend(); ++kept) {
        if (kept->servo == servo)
            return kept->before;
    }
    return {};
}

void StepTest::back(ServoRef servo)
{
    const auto items = earlier(servo);
    if (items.empty() || m_writing)
        return;
    m_writing = Kept{servo, {}, items};
    m_writingBack = true;
    m_desk.write(servo, {items});
    Q_EMIT keptChanged();
}

/// What was really kept can be taken back; what was taken back is forgotten.
void StepTest::happened(const Event& event)
{
    if (!m_writing || event.kind != Event::Kind::Written || event.servo != m_writing->servo)
        return;
    if (!event.error && !written(event, m_writing->after))
        return; // another write of this servo
    const Kept ended = *std::exchange(m_writing, std::nullopt);
    const bool good = !event.error && event.report && event.report->allGood();
    if (good && !m_writingBack) {
        m_kept.push_back(ended);
    } else if (good) {
        const auto last = std::find_if(m_kept.rbegin(), m_kept.rend(),
                                       [&](const Kept& one) { return one.servo == ended.servo; });
        if (last != m_kept.rend())
            m_kept.erase(std::next(last).base());
    }
    Q_EMIT keptChanged();
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
        m_inbox.post([this, written, path] {
            if (written)
                Q_EMIT saved(path);
            else
                Q_EMIT saveFailed(written.error());
        });
    });
}
} // namespace session
