// SPDX-License-Identifier: GPL-3.0-or-later
// The wire between host and simulated servos: byte times at each sender's baud rate, half duplex,
// echo, adapter latency, collisions (overlapping bits combine, low wins) and named faults. Driven
// by absolute instants, so it runs as fast as the caller's clock. One thread at a time.
#pragma once

#include "sim/servo/virtual_servo.h"

#include <QString>

#include <functional>
#include <map>
#include <vector>

namespace sim {
/// Probabilities 0…1 per reply, by name: drop, corrupt, garbage, late, truncate.
struct FaultPlan {
    double drop = 0;     ///< the reply never leaves the servo
    double corrupt = 0;  ///< one bit of one byte is flipped
    double garbage = 0;  ///< random bytes ahead of the reply
    double late = 0;     ///< the reply comes lateBy after its time
    double truncate = 0; ///< the reply ends early
    base::Duration lateBy = std::chrono::milliseconds(30);
    std::vector<int> muteIds; ///< these obey, but never answer
    /// Called after each request; a servo for which it returns true obeys that request too, and is
    /// mute from then on.
    std::function<bool(const VirtualServo&)> muteWhen;
    double dropRequest = 0; ///< the request is lost before any servo receives it
};

struct WireConfig {
    bool echo = false;
    base::Duration adapterLatency{}; ///< USB adapter: bytes reach the host this much later
    FaultPlan faults;
    std::uint64_t seed = 1;
    /// Without clock errors, jitter and differences at rest, for tests of figures.
    bool identicalServos = false;
    base::Duration dt = std::chrono::milliseconds(1);
};

class VirtualBus {
public:
    explicit VirtualBus(WireConfig config = {});
    ~VirtualBus();

    VirtualServo& add(VirtualServo servo);
    std::vector<VirtualServo*> servos();
    VirtualServo* servo(int id); ///< first with this ID, null if none

    /// The host's bytes begin to leave at `now`, or when the wire is free of earlier host bytes.
    void hostWrites(base::ByteView bytes, int baud, base::Duration now);

    /// Moves everything on to `now` and returns the bytes that have reached the host by then.
    base::Bytes hostReads(base::Duration now);

    /// When the next byte will reach the host, if one is on its way.
    std::optional<base::Duration> nextHostByte() const;

    /// Lets the servos receive what has been written so far, though not beyond `deadline`. Returns
    /// when the next unbroken run of bytes will have reached the host as a whole; nullopt: not by
    /// the deadline. A real adapter hands bytes over in the same way, and it saves a wake-up per
    /// byte. While a silence may be ending a Modbus frame, or a servo writes its EPROM with
    /// requests waiting, the result is that instant, at which nothing comes: ask again then.
    std::optional<base::Duration> nextHostRun(base::Duration deadline);

    void setHostBaud(int baud); ///< what the host's receiver listens at
    int hostBaud() const;

    void powerCycle(); ///< all servos on the wire off and on again

    // --- plugs (virtual_bus_hotplug.cpp): at first each servo is on the wire ---
    bool isPlugged(std::size_t nodeIndex) const; ///< places as in servos()
    void plug(std::size_t nodeIndex);            ///< with power; nothing if it is on the wire
    void unplug(std::size_t nodeIndex);          ///< even in the middle of a reply
    void unplugAll();
    /// Unplugs all servos; connectNext() plugs them in one after the other.
    void makeHotplugQueue();
    bool hasHotplugQueue() const;
    std::size_t pendingServoCount() const; ///< those that have not been on the wire
    /// Unplugs the servos on the wire and plugs in the next pending one; nullopt: none is pending.
    std::optional<std::size_t> connectNext();

    void cutLink(); ///< from now on nothing passes and SimLink reports LinkLost
    void restoreLink();
    bool linkCut() const;
    /// Cuts the link after this many more host bytes (tests: at every byte of a write).
    void cutAfterHostBytes(std::size_t count);

    WireConfig& config();

private:
    struct State;
    std::unique_ptr<State> m_state;
};
} // namespace sim
