// SPDX-License-Identifier: GPL-3.0-or-later
// Goals of a sweep test on their way, and whether they may go.
#include "device/transactions.h"
#include "device/write_access.h"
#include "jobs/sweep/sweep_runner.h"

#include <algorithm>

namespace jobs {
using base::ErrorCode;
using record::SweepEnd;

/// Tries again while the line is silent; what else goes wrong is said to the caller.
base::Result<void> SweepRunner::send(std::vector<double> targets)
{
    for (;;) {
        const bool anySign = m_checkHolding || isAnySilent();
        // A servo that rests at its target shows no sign of torque that was switched off, nor of an
        // exchange. Goals of a sine follow each other too closely to ask before each of them.
        m_checkHolding |= m_run.spec.shape != record::SweepShape::Sine || !m_hasSentGoal;
        const auto isHolding = areStillHolding();
        if (isHolding && !*isHolding) {
            m_isLegUncertain |= !anySign; // that may have been before that leg was over
            return {};
        }
        const auto sent = isHolding ? sendSweepGoals(m_context, m_servos, m_run.spec, targets)
                                    : base::Result<void>(tl::unexpected(isHolding.error()));
        if (sent) {
            for (std::size_t i = 0; i < m_tracks.size(); ++i)
                m_tracks[i].goal = targets[i];
            m_hasSentGoal = true;
            return {};
        }
        if (!canRetry(sent.error()))
            return hasEnded() ? base::Result<void>{} : sent;
    }
}

/// After an error that a silent line explains, once it has been listened to for a while. What ends
/// the test ends it here.
bool SweepRunner::canRetry(const base::Error& error)
{
    switch (error.code) {
    case ErrorCode::NoReply:
    case ErrorCode::Garbled:
    case ErrorCode::UnexpectedReply:
    case ErrorCode::LineBusy:
    case ErrorCode::Uncertain: // a place to go to may be named twice
        m_checkHolding = true;
        readUntil(now() + minGap, [] { return false; });
        return !hasEnded();
    case ErrorCode::Stopped:
        endRun(SweepEnd::Stopped);
        return false;
    case ErrorCode::Preempted:
        endRun(SweepEnd::Emergency);
        return false;
    case ErrorCode::LinkLost:
        endRun(SweepEnd::LinkLost);
        return false;
    case ErrorCode::IdentityMismatch:
        endReplaced(indexOfServo(error.id));
        return false;
    default:
        return false;
    }
}

/// A servo that has restarted, or was switched off by another program, has no torque, and a goal
/// would switch it on by surprise, from wherever it has sunk to; one that came in its place has
/// other limits. Then the run ends, and this is false. Before the first goal torque may be off by
/// right: that goal is to switch it on.
base::Result<bool> SweepRunner::areStillHolding()
{
    m_checkHolding |= isAnySilent();
    if (!m_checkHolding)
        return true;
    if (const auto asked = findReplacedServos(); !asked)
        return tl::unexpected(asked.error());
    for (std::size_t i = 0; m_hasSentGoal && i < m_servos.size(); ++i) {
        device::Servo& servo = m_servos[i];
        const catalog::Register* torque = servo.profile->byRole(catalog::Role::TorqueSwitch);
        if (torque == nullptr || m_tracks[i].isReplaced)
            continue;
        const auto raw = device::readRegister(m_context, servo, *torque);
        if (!raw && hasEnded())
            continue; // that another one has lost it is known
        if (!raw)
            return tl::unexpected(raw.error());
        m_tracks[i].hasLostTorque = *raw == 0;
        if (*raw == 0)
            endRun(SweepEnd::TorqueLost, int(i));
    }
    m_checkHolding = false;
    return std::all_of(m_tracks.begin(), m_tracks.end(),
                       [](const ServoTrack& track) { return track.isHolding(); });
}

/// A servo can be exchanged for another one of its ID, with or without a silence in between.
base::Result<void> SweepRunner::findReplacedServos()
{
    const auto ask = [this](const device::Servo& servo) {
        return device::requireSameServo(m_context, servo, QStringLiteral("sweep"));
    };
    for (std::size_t i = 0; i < m_servos.size(); ++i) {
        auto same = ask(m_servos[i]);
        // Asked so often, a disturbed reply may pass its check sum; hardly twice in a row.
        if (!same && same.error().code == ErrorCode::IdentityMismatch)
            same = ask(m_servos[i]);
        if (!same && same.error().code == ErrorCode::IdentityMismatch)
            endReplaced(int(i));
        else if (!same && !hasEnded())
            return same;
    }
    return {};
}

void SweepRunner::endReplaced(int servo)
{
    if (servo >= 0)
        m_tracks[std::size_t(servo)].isReplaced = true;
    endRun(SweepEnd::ServoReplaced, servo);
}

/// Asks every servo; a silence is waited out. False: the run has ended.
bool SweepRunner::confirmHolding()
{
    while (!hasEnded()) {
        m_checkHolding = true;
        const auto isHolding = areStillHolding();
        if (isHolding)
            return *isHolding;
        if (!canRetry(isHolding.error()))
            endRun(SweepEnd::Refused);
    }
    return false;
}

bool SweepRunner::isAnySilent() const
{
    return std::any_of(m_tracks.begin(), m_tracks.end(), [this](const ServoTrack& track) {
        return now() - track.lastReplyAt >= minGap;
    });
}

bool SweepRunner::sendOrEnd(const std::vector<double>& targets)
{
    const auto sent = send(targets);
    if (!sent) {
        // The servo does not take a goal it took before: its limits or mode have changed.
        endRun(SweepEnd::Refused, indexOfServo(sent.error().id));
    }
    return !hasEnded();
}

int SweepRunner::indexOfServo(int id) const
{
    for (std::size_t i = 0; i < m_servos.size(); ++i) {
        if (m_servos[i].id == id)
            return int(i);
    }
    return -1;
}
} // namespace jobs
