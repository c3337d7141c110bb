// SPDX-License-Identifier: GPL-3.0-or-later
// Servos that come and go: a plugged servo has power and listens, an unplugged one does neither.
#include "sim/bus/virtual_bus_state.h"

#include <algorithm>

namespace sim {
bool VirtualBus::isPlugged(std::size_t nodeIndex) const
{
    return m_state->nodes.at(nodeIndex).plugged;
}

void VirtualBus::plug(std::size_t nodeIndex)
{
    State& s = *m_state;
    BusNode& node = s.nodes.at(nodeIndex);
    if (node.plugged)
        return;
    node.plugged = true;
    node.wasPlugged = true;
    node.sendsUntil = 0;
    node.servo.powerOn();
    s.updateReceivers(s.now);
}

void VirtualBus::unplug(std::size_t nodeIndex)
{
    State& s = *m_state;
    BusNode& node = s.nodes.at(nodeIndex);
    if (!node.plugged)
        return;
    node.plugged = false;
    node.servo.powerOff();
    node.clearRequests();
    s.line.silence(static_cast<int>(nodeIndex), s.now);
}

void VirtualBus::unplugAll()
{
    for (std::size_t nodeIndex = 0; nodeIndex < m_state->nodes.size(); ++nodeIndex)
        unplug(nodeIndex);
}

void VirtualBus::makeHotplugQueue()
{
    unplugAll();
    for (BusNode& node : m_state->nodes)
        node.wasPlugged = false;
    m_state->hotplugQueue = true;
}

bool VirtualBus::hasHotplugQueue() const
{
    return m_state->hotplugQueue;
}

std::size_t VirtualBus::pendingServoCount() const
{
    const auto& nodes = m_state->nodes;
    return static_cast<std::size_t>(std::count_if(
        nodes.begin(), nodes.end(), [](const BusNode& node) { return !node.wasPlugged; }));
}

std::optional<std::size_t> VirtualBus::connectNext()
{
    unplugAll();
    const auto& nodes = m_state->nodes;
    const auto next = std::find_if(nodes.begin(), nodes.end(),
                                   [](const BusNode& node) { return !node.wasPlugged; });
    if (next == nodes.end())
        return std::nullopt;
    const auto nodeIndex = static_cast<std::size_t>(next - nodes.begin());
    plug(nodeIndex);
    return nodeIndex;
}
} // namespace sim
