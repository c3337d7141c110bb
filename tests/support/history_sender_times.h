// SPDX-License-Identifier: GPL-3.0-or-later
// An impatient sender of the history, for the tests, and the kind of a server's error. Pure.
#pragma once

#include "session/history/history_sender.h"

namespace support {
/// `silence`: short only where the server is silent; a busy machine answers late.
inline session::HistorySender::Timing
shortSenderTimes(std::chrono::milliseconds silence = std::chrono::minutes(1))
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
