// SPDX-License-Identifier: GPL-3.0-or-later
// Like JobThread, for jobs that may hang in a library for as long as a server pleases: its owner
// waits for them at the end as long as it likes and no longer, and leaves one that is still at it
// behind. So a job owns all it uses (shared pointers), and looks whether it has been left before
// it touches anything else. start() from the owner only; never waits.
#pragma once

#include <chrono>
#include <functional>
#include <memory>

namespace session {
class LooseThread {
public:
    LooseThread();
    LooseThread(const LooseThread&) = delete;
    LooseThread& operator=(const LooseThread&) = delete;
    ~LooseThread(); ///< leaves it at once

    void start(std::function<void()> job);
    /// Drops what waits. True: the running job has ended too, within `grace`.
    bool end(std::chrono::milliseconds grace);

private:
    struct State;
    static void run(const std::shared_ptr<State>& state);

    std::shared_ptr<State> m_state; ///< shared with the thread, which may outlive this
};
} // namespace session
