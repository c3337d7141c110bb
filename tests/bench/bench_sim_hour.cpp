// SPDX-License-Identifier: GPL-3.0-or-later
// One hour of simulated time: six servos, steps of 1 ms, each read 20 times a second (15 bytes from
// 56) by raw requests through the virtual bus. Aim: at most 5 s on one core, at rest and in motion.
#include "sim/host/presets.h"

#include <chrono>
#include <cstdio>
#include <ctime>
#include <numeric>

using namespace std::chrono_literals;

namespace {
constexpr int baud = 1'000'000;
constexpr base::Duration pollPeriod = 50ms;
constexpr base::Duration span = 1h;
constexpr double target = 5.0;

base::Bytes frame(std::uint8_t id, std::uint8_t instruction, const base::Bytes& params)
{
    const auto length = static_cast<std::uint8_t>(params.size() + 2);
    base::Bytes bytes;
    bytes.reserve(params.size() + 6);
    bytes.assign({0xFF, 0xFF, id, length, instruction});
    bytes.insert(bytes.end(), params.begin(), params.end());
    const unsigned sum = std::accumulate(bytes.begin() + 2, bytes.end(), 0U);
    bytes.push_back(static_cast<std::uint8_t>(~sum));
    return bytes;
}

/// Sends and takes the reply; its size.
std::size_t ask(sim::VirtualBus& bus, const base::Bytes& request, base::Duration& now)
{
    bus.hostWrites(request, baud, now);
    const auto complete = bus.nextHostRun(now + 10ms);
    now = complete.value_or(now + 10ms);
    return bus.hostReads(now).size();
}

double cpuSeconds()
{
    timespec time{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_nsec) * 1e-9;
}

bool run(const char* name, bool moving)
{
    const auto loaded = catalog::Catalog::load();
    auto bus = sim::makePreset(QStringLiteral("demo"), loaded.catalog);
    if (!bus)
        return false;
    base::Duration now{};
    (*bus)->hostReads(now);
    std::size_t asked = 0;
    std::size_t answered = 0;
    const double begin = cpuSeconds();
    for (base::Duration due{}; due < span; due += pollPeriod) {
        now = std::max(now, due);
        if (moving && due % 2s == base::Duration{}) {
            const auto high = static_cast<std::uint8_t>(due % 4s == base::Duration{} ? 6 : 9);
            for (std::uint8_t id = 1; id <= 4; ++id)
                ask(**bus, frame(id, 0x03, {42, 0, high}), now);
        }
        for (std::uint8_t id = 1; id <= 6; ++id) {
            ++asked;
            answered += ask(**bus, frame(id, 0x02, {56, 15}), now) == 21 ? 1 : 0;
        }
    }
    const double used = cpuSeconds() - begin;
    std::printf("%-10s %zu of %zu reads answered, %.2f s of CPU, %.2f x the aim of %.0f s\n", name,
                answered, asked, used, used / target, target);
    return answered == asked && used <= target;
}
} // namespace

int main()
{
    const bool resting = run("at rest", false);
    const bool moving = run("in motion", true);
    return resting && moving ? 0 : 1;
}
