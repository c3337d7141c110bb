// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/virtual_bus_state.h"

#include <algorithm>

namespace sim {
namespace {
/// How long a byte begun within a burst may last beyond its end, or a silence after it, in bits of
/// the slowest listener.
constexpr double lingeringBits = 48;

bool hasEarFor(const VirtualServo& servo, const ServoEar& ear)
{
    return servo.baud() == ear.baud() && servo.profile().protocol == ear.protocol();
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
    for (;;) {
        ServoEar::Event event;
        ServoEar* ear = nextEar(to, event);
        if (const auto due = requestDue(); due && *due <= (ear != nullptr ? event.at : to)) {
            obeyWaiting(*due);
            continue;
        }
        if (ear == nullptr)
            break;
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
