// SPDX-License-Identifier: GPL-3.0-or-later
#include "jobs/sweep/sweep_reader.h"

#include "device/motion/turn_count.h"
#include "jobs/sweep/sweep_axis.h"
#include "jobs/watch/poll_spans.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace jobs {
using base::Duration;
using catalog::Role;

namespace {
constexpr std::array measuredRoles{
    Role::PresentPosition, Role::PresentSpeed,       Role::PresentLoad, Role::PresentCurrent,
    Role::PresentVoltage,  Role::PresentTemperature, Role::Moving,      Role::Status};

/// A swing over the seam: the greatest age of the reading before, and how far it may go, in turns.
constexpr Duration maxSeamGap = std::chrono::milliseconds(200);
constexpr double seamTolerance = 0.125;
} // namespace

SweepReader::SweepReader(const std::vector<device::Servo>& servos)
{
    SyncReadGroups families;
    for (const device::Servo& servo : servos) {
        Source source;
        source.servo = servo;
        source.stepsPerTurn = stepsPerTurn(servo);
        source.group = families.of(*servo.profile);
        const device::TurnBasis basis = device::turnBasis(servo);
        const catalog::Mode* mode = servo.mode();
        source.wraps = basis.steps > 0 && !basis.countsTurns && mode != nullptr;
        source.limited = source.wraps && !mode->limitsZero;
        std::vector<const catalog::Register*> registers;
        for (const Role role : measuredRoles) {
            const catalog::Register* reg = servo.profile->byRole(role);
            const bool inReply = role == Role::Status && servo.repliesCarryStatus();
            if (reg != nullptr && servo.measures(*reg) && !inReply)
                registers.push_back(reg);
        }
        source.reader = PollReader(registers, pollSpans(*servo.profile, registers, {}));
        source.reader.updateMeanings(servo);
        m_sources.push_back(std::move(source));
    }
}

bus::PollPlan SweepReader::plan() const
{
    bus::PollPlan plan;
    for (const Source& source : m_sources)
        plan.servos.push_back(pollServo(source.servo, source.reader.spans(), source.group));
    return plan;
}

std::optional<SweepReader::Reading> SweepReader::add(const bus::Sample& sample)
{
    const auto found = std::find_if(m_sources.begin(), m_sources.end(), [&](const Source& source) {
        return source.servo.id == sample.id && source.servo.protocol == sample.protocol;
    });
    if (found == m_sources.end())
        return std::nullopt;
    Source& source = *found;
    source.reader.takeUnfinishedBefore(sample);
    const auto reading = source.reader.add(sample, &source.servo);
    if (!reading)
        return std::nullopt;
    return Reading{std::size_t(found - m_sources.begin()), toSample(source, *reading)};
}

/// A reading is never half a turn away from the one before.
double SweepReader::unwrap(Source& source, double position, Duration at)
{
    if (!source.wraps)
        return position;
    if (source.limited)
        return unwrapNearSeam(source, position, at);
    if (source.last)
        source.turns += std::round((*source.last - position - source.turns) / source.stepsPerTurn) *
                        source.stepsPerTurn;
    source.last = position + source.turns;
    return *source.last;
}

/// Beyond 0 or the last step an encoder goes on from the other end: a swing over the target there
/// must not look like a jump of a turn. It is a swing only if the reading before was near enough.
double SweepReader::unwrapNearSeam(Source& source, double position, Duration at)
{
    const double turn = source.stepsPerTurn;
    double found = position;
    if (source.last && at - source.lastAt < maxSeamGap) {
        const double near = position + std::round((*source.last - position) / turn) * turn;
        const bool swing = near > -turn * seamTolerance && near < turn * (1 + seamTolerance);
        found = swing ? near : position;
    }
    source.last = found;
    source.lastAt = at;
    return found;
}

void SweepReader::anchor(std::size_t servo, double position)
{
    Source& source = m_sources.at(servo);
    if (!source.wraps || source.limited || !source.last)
        return;
    const double turns =
        std::round((position - *source.last) / source.stepsPerTurn) * source.stepsPerTurn;
    source.turns += turns;
    *source.last += turns;
}

SweepSample SweepReader::toSample(Source& source, const PollReading& reading)
{
    SweepSample sample;
    sample.at = reading.at;
    sample.answered = reading.answered;
    sample.status = reading.status;
    for (const PollValue& value : reading.values) {
        switch (value.reg->role) {
        case Role::PresentPosition: // in steps, whatever unit is shown
            sample.position = unwrap(source, double(value.raw), reading.at);
            break;
        case Role::PresentSpeed:
            sample.speed =
                toSteps(value.physical, source.servo.meaning(*value.reg).unit, source.stepsPerTurn);
            break;
        case Role::PresentLoad:
            sample.load = value.physical;
            break;
        case Role::PresentCurrent:
            sample.current = value.physical;
            break;
        case Role::PresentVoltage:
            sample.voltage = value.physical;
            break;
        case Role::PresentTemperature:
            sample.temperature = value.physical;
            break;
        case Role::Moving:
            sample.moving = value.raw != 0;
            break;
        default:
            break;
        }
    }
    return sample;
}
} // namespace jobs
