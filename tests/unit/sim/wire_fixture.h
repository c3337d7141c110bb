// SPDX-License-Identifier: GPL-3.0-or-later
// Frames written out by hand and a bus to send them on, for the tests of the simulated wire. The
// frames are built from the published frame layout, not with our own codec.
#pragma once

#include "sim/host/presets.h"

#include <numeric>

namespace wire {
inline const catalog::Catalog& models()
{
    static const catalog::Catalog::LoadResult loaded = catalog::Catalog::load();
    return loaded.catalog;
}

/// Its servos reply exactly in time.
inline std::unique_ptr<sim::VirtualBus> bus(const char* list, std::optional<int> baud = {},
                                            sim::WireConfig config = {})
{
    config.identicalServos = true;
    auto made = sim::makeServos(QString::fromLatin1(list), models(), baud, config);
    if (!made)
        qFatal("%s", qPrintable(made.error().detail));
    return std::move(*made);
}

inline base::Bytes frame(std::uint8_t id, std::uint8_t instruction, const base::Bytes& params = {})
{
    base::Bytes bytes;
    bytes.reserve(params.size() + 6);
    bytes.assign({0xFF, 0xFF, id, static_cast<std::uint8_t>(params.size() + 2), instruction});
    bytes.insert(bytes.end(), params.begin(), params.end());
    const unsigned sum = std::accumulate(bytes.begin() + 2, bytes.end(), 0U);
    bytes.push_back(static_cast<std::uint8_t>(~sum));
    return bytes;
}

inline base::Bytes ping(std::uint8_t id)
{
    return frame(id, 0x01);
}
inline base::Bytes read(std::uint8_t id, std::uint8_t address, std::uint8_t count)
{
    return frame(id, 0x02, {address, count});
}
inline base::Bytes write(std::uint8_t id, std::uint8_t address, std::uint8_t value)
{
    return frame(id, 0x03, {address, value});
}

inline base::Bytes joined(std::initializer_list<base::Bytes> frames)
{
    base::Bytes all;
    for (const base::Bytes& one : frames)
        all.insert(all.end(), one.begin(), one.end());
    return all;
}

inline bool isStatusOf(const base::Bytes& bytes, std::uint8_t id)
{
    return bytes.size() >= 6 && frame(id, bytes[4], {bytes.begin() + 5, bytes.end() - 1}) == bytes;
}

/// Sends at `now` and returns what has come back after `patience`.
inline base::Bytes ask(sim::VirtualBus& bus, const base::Bytes& request, base::Duration& now,
                       int baud = 1'000'000, base::Duration timeout = std::chrono::milliseconds(50))
{
    bus.setHostBaud(baud);
    bus.hostWrites(request, baud, now);
    now += timeout;
    return bus.hostReads(now);
}
} // namespace wire
