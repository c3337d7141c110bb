// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/virtual_bus_state.h"

#include <algorithm>

namespace sim {
namespace {
constexpr std::uint8_t syncReadInstruction = 0x82;
constexpr std::size_t syncReadHead = 2; // address and count ahead of the IDs
constexpr std::size_t statusOverhead = 6;
/// Between the replies of a SYNC READ: 16 servos × 21 bytes at 1 Mbaud came 0.295 ms apart.
constexpr Nanos syncReadGap = 85'000;
/// How long a byte begun within a burst may last beyond its end, or a silence after it, in bits of
/// the slowest listener.
constexpr double lingeringBits = 48;

bool hasEarFor(const VirtualServo& servo, const ServoEar& ear)
{
    return servo.baud() == ear.baud() && servo.profile().protocol == ear.protocol();
}

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
} // namespace

// The clock may count from anywhere: the bus' own time begins with the first call.
void VirtualBus::State::begin(Nanos at)
{
    if (started)
        return;
    started = true;
    now = steppedTo = hostSpeaksUntil = at;
    hostReceiver = UartReceiver(hostHears(), hostReceiver.baud(), at);
    tuneEars(at);
}

void VirtualBus::State::advance(Nanos to)
{
    begin(to);
    if (to <= now)
        return;
    ServoEar::Event event;
    while (ServoEar* ear = nextEar(to, event)) {
        if (const auto frame = ear->take(event))
            obey(*frame);
    }
    receiveForHost(to);
    stepServos(to);
    now = to;
    forgetPast();
}

void VirtualBus::State::stepServos(Nanos to)
{
    const Nanos dt = toNanos(config.dt);
    while (steppedTo + dt <= to) {
        steppedTo += dt;
        for (Seat& seat : seats) {
            seat.servo.step(config.dt);
            if (seat.servo.deaf())
                seat.deafUntil = steppedTo;
        }
    }
}

// One ear for each rate and language that some servo listens in.
void VirtualBus::State::tuneEars(Nanos at)
{
    for (const Seat& seat : seats) {
        const bool known = std::any_of(ears.begin(), ears.end(), [&seat](const ServoEar& ear) {
            return hasEarFor(seat.servo, ear);
        });
        if (!known)
            ears.emplace_back(seat.servo.profile().protocol, seat.servo.baud(), at);
    }
    std::erase_if(ears, [this](const ServoEar& ear) {
        return std::none_of(seats.begin(), seats.end(),
                            [&ear](const Seat& seat) { return hasEarFor(seat.servo, ear); });
    });
}

ServoEar* VirtualBus::State::nextEar(Nanos to, ServoEar::Event& event)
{
    ServoEar* first = nullptr;
    for (ServoEar& ear : ears) {
        const auto next = ear.peek(line);
        if (next && next->at <= to && (first == nullptr || next->at < event.at)) {
            first = &ear;
            event = *next;
        }
    }
    return first;
}

// The latest instant at which a silence may turn what has been heard so far into a request.
std::optional<Nanos> VirtualBus::State::silenceDue() const
{
    std::optional<Nanos> latest;
    for (const ServoEar& ear : ears) {
        if (const auto due = ear.silenceDue(); due && (!latest || *due > *latest))
            latest = due;
    }
    return latest;
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
    if (frame.protocol == base::Protocol::Feetech &&
        frame.content.instruction == syncReadInstruction)
        obeySyncRead(frame);
    else
        obeyRequest(frame);
    tuneEars(frame.end);
}

void VirtualBus::State::obeyRequest(const HeardFrame& frame)
{
    const bool toAll = frame.content.id == protocol::broadcastId;
    ServoRequest request;
    request.instruction = frame.content.instruction;
    request.params = frame.content.params;
    for (std::size_t place = 0; place < seats.size(); ++place) {
        if (!listens(place, frame))
            continue;
        const Hears hears = seats[place].servo.hears(frame.content.id, request.instruction);
        request.broadcast = toAll || hears == Hears::Silently;
        if (toAll || hears != Hears::No)
            ask(place, request, frame.end, std::nullopt);
    }
}

// Each listed servo speaks after the one before it; where one is missing, its time passes unused.
void VirtualBus::State::obeySyncRead(const HeardFrame& frame)
{
    const base::Bytes& params = frame.content.params;
    if (params.size() <= syncReadHead)
        return;
    ServoRequest request;
    request.broadcast = true;
    request.instruction = syncReadInstruction;
    request.params = params;
    const Burst silence(0, 0, frame.baud, base::Bytes(statusOverhead + params[1]));
    Nanos turn = frame.end;
    for (std::size_t index = syncReadHead; index < params.size(); ++index) {
        request.syncReadIndex = static_cast<int>(index - syncReadHead);
        const bool leads = request.syncReadIndex == 0;
        std::optional<Nanos> spokenUntil;
        for (std::size_t place = 0; place < seats.size(); ++place) {
            if (!listens(place, frame) || seats[place].servo.id() != params[index])
                continue;
            const auto end = ask(place, request, frame.end,
                                 leads ? std::nullopt : std::optional(turn + syncReadGap));
            if (end)
                spokenUntil = std::max(spokenUntil.value_or(0), *end);
        }
        turn = spokenUntil.value_or(turn + syncReadGap + silence.end());
    }
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
    const std::vector<int>& mute = config.faults.muteIds;
    if (!answer || cut || std::find(mute.begin(), mute.end(), id) != mute.end())
        return std::nullopt;
    auto frame = encode(seat.servo.profile().protocol, *answer);
    const auto lateness = dice.spoil(frame, config.faults);
    if (!lateness)
        return std::nullopt;
    const Nanos start =
        std::max({at + delay, notBefore.value_or(0), seat.speaksUntil}) + toNanos(*lateness);
    const Burst& spoken = line.speak(Burst(static_cast<int>(place), start, baud, std::move(frame)));
    seat.speaksUntil = spoken.end();
    return *lateness > base::Duration{} ? std::nullopt : std::optional(spoken.end());
}

void VirtualBus::State::receiveForHost(Nanos to)
{
    hostReceiver.listenTo(hostHears());
    for (auto heard = hostReceiver.peek(line); heard && heard->end <= to;
         heard = hostReceiver.peek(line)) {
        hostReceiver.take(*heard);
        if (!cut)
            toHost.push_back({heard->end + latency(), heard->burstEnd + latency(), heard->value});
    }
}

bool VirtualBus::State::replyUnderWay() const
{
    return !toHost.empty() || hostReceiver.peek(line).has_value();
}

void VirtualBus::State::forgetPast()
{
    int slowest = hostReceiver.baud();
    for (const ServoEar& ear : ears)
        slowest = std::min(slowest, ear.baud());
    line.forgetBefore(now - static_cast<Nanos>(lingeringBits * 1e9 / slowest));
}
} // namespace sim
