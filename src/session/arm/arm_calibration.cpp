// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/arm/arm_calibration.h"

#include "jobs/arm/joint_access.h"
#include "jobs/arm/record_ranges.h"
#include "session/snapshot/safety_snapshot.h"

#include <algorithm>
#include <numeric>

namespace session {
namespace {
using base::JointKind;
using namespace std::chrono_literals;

constexpr auto rangeInterval = 50ms;

std::vector<device::Servo*> allServos(TaskContext& context)
{
    std::vector<device::Servo*> all{&context.servo};
    all.insert(all.end(), context.otherServos.begin(), context.otherServos.end());
    return all;
}

base::Result<void> readJoints(TaskContext& context)
{
    for (device::Servo* servo : allServos(context)) {
        if (const auto read = jobs::readJoint(context.device, *servo); !read)
            return read;
    }
    return {};
}
} // namespace

/// Filled on the job's thread, read on the main thread.
struct ArmCalibration::Live {
    std::atomic<bool> isEnough = false;
    std::mutex mutex{};
    std::vector<jobs::JointRange> ranges{};
    std::vector<jobs::MoveTestReport> tests{};
    std::vector<device::Servo> servos{}; ///< as they were recorded
};

ArmCalibration::ArmCalibration(Workbench& workbench)
    : m_workbench(workbench)
{
    m_drainTimer.setInterval(rangeInterval);
    connect(&m_drainTimer, &QTimer::timeout, this, &ArmCalibration::drain);
    const ServoRegistry& registry = workbench.registry();
    for (const auto signal :
         {&ServoRegistry::servoAdded, &ServoRegistry::servoRemoved, &ServoRegistry::addressChanged})
        connect(&registry, signal, this, &ArmCalibration::matchServos);
    connect(&registry, &ServoRegistry::servoAdded, this, [this] { m_asked.clear(); });
    connect(&registry, &ServoRegistry::servosCleared, this, [this] {
        m_asked.clear();
        matchServos();
    });
    connect(&registry, &ServoRegistry::tableChanged, this, &ArmCalibration::updateHeld);
    connect(&workbench, &Workbench::stateChanged, this, &ArmCalibration::changed);
    setArm(jobs::loadArm(jobs::builtInArms().front()).value_or(jobs::Arm()));
}

void ArmCalibration::setArm(jobs::Arm arm)
{
    if (isBusy())
        return;
    m_arm = std::move(arm);
    m_joints.clear();
    for (const jobs::Joint& joint : m_arm.joints)
        m_joints.push_back({joint});
    m_step = Step::Idle;
    matchServos();
}

void ArmCalibration::matchServos()
{
    bool isOther = false;
    for (ArmJoint& one : m_joints) {
        const ServoRef now =
            m_workbench.registry().findServo(base::Protocol::Feetech, one.joint.id);
        if (std::exchange(one.servo, now) == now)
            continue;
        isOther = true;
        if (m_step != Step::Testing)
            one.test.reset();
    }
    if (isOther && m_step == Step::Recorded) // the plan is for the servos that were moved
        forgetPlan();
    updateHeld();
}

void ArmCalibration::updateHeld()
{
    for (ArmJoint& one : m_joints) {
        const ServoEntry* entry = m_workbench.registry().servo(one.servo);
        const auto held = entry != nullptr && entry->servo.profile
                              ? jobs::calibrationIn(entry->servo)
                              : std::nullopt;
        if (std::exchange(one.held, held) != held && m_step == Step::Idle)
            one.test.reset(); // it was for the limits that it had
    }
    Q_EMIT changed();
}

JointRows ArmCalibration::movable(const JointRows& rows) const
{
    JointRows all = rows;
    if (all.empty()) {
        all.resize(m_joints.size());
        std::iota(all.begin(), all.end(), std::size_t(0));
    }
    const auto isLeftOut = [this](std::size_t row) {
        return row >= m_joints.size() || m_joints[row].joint.kind == JointKind::Wheel;
    };
    all.erase(std::remove_if(all.begin(), all.end(), isLeftOut), all.end());
    return all;
}

JointRows ArmCalibration::plannedRows() const
{
    JointRows rows;
    for (std::size_t row = 0; row < m_joints.size(); ++row) {
        if (m_joints[row].planned)
            rows.push_back(row);
    }
    return rows;
}

std::vector<ServoRef> ArmCalibration::servosAt(const JointRows& rows) const
{
    std::vector<ServoRef> all;
    for (const std::size_t row : rows)
        all.push_back(m_joints[row].servo);
    return all;
}

std::vector<jobs::JointServo> ArmCalibration::jointServos() const
{
    std::vector<jobs::JointServo> all;
    for (const ArmJoint& one : m_joints) {
        const ServoEntry* entry = m_workbench.registry().servo(one.servo);
        const bool isKnown = entry != nullptr && entry->servo.profile;
        all.push_back({one.joint, isKnown ? &entry->servo : nullptr, m_arm.isLeader});
    }
    return all;
}

std::vector<ServoRef>
ArmCalibration::servosOf(const std::vector<snapshot::Snapshot>& templates) const
{
    std::vector<ServoRef> all;
    for (const ArmJoint& one : m_joints) {
        const bool isWritten =
            std::any_of(templates.begin(), templates.end(), [&](const snapshot::Snapshot& values) {
                return values.servo.id == one.joint.id;
            });
        if (isWritten)
            all.push_back(one.servo);
    }
    return all;
}

bool ArmCalibration::isFree() const
{
    return !isBusy() && m_workbench.link().state() == LinkState::Open &&
           !m_workbench.tasks().isBusy() && !m_workbench.search().isSearching();
}

bool ArmCalibration::canStart(const JointRows& rows) const
{
    const std::vector<ServoRef> all = servosAt(movable(rows));
    const bool isThere = !all.empty() && std::all_of(all.begin(), all.end(), [this](ServoRef ref) {
        const ServoEntry* entry = m_workbench.registry().servo(ref);
        return entry != nullptr && entry->servo.profile;
    });
    return isThere && isFree();
}

/// False: one of them is not in the list.
bool ArmCalibration::perform(Task task, std::vector<ServoRef> servos)
{
    if (servos.empty() || std::count(servos.begin(), servos.end(), ServoRef(0)) > 0)
        return false;
    task.otherServos.assign(servos.begin() + 1, servos.end());
    task.guard = this;
    m_workbench.tasks().perform(servos.front(), std::move(task));
    return true;
}

void ArmCalibration::readUnread()
{
    std::vector<ServoRef> unread;
    for (const ArmJoint& one : m_joints) {
        const ServoEntry* entry = m_workbench.registry().servo(one.servo);
        const bool wasAsked = std::count(m_asked.begin(), m_asked.end(), one.servo) > 0;
        if (entry != nullptr && entry->servo.profile && !one.held && !wasAsked)
            unread.push_back(one.servo);
    }
    if (unread.empty() || !isFree())
        return;
    m_asked.insert(m_asked.end(), unread.begin(), unread.end());
    Task task;
    task.name = QStringLiteral("read");
    task.quiet = true;
    task.work = readJoints;
    task.done = [this](const TaskCompletion&) { updateHeld(); };
    (void)perform(std::move(task), std::move(unread));
}

/// A task on joints that is shown while it runs, through m_live, which it fills.
void ArmCalibration::startLive(Step step, const JointRows& rows, Task task)
{
    forgetPlan();
    m_moving = movable(rows);
    task.isLongRunning = true;
    task.holdsTorqueAfterwards = false;
    task.quiet = true;
    if (!perform(std::move(task), servosAt(m_moving)))
        return;
    m_step = step;
    if (Connection* connection = m_workbench.link().connection())
        connection->moveSimulatedServosByHand(step == Step::Recording);
    m_drainTimer.start();
    Q_EMIT changed();
}

void ArmCalibration::startRecording(const JointRows& rows)
{
    if (!canStart(rows))
        return;
    m_live = std::make_shared<Live>();
    Task task;
    task.name = QStringLiteral("record-ranges");
    task.work = [live = m_live](TaskContext& context) -> base::Result<void> {
        const std::vector<device::Servo*> all = allServos(context);
        std::vector<device::Servo> moved;
        for (const device::Servo* servo : all)
            moved.push_back(*servo);
        const auto recorded = jobs::recordRanges(context.device, moved, [&](const auto& ranges) {
            const std::lock_guard lock(live->mutex);
            live->ranges = ranges;
            return !live->isEnough;
        });
        for (std::size_t i = 0; i < all.size(); ++i)
            *all[i] = moved[i]; // what has been read of them
        const std::lock_guard lock(live->mutex);
        live->servos = std::move(moved);
        if (recorded && context.stop.isRequested())
            return base::fail(base::ErrorCode::Stopped, QStringLiteral("arm"));
        return recorded.map([](const auto&) {});
    };
    task.done = [this](const TaskCompletion& end) { recordingEnded(end); };
    startLive(Step::Recording, rows, std::move(task));
}

void ArmCalibration::finishRecording(bool isMiddleShown)
{
    if (m_step != Step::Recording)
        return;
    m_isMiddleShown = isMiddleShown;
    m_live->isEnough = true;
}

void ArmCalibration::forgetPlan()
{
    m_plan.clear();
    for (ArmJoint& one : m_joints) {
        one.range = {};
        one.planned.reset();
        one.test.reset();
    }
    if (m_step == Step::Recorded)
        m_step = Step::Idle;
}

void ArmCalibration::cancel()
{
    if (m_step == Step::Recording || m_step == Step::Testing)
        return m_workbench.tasks().stopTest();
    if (m_step != Step::Recorded)
        return;
    forgetPlan();
    Q_EMIT changed();
}

void ArmCalibration::drain()
{
    {
        const std::lock_guard lock(m_live->mutex);
        for (std::size_t i = 0; i < m_live->ranges.size(); ++i)
            m_joints[m_moving[i]].range = m_live->ranges[i];
        for (std::size_t i = 0; i < m_live->tests.size(); ++i)
            m_joints[m_moving[i]].test = m_live->tests[i];
    }
    Q_EMIT changed();
}

void ArmCalibration::recordingEnded(const TaskCompletion& end)
{
    m_drainTimer.stop();
    if (Connection* connection = m_workbench.link().connection())
        connection->moveSimulatedServosByHand(false);
    m_step = end.error ? Step::Idle : Step::Recorded;
    drain();
    if (end.error)
        forgetPlan(); // a part of a range is none
    std::optional<base::Error> refusal;
    for (std::size_t i = 0; !end.error && i < m_live->servos.size(); ++i) {
        ArmJoint& one = m_joints[m_moving[i]];
        const device::Servo& servo = m_live->servos[i];
        const auto middle = m_isMiddleShown ? std::optional(one.range.now) : std::nullopt;
        const auto values = jobs::calibrationOf(servo, one.joint.kind, one.range, middle);
        if (!values) {
            if (one.range.state == base::JointState::Recorded) // else its state says why
                refusal = values.error();
            continue;
        }
        one.planned = *values;
        m_plan.push_back(jobs::calibrationTemplate(servo, one.joint.kind, *values, programName()));
    }
    updateHeld();
    if (end.error && end.error->code != base::ErrorCode::Stopped)
        Q_EMIT failed(*end.error);
    else if (refusal)
        Q_EMIT failed(*refusal);
}

void ArmCalibration::write()
{
    if (m_step == Step::Recorded)
        writeTemplates(m_plan);
}

void ArmCalibration::writeFile(const std::vector<jobs::LerobotJoint>& file)
{
    if (m_step != Step::Idle)
        return;
    std::vector<snapshot::Snapshot> templates;
    for (const ArmJoint& one : m_joints) {
        const ServoEntry* entry = m_workbench.registry().servo(one.servo);
        const auto saved = std::find_if(file.begin(), file.end(), [&](const auto& joint) {
            return joint.name == one.joint.name && joint.id == one.joint.id;
        });
        if (entry == nullptr || !entry->servo.profile || saved == file.end())
            continue;
        const auto valid = jobs::requireValid(entry->servo, saved->calibration);
        if (!valid)
            return Q_EMIT failed(valid.error());
        templates.push_back(jobs::calibrationTemplate(entry->servo, one.joint.kind,
                                                      saved->calibration, programName()));
    }
    writeTemplates(std::move(templates));
}

std::vector<snapshot::Snapshot> ArmCalibration::lerobotTemplates() const
{
    std::vector<snapshot::Snapshot> templates;
    for (const jobs::JointServo& one : jointServos()) {
        const jobs::JointSettings settings = one.lerobotSettings();
        if (!settings.empty() && !jobs::changesOf(*one.servo, settings).empty())
            templates.push_back(jobs::jointTemplate(*one.servo, settings, programName()));
    }
    return templates;
}

bool ArmCalibration::canPrepare() const
{
    return m_step == Step::Idle && isFree() && !lerobotTemplates().empty();
}

void ArmCalibration::prepare()
{
    if (m_step == Step::Idle)
        writeTemplates(lerobotTemplates());
}

void ArmCalibration::startMoveTest(int torquePercent, const JointRows& rows)
{
    if (!canStart(rows))
        return;
    m_live = std::make_shared<Live>();
    Task task;
    task.name = QStringLiteral("move-test");
    task.effect = Effect::Moves;
    task.work = [live = m_live, torquePercent](TaskContext& context) -> base::Result<void> {
        if (const auto read = readJoints(context); !read)
            return read;
        for (device::Servo* servo : allServos(context)) {
            if (context.stop.isRequested())
                return base::fail(base::ErrorCode::Stopped, QStringLiteral("move-test"));
            const auto show = [&](const jobs::MoveTestReport& report) {
                const std::lock_guard lock(live->mutex);
                live->tests.back() = report;
            };
            {
                const std::lock_guard lock(live->mutex);
                live->tests.push_back({base::MoveTestState::Moving,
                                       servo->raw(catalog::Role::PresentPosition).value_or(0)});
            }
            const auto report = jobs::testMoves(context.device, *servo, torquePercent, show);
            if (!report) {
                const std::lock_guard lock(live->mutex);
                live->tests.pop_back();
                return tl::unexpected(report.error());
            }
            show(*report);
            if (report->state != base::MoveTestState::Reached &&
                report->state != base::MoveTestState::NotReached)
                return {}; // an alarm, say, of the supply: the others do not start
        }
        return {};
    };
    task.done = [this](const TaskCompletion& end) { testEnded(end); };
    startLive(Step::Testing, rows, std::move(task));
}

void ArmCalibration::testEnded(const TaskCompletion& end)
{
    m_drainTimer.stop();
    m_step = Step::Idle;
    for (const std::size_t row : m_moving) // one may have been ended while it moved
        m_joints[row].test.reset();
    drain();
    updateHeld();
    Q_EMIT tested(!end.error);
    if (end.error && end.error->code != base::ErrorCode::Stopped)
        Q_EMIT failed(*end.error);
}

void ArmCalibration::writeTemplates(std::vector<snapshot::Snapshot> templates)
{
    std::vector<ServoRef> targets = servosOf(templates);
    const auto results = std::make_shared<std::vector<jobs::ApplyResult>>();
    Task task;
    task.name = QStringLiteral("calibrate-arm");
    task.savesTable = true;
    task.quiet = true;
    task.work = [results,
                 templates = std::move(templates)](TaskContext& context) -> base::Result<void> {
        *results = jobs::writeJoints(context.device, templates, {}, context.progress);
        return readJoints(context);
    };
    task.done = [this, results](const TaskCompletion& end) {
        m_step = Step::Idle;
        forgetPlan();
        for (const jobs::ApplyResult& one : *results) {
            const auto joint =
                std::find_if(m_joints.begin(), m_joints.end(),
                             [&](const auto& each) { return each.joint.id == one.id; });
            if (joint != m_joints.end())
                m_workbench.restores().reportApplied(joint->servo, one);
        }
        updateHeld();
        if (!results->empty())
            Q_EMIT written(*results);
        else if (end.error)
            Q_EMIT failed(*end.error);
    };
    if (!perform(std::move(task), std::move(targets)))
        return;
    m_step = Step::Writing;
    Q_EMIT changed();
}

std::vector<jobs::LerobotJoint> ArmCalibration::heldAsFile() const
{
    std::vector<jobs::LerobotJoint> all;
    for (const ArmJoint& one : m_joints) {
        if (one.held)
            all.push_back({one.joint.name, one.joint.id, one.joint.isReversed ? 1 : 0, *one.held});
    }
    return all;
}
} // namespace session
