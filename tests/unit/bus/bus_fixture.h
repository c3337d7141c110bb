// SPDX-License-Identifier: GPL-3.0-or-later
// What the BusCore tests share: a core on a scripted link with servos 1, 2 and 3.
#pragma once

#include "bus/bus_core.h"

#include <QtTest/qtestcase.h>

#include "scripted_link.h"

struct BusFixture {
    Script script;
    std::unique_ptr<bus::BusCore> core;

    void open(bus::CoreOptions options = {},
              const protocol::Codec& codec = protocol::feetechCodec())
    {
        for (int id = 1; id <= 3; ++id)
            script.tables.try_emplace(id, sequentialTable(id));
        core = std::make_unique<bus::BusCore>(std::make_unique<ScriptedLink>(script), codec,
                                              script.clock, options);
        script.sent.clear();
        core->takeTrace();
    }

    void pause(Duration span) const { core->pauseUntil(script.clock.now() + span, nullptr); }

    base::Result<bus::Outcome> transact(protocol::Request request, int retries = -1,
                                        Duration timeout = {}, std::uint64_t hold = 0)
    {
        bus::Transaction transaction;
        transaction.request = std::move(request);
        transaction.retries = retries;
        transaction.timeout = timeout;
        transaction.hold = hold;
        return core->transact(transaction);
    }

    /// Time a transaction takes.
    Duration timed(protocol::Request request, int retries = 0, Duration timeout = {})
    {
        const Duration start = script.clock.now();
        static_cast<void>(transact(std::move(request), retries, timeout));
        return script.clock.now() - start;
    }

    bus::Counters counters(int id) const
    {
        const auto statistics = core->statistics();
        const auto found = statistics.byId.find(id);
        return found == statistics.byId.end() ? bus::Counters{} : found->second;
    }
};

inline Bytes tableBytes(int id, int address, int count)
{
    const Bytes table = sequentialTable(id);
    return Bytes(table.begin() + address, table.begin() + address + count);
}
