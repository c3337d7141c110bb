// SPDX-License-Identifier: GPL-3.0-or-later
// From a received request to the servo's reply on the wire: at once, in its turn of a SYNC READ, or
// as soon as the servo is not busy any more.
#include "sim/bus/virtual_bus_state.h"

#include <algorithm>

namespace sim {
namespace {
constexpr std::uint8_t syncReadInstruction = 0x82;
constexpr std::size_t syncReadHead = 2; // address and count ahead of the IDs
constexpr std::size_t statusOverhead = 6;
/// Between the replies of a SYNC READ: 16 servos × 21 bytes at 1 Mbaud came 0.295 ms apart.
constexpr Nanos syncReadGap = 85'000;
/// Bytes that wait while a servo writes its EPROM; a packet that does not fit any more is lost. No
/// source gives the size. Chosen: the longest packet of the vendor's SDK (250 bytes) fits, and
/// every byte of the host counts, whichever servo it is for.
constexpr std::size_t receiveBufferSize = 256;

base::Bytes encode(base::Protocol protocol, const ServoReply& reply)
{
    switch (protocol) {
    case base::Protocol::Feetech:
        return protocol::encodeFeetechStatus(reply.id, reply.status, reply.data);
    case base::Protocol::Modbus:
        return protocol::encodeModbusReply(reply.id, reply.function, reply.data);
    case base::Protocol::Lx:
        break;
    }
    return protocol::encodeLxReply(reply.id, reply.function, reply.data);
}

bool isSyncRead(const ReceivedFrame& frame)
{
    return frame.protocol == base::Protocol::Feetech &&
           frame.content.instruction == syncReadInstruction;
}

/// The request to the servo at this place of a SYNC READ's parameters.
ServoRequest syncReadRequest(const ReceivedFrame& frame, std::size_t index)
{
    return {true, frame.content.instruction, frame.content.params,
            static_cast<int>(index - syncReadHead)};
}
} // namespace

void BusNode::enqueue(const ReceivedFrame& frame)
{
    if (queuedBytes + frame.content.consumed > receiveBufferSize)
        return;
    queue.push_back(frame);
    queuedBytes += frame.content.consumed;
}

void BusNode::clearRequests()
{
    queue.clear();
    queuedBytes = 0;
    writingUntil = 0;
}

bool VirtualBus::State::listens(std::size_t nodeIndex, const ReceivedFrame& frame) const
{
    const BusNode& node = nodes[nodeIndex];
    return node.servo.profile().protocol == frame.protocol && node.servo.baud() == frame.baud &&
           !node.servo.isDeaf() && node.deafUntil < frame.start && isSilentBefore(nodeIndex, frame);
}

// To a Modbus servo a request that follows another servo's reply too closely is part of that reply.
// A servo does not receive its own reply.
bool VirtualBus::State::isSilentBefore(std::size_t nodeIndex, const ReceivedFrame& frame) const
{
    if (frame.protocol != base::Protocol::Modbus)
        return true;
    const Nanos from = frame.start - modbusSilence(frame.baud);
    return std::none_of(line.bursts().begin(), line.bursts().end(), [&](const Burst& burst) {
        return burst.sender != hostSender && burst.sender != static_cast<int>(nodeIndex) &&
               burst.start < frame.start && burst.end() > from;
    });
}

void VirtualBus::State::dispatch(const ReceivedFrame& frame)
{
    advanceServos(frame.end);
    if (faultInjector.dropsRequest(config.faults))
        return;
    if (isSyncRead(frame))
        dispatchSyncRead(frame);
    else
        dispatchRequest(frame);
    updateReceivers(frame.end);
}

// Requests that arrive while it writes its EPROM wait until it has finished.
bool VirtualBus::State::canAccept(std::size_t nodeIndex, const ReceivedFrame& frame)
{
    if (!listens(nodeIndex, frame))
        return false;
    BusNode& node = nodes[nodeIndex];
    if (!node.mustQueue(frame.end))
        return true;
    node.enqueue(frame);
    return false;
}

void VirtualBus::State::dispatchRequest(const ReceivedFrame& frame)
{
    for (std::size_t nodeIndex = 0; nodeIndex < nodes.size(); ++nodeIndex) {
        if (canAccept(nodeIndex, frame))
            deliverTo(nodeIndex, frame, frame.end);
    }
}

void VirtualBus::State::deliverTo(std::size_t nodeIndex, const ReceivedFrame& frame, Nanos at)
{
    const bool toAll = frame.content.id == protocol::broadcastId;
    ServoRequest request;
    request.instruction = frame.content.instruction;
    request.params = frame.content.params;
    const AddressMatch addressMatch =
        nodes[nodeIndex].servo.addressMatch(frame.content.id, request.instruction);
    request.broadcast = toAll || addressMatch == AddressMatch::Silently;
    if (toAll || addressMatch != AddressMatch::No)
        deliver(nodeIndex, request, at, std::nullopt);
}

// The earliest instant at which a servo can handle the requests in its receive buffer.
std::optional<Nanos> VirtualBus::State::requestDue() const
{
    std::optional<Nanos> first;
    for (const BusNode& node : nodes) {
        if (!node.queue.empty() && (!first || node.writingUntil < *first))
            first = node.writingUntil;
    }
    return first;
}

void VirtualBus::State::dispatchQueued(Nanos at)
{
    advanceServos(at);
    for (std::size_t nodeIndex = 0; nodeIndex < nodes.size(); ++nodeIndex) {
        BusNode& node = nodes[nodeIndex];
        if (node.queue.empty() || node.writingUntil > at)
            continue;
        const ReceivedFrame frame = std::move(node.queue.front());
        node.queue.pop_front();
        node.queuedBytes -= frame.content.consumed;
        if (node.servo.isDeaf())
            node.clearRequests();
        else if (isSyncRead(frame))
            deliverSyncRead(nodeIndex, frame, at);
        else
            deliverTo(nodeIndex, frame, at);
    }
    updateReceivers(at);
}

// Each listed servo replies after the one before it. The time of a missing servo passes unused, and
// a servo that is writing its EPROM comes too late.
void VirtualBus::State::dispatchSyncRead(const ReceivedFrame& frame)
{
    const base::Bytes& params = frame.content.params;
    if (params.size() <= syncReadHead)
        return;
    std::vector<std::size_t> free;
    for (std::size_t nodeIndex = 0; nodeIndex < nodes.size(); ++nodeIndex) {
        if (canAccept(nodeIndex, frame))
            free.push_back(nodeIndex);
    }
    const Burst silence(0, 0, frame.baud, base::Bytes(statusOverhead + params[1]));
    Nanos nextReplyAt = frame.end;
    for (std::size_t index = syncReadHead; index < params.size(); ++index) {
        const ServoRequest request = syncReadRequest(frame, index);
        const bool isFirst = request.syncReadIndex == 0;
        std::optional<Nanos> busyUntil;
        for (const std::size_t nodeIndex : free) {
            if (nodes[nodeIndex].servo.id() != params[index])
                continue;
            const auto end =
                deliver(nodeIndex, request, frame.end,
                        isFirst ? std::nullopt : std::optional(nextReplyAt + syncReadGap));
            if (end)
                busyUntil = std::max(busyUntil.value_or(0), *end);
        }
        nextReplyAt = busyUntil.value_or(nextReplyAt + syncReadGap + silence.end());
    }
}

// A SYNC READ that waited: its turn may be over.
void VirtualBus::State::deliverSyncRead(std::size_t nodeIndex, const ReceivedFrame& frame, Nanos at)
{
    const base::Bytes& params = frame.content.params;
    for (std::size_t index = syncReadHead; index < params.size(); ++index) {
        if (nodes[nodeIndex].servo.id() == params[index]) {
            deliver(nodeIndex, syncReadRequest(frame, index), at, std::nullopt);
            return;
        }
    }
}

// `id`: the one in the request. Once muteWhen was true, it stays mute.
bool VirtualBus::State::isMute(const VirtualServo& servo, int id)
{
    std::vector<int>& mute = config.faults.muteIds;
    if (std::find(mute.begin(), mute.end(), id) != mute.end())
        return true;
    if (!config.faults.muteWhen || !config.faults.muteWhen(servo))
        return false;
    mute.push_back(id);
    return true;
}

// When the servo will have finished its reply; nullopt if it stays silent. `notBefore`: its turn in
// a SYNC READ.
std::optional<Nanos> VirtualBus::State::deliver(std::size_t nodeIndex, const ServoRequest& request,
                                                Nanos at, std::optional<Nanos> notBefore)
{
    BusNode& node = nodes[nodeIndex];
    // The status packet of an ID or rate change still leaves the way the request came.
    const int id = node.servo.id();
    const int baud = node.servo.baud();
    const Nanos delay = toNanos(node.servo.replyDelay());
    const auto reply = node.servo.handle(request);
    if (node.servo.isDeaf())
        node.deafUntil = at;
    const Nanos written = at + toNanos(node.servo.writeTime());
    node.writingUntil = written;
    if (!reply || cut || isMute(node.servo, id))
        return std::nullopt;
    const Nanos ready = written + delay + toNanos(reply->wait);
    return transmit(nodeIndex, encode(node.servo.profile().protocol, *reply), baud,
                    std::max(ready, notBefore.value_or(0)));
}

std::optional<Nanos> VirtualBus::State::transmit(std::size_t nodeIndex, base::Bytes reply, int baud,
                                                 Nanos ready)
{
    BusNode& node = nodes[nodeIndex];
    const auto lateness = faultInjector.applyFaults(reply, config.faults);
    if (!lateness)
        return std::nullopt;
    ReplyTiming& timing = node.servo.timing();
    const Nanos start =
        std::max(ready, node.sendsUntil) + timing.nextTurnAround().count() + toNanos(*lateness);
    const Burst& transmitted = line.transmit(
        Burst(static_cast<int>(nodeIndex), start, baud, std::move(reply), timing.clockError()));
    node.sendsUntil = transmitted.end();
    return *lateness > base::Duration{} ? std::nullopt : std::optional(transmitted.end());
}
} // namespace sim
