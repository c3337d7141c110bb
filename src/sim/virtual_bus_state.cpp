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
/// How long a byte begun within a burst may last beyond its end, in bits of the slowest listener.
constexpr double lingeringBits = 12;
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
    Heard heard;
    while (ServoEar* ear = nextEar(to, heard)) {
        if (const auto frame = ear->take(heard))
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

// One ear for each rate that some servo listens at.
void VirtualBus::State::tuneEars(Nanos at)
{
    for (const Seat& seat : seats) {
        const int baud = seat.servo.baud();
        const bool known = std::any_of(ears.begin(), ears.end(),
                                       [baud](const ServoEar& ear) { return ear.baud() == baud; });
        if (!known)
            ears.emplace_back(baud, at);
    }
    std::erase_if(ears, [this](const ServoEar& ear) {
        return std::none_of(seats.begin(), seats.end(),
                            [&ear](const Seat& seat) { return seat.servo.baud() == ear.baud(); });
    });
}

ServoEar* VirtualBus::State::nextEar(Nanos to, Heard& heard)
{
    ServoEar* first = nullptr;
    for (ServoEar& ear : ears) {
        const auto next = ear.peek(line);
        if (next && next->end <= to && (first == nullptr || next->end < heard.end)) {
            first = &ear;
            heard = *next;
        }
    }
    return first;
}

bool VirtualBus::State::listens(const Seat& seat, const HeardFrame& frame) const
{
    return seat.servo.baud() == frame.baud && !seat.servo.deaf() && seat.deafUntil < frame.start;
}

void VirtualBus::State::obey(const HeardFrame& frame)
{
    stepServos(frame.end);
    if (dice.losesRequest(config.faults))
        return;
    if (frame.content.instruction == syncReadInstruction) {
        obeySyncRead(frame);
    } else {
        ServoRequest request;
        request.broadcast = frame.content.id == protocol::broadcastId;
        request.instruction = frame.content.instruction;
        request.params = frame.content.params;
        for (std::size_t place = 0; place < seats.size(); ++place) {
            const Seat& seat = seats[place];
            if (listens(seat, frame) && (request.broadcast || seat.servo.id() == frame.content.id))
                ask(place, request, frame.end, std::nullopt);
        }
    }
    tuneEars(frame.end);
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
            const Seat& seat = seats[place];
            if (!listens(seat, frame) || seat.servo.id() != params[index])
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
    auto frame = protocol::encodeFeetechStatus(answer->id, answer->status, answer->data);
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

void VirtualBus::State::forgetPast()
{
    int slowest = hostReceiver.baud();
    for (const ServoEar& ear : ears)
        slowest = std::min(slowest, ear.baud());
    line.forgetBefore(now - static_cast<Nanos>(lingeringBits * 1e9 / slowest));
}
} // namespace sim
