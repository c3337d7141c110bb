// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/bus/virtual_bus_state.h"

#include "sim/servo/bootloader.h"

#include <algorithm>

namespace sim {
namespace {
/// How long a byte begun within a burst may last beyond its end, or a silence after it, in bits of
/// the slowest listener.
constexpr double retainedBits = 48;

bool isHeardBy(const VirtualServo& servo, const RequestReceiver& receiver)
{
    return servo.baud() == receiver.baud() && servo.profile().protocol == receiver.protocol();
}

} // namespace

// The clock may count from anywhere: the bus' own time begins with the first call.
void VirtualBus::State::begin(Nanos at)
{
    if (started)
        return;
    started = true;
    now = steppedTo = hostSendsUntil = at;
    hostReceiver = UartReceiver(hostFilter(), hostReceiver.baud(), at);
    updateReceivers(at);
}

void VirtualBus::State::advance(Nanos to)
{
    begin(to);
    if (to <= now)
        return;
    for (;;) {
        RequestReceiver::Event event;
        RequestReceiver* receiver = nextReceiver(to, event);
        if (const auto due = requestDue(); due && *due <= (receiver != nullptr ? event.at : to)) {
            dispatchQueued(*due);
            continue;
        }
        if (dispatchBootloaderByte(receiver != nullptr ? event.at : to))
            continue;
        if (receiver == nullptr)
            break;
        if (const auto frame = receiver->take(event))
            dispatch(*frame);
    }
    receiveForHost(to);
    advanceServos(to);
    now = to;
    discardPast();
}

void VirtualBus::State::advanceServos(Nanos to)
{
    const Nanos dt = toNanos(config.dt);
    while (steppedTo + dt <= to) {
        steppedTo += dt;
        for (BusNode& node : nodes) {
            node.servo.step(config.dt);
            if (node.servo.isDeaf())
                node.deafUntil = steppedTo;
        }
    }
}

// One receiver for each rate and protocol that a servo listens to.
void VirtualBus::State::updateReceivers(Nanos at)
{
    for (const BusNode& node : nodes) {
        const bool known = std::any_of(
            receivers.begin(), receivers.end(),
            [&node](const RequestReceiver& receiver) { return isHeardBy(node.servo, receiver); });
        if (!known)
            receivers.emplace_back(node.servo.profile().protocol, node.servo.baud(), at);
    }
    std::erase_if(receivers, [this](const RequestReceiver& receiver) {
        return std::none_of(nodes.begin(), nodes.end(), [&receiver](const BusNode& node) {
            return isHeardBy(node.servo, receiver);
        });
    });
    const bool boots = std::any_of(nodes.begin(), nodes.end(),
                                   [](const BusNode& node) { return node.servo.hearsFirmware(); });
    if (!boots)
        bootloaderReceiver.reset();
    else if (!bootloaderReceiver)
        bootloaderReceiver.emplace(RxFilter::Host, Bootloader::baud, at);
}

// True: there was one.
bool VirtualBus::State::dispatchBootloaderByte(Nanos to)
{
    const auto byte = bootloaderReceiver ? bootloaderReceiver->peek(line) : std::nullopt;
    if (!byte || byte->end > to)
        return false;
    bootloaderReceiver->take(*byte);
    advanceServos(byte->end);
    for (std::size_t nodeIndex = 0; nodeIndex < nodes.size(); ++nodeIndex) {
        VirtualServo& servo = nodes[nodeIndex].servo;
        if (!byte->framed || !servo.hearsFirmware())
            continue;
        const auto reply = servo.receiveInBootloader(byte->value);
        if (reply && !cut && !isMute(servo, servo.id()))
            transmit(nodeIndex, {reply->byte}, Bootloader::baud,
                     byte->end + toNanos(servo.replyDelay() + reply->wait));
    }
    return true;
}

RequestReceiver* VirtualBus::State::nextReceiver(Nanos to, RequestReceiver::Event& event)
{
    RequestReceiver* first = nullptr;
    for (RequestReceiver& receiver : receivers) {
        const auto next = receiver.peek(line);
        if (next && next->at <= to && (first == nullptr || next->at < event.at)) {
            first = &receiver;
            event = *next;
        }
    }
    return first;
}

// The latest instant at which a silence may turn the bytes received so far into a request.
std::optional<Nanos> VirtualBus::State::silenceEnd() const
{
    std::optional<Nanos> latest;
    for (const RequestReceiver& receiver : receivers) {
        if (const auto due = receiver.silenceEnd(); due && (!latest || *due > *latest))
            latest = due;
    }
    return latest;
}

void VirtualBus::State::receiveForHost(Nanos to)
{
    hostReceiver.setFilter(hostFilter());
    for (auto received = hostReceiver.peek(line); received && received->end <= to;
         received = hostReceiver.peek(line)) {
        hostReceiver.take(*received);
        if (!cut)
            toHost.push_back(
                {received->end + latency(), received->burstEnd + latency(), received->value});
    }
}

bool VirtualBus::State::isReplyPending() const
{
    return !toHost.empty() || hostReceiver.peek(line).has_value();
}

void VirtualBus::State::discardPast()
{
    int slowest = hostReceiver.baud();
    for (const RequestReceiver& receiver : receivers)
        slowest = std::min(slowest, receiver.baud());
    if (bootloaderReceiver)
        slowest = std::min(slowest, bootloaderReceiver->baud());
    line.removeBefore(now - static_cast<Nanos>(retainedBits * 1e9 / slowest));
}
} // namespace sim
