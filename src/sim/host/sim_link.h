// SPDX-License-Identifier: GPL-3.0-or-later
// The simulated bus as a port: "sim:NAME". On a manual clock waiting jumps to the next byte; on the
// system clock it waits for real, to the microsecond when asked to pace. Bus thread only, but
// another thread may access the VirtualBus through withBus().
#pragma once

#include "sim/bus/virtual_bus.h"
#include "transport/link.h"

#include <functional>
#include <memory>
#include <mutex>

namespace sim {
/// A VirtualBus with the lock that lets a test or a power-cycle button reach it while a link runs.
class SharedBus {
public:
    explicit SharedBus(std::unique_ptr<VirtualBus> bus)
        : m_bus(std::move(bus))
    {}
    template <typename Function>
    decltype(auto) with(Function&& function)
    {
        const std::lock_guard lock(m_mutex);
        return function(*m_bus);
    }

private:
    std::mutex m_mutex;
    std::unique_ptr<VirtualBus> m_bus;
};

std::unique_ptr<transport::Link> makeSimLink(std::shared_ptr<SharedBus> bus, QString name,
                                             base::Clock& clock, int baud);
} // namespace sim
