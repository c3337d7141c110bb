// SPDX-License-Identifier: GPL-3.0-or-later
// What a diagnosis of an open port should try, with what the system tells about the port: other
// programs that have it open, the latency timer of the adapter. May take tens of milliseconds, so
// not on the main thread of a window.
#pragma once

#include "jobs/diagnose/diagnose.h"
#include "session/connection.h"

namespace session {
jobs::DiagnosisSpec diagnosisSpec(const PortRequest& port);
} // namespace session
