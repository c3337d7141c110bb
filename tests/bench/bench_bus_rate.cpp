// SPDX-License-Identifier: GPL-3.0-or-later
// How much of a paced wire the poll plan uses, against a bare write/poll/read loop on the same
// pseudo-terminal: Feetech feedback of one servo and of six at 1 Mbaud; eight Modbus registers and
// the LX position at 115200. The bare Modbus loop keeps the silence the standard asks for. Five
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

base::SystemClock wallClock;

/// What is read, of whom, and what comes back for it.
struct ReadPattern {
    QString what{};
    QStringList servos{};
    int baud = 1'000'000;
    speed_t rate = B1000000;
    protocol::Request request{};
    Duration silence{}; ///< between a reply and the next request
    double wanted = 0.95;

    const protocol::Codec& codec() const { return protocol::codecFor(request.protocol); }
    std::vector<int> ids() const
    {
        std::vector<int> asked{request.id};
        if (!request.targets.empty())
            asked.clear();
        for (const protocol::Target& target : request.targets)
            asked.push_back(target.id);
        return asked;
    }
};

/// Exchanges a second of the loop that every simple program has.
double baselineRate(const QString& path, const ReadPattern& course)
{
    const base::Bytes frame = course.codec().encode(course.request).value();
    const QByteArray request(reinterpret_cast<const char*>(frame.data()), qsizetype(frame.size()));
    const auto expected = course.codec().expect(course.request);
    const qsizetype replyBytes = qsizetype(expected.ids.size()) * expected.replyBytes;
    const raw::Client client(path, course.rate);
    wallClock.sleepFor(50ms); // what the client before has asked for passes
    int exchanges = 0;
    Duration lost{}; // spent on answers that a busy machine did not let through
    const Duration start = wallClock.now();
    while (wallClock.now() < start + span) {
        const Duration asked = wallClock.now();
        client.send(request);
        const bool answered = client.receive(replyBytes).size() == replyBytes;
        exchanges += answered ? 1 : 0;
        if (!answered) {
            client.receive(replyBytes); // what is left of it
            lost += wallClock.now() - asked;
        }
        if (course.silence > 0us)
            wallClock.sleepFor(course.silence);
    }
    if (exchanges == 0)
        qFatal("no answer from the simulated bus");
    return exchanges / std::chrono::duration<double>(wallClock.now() - start - lost).count();
}

/// Rounds a second of a poll plan over the same servos.
double planRate(const QString& path, const ReadPattern& course)
{
    transport::PortSpec spec;
    spec.name = path;
    spec.baud = course.baud;
    auto bus = bus::BusThread::open([&] { return transport::openPort(spec, wallClock); },
                                    course.codec(), wallClock);
    if (!bus)
        qFatal("cannot open the port through the bus");
    bus::PollPlan plan;
    for (const int id : course.ids()) {
        plan.servos.push_back({id,
                               {{course.request.address, course.request.count}},
                               true,
                               0,
                               course.request.protocol});
    }
    const bus::PollId id = (*bus)->startPoll(plan);
    (*bus)->pauseUntil(wallClock.now() + span, nullptr);
    std::vector<Duration> answered;
    for (const bus::Sample& sample : (*bus)->takeSamples(id)) {
        if (sample.answered && sample.id == course.ids().front())
            answered.push_back(sample.at);
    }
    if (answered.size() < 2)
        qFatal("the plan was not answered");
    const double seconds =
        std::chrono::duration<double>(answered.back() - answered.front()).count();
    return double(answered.size() - 1) / seconds;
}

void compare(QTextStream& out, const ReadPattern& course)
{
    const raw::Simulator simulator({QStringLiteral("--servos"), course.servos.join(u','),
                                    QStringLiteral("--baud"), QString::number(course.baud),
                                    QStringLiteral("--wire-time")});
    std::vector<double> ratios;
    for (int pair = 0; pair < pairs; ++pair) {
        const double baseline = baselineRate(simulator.port(), course);
        const double plan = planRate(simulator.port(), course);
        ratios.push_back(plan / baseline);
        out << QStringLiteral("%1: bare %2/s, plan %3/s, ratio %4\n")
                   .arg(course.what)
                   .arg(baseline, 0, 'f', 0)
                   .arg(plan, 0, 'f', 0)
                   .arg(plan / baseline, 0, 'f', 3);
        out.flush();
    }
    std::sort(ratios.begin(), ratios.end());
    out << QStringLiteral("%1: median ratio %2 (wanted %3)\n")
               .arg(course.what)
               .arg(ratios[pairs / 2], 0, 'f', 3)
               .arg(course.wanted, 0, 'f', 2);
    out.flush();
}

std::vector<ReadPattern> courses()
{
    using protocol::Request;
    constexpr int feedback = 56;
    constexpr int feedbackBytes = 15;
    constexpr int modbusFeedback = 2 * 256;
    constexpr int lxPosition = 8 * 28;
    QStringList six;
    for (int id = 1; id <= 6; ++id)
        six += QStringLiteral("sts3215@%1").arg(id);
    ReadPattern one{QStringLiteral("read of one servo"), six};
    one.request = Request::read(1, feedback, feedbackBytes);
    ReadPattern all{QStringLiteral("sync read of six"), six};
    all.request = Request::syncRead(feedback, feedbackBytes, {1, 2, 3, 4, 5, 6});
    all.wanted = 0.97;
    ReadPattern modbus{QStringLiteral("Modbus read of eight registers"),
                       {QStringLiteral("smsmb@1")},
                       115'200,
                       B115200};
    modbus.request = Request::read(1, modbusFeedback, 16).in(base::Protocol::Modbus);
    modbus.silence = 1750us;
    ReadPattern lx{QStringLiteral("LX position"), {QStringLiteral("lx16a@1")}, 115'200, B115200};
    lx.request = Request::read(1, lxPosition, 2).in(base::Protocol::Lx);
    return {one, all, modbus, lx};
}
} // namespace

int main(int argc, char* argv[])
{
    const QCoreApplication application(argc, argv);
    QTextStream out(stdout);
    for (const ReadPattern& course : courses())
        compare(out, course);
    return 0;
}
