// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/motion/mode.h"
#include "device/motion/motion.h"
#include "device/write_access.h"
#include "device/write_check.h"

#include <QRegularExpression>

namespace device {
using base::ErrorCode;
using catalog::Role;

namespace {
tl::unexpected<base::Error> refuse(ErrorCode code, const Servo& servo, const QString& key,
                                   const QString& detail)
{
    return tl::unexpected(base::Error{code, QStringLiteral("move"), detail, servo.id, key});
}

QString fieldName(Role role)
{
    if (role == Role::GoalCurrent)
        return QStringLiteral("current");
    return role == Role::Acceleration ? QStringLiteral("acceleration") : QStringLiteral("speed");
}

/// Builds the list of fields; holds what the helpers share.
class Planner {
public:
    Planner(const Context& context, const MoveCommand& command)
        : m_context(context)
        , m_command(command)
        , m_servo(*command.servo)
    {}

    base::Result<MovePlan> plan();

private:
    base::Result<void> addField(Role role, const QString& text);
    base::Result<void> addAcceleration();
    base::Result<void> addSpeed();
    base::Result<void> addTime();
    base::Result<void> addCurrent();
    base::Result<void> addGoal();
    base::Result<void> readState();
    bool drivesPosition() const { return m_mode->command == Role::GoalPosition; }

