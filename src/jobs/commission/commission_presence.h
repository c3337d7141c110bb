// SPDX-License-Identifier: GPL-3.0-or-later
// Which servo is connected to the line: waits until one servo replies alone, checks that it still
// is the same one, and waits until it is disconnected. Writes nothing. Internal to jobs; the job's
// thread. Errors: Stopped, and those of CommissionDetector.
#pragma once

#include "jobs/commission/commission_display.h"
#include "jobs/commission/commission_progress.h"

namespace jobs {
class CommissionPresence {
public:
    using BusLocation = CommissionDetector::BusLocation;

    CommissionPresence(const device::Context& context, const CommissionSpec& spec,
                       const CommissionProgress& progress, CommissionDisplay& display)
        : m_context(context)
        , m_progress(progress)
        , m_display(display)
        , m_detector(context, spec)
    {}

    base::Result<device::Servo> waitForServo();
    /// Nothing was disconnected or exchanged since the servo was checked.
    base::Result<bool> isStillAlone(const device::Servo& servo);
    base::Result<void> waitUntilGone(const BusLocation& place);
    /// Once, with a pause; a servo that is being disconnected makes contact more than once, so it
    /// counts as gone only after several silences in a row. `missed` counts them.
    base::Result<bool> isGone(const BusLocation& place, int& missed);
    /// Where it replies after a failure, under its old ID or its new one; nullopt: nowhere.
    base::Result<std::optional<BusLocation>> findAgain(const CommissionWork& work);
    base::Result<void> setRate(int baud);

private:
    base::Result<bool> isAlone(const BusLocation& first, device::Servo& servo);
    base::Result<void> pause(base::Duration span);

    const device::Context& m_context;
    const CommissionProgress& m_progress;
    CommissionDisplay& m_display;
    CommissionDetector m_detector;
};
} // namespace jobs
