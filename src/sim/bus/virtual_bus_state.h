// SPDX-License-Identifier: GPL-3.0-or-later
// Inside of VirtualBus: the servos on their places, the line, and which servo receives what and
// when. All instants are absolute nanoseconds of the caller's clock. One thread.
#pragma once

#include "sim/bus/request_receiver.h"
#include "sim/bus/virtual_bus.h"
#include "sim/faults/fault_injector.h"

#include <deque>

namespace sim {
inline Nanos toNanos(base::Duration time)
{
    return std::chrono::nanoseconds(time).count();
}

// Rounded up, so that a caller that waits until then finds the byte.
inline base::Duration toDuration(Nanos time)
{
    return base::Duration((time + 999) / 1000);
}

/// A servo on its place on the bus.
struct BusNode {
    explicit BusNode(VirtualServo&& what)
        : servo(std::move(what))
    {}
    VirtualServo servo;
    bool plugged = true;
    bool wasPlugged = true; ///< has been on the wire
    Nanos deafUntil = -1;   ///< last instant at which it was seen deaf
    Nanos sendsUntil = 0;
    Nanos writingUntil = 0;          ///< its EPROM; requests wait until then
    std::deque<ReceivedFrame> queue; ///< in its receive buffer
    std::size_t queuedBytes = 0;

    bool mustQueue(Nanos at) const { return at < writingUntil || !queue.empty(); }
    void enqueue(const ReceivedFrame& frame);
    void clearRequests(); ///< with the power, or at a restart
};

struct HostByte {
    Nanos at = 0;
    Nanos runEnd = 0;
    std::uint8_t value = 0;
};

struct VirtualBus::State {
    explicit State(WireConfig wire)
        : config(std::move(wire))
        , faultInjector(config.seed)
        , hostReceiver(RxFilter::Servos, 1'000'000, 0)
    {}

    WireConfig config;
    FaultInjector faultInjector;
    std::deque<BusNode> nodes;
    WireLine line;
    std::vector<RequestReceiver> receivers;
    UartReceiver hostReceiver;
    std::optional<UartReceiver> bootloaderReceiver; ///< while a servo is in its bootloader
    std::deque<HostByte> toHost;
    Nanos now = 0;
    Nanos steppedTo = 0;
    Nanos hostSendsUntil = 0;
    std::optional<std::size_t> bytesUntilCut;
    bool hotplugQueue = false;
    bool started = false;
    bool cut = false;

    void begin(Nanos at);
    void advance(Nanos to);
    void advanceServos(Nanos to);
    void updateReceivers(Nanos at);
    RequestReceiver* nextReceiver(Nanos to, RequestReceiver::Event& event);
    bool dispatchBootloaderByte(Nanos to);
    std::optional<Nanos> silenceEnd() const;
    void dispatch(const ReceivedFrame& frame);
    void dispatchRequest(const ReceivedFrame& frame);
    void dispatchSyncRead(const ReceivedFrame& frame);
    bool canAccept(std::size_t nodeIndex, const ReceivedFrame& frame);
    void deliverTo(std::size_t nodeIndex, const ReceivedFrame& frame, Nanos at);
    void deliverSyncRead(std::size_t nodeIndex, const ReceivedFrame& frame, Nanos at);
    std::optional<Nanos> requestDue() const;
    void dispatchQueued(Nanos at);
    std::optional<Nanos> deliver(std::size_t nodeIndex, const ServoRequest& request, Nanos at,
                                 std::optional<Nanos> notBefore);
    /// Nullopt: lost to a fault, or too late for its turn.
    std::optional<Nanos> transmit(std::size_t nodeIndex, base::Bytes reply, int baud, Nanos ready);
    bool isMute(const VirtualServo& servo, int id);
    bool listens(std::size_t nodeIndex, const ReceivedFrame& frame) const;
    bool isSilentBefore(std::size_t nodeIndex, const ReceivedFrame& frame) const;
    void receiveForHost(Nanos to);
    bool isReplyPending() const;
    void discardPast();
    Nanos latency() const { return toNanos(config.adapterLatency); }
    RxFilter hostFilter() const { return config.echo ? RxFilter::All : RxFilter::Servos; }
};
} // namespace sim
