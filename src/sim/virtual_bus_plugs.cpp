// SPDX-License-Identifier: GPL-3.0-or-later
// Servos that come and go: who is plugged has power and listens, who is not has neither.
#include "sim/virtual_bus_state.h"

#include <algorithm>

namespace sim {
bool VirtualBus::plugged(std::size_t place) const
{
    return m_state->seats.at(place).plugged;
}

void VirtualBus::plug(std::size_t place)
{
    State& s = *m_state;
    Seat& seat = s.seats.at(place);
    if (seat.plugged)
        return;
    seat.plugged = true;
    seat.seen = true;
    seat.speaksUntil = 0;
    seat.servo.powerOn();
    s.tuneEars(s.now);
}

void VirtualBus::unplug(std::size_t place)
{
    State& s = *m_state;
    Seat& seat = s.seats.at(place);
    if (!seat.plugged)
        return;
    seat.plugged = false;
    seat.servo.powerOff();
    seat.forgetRequests();
    s.line.silence(static_cast<int>(place), s.now);
}

void VirtualBus::unplugAll()
{
    for (std::size_t place = 0; place < m_state->seats.size(); ++place)
        unplug(place);
}

void VirtualBus::makeBag()
{
    unplugAll();
    for (Seat& seat : m_state->seats)
        seat.seen = false;
    m_state->bag = true;
}

bool VirtualBus::isBag() const
{
    return m_state->bag;
}

std::size_t VirtualBus::inBag() const
{
    const auto& seats = m_state->seats;
    return static_cast<std::size_t>(
        std::count_if(seats.begin(), seats.end(), [](const Seat& seat) { return !seat.seen; }));
}

std::optional<std::size_t> VirtualBus::plugNext()
{
    unplugAll();
    const auto& seats = m_state->seats;
    const auto next =
        std::find_if(seats.begin(), seats.end(), [](const Seat& seat) { return !seat.seen; });
    if (next == seats.end())
        return std::nullopt;
    const auto place = static_cast<std::size_t>(next - seats.begin());
    plug(place);
    return place;
}
} // namespace sim
