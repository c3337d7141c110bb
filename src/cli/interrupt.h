// SPDX-License-Identifier: GPL-3.0-or-later
// Ctrl-C and SIGTERM become a base::Stop. One object, made by main before any other thread, so that
// the signals are blocked in all of them and only a thread of its own receives them. A second
// Ctrl-C does not cut short the closing of a lock, but ends the program once that has had two
// seconds.
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