    const Context& m_context;
    const MoveCommand& m_command;
    Servo& m_servo;
    const catalog::Mode* m_mode = nullptr;
    MovePlan m_plan;
};

base::Result<void> Planner::addField(Role role, const QString& text)
{
    const catalog::Register* reg = m_servo.profile->byRole(role);
    if (reg == nullptr)
        return refuse(ErrorCode::NotSupported, m_servo, {}, fieldName(role));
    const auto meaning = m_servo.meaning(*reg);
    const auto raw = catalog::parseValue(text, *reg, meaning);
    if (!raw) {
        base::Error error = raw.error();
        error.id = m_servo.id;
        error.registerKey = reg->key;
        return tl::unexpected(error);
    }
    const auto valid = checkValues(m_context, m_servo, {{reg, *raw}});
    if (!valid)
        return valid;
    m_plan.fields.push_back({reg->key, *raw});
    return {};
}

base::Result<void> Planner::addAcceleration()
{
    return m_command.acceleration ? addField(Role::Acceleration, *m_command.acceleration)
                                  : base::Result<void>{};
}

base::Result<void> Planner::addSpeed()
{
    if (!m_command.speed)
        return {};
    if (!drivesPosition())
        return refuse(ErrorCode::NotSupported, m_servo, QStringLiteral("speed"), m_mode->key);
    if (sharesFrameWithMode(*m_servo.profile, Role::GoalSpeed))
        return refuse(ErrorCode::NotSupported, m_servo, {}, QStringLiteral("speed-by-time"));
    const auto added = addField(Role::GoalSpeed, *m_command.speed);
    // The sign means something in speed mode only.
    if (added && m_plan.fields.back().raw < 0)
        return refuse(ErrorCode::OutOfRange, m_servo, QStringLiteral("speed"),
                      QStringLiteral("< 0"));
    return added;
}

/// Milliseconds. SCS: they act while the speed is 0; LX: they are sent with every goal.
base::Result<void> Planner::addTime()
{
    const catalog::Register* reg = m_servo.profile->byRole(Role::GoalTime);
    if (!m_command.time) {
        const catalog::Register* goal = m_servo.profile->byRole(Role::GoalPosition);
        if (reg != nullptr && drivesPosition() && reg->block && reg->block == goal->block)
            m_plan.fields.push_back({reg->key, 0});
        return {};
    }
    if (reg == nullptr || !drivesPosition())
        return refuse(ErrorCode::NotSupported, m_servo, QStringLiteral("time"), m_mode->key);
    if (m_command.speed) {
        return refuse(ErrorCode::BadArgument, m_servo, QStringLiteral("time"),
                      QStringLiteral("speed"));
    }
    if (const auto added = addField(Role::GoalTime, *m_command.time); !added)
        return added;
    m_plan.travelTime = std::chrono::milliseconds(m_plan.fields.back().raw);
    const catalog::Register* speed = m_servo.profile->byRole(Role::GoalSpeed);
    if (speed != nullptr && !sharesFrameWithMode(*m_servo.profile, Role::GoalSpeed) &&
        m_servo.raw(*speed).value_or(1) != 0) {
        m_plan.fields.push_back({speed->key, 0});
        m_context.note(NoticeCode::SpeedZeroedForTime, m_servo.id, speed->key);
    }
    return {};
}

/// The current of this move. In the modes it drives it is the goal itself. 0 means no torque at
/// all: sendMoves notes it.
base::Result<void> Planner::addCurrent()
{
    if (!m_command.current)
        return {};
    if (m_mode->command == Role::GoalCurrent)
        return refuse(ErrorCode::NotSupported, m_servo, QStringLiteral("current"), m_mode->key);
    const auto added = addField(Role::GoalCurrent, *m_command.current);
    if (added && m_plan.fields.back().raw < 0) {
        return refuse(ErrorCode::OutOfRange, m_servo, QStringLiteral("current"),
                      QStringLiteral("< 0"));
    }
    return added;
}

base::Result<void> Planner::addGoal()
{
    static const QRegularExpression bareNumber(QStringLiteral("^\\s*[-+]?\\d+\\s*$"));
    const QString unit = m_servo.meaning(*m_servo.profile->byRole(m_mode->command)).unit;
    if (!drivesPosition() && !unit.isEmpty() && bareNumber.match(m_command.goal).hasMatch()) {
        // A user who types "2048" means a position; as a speed it would turn forever.
        return refuse(ErrorCode::BadArgument, m_servo, m_mode->key, QStringLiteral("unit ") + unit);
    }
    const auto added = addField(m_mode->command, m_command.goal);
    if (added)
        m_plan.goalRaw = m_plan.fields.back().raw;
    return added;
}

/// What the fields are checked against.
base::Result<void> Planner::readState()
{
    const base::Duration now = m_context.bus.clock().now();
    const bool known = m_command.maxSettingsAge > base::Duration::zero() &&
                       settingsReadSince(m_servo, now - m_command.maxSettingsAge);
    if (!known) {
        if (const auto fresh = readSettings(m_context, m_servo); !fresh)
            return fresh;
    }
    m_mode = m_servo.mode();
    if (m_mode == nullptr || m_servo.profile->byRole(m_mode->command) == nullptr)
        return refuse(ErrorCode::NotSupported, m_servo, {}, QStringLiteral("mode"));
    if (!m_command.mode.isEmpty() && m_command.mode != m_mode->key)
        return refuse(ErrorCode::Refused, m_servo, m_mode->key, QStringLiteral("mode-changed"));
    return {};
}

base::Result<MovePlan> Planner::plan()
{
    if (const auto writable = requireWritable(m_servo, QStringLiteral("move")); !writable)
        return tl::unexpected(writable.error());
    if (const auto known = readState(); !known)
        return tl::unexpected(known.error());
    m_plan.servo = &m_servo;
    m_plan.mode = m_mode->key;
    m_plan.goalRole = m_mode->command;
    m_plan.relative = isRelative(*m_mode);
    m_plan.energizes = m_servo.raw(Role::TorqueSwitch).value_or(0) != 1;
    for (const auto add : {&Planner::addAcceleration, &Planner::addSpeed, &Planner::addTime,
                           &Planner::addCurrent, &Planner::addGoal}) {
        if (const auto added = (this->*add)(); !added)
            return tl::unexpected(added.error());
    }
    return m_plan;
}
} // namespace

base::Result<MovePlan> planMove(const Context& context, const MoveCommand& command)
{
    return Planner(context, command).plan();
}
} // namespace device
