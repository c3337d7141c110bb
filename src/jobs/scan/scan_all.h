// SPDX-License-Identifier: GPL-3.0-or-later
// Who is on the line, for tasks that must miss nobody (a bundle of the whole bus): searches until
// two searches in a row agree, with long patience once replies came late. Never writes. Job thread.
// Errors: those of a search; Garbled when no two of them agree (noise, a bad contact), with the ID
// of one that answered sometimes, or of one that cannot be read or seems to be two.
#pragma once

#include "jobs/scan/scan.h"

namespace jobs {
/// A stopped search is the error Stopped: what it has found is not all there is.
base::Result<std::vector<device::Servo>> scanAll(const device::Context& context,
                                                 const std::vector<base::Protocol>& protocols,
                                                 const ProgressFn& progress = {});
} // namespace jobs
