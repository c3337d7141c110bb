// SPDX-License-Identifier: GPL-3.0-or-later
// Inside of VirtualBus: the servos on their places, the line, who hears what and when. All instants
// are absolute nanoseconds of the caller's clock. One thread.
#pragma once

#include "sim/fault_dice.h"
#include "sim/servo_ear.h"
#include "sim/virtual_bus.h"

#include <deque>

namespace sim {
inline Nanos toNanos(base::Duration time)
{
    return std::chrono::nanoseconds(time).count();
}

// Rounded up, so that a caller who waits until then finds the byte.
inline base::Duration toDuration(Nanos time)
{
    return base::Duration((time + 999) / 1000);
}

/// A servo on its place on the bus.
struct Seat {
    explicit Seat(VirtualServo&& what)
        : servo(std::move(what))
    {}
    VirtualServo servo;
    bool plugged = true;
    bool seen = true;     ///< has been on the wire
    Nanos deafUntil = -1; ///< last instant at which it was seen deaf
    Nanos speaksUntil = 0;
    Nanos writesUntil = 0;          ///< its EPROM; requests wait until then
    std::deque<HeardFrame> waiting; ///< in its receive buffer
    std::size_t waitingBytes = 0;

    bool keepsWaiting(Nanos at) const { return at < writesUntil || !waiting.empty(); }
    void keep(const HeardFrame& frame);
    void forgetRequests(); ///< with the power, or at a restart
};

struct HostByte {
    Nanos at = 0;
    Nanos runEnd = 0;
    std::uint8_t value = 0;
};

struct VirtualBus::State {
    explicit State(WireConfig wire)
        : config(std::move(wire))
        , dice(config.seed)
        , hostReceiver(Listens::Servos, 1'000'000, 0)
    {}

    WireConfig config;
    FaultDice dice;
    std::deque<Seat> seats;
    WireLine line;
    std::vector<ServoEar> ears;
    UartReceiver hostReceiver;
    std::deque<HostByte> toHost;
    Nanos now = 0;
    Nanos steppedTo = 0;
    Nanos hostSpeaksUntil = 0;
    std::optional<std::size_t> bytesUntilCut;
    bool bag = false;
    bool started = false;
    bool cut = false;

    void begin(Nanos at);
    void advance(Nanos to);
    void stepServos(Nanos to);
    void tuneEars(Nanos at);
    ServoEar* nextEar(Nanos to, ServoEar::Event& event);
    std::optional<Nanos> silenceDue() const;
    void obey(const HeardFrame& frame);
    void obeyRequest(const HeardFrame& frame);
    void obeySyncRead(const HeardFrame& frame);
    bool isFree(std::size_t place, const HeardFrame& frame);
    void askOne(std::size_t place, const HeardFrame& frame, Nanos at);
    void askInList(std::size_t place, const HeardFrame& frame, Nanos at);
    std::optional<Nanos> requestDue() const;
    void obeyWaiting(Nanos at);
    std::optional<Nanos> ask(std::size_t place, const ServoRequest& request, Nanos at,
                             std::optional<Nanos> notBefore);
    bool isMute(const VirtualServo& servo, int id);
    bool listens(std::size_t place, const HeardFrame& frame) const;
    bool quietBefore(std::size_t place, const HeardFrame& frame) const;
    void receiveForHost(Nanos to);
    bool replyUnderWay() const;
    void forgetPast();
    Nanos latency() const { return toNanos(config.adapterLatency); }
    Listens hostHears() const { return config.echo ? Listens::All : Listens::Servos; }
};
} // namespace sim
