// SPDX-License-Identifier: GPL-3.0-or-later
#include "jobs/sweep/sweep_reader.h"

#include "device/alarms.h"
#include "device/motion/turn_count.h"
#include "jobs/sweep/sweep_axis.h"

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

/// So old may the reading before be for a swing over the seam, and so far may it go, in turns.
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
        for (const Role role : measuredRoles) {
            const catalog::Register* reg = servo.profile->byRole(role);
            const bool inReply = role == Role::Status && servo.repliesCarryStatus();
            if (reg != nullptr && servo.measures(*reg) && !inReply)
                source.registers.push_back(reg);
        }
        source.spans = pollSpans(*servo.profile, source.registers, {});
        m_sources.push_back(std::move(source));
    }
}

bus::PollPlan SweepReader::plan() const
{
    bus::PollPlan plan;
    for (const Source& source : m_sources) {
        const catalog::Profile& profile = *source.servo.profile;
        plan.servos.push_back({source.servo.id, source.spans, profile.syncRead, source.group,
                               source.servo.protocol, profile.readGap, profile.maxRead});
    }
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
    const std::size_t block = blockIndex(sample, source.spans);
    if (source.pollRound.startsNewRound(block)) {
        source.pollRound.reset();
        source.pending = {};
    }
    source.pending.at = sample.at;
    if (sample.answered)
        take(source, sample);
    if (!source.pollRound.take(block, sample))
        return std::nullopt;
    source.pollRound.reset();
    return Reading{std::size_t(found - m_sources.begin()), std::exchange(source.pending, {})};
}

void SweepReader::take(Source& source, const bus::Sample& sample)
{
    source.pending.answered = true;
    device::Servo& servo = source.servo;
    if (servo.repliesCarryStatus()) {
        source.pending.status = sample.status;
    } else {
        servo.image.store(sample.address, sample.data, sample.at);
        device::updateStatus(servo, sample.address, int(sample.data.size()));
        source.pending.status = servo.status;
    }
    for (const catalog::Register* reg : source.registers) {
        const int offset = reg->offset - sample.address;
        if (offset < 0 || offset + reg->size > int(sample.data.size()))
            continue;
        const auto wire =
            base::ByteView(sample.data).subspan(std::size_t(offset), std::size_t(reg->size));
        storeValue(source.pending, source, *reg,
                   catalog::decodeRaw(wire, *reg, servo.meaning(*reg), servo.profile->byteOrder));
    }
}

/// A reading is never half a turn away from the one before.
double SweepReader::unwrap(Source& source, double position)
{
    if (!source.wraps)
        return position;
    if (source.limited)
        return unwrapNearSeam(source, position);
    if (source.last)
        source.turns += std::round((*source.last - position - source.turns) / source.stepsPerTurn) *
                        source.stepsPerTurn;
    source.last = position + source.turns;
    return *source.last;
}

/// Beyond 0 or the last step an encoder goes on from the other end: a swing over the target there
/// must not look like a jump of a turn. It is a swing only if the reading before was near enough.
double SweepReader::unwrapNearSeam(Source& source, double position)
{
    const double turn = source.stepsPerTurn;
    const Duration at = source.pending.at;
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

void SweepReader::storeValue(SweepSample& into, Source& source, const catalog::Register& reg,
                             std::int64_t raw)
{
    const catalog::ValueFormat meaning = source.servo.meaning(reg);
    const double physical = catalog::toPhysical(raw, meaning);
    switch (reg.role) {
    case Role::PresentPosition: // in steps, whatever unit is shown
        into.position = unwrap(source, double(raw));
        break;
    case Role::PresentSpeed:
        into.speed = toSteps(physical, meaning.unit, source.stepsPerTurn);
        break;
    case Role::PresentLoad:
        into.load = physical;
        break;
    case Role::PresentCurrent:
        into.current = physical;
        break;
    case Role::PresentVoltage:
        into.voltage = physical;
        break;
    case Role::PresentTemperature:
        into.temperature = physical;
        break;
    case Role::Moving:
        into.moving = raw != 0;
        break;
    default:
        break;
    }
}
} // namespace jobs
