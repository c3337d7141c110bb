// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/bus/virtual_bus_state.h"

#include <algorithm>

namespace sim {
VirtualBus::VirtualBus(WireConfig config)
    : m_state(std::make_unique<State>(std::move(config)))
{}

VirtualBus::~VirtualBus() = default;

VirtualServo& VirtualBus::add(VirtualServo servo)
{
    auto& node = m_state->nodes.emplace_back(std::move(servo));
    m_state->updateReceivers(m_state->now);
    return node.servo;
}

std::vector<VirtualServo*> VirtualBus::servos()
{
    std::vector<VirtualServo*> all;
    for (BusNode& node : m_state->nodes)
        all.push_back(&node.servo);
    return all;
}

VirtualServo* VirtualBus::servo(int id)
{
    for (BusNode& node : m_state->nodes) {
        if (node.servo.id() == id)
            return &node.servo;
    }
    return nullptr;
}

void VirtualBus::hostWrites(base::ByteView bytes, int baud, base::Duration now)
{
    State& s = *m_state;
    s.advance(toNanos(now));
    s.updateReceivers(s.now);
    std::size_t count = s.cut ? 0 : bytes.size();
    if (s.bytesUntilCut) {
        count = std::min(count, *s.bytesUntilCut);
        *s.bytesUntilCut -= count;
    }
    if (count > 0) {
        const Nanos start = std::max(s.now, s.hostSendsUntil);
        const auto sent = bytes.first(count);
        s.hostSendsUntil =
            s.line.transmit(Burst(hostSender, start, baud, {sent.begin(), sent.end()})).end();
    }
    if (s.bytesUntilCut == std::size_t{0}) {
        s.cut = true;
        s.toHost.clear();
    }
}

base::Bytes VirtualBus::hostReads(base::Duration now)
{
    State& s = *m_state;
    const Nanos at = toNanos(now);
    s.advance(at);
    base::Bytes bytes;
    while (!s.toHost.empty() && s.toHost.front().at <= at) {
        bytes.push_back(s.toHost.front().value);
        s.toHost.pop_front();
    }
    return bytes;
}

std::optional<base::Duration> VirtualBus::nextHostByte() const
{
    const State& s = *m_state;
    if (!s.toHost.empty())
        return toDuration(s.toHost.front().at);
    const auto received = s.hostReceiver.peek(s.line);
    if (!received || s.cut)
        return std::nullopt;
    return toDuration(received->end + s.latency());
}

std::optional<base::Duration> VirtualBus::nextHostRun(base::Duration deadline)
{
    State& s = *m_state;
    const Nanos limit = toNanos(deadline);
    s.advance(std::min(limit, std::max(s.now, s.hostSendsUntil)));
    // Until then more bytes may come that belong to the same frame, or a servo is busy writing.
    for (const auto due : {s.silenceEnd(), s.requestDue()}) {
        if (due && *due <= limit && !s.isReplyPending())
            return toDuration(*due);
    }
    Nanos end = 0;
    if (!s.toHost.empty()) {
        end = s.toHost.front().runEnd;
    } else {
        const auto received = s.hostReceiver.peek(s.line);
        if (!received || s.cut)
            return std::nullopt;
        end = received->burstEnd + s.latency();
    }
    const auto whole = toDuration(end);
    return whole <= deadline ? std::optional(whole) : std::nullopt;
}

void VirtualBus::setHostBaud(int baud)
{
    m_state->hostReceiver = UartReceiver(m_state->hostFilter(), baud, m_state->now);
}

int VirtualBus::hostBaud() const
{
    return m_state->hostReceiver.baud();
}

void VirtualBus::powerCycle()
{
    State& s = *m_state;
    for (BusNode& node : s.nodes) {
        if (!node.plugged)
            continue;
        node.servo.powerOff();
        node.servo.powerOn();
        node.sendsUntil = 0;
        node.clearRequests();
    }
    s.line.removeServos();
    s.receivers.clear();
    s.updateReceivers(s.now);
}

void VirtualBus::cutLink()
{
    State& s = *m_state;
    s.cut = true;
    s.toHost.clear();
    s.line.silenceHost(s.now);
    s.hostSendsUntil = s.now;
}

void VirtualBus::restoreLink()
{
    State& s = *m_state;
    s.cut = false;
    s.bytesUntilCut.reset();
    s.toHost.clear();
    s.hostReceiver = UartReceiver(s.hostFilter(), s.hostReceiver.baud(), s.now);
}

bool VirtualBus::linkCut() const
{
    return m_state->cut;
}

void VirtualBus::cutAfterHostBytes(std::size_t count)
{
    m_state->bytesUntilCut = count;
    if (count == 0)
        cutLink();
}

WireConfig& VirtualBus::config()
{
    return m_state->config;
}
} // namespace sim
