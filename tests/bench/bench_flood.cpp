// SPDX-License-Identifier: GPL-3.0-or-later
// What a byte costs that nobody asked for, when little of it waits and when very much does: valid
// frames and noise, in one arrival of 16 KiB and one of 4 MiB, beside a loop that only adds the
// bytes up. Wanted: the same cost a byte however much waits (ratio below 2).
#include "bus/bus_core.h"

#include <cstdio>
#include <ctime>
#include <random>

namespace {
using base::Bytes;
using base::Duration;
using namespace std::chrono_literals;

constexpr std::size_t little = std::size_t{16} << 10;
constexpr std::size_t much = std::size_t{4} << 20;

/// Hands over what it was given in one piece.
class PreloadedLink final : public transport::Link {
public:
    PreloadedLink(Bytes& waiting, base::ManualClock& clock)
        : m_waiting(waiting)
        , m_clock(clock)
    {}
    base::Result<void> write(base::ByteView) override { return {}; }
    base::Result<std::size_t> read(Bytes& buffer) override
    {
        buffer.insert(buffer.end(), m_waiting.begin(), m_waiting.end());
        return std::exchange(m_waiting, {}).size();
    }
    base::Result<bool> waitForReadyRead(Duration span) override
    {
        if (m_waiting.empty())
            m_clock.advance(span);
        return !m_waiting.empty();
    }
    base::Result<void> setBaud(int) override { return {}; }
    int baud() const override { return 1'000'000; }
    QString name() const override { return QStringLiteral("pile"); }

private:
    Bytes& m_waiting;
    base::ManualClock& m_clock;
};

double seconds()
{
    return double(std::clock()) / CLOCKS_PER_SEC;
}

Bytes frames(std::size_t size)
{
    const Bytes unit{0xFF, 0xFF, 1, 4, 0, 8, 9, 0xE9};
    Bytes all;
    while (all.size() + unit.size() <= size)
        all.insert(all.end(), unit.begin(), unit.end());
    return all;
}

Bytes noise(std::size_t size)
{
    std::minstd_rand random(1);
    Bytes all(size);
    for (std::uint8_t& byte : all)
        byte = std::uint8_t(random() >> 8);
    return all;
}

/// Nanoseconds for each byte; so often that both sizes digest as much.
double costPerByte(const Bytes& bytes)
{
    base::ManualClock clock;
    Bytes waiting;
    bus::BusCore core(std::make_unique<PreloadedLink>(waiting, clock), protocol::feetechCodec(),
                      clock, {});
    const std::size_t rounds = 2 * much / bytes.size();
    const double start = seconds();
    for (std::size_t i = 0; i < rounds; ++i) {
        waiting = bytes;
        (void)core.listen({});
    }
    return (seconds() - start) * 1e9 / double(rounds * bytes.size());
}

double baselineCost()
{
    const Bytes bytes = noise(much);
    unsigned sum = 0;
    const double start = seconds();
    for (int round = 0; round < 20; ++round) {
        for (const std::uint8_t byte : bytes)
            sum = sum * 31 + byte;
    }
    const double cost = (seconds() - start) * 1e9 / (20.0 * double(bytes.size()));
    return sum == 0 ? cost + 1e-9 : cost;
}
} // namespace

int main()
{
    const double baseline = baselineCost();
    bool linear = true;
    for (const auto& [name, make] : {std::pair{"frames", &frames}, std::pair{"noise", &noise}}) {
        const double few = costPerByte(make(little));
        const double many = costPerByte(make(much));
        linear = linear && many < 2 * few;
        std::printf("%s: %.0f ns a byte in 16 KiB, %.0f in 4 MiB: ratio %.2f; %.0f times a bare "
                    "loop\n",
                    name, few, many, many / few, few / baseline);
    }
    return linear ? 0 : 1;
}
