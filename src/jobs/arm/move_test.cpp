// SPDX-License-Identifier: GPL-3.0-or-later
#include "jobs/arm/move_test.h"

#include "device/motion/motion.h"
#include "device/reader.h"
#include "jobs/arm/calibration.h"
#include "jobs/motion_check.h"
#include "jobs/sweep/sweep.h"
#include "jobs/temporary_settings.h"

#include <algorithm>
#include <cmath>

namespace jobs {
namespace {
using base::MoveTestState;
using catalog::Role;
using results::SweepEnd;

/// The ends of the range are mechanical stops, which it must not push against.
constexpr std::int64_t marginFraction = 20;
constexpr std::int64_t minMargin = 20;
/// Little torque holds a heavy arm a little below its goal: 4°.
constexpr double toleranceFraction = 4.0 / 360;
const QString testSpeed = QStringLiteral("10rpm"); // 60 °/s
const QString testAcceleration = QStringLiteral("20");

tl::unexpected<base::Error> refuse(const device::Servo& servo, const char* reason)
{
    return base::fail(base::ErrorCode::NotSupported, QStringLiteral("move-test"),
                      QLatin1String(reason), servo.id);
}

/// From where it stands to both ends and back.
results::SweepSpec specOf(const device::Servo& servo, const JointCalibration& limits)
{
    const std::int64_t low = limits.rangeMin;
    const std::int64_t high = limits.rangeMax;
    const std::int64_t margin =
        std::min((high - low) / 2, std::max(minMargin, (high - low) / marginFraction));
    const std::int64_t now = servo.raw(Role::PresentPosition).value_or(low);
    results::SweepSpec spec;
    spec.shape = results::SweepShape::Points;
    for (const std::int64_t point :
         {std::clamp(now, low + margin, high - margin), low + margin, high - margin})
        spec.points.push_back({QString::number(point)});
    spec.pace = results::SweepPace::Dwell;
    spec.pause = std::chrono::milliseconds(100);
    spec.speed = testSpeed;
    if (servo.profile->byRole(Role::Acceleration) != nullptr)
        spec.acceleration = testAcceleration;
    spec.releaseAtEnd = true;
    return spec;
}

/// It ends without torque, as the user was told: that goals turn it on is nothing to report.
void removeTorqueNotices(device::Notices& notices, std::size_t since)
{
    using base::NoticeCode;
    notices.erase(std::remove_if(notices.begin() + static_cast<std::ptrdiff_t>(since),
                                 notices.end(),
                                 [](const base::Notice& one) {
                                     return one.code == NoticeCode::TorqueSwitchedOn ||
                                            one.code == NoticeCode::TorqueSwitchedOff;
                                 }),
                  notices.end());
}

/// Little torque, and the speed and acceleration of the test, which its goals would leave behind.
base::Result<std::unique_ptr<TemporarySettings>> setTemporarily(const device::Context& context,
                                                                device::Servo& servo, int percent)
{
    const catalog::Register* limit = servo.profile->byRole(Role::TorqueLimit);
    if (limit == nullptr)
        return refuse(servo, "no-torque-limit");
    if (const auto present = device::readRoles(context, servo, {Role::TorqueLimit}); !present)
        return tl::unexpected(present.error());
    const std::int64_t wanted = catalog::toRaw(percent, servo.meaning(*limit));
    std::vector<device::WriteItem> items{
        {limit->key, std::min(wanted, servo.raw(Role::TorqueLimit).value_or(wanted))}};
    for (const auto& [role, text] :
         {std::pair(Role::GoalSpeed, testSpeed), std::pair(Role::Acceleration, testAcceleration)}) {
        const catalog::Register* reg = servo.profile->byRole(role);
        if (reg == nullptr)
            continue;
        const auto raw = catalog::parseValue(text, *reg, servo.meaning(*reg));
        if (!raw)
            return tl::unexpected(raw.error());
        items.push_back({reg->key, *raw});
    }
    return TemporarySettings::set(context, servo, items);
}

class MoveTest {
public:
    MoveTest(device::Servo& servo, const results::SweepSpec& spec, const MoveTestFn& onMove)
        : m_servos{servo}
        , m_servo(servo)
        , m_spec(spec)
        , m_onMove(onMove)
        , m_report{MoveTestState::Moving, servo.raw(Role::PresentPosition).value_or(0),
                   spec.points.front().target.toLongLong()}
    {}

