// SPDX-License-Identifier: GPL-3.0-or-later
// Ending a motion: the command, and the proof that the shaft has come to rest.
#include "device/motion/hold_position.h"
#include "device/motion/mode.h"
#include "device/motion/motion.h"
#include "device/motion/torque_off.h"
#include "device/write_access.h"

#include <cmath>
#include <cstdlib>

namespace device {
using base::ErrorCode;
using catalog::Role;
using namespace std::chrono_literals;

namespace {
constexpr std::int64_t torqueIsOn = 1;
/// Enough for three steps of the slowest move (LX: 1000 steps in 30 s).
constexpr base::Duration haltReadInterval = 100ms;
/// A braking servo is slower by `slower` within this time; otherwise it keeps turning.
constexpr base::Duration brakingTimeout = 600ms;
constexpr double slowdownFactor = 0.95;
constexpr base::Duration maxBrakingTime = 10s;
/// Near a position goal (1/64 turn) the shaft may still swing.
constexpr int nearFraction = 64;
/// Far from its goal a servo counts as at rest after this number of readings without motion.
constexpr int minHeldReadings = 10;

struct MotionReading {
    base::Duration at{};
    std::int64_t position = 0;
    bool turning = false; ///< by its moving flag or its speed
};

base::Result<MotionReading> readMotion(const Context& context, Servo& servo)
{
    const auto done =
        readRoles(context, servo, {Role::PresentPosition, Role::PresentSpeed, Role::Moving});
    if (!done)
        return tl::unexpected(done.error());
    const auto position = servo.raw(Role::PresentPosition);
    if (!position)
        return base::fail(ErrorCode::NotSupported, QStringLiteral("torque"),
                          QStringLiteral("position"), servo.id);
    // HLS: bit 1 only means that the goal has not been reached.
    constexpr std::int64_t movingBit = 1;
    const bool flag = (servo.raw(Role::Moving).value_or(0) & movingBit) != 0;
    return MotionReading{context.bus.clock().now(), *position,
                         flag || servo.raw(Role::PresentSpeed).value_or(0) != 0};
}

/// Follows a servo after its stop command.
class BrakingMonitor {
public:
    BrakingMonitor(const Servo& servo, std::optional<std::int64_t> goal, const MotionReading& first)
        : m_turn(servo.profile->stepsPerTurn)
        , m_goal(goal)
        , m_factor(std::max<std::int64_t>(1, servo.raw(Role::AngleResolution).value_or(1)))
        , m_endless(servo.mode() != nullptr && servo.mode()->command != Role::GoalPosition)
        , m_begin(first.at)
        , m_improvedAt(first.at)
        , m_last(first)
        , m_distance(distance(first))
    {}

    void add(const MotionReading& now)
    {
        const double moved = distanceBetween(now.position, m_last.position);
        const double seconds = std::chrono::duration<double>(now.at - m_last.at).count();
        const bool wasNear = isNear(m_last);
        m_standing = moved <= 1 ? m_standing + 1 : 0; // the last step of the encoder flickers
        m_resting = m_standing > 0 && !now.turning;
        if (!m_endless)
            m_resting = m_resting || (wasNear && isNear(now)) || m_standing >= minHeldReadings;
        bool improved = lowerMinimum(m_speed, seconds > 0 ? moved / seconds : 0);
        if (m_goal) {
            const double left = distance(now);
            if (left > distanceBetween(m_last.position, *m_goal * m_factor))
                m_distance = left; // overshoots: counted from where it turns back
            improved = lowerMinimum(m_distance, left) || improved;
        }
        m_improvedAt = improved ? now.at : m_improvedAt;
        m_last = now;
    }

    bool resting() const { return m_resting; }
    bool isStillTurning() const
    {
        const bool mayStand = !m_endless && m_standing > 0;
        return m_last.at - m_begin > maxBrakingTime ||
               (!mayStand && m_last.at - m_improvedAt > brakingTimeout);
    }

private:
    double distanceBetween(std::int64_t a, std::int64_t b) const
    {
        return std::abs(std::remainder(static_cast<double>(a - b), m_turn));
    }
    double distance(const MotionReading& at) const
    {
        return m_goal ? distanceBetween(at.position, *m_goal * m_factor) : 0;
    }
    bool isNear(const MotionReading& at) const
    {
        return m_goal && distance(at) <= m_turn / nearFraction * static_cast<double>(m_factor);
    }
    static bool lowerMinimum(std::optional<double>& minimum, double now)
    {
        if (minimum && now >= *minimum * slowdownFactor)
            return false;
        minimum = now;
        return true;
    }

