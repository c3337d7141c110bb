// SPDX-License-Identifier: GPL-3.0-or-later
// How punctual servodesk-sim --wire-time is, and what it costs. A client of raw system calls reads
// 15 bytes from 56 at 1 Mbaud, back to back; 8 + 21 bytes of 10 µs and the servo's reply delay make
// the due time. Aim: p99 at most 60 µs late, at most 25 % of a core. Lateness is the client's, so
// it holds the terminal's own way there and back; the cost of one way is printed beside it. Means
// something on an idle machine only.
#include "integration/raw_client.h"

#include <QCoreApplication>

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <vector>

namespace {
using Clock = std::chrono::steady_clock;
constexpr int rounds = 10'000;
constexpr double wireTime = 290;
constexpr double replyDelay = 40; // of a simulated STS
constexpr double due = wireTime + replyDelay;

double cpuSeconds(qint64 pid)
{
    clockid_t clock{};
    timespec time{};
    if (clock_getcpuclockid(static_cast<pid_t>(pid), &clock) != 0 ||
        clock_gettime(clock, &time) != 0)
        return 0;
    return static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_nsec) * 1e-9;
}

double microseconds(Clock::duration span)
{
    return std::chrono::duration<double, std::micro>(span).count();
}

double roundTrip(const raw::Client& client, const QByteArray& request, qsizetype replyBytes)
{
    const auto start = Clock::now();
    client.send(request);
    while (!client.readable(raw::timeoutMs)) {
    }
    const auto end = Clock::now();
    client.receive(replyBytes);
    return microseconds(end - start);
}

/// What a terminal costs by itself: from a write at one end until it is readable at the other.
std::vector<double> terminalHops()
{
    const int master = posix_openpt(O_RDWR | O_NOCTTY);
    grantpt(master);
    unlockpt(master);
    const raw::Client client(QString::fromLocal8Bit(ptsname(master)));
    const QByteArray reply(21, 'x');
    std::vector<double> times;
    for (int i = 0; i < rounds; ++i) {
        const auto start = Clock::now();
        if (write(master, reply.constData(), 21) != 21)
            break;
        while (!client.readable(raw::timeoutMs)) {
        }
        times.push_back(microseconds(Clock::now() - start));
        client.receive(21);
        usleep(300);
    }
    close(master);
    return times;
}

double at(std::vector<double>& times, double share)
{
    std::sort(times.begin(), times.end());
    return times[static_cast<std::size_t>(share * static_cast<double>(times.size() - 1))];
}

/// Share of a core the simulator takes while `load` runs.
template <typename Load>
double coreShare(qint64 pid, Load load)
{
    const double before = cpuSeconds(pid);
    const auto start = Clock::now();
    load();
    return (cpuSeconds(pid) - before) / (microseconds(Clock::now() - start) * 1e-6);
}
} // namespace

int main(int argc, char** argv)
{
    const QCoreApplication application(argc, argv);
    raw::Simulator simulator(
        {QStringLiteral("--wire-time"), QStringLiteral("--servos"), QStringLiteral("sts3215@1")});
    const raw::Client client(simulator.port());
    const QByteArray read = raw::bytes("FFFF010402380FB1");
    std::vector<double> times;
    const double busy = coreShare(simulator.pid(), [&] {
        for (int i = 0; i < rounds; ++i)
            times.push_back(roundTrip(client, read, 21));
    });
    const double idle = coreShare(simulator.pid(), [] { usleep(3'000'000); });
    auto hops = terminalHops();
    const auto late = [&](double share) { return at(times, share) - due; };
    std::printf("reply due after %.0f us, complete after %.0f us at best\n", due, at(times, 0));
    std::printf(
        "late: p50 %.0f us, p90 %.0f us, p99 %.0f us, worst %.0f us (p99: %.2f x the aim)\n",
        late(0.5), late(0.9), late(0.99), late(1.0), late(0.99) / 60);
    std::printf("of it a bare terminal, one way: p50 %.0f us, p90 %.0f us, p99 %.0f us\n",
                at(hops, 0.5), at(hops, 0.9), at(hops, 0.99));
    std::printf("CPU: %.1f %% of a core busy (%.2f x the aim), %.2f %% idle\n", busy * 100,
                busy / 0.25, idle * 100);
    return late(0.99) <= 60 && busy <= 0.25 ? 0 : 1;
}
