// SPDX-License-Identifier: GPL-3.0-or-later
// How much of a paced 1 Mbaud wire the poll plan uses, against a bare write/poll/read loop on the
// same pseudo-terminal: 15 bytes of feedback from one servo, and sync reads of six. Five
// interleaved pairs each; prints every ratio and the median. POSIX, since the bare loop is.
#include "base/clock.h"
#include "bus/bus_thread.h"
#include "integration/raw_client.h"
#include "protocol/codec.h"
#include "transport/port_opener.h"

#include <QCoreApplication>
#include <QTextStream>

#include <algorithm>

using base::Duration;
using namespace std::chrono_literals;

namespace {
constexpr int pairs = 5;
constexpr Duration span = 2s;
constexpr int address = 56;
constexpr int count = 15;

base::SystemClock wallClock;

/// Exchanges a second of the loop that every simple program has.
double bareRate(const QString& path, const QByteArray& request, qsizetype replyBytes)
{
    const raw::Client client(path);
    wallClock.sleepFor(50ms); // what the client before has asked for passes
    int exchanges = 0;
    Duration lost{}; // spent on answers that a busy machine did not let through
    const Duration start = wallClock.now();
    while (wallClock.now() < start + span) {
        const Duration asked = wallClock.now();
        client.say(request);
        if (client.hear(replyBytes).size() == replyBytes) {
            ++exchanges;
            continue;
        }
        client.hear(replyBytes); // what is left of it
        lost += wallClock.now() - asked;
    }
    if (exchanges == 0)
        qFatal("no answer from the simulated bus");
    return exchanges / std::chrono::duration<double>(wallClock.now() - start - lost).count();
}

/// Rounds a second of a poll plan over these servos.
double planRate(const QString& path, const std::vector<int>& ids)
{
    transport::PortSpec spec;
    spec.name = path;
    auto bus = bus::BusThread::open([&] { return transport::openPort(spec, wallClock); },
                                    protocol::feetechCodec(), wallClock);
    if (!bus)
        qFatal("cannot open the port through the bus");
    bus::PollPlan plan;
    for (const int id : ids)
        plan.servos.push_back({id, {{address, count}}, true, 0});
    const bus::PollId id = (*bus)->startPoll(plan);
    (*bus)->pauseUntil(wallClock.now() + span, nullptr);
    std::vector<Duration> answered;
    for (const bus::Sample& sample : (*bus)->takeSamples(id)) {
        if (sample.answered && sample.id == ids.front())
            answered.push_back(sample.at);
    }
    if (answered.size() < 2)
        qFatal("the plan was not answered");
    const double seconds =
        std::chrono::duration<double>(answered.back() - answered.front()).count();
    return double(answered.size() - 1) / seconds;
}

void compare(QTextStream& out, const QString& what, const QString& path,
             const std::vector<int>& ids, double wanted)
{
    const auto request = ids.size() == 1 ? protocol::Request::read(ids.front(), address, count)
                                         : protocol::Request::syncRead(address, count, ids);
    const base::Bytes frame = protocol::feetechCodec().encode(request).value();
    const QByteArray bytes(reinterpret_cast<const char*>(frame.data()), qsizetype(frame.size()));
    std::vector<double> ratios;
    for (int pair = 0; pair < pairs; ++pair) {
        const double bare = bareRate(path, bytes, qsizetype(ids.size()) * (6 + count));
        const double plan = planRate(path, ids);
        ratios.push_back(plan / bare);
        out << QStringLiteral("%1: bare %2/s, plan %3/s, ratio %4\n")
                   .arg(what)
                   .arg(bare, 0, 'f', 0)
                   .arg(plan, 0, 'f', 0)
                   .arg(plan / bare, 0, 'f', 3);
        out.flush();
    }
    std::sort(ratios.begin(), ratios.end());
    out << QStringLiteral("%1: median ratio %2 (wanted %3)\n")
               .arg(what)
               .arg(ratios[pairs / 2], 0, 'f', 3)
               .arg(wanted, 0, 'f', 2);
    out.flush();
}
} // namespace

int main(int argc, char* argv[])
{
    const QCoreApplication application(argc, argv);
    QTextStream out(stdout);
    const raw::Simulator simulator(
        {QStringLiteral("--servos"),
         QStringLiteral("sts3215@1,sts3215@2,sts3215@3,sts3215@4,sts3215@5,sts3215@6"),
         QStringLiteral("--baud"), QStringLiteral("1000000"), QStringLiteral("--wire-time")});
    const QString path = simulator.port();
    compare(out, QStringLiteral("read of one servo"), path, {1}, 0.95);
    compare(out, QStringLiteral("sync read of six"), path, {1, 2, 3, 4, 5, 6}, 0.97);
    return 0;
}
