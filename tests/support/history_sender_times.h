// SPDX-License-Identifier: GPL-3.0-or-later
// An impatient sender of the history, for the tests, and the kind of a server's error. Pure.
#pragma once

#include "session/history/history_sender.h"

namespace support {
inline session::HistorySender::Timing shortSenderTimes(std::chrono::milliseconds silence)
{
    using namespace std::chrono_literals;
    session::HistorySender::Timing times;
    times.checkInterval = 50ms;
    times.debounce = 1ms;
    times.firstRetry = 20ms;
    times.lastRetry = 100ms;
    times.silence = silence;
    return times;
}

/// "certificate" of "certificate: …"
inline QString serverErrorKind(const base::Error& error)
{
    return error.detail.left(error.detail.indexOf(u':'));
}
} // namespace support
