// SPDX-License-Identifier: GPL-3.0-or-later
// Turns Ctrl-C and SIGTERM into a base::StopToken. One object, created by main before any other
// thread: the signals are blocked in all threads, and its own thread receives them. A second Ctrl-C
// ends the program, but only after two seconds, in which an open EPROM lock is closed.
#pragma once

#include "base/stop_token.h"

#include <atomic>
#include <thread>

namespace cli {
class Interrupt {
public:
    Interrupt();
    ~Interrupt();
    Interrupt(const Interrupt&) = delete;
    Interrupt& operator=(const Interrupt&) = delete;

    const base::StopToken& stop() const { return m_stop; }

private:
    void receive();

    base::StopToken m_stop;
    std::atomic<bool> m_ending{false};
    std::thread m_receiver;
};
} // namespace cli
