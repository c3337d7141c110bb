// SPDX-License-Identifier: GPL-3.0-or-later
// How much of a paced 1 Mbaud wire the poll plan uses, against a bare write/poll/read loop on the
// same pseudo-terminal: 15 bytes of feedback from one servo, and sync reads of six. Five
// interleaved pairs each; prints every ratio and the median. POSIX, since the bare loop is.
#include "base/clock.h"
#include "bus/bus_thread.h"
#include "protocol/codec.h"
#include "transport/port_opener.h"

#include <QCoreApplication>
#include <QProcess>
#include <QTextStream>

#include <algorithm>
#include <fcntl.h>
#include <poll.h>
#include <termios.h>
#include <unistd.h>

using base::Bytes;
using base::Duration;
using namespace std::chrono_literals;

namespace {
constexpr int pairs = 5;
constexpr Duration span = 2s;
constexpr int address = 56;
constexpr int count = 15;

base::SystemClock wallClock;

int openRaw(const QString& path)
{
    const int descriptor = open(path.toLocal8Bit().constData(), O_RDWR | O_NOCTTY);
    termios settings{};
    if (descriptor < 0 || tcgetattr(descriptor, &settings) != 0)
        qFatal("cannot open the simulated port");
    cfmakeraw(&settings);
    cfsetspeed(&settings, B1000000);
    tcsetattr(descriptor, TCSANOW, &settings);
    wallClock.sleepFor(50ms); // what the client before has asked for passes
    tcflush(descriptor, TCIOFLUSH);
    return descriptor;
}

/// Exchanges a second of the loop that every simple program has.
double bareRate(const QString& path, const Bytes& request, std::size_t replyBytes)
{
    const int descriptor = openRaw(path);
    std::array<std::uint8_t, 4096> buffer;
    int exchanges = 0;
    const Duration start = wallClock.now();
    while (wallClock.now() < start + span) {
        if (write(descriptor, request.data(), request.size()) != ssize_t(request.size()))
            qFatal("cannot write");
        std::size_t got = 0;
        while (got < replyBytes) {
            pollfd wait{descriptor, POLLIN, 0};
            if (poll(&wait, 1, 100) != 1)
                break;
            got += std::size_t(std::max<ssize_t>(read(descriptor, buffer.data(), 4096), 0));
        }
        exchanges += got == replyBytes ? 1 : 0;
    }
    const double seconds = std::chrono::duration<double>(wallClock.now() - start).count();
    close(descriptor);
    return exchanges / seconds;
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
    const Bytes frame = protocol::feetechCodec().encode(request).value();
    std::vector<double> ratios;
    for (int pair = 0; pair < pairs; ++pair) {
        const double bare = bareRate(path, frame, ids.size() * std::size_t(6 + count));
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
    QProcess simulator;
    simulator.setProcessChannelMode(QProcess::ForwardedErrorChannel);
    simulator.start(QStringLiteral(BIN_DIR "/servodesk-sim"),
                    {QStringLiteral("--servos"),
                     QStringLiteral("sts3215@1,sts3215@2,sts3215@3,sts3215@4,sts3215@5,sts3215@6"),
                     QStringLiteral("--baud"), QStringLiteral("1000000"),
                     QStringLiteral("--wire-time")});
    if (!simulator.waitForStarted() || !simulator.waitForReadyRead())
        qFatal("cannot start servodesk-sim");
    const QString line = QString::fromLocal8Bit(simulator.readLine()).trimmed();
    const QString path = line.section(QStringLiteral(": "), 1);
    compare(out, QStringLiteral("read of one servo"), path, {1}, 0.95);
    compare(out, QStringLiteral("sync read of six"), path, {1, 2, 3, 4, 5, 6}, 0.97);
    simulator.terminate();
    simulator.waitForFinished();
    return 0;
}