    double m_turn;
    std::optional<std::int64_t> m_goal;
    std::int64_t m_factor;
    bool m_endless;
    base::Duration m_begin;
    base::Duration m_improvedAt;
    MotionReading m_last;
    std::optional<double> m_speed{}; ///< the slowest so far, steps a second
    std::optional<double> m_distance;
    int m_standing = 0;
    bool m_resting = false;
};

/// False when it keeps turning. A servo that slows down is waited for.
base::Result<bool> waitForRest(const Context& context, Servo& servo,
                               std::optional<std::int64_t> goal)
{
    const auto first = readMotion(context, servo);
    if (!first)
        return tl::unexpected(first.error());
    BrakingMonitor check(servo, goal, *first);
    while (!check.resting()) {
        if (check.isStillTurning())
            return false;
        base::Clock& clock = context.bus.clock();
        if (!context.bus.pauseUntil(clock.now() + haltReadInterval, &context.stop))
            return base::fail(ErrorCode::Stopped, QStringLiteral("torque"), {}, servo.id);
        const auto now = readMotion(context, servo);
        if (!now)
            return tl::unexpected(now.error());
        check.add(*now);
    }
    return true;
}

/// No position to hold is known: torque off ends the motion for certain.
bool cannotHold(const base::Error& error)
{
    return error.code == ErrorCode::TurnsUnknown || error.code == ErrorCode::OutOfRange ||
           error.code == ErrorCode::NotSupported;
}

base::Result<HaltCommand> holdStill(const Context& context, Servo& servo)
{
    const auto holding = holdValues(servo);
    if (!holding && cannotHold(holding.error()))
        return torqueOff(context, servo).map([] { return HaltCommand{}; });
    if (!holding)
        return tl::unexpected(holding.error());
    if (const auto written = writeVerified(context, servo, *holding); !written)
        return tl::unexpected(written.error());
    return HaltCommand{HaltCommand::Kind::Holding, holding->front().reg, holding->front().raw};
}

/// Ends the present move at the present position (LX). There is no reply, so it is sent more than
/// once.
base::Result<HaltCommand> sendHalt(const Context& context, Servo& servo)
{
    constexpr int sendCount = 3;
    for (int sent = 0; sent < sendCount; ++sent) {
        bus::Transaction transaction;
        transaction.request = protocol::Request::halt(servo.id).in(servo.protocol);
        transaction.priority = context.priority;
        transaction.hold = context.hold;
        transaction.epoch = context.epoch;
        if (const auto result = context.bus.transact(transaction); !result)
            return tl::unexpected(result.error());
    }
    return HaltCommand{HaltCommand::Kind::StopCommand};
}

/// Signs of a second servo, or of a line on which a second one could not be noticed.
std::uint64_t busErrorCount(const Context& context)
{
    const bus::Counters total = context.bus.statistics().total;
    return total.badChecksums + total.foreign + total.late + total.noiseBytes + total.retried;
}

/// Is sent before it is proven that one servo answers alone: that takes a dozen reads, and
/// confirm() makes up for it. A standstill in speed or PWM mode and the stop command of LX are the
/// same command for every servo that receives them. A position to hold belongs to one servo, so the
/// reads that lead to it must have been clean: replies of two servos are clean only if they are
/// equal, and then the position is the same. `before`: the signs before those reads.
base::Result<HaltCommand> commandTurning(const Context& context, Servo& servo, std::uint64_t before)
{
    Context atOnce = context;
    atOnce.emergencyStop = true;
    const catalog::Mode* mode = servo.mode();
    // A step under way cannot be reverted by another one.
    if (mode != nullptr && isRelative(*mode))
        return torqueOff(atOnce, servo).map([] { return HaltCommand{}; });
    const bool drivesPosition = mode != nullptr && mode->command == Role::GoalPosition;
    if (drivesPosition && canEncode(servo, protocol::Request::halt(servo.id)))
        return sendHalt(context, servo);
    if (mode != nullptr && !drivesPosition)
        return holdStill(atOnce, servo);
    if (const auto fresh = readRoles(context, servo, {Role::PresentPosition}); !fresh)
        return tl::unexpected(fresh.error());
    if (busErrorCount(context) == before)
        return holdStill(atOnce, servo);
    if (const auto alone = requireVerified(context, servo, QStringLiteral("torque")); !alone)
        return tl::unexpected(alone.error());
    if (const auto fresh = readRoles(context, servo, {Role::PresentPosition}); !fresh)
        return tl::unexpected(fresh.error());
    return holdStill(context, servo);
}

/// Nothing with a register: torque is off already.
base::Result<HaltCommand> command(const Context& context, Servo& servo)
{
    const QString operation = QStringLiteral("torque");
    const bool verified =
        context.bus.verifiedIds().contains(servo.protocol, servo.id, context.bus.baud());
    const auto may =
        verified ? beginWriting(context, servo, operation) : requireWritable(servo, operation);
    if (!may)
        return tl::unexpected(may.error());
    const catalog::Register* torque = servo.profile->byRole(Role::TorqueSwitch);
    if (torque == nullptr)
        return base::fail(ErrorCode::NotSupported, operation, operation, servo.id);
    const std::uint64_t before = busErrorCount(context);
    if (const auto fresh = readSettings(context, servo); !fresh)
        return tl::unexpected(fresh.error());
    if (auto obstacle = writeObstacle(servo)) {
        obstacle->operation = operation;
        return tl::unexpected(std::move(*obstacle));
    }
    if (servo.raw(*torque).value_or(0) != torqueIsOn)
        return HaltCommand{HaltCommand::Kind::Nothing, torque};
    return commandTurning(context, servo, before);
}

/// True when the stop command has acted: the shaft does not move between two readings.
base::Result<bool> hasStopped(const Context& context, Servo& servo)
{
    const auto first = readMotion(context, servo);
    if (!first)
        return tl::unexpected(first.error());
    context.bus.clock().sleepFor(haltReadInterval);
    return readMotion(context, servo).map([&](const MotionReading& second) {
        return std::abs(second.position - first->position) <= 1;
    });
}

base::Result<void> confirm(const Context& context, Servo& servo, HaltCommand command)
{
    if (const auto alone = requireVerified(context, servo, QStringLiteral("torque")); !alone)
        return alone;
    if (command.kind == HaltCommand::Kind::StopCommand) {
        const auto heard = hasStopped(context, servo);
        if (!heard)
            return tl::unexpected(heard.error());
        if (*heard)
            return {};
        // A servo that still moves gets its present position as the goal.
        auto holding = holdStill(context, servo);
        if (!holding && holding.error().code == ErrorCode::Mismatch)
            holding.error().code = ErrorCode::Refused;
        if (!holding)
            return tl::unexpected(holding.error());
        command = *holding;
    }
    if (command.kind == HaltCommand::Kind::Nothing) {
        if (command.reg != nullptr)
            context.note(NoticeCode::AlreadySet, servo.id, command.reg->key);
        return {};
    }
    const bool position = command.reg->role == Role::GoalPosition;
    const auto rests =
        waitForRest(context, servo, position ? std::optional(command.raw) : std::nullopt);
    if (!rests)
        return tl::unexpected(rests.error());
    if (!*rests)
        return torqueOff(context, servo);
    context.note(NoticeCode::HoldingAt, servo.id, command.reg->key, command.raw);
    return {};
}
} // namespace

base::Result<HaltCommand> commandHalt(const Context& outer, Servo& servo)
{
    const Owned owned = own(outer, {servo.id});
    auto commanded = command(owned.context, servo);
    if (commanded)
        return commanded;
    return forceTorqueOff(owned.context, servo, std::move(commanded.error())).map([] {
        return HaltCommand{};
    });
}

base::Result<void> confirmHalt(const Context& outer, Servo& servo, const HaltCommand& command)
{
    const Owned owned = own(outer, {servo.id});
    auto halted = confirm(owned.context, servo, command);
    return halted ? halted : forceTorqueOff(owned.context, servo, std::move(halted.error()));
}

base::Result<void> halt(const Context& outer, Servo& servo)
{
    const Owned owned = own(outer, {servo.id});
    const auto commanded = commandHalt(owned.context, servo);
    return commanded ? confirmHalt(owned.context, servo, *commanded)
                     : tl::unexpected(commanded.error());
}

std::vector<base::Result<void>> haltAll(const Context& context, const std::vector<Servo*>& servos)
{
    // One that does not reply must not keep the others moving: it is asked again after them.
    Context quick = context;
    quick.patient = false;
    std::vector<base::Result<HaltCommand>> commanded;
    for (Servo* servo : servos) {
        const Owned owned = own(quick, {servo->id});
        commanded.push_back(command(owned.context, *servo));
    }
    for (std::size_t i = 0; i < servos.size(); ++i) {
        if (!commanded[i])
            commanded[i] = commandHalt(context, *servos[i]);
    }
    std::vector<base::Result<void>> halted;
    for (std::size_t i = 0; i < servos.size(); ++i) {
        halted.push_back(commanded[i] ? confirmHalt(context, *servos[i], *commanded[i])
                                      : tl::unexpected(commanded[i].error()));
    }
    return halted;
}
} // namespace device
