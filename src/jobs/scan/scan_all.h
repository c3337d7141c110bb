// SPDX-License-Identifier: GPL-3.0-or-later
// All servos on the line, for tasks that must not miss one (a bundle of the whole bus): searches
// until two searches in a row agree, with a long timeout once replies came late. Never writes. Job
// thread. Errors: those of a search; Garbled when no two of them agree (noise, a bad contact), with
// the ID of a servo that answered sometimes, or of one that cannot be read or seems to be two.
#pragma once

#include "jobs/scan/scan.h"

namespace jobs {
/// A stopped search is the error Stopped, because its list is not complete.
base::Result<std::vector<device::Servo>> scanAll(const device::Context& context,
                                                 const std::vector<base::Protocol>& protocols,
                                                 const ProgressFn& progress = {});
} // namespace jobs
