// SPDX-License-Identifier: GPL-3.0-or-later
// From a request that was heard to the servo's answer on the wire: at once, in the turn of a SYNC
// READ, or after what keeps the servo busy.
#include "sim/virtual_bus_state.h"

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
constexpr std::size_t receiveBuffer = 256;

base::Bytes encode(base::Protocol protocol, const ServoAnswer& answer)
{
    switch (protocol) {
    case base::Protocol::Feetech:
        return protocol::encodeFeetechStatus(answer.id, answer.status, answer.data);
    case base::Protocol::Modbus:
        return protocol::encodeModbusReply(answer.id, answer.function, answer.data);
    case base::Protocol::Lx:
        break;
    }
    return protocol::encodeLxReply(answer.id, answer.function, answer.data);
}

bool isSyncRead(const HeardFrame& frame)
{
    return frame.protocol == base::Protocol::Feetech &&
           frame.content.instruction == syncReadInstruction;
}

/// What the servo at this place of a SYNC READ's parameters is asked.
ServoRequest listed(const HeardFrame& frame, std::size_t index)
{
    return {true, frame.content.instruction, frame.content.params,
            static_cast<int>(index - syncReadHead)};
}
} // namespace

void Seat::keep(const HeardFrame& frame)
{
    if (waitingBytes + frame.content.consumed > receiveBuffer)
        return;
    waiting.push_back(frame);
    waitingBytes += frame.content.consumed;
}

void Seat::forgetRequests()
{
    waiting.clear();
    waitingBytes = 0;
    writesUntil = 0;
}

bool VirtualBus::State::listens(std::size_t place, const HeardFrame& frame) const
{
    const Seat& seat = seats[place];
    return seat.servo.profile().protocol == frame.protocol && seat.servo.baud() == frame.baud &&
           !seat.servo.deaf() && seat.deafUntil < frame.start && quietBefore(place, frame);
}

// To a Modbus servo a request that follows another servo's reply too closely is part of that reply;
// its own it does not hear.
bool VirtualBus::State::quietBefore(std::size_t place, const HeardFrame& frame) const
{
    if (frame.protocol != base::Protocol::Modbus)
        return true;
    const Nanos from = frame.start - modbusSilence(frame.baud);
    return std::none_of(line.bursts().begin(), line.bursts().end(), [&](const Burst& burst) {
        return burst.speaker != hostSpeaker && burst.speaker != static_cast<int>(place) &&
               burst.start < frame.start && burst.end() > from;
    });
}

void VirtualBus::State::obey(const HeardFrame& frame)
{
    stepServos(frame.end);
    if (dice.losesRequest(config.faults))
        return;
    if (isSyncRead(frame))
        obeySyncRead(frame);
    else
        obeyRequest(frame);
    tuneEars(frame.end);
}

// What it hears while it writes its EPROM waits until it has.
bool VirtualBus::State::isFree(std::size_t place, const HeardFrame& frame)
{
    if (!listens(place, frame))
        return false;
    Seat& seat = seats[place];
    if (!seat.keepsWaiting(frame.end))
        return true;
    seat.keep(frame);
    return false;
}

void VirtualBus::State::obeyRequest(const HeardFrame& frame)
{
    for (std::size_t place = 0; place < seats.size(); ++place) {
        if (isFree(place, frame))
            askOne(place, frame, frame.end);
    }
}

void VirtualBus::State::askOne(std::size_t place, const HeardFrame& frame, Nanos at)
{
    const bool toAll = frame.content.id == protocol::broadcastId;
    ServoRequest request;
    request.instruction = frame.content.instruction;
    request.params = frame.content.params;
    const Hears hears = seats[place].servo.hears(frame.content.id, request.instruction);
    request.broadcast = toAll || hears == Hears::Silently;
    if (toAll || hears != Hears::No)
        ask(place, request, at, std::nullopt);
}