    base::Result<MoveTestReport> run(const device::Context& context)
    {
        SweepRequest request;
        request.spec = m_spec;
        results::SweepLimits limits;
        limits.tolerance = toleranceFraction * m_servo.profile->stepsPerTurn;
        request.limits = {limits};
        SweepCallbacks callbacks;
        callbacks.onSample = [this](std::size_t, const SweepSample& sample, double goal, int leg) {
            if (!sample.position)
                return;
            m_report.position = std::llround(*sample.position);
            if (leg > 0) // before, it goes to the point next to where it stands
                m_report.goal = std::llround(goal);
            m_report.state = MoveTestState::Moving;
            if (m_onMove)
                m_onMove(m_report);
        };
        std::optional<base::Error> notReleased;
        callbacks.onUnreleasedTorque = [&](const UnreleasedTorque& one) {
            notReleased = one.error;
        };
        const auto run = sweep(context, m_servos, request, callbacks);
        m_servo = m_servos.front();
        if (notReleased) { // once more, before it gets its whole torque back
            if (const auto off = device::setTorque(context, m_servo, device::Torque::Off); !off)
                return tl::unexpected(*notReleased);
        }
        return run ? reportOf(*run) : failed(run.error());
    }

private:
    /// It did not even reach the point next to where it stood.
    base::Result<MoveTestReport> failed(const base::Error& error)
    {
        if (error.code != base::ErrorCode::Refused || error.detail != QLatin1String("no-start"))
            return tl::unexpected(error);
        m_report.state = MoveTestState::NotReached;
        return m_report;
    }

    base::Result<MoveTestReport> reportOf(const results::SweepRun& run)
    {
        const auto& legs = run.servos.front().legs;
        const auto missed = std::find_if(legs.begin(), legs.end(),
                                         [](const results::SweepLeg& leg) { return leg.missed; });
        switch (run.end) {
        case SweepEnd::Finished:
            if (missed == legs.end()) {
                m_report.state = MoveTestState::Reached;
                return m_report;
            }
            m_report.goal = std::llround(missed->target);
            m_report.position = std::llround(missed->reached.value_or(missed->start));
            [[fallthrough]];
        case SweepEnd::Stall:
        case SweepEnd::Failure:
            m_report.state = MoveTestState::NotReached;
            return m_report;
        case SweepEnd::Alarm:
            m_report.state = MoveTestState::Alarm;
            return m_report;
        case SweepEnd::TorqueLost:
        case SweepEnd::ServoReplaced:
        case SweepEnd::Refused:
            m_report.state = MoveTestState::TorqueLost;
            return m_report;
        case SweepEnd::Stopped:
            return base::fail(base::ErrorCode::Stopped, QStringLiteral("move-test"));
        case SweepEnd::Emergency:
            return base::fail(base::ErrorCode::Preempted, QStringLiteral("move-test"));
        case SweepEnd::LinkLost:
            break;
        }
        return base::fail(base::ErrorCode::LinkLost, QStringLiteral("move-test"), {}, m_servo.id);
    }

    std::vector<device::Servo> m_servos;
    device::Servo& m_servo;
    const results::SweepSpec m_spec;
    const MoveTestFn& m_onMove;
    MoveTestReport m_report;
};
} // namespace

base::Result<MoveTestReport> testMoves(const device::Context& context, device::Servo& servo,
                                       int torquePercent, const MoveTestFn& onMove)
{
    if (const auto read = device::readRoles(context, servo, {Role::PresentPosition}); !read)
        return tl::unexpected(read.error());
    const auto limits = calibrationIn(servo);
    if (!limits)
        return refuse(servo, "no-position-limits");
    if (limits->rangeMin >= limits->rangeMax || !isInPositionMode(servo))
        return tl::unexpected(notInPositionMode(QStringLiteral("move-test"), servo));
    const auto torque = setTemporarily(context, servo, torquePercent);
    if (!torque)
        return tl::unexpected(torque.error());
    const std::size_t since = context.notices.size();
    auto report = MoveTest(servo, specOf(servo, *limits), onMove).run(context);
    removeTorqueNotices(context.notices, since);
    const auto restored = (*torque)->revert();
    if (report && !restored)
        return tl::unexpected(restored.error());
    return report;
}
} // namespace jobs
