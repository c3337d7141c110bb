// SPDX-License-Identifier: GPL-3.0-or-later
// From registers to what a poll plan reads, for the jobs and for the window's polling. Pure; any
// thread.
#pragma once

#include "bus/poll.h"
#include "device/servo.h"

#include <map>

namespace jobs {
/// How many rounds of `period` fit into `interval`; `defaultDivider` where rounds follow each other
/// without a pause.
int everyNth(base::Duration period, base::Duration interval, int defaultDivider);

/// The blocks as the bus will read them. What changes slowly and costs a read of its own (LX:
/// temperature, voltage) is read about once a second only.
std::vector<bus::PollSpan> pollSpans(const catalog::Profile& profile,
                                     const std::vector<const catalog::Register*>& registers,
                                     base::Duration period);

/// Servos of one number may share a sync read: their maps and byte orders are the same.
class SyncReadGroups {
public:
    int of(const catalog::Profile& profile);

private:
    std::map<std::pair<QString, base::ByteOrder>, int> m_numbers;
};

/// A servo as a poll plan names it. `group`: of SyncReadGroups.
bus::PollServo pollServo(const device::Servo& servo, std::vector<bus::PollSpan> spans, int group);
} // namespace jobs