// The earliest instant at which a servo has time for what waits in its receive buffer.
std::optional<Nanos> VirtualBus::State::requestDue() const
{
    std::optional<Nanos> first;
    for (const Seat& seat : seats) {
        if (!seat.waiting.empty() && (!first || seat.writesUntil < *first))
            first = seat.writesUntil;
    }
    return first;
}

void VirtualBus::State::obeyWaiting(Nanos at)
{
    stepServos(at);
    for (std::size_t place = 0; place < seats.size(); ++place) {
        Seat& seat = seats[place];
        if (seat.waiting.empty() || seat.writesUntil > at)
            continue;
        const HeardFrame frame = std::move(seat.waiting.front());
        seat.waiting.pop_front();
        seat.waitingBytes -= frame.content.consumed;
        if (seat.servo.deaf())
            seat.forgetRequests();
        else if (isSyncRead(frame))
            askInList(place, frame, at);
        else
            askOne(place, frame, at);
    }
    tuneEars(at);
}

// Each listed servo speaks after the one before it; where one is missing, its time passes unused,
// and one that is writing its EPROM comes too late.
void VirtualBus::State::obeySyncRead(const HeardFrame& frame)
{
    const base::Bytes& params = frame.content.params;
    if (params.size() <= syncReadHead)
        return;
    std::vector<std::size_t> free;
    for (std::size_t place = 0; place < seats.size(); ++place) {
        if (isFree(place, frame))
            free.push_back(place);
    }
    const Burst silence(0, 0, frame.baud, base::Bytes(statusOverhead + params[1]));
    Nanos turn = frame.end;
    for (std::size_t index = syncReadHead; index < params.size(); ++index) {
        const ServoRequest request = listed(frame, index);
        const bool leads = request.syncReadIndex == 0;
        std::optional<Nanos> spokenUntil;
        for (const std::size_t place : free) {
            if (seats[place].servo.id() != params[index])
                continue;
            const auto end = ask(place, request, frame.end,
                                 leads ? std::nullopt : std::optional(turn + syncReadGap));
            if (end)
                spokenUntil = std::max(spokenUntil.value_or(0), *end);
        }
        turn = spokenUntil.value_or(turn + syncReadGap + silence.end());
    }
}

// A SYNC READ that waited: its turn may be over.
void VirtualBus::State::askInList(std::size_t place, const HeardFrame& frame, Nanos at)
{
    const base::Bytes& params = frame.content.params;
    for (std::size_t index = syncReadHead; index < params.size(); ++index) {
        if (seats[place].servo.id() == params[index]) {
            ask(place, listed(frame, index), at, std::nullopt);
            return;
        }
    }
}

// `id`: what it was asked under. Once muteWhen was true, it stays mute.
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

// When the servo will have spoken; nullopt if it stays silent. `notBefore`: its turn in a SYNC
// READ.
std::optional<Nanos> VirtualBus::State::ask(std::size_t place, const ServoRequest& request,
                                            Nanos at, std::optional<Nanos> notBefore)
{
    Seat& seat = seats[place];
    // The status packet of an ID or rate change still leaves the way the request came.
    const int id = seat.servo.id();
    const int baud = seat.servo.baud();
    const Nanos delay = toNanos(seat.servo.replyDelay());
    const auto answer = seat.servo.handle(request);
    if (seat.servo.deaf())
        seat.deafUntil = at;
    const Nanos written = at + toNanos(seat.servo.writeTime());
    seat.writesUntil = written;
    if (!answer || cut || isMute(seat.servo, id))
        return std::nullopt;
    auto frame = encode(seat.servo.profile().protocol, *answer);
    const auto lateness = dice.spoil(frame, config.faults);
    if (!lateness)
        return std::nullopt;
    const Nanos ready = written + delay + toNanos(answer->wait);
    const Nanos start =
        std::max({ready, notBefore.value_or(0), seat.speaksUntil}) + toNanos(*lateness);
    const Burst& spoken = line.speak(Burst(static_cast<int>(place), start, baud, std::move(frame)));
    seat.speaksUntil = spoken.end();
    return *lateness > base::Duration{} ? std::nullopt : std::optional(spoken.end());
}
} // namespace sim
