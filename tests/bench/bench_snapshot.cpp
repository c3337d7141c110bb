// SPDX-License-Identifier: GPL-3.0-or-later
// What comparing and restoring cost beyond the wire, on a paced pseudo-terminal at 1 Mbaud, against
// bare loops on the same terminal: (1) the difference of a servo's whole table (HLS, 65 rows)
// against a file, the reading included, against reading the same blocks; (2) a restore of 48 rows,
// 24 on each of two servos, from torque off to the proof of the lock, against sending the same
// EPROM writes one after another with the time each is given. The journal is in memory: how long a
// disk takes is another matter. Five interleaved pairs each, every ratio and the median. POSIX.
#include "base/clock.h"
#include "bus/bus_thread.h"
#include "device/transactions.h"
#include "integration/raw_client.h"
#include "integration/restore_support.h"
#include "jobs/restore/restore.h"
#include "jobs/restore/take_snapshot.h"
#include "protocol/codec.h"
#include "snapshot/snapshot_compare.h"
#include "transport/port_opener.h"

#include <QCoreApplication>
#include <QTextStream>

#include <algorithm>

using base::Duration;
using namespace std::chrono_literals;

namespace {
constexpr int pairs = 5;
base::SystemClock wallClock;

double seconds(Duration span)
{
    return std::chrono::duration<double>(span).count();
}

/// The program's side of the terminal.
struct Host {
    explicit Host(const QString& port)
    {
        transport::PortSpec spec;
        spec.name = port;
        spec.baud = 1'000'000;
        auto opened = bus::BusThread::open([&] { return transport::openPort(spec, wallClock); },
                                           protocol::feetechCodec(), wallClock);
        if (!opened)
            qFatal("cannot open the port");
        bus = std::move(*opened);
    }
    device::Context context() { return {*bus, support::builtInCatalog(), journal, stop, notices}; }

    std::unique_ptr<bus::BusThread> bus;
    support::MemoryJournal journal;
    base::StopToken stop;
    device::Notices notices;
};

device::Servo whole(Host& host, int id)
{
    auto servo = device::identify(host.context(), id);
    if (!servo || !device::readAll(host.context(), *servo))
        qFatal("servo %d does not answer", id);
    return *servo;
}

QByteArray bytesOf(const base::Bytes& frame)
{
    return {reinterpret_cast<const char*>(frame.data()), qsizetype(frame.size())};
}

void report(QTextStream& out, const char* what, std::vector<double> ratios, double wanted)
{
    std::sort(ratios.begin(), ratios.end());
    out << what << ": median ratio " << QString::number(ratios[ratios.size() / 2], 'f', 3)
        << " (wanted at most " << QString::number(wanted, 'f', 2) << ")\n";
    out.flush();
}

void compareTables(QTextStream& out)
{
    const raw::Simulator simulator({QStringLiteral("--servos"), QStringLiteral("hls3606@1"),
                                    QStringLiteral("--baud"), QStringLiteral("1000000"),
                                    QStringLiteral("--wire-time")});
    std::vector<protocol::Request> reads;
    QByteArray file;
    {
        Host host(simulator.port());
        const device::Servo servo = whole(host, 1);
        std::vector<const catalog::Register*> registers;
        for (const catalog::Register& reg : servo.profile->registers)
            registers.push_back(&reg);
        for (const bus::PollSpan& span : device::planSpans(*servo.profile, registers))
            reads.push_back(protocol::Request::read(1, span.address, span.count));
        file = snapshot::encodeSnapshot(jobs::snapshotOf(servo, QStringLiteral("bench")));
    }
    std::vector<double> ratios;
    for (int pair = 0; pair < pairs; ++pair) {
        double bare = 0;
        {
            const raw::Client client(simulator.port(), B1000000);
            wallClock.sleepFor(50ms);
            const Duration start = wallClock.now();
            for (const protocol::Request& read : reads) {
                client.send(bytesOf(protocol::feetechCodec().encode(read).value()));
                client.receive(protocol::feetechCodec().expect(read).replyBytes);
            }
            bare = seconds(wallClock.now() - start);
        }
        Host host(simulator.port());
        auto servo = device::identify(host.context(), 1);
        const Duration start = wallClock.now();
        const auto table = jobs::takeSnapshot(host.context(), *servo, QStringLiteral("bench"));
        const auto other = snapshot::decodeSnapshot(file);
        const auto comparison = snapshot::compareSnapshots({&*table, &*other});
        const double ours = seconds(wallClock.now() - start);
        ratios.push_back(ours / bare);
        out << QStringLiteral("difference of %1 rows: bare reads %2 ms, with the file %3 ms, "
                              "ratio %4\n")
                   .arg(comparison.rows.size())
                   .arg(bare * 1000, 0, 'f', 2)
                   .arg(ours * 1000, 0, 'f', 2)
                   .arg(ours / bare, 0, 'f', 3);
        out.flush();
    }
    report(out, "difference, of 500 ms allowed it is far from", ratios, 10);
}

/// Every second writable row, then as many more as make 24.
support::TableValues rowsToChange(const device::Servo& servo)
{
    constexpr std::size_t wanted = 24;
    support::TableValues all = support::RandomTable(5).make(servo);
    for (const char* key : {"operating_mode", "response_level", "return_delay", "phase"})
        all.erase(QLatin1String(key));
    for (auto it = all.begin(); it != all.end();)
        it = servo.raw(it->first) == it->second ? all.erase(it) : std::next(it);
    while (all.size() > wanted)
        all.erase(std::prev(all.end()));
    return all;
}

snapshot::Snapshot targetSnapshot(const device::Servo& servo, const support::TableValues& rows)
{
    snapshot::Snapshot snapshot = jobs::snapshotOf(servo, QStringLiteral("bench"));
    for (snapshot::SnapshotRegister& reg : snapshot.registers) {
        const auto row = rows.find(reg.key);
        if (row != rows.end())
            reg.raw = row->second;
    }
    return snapshot;
}

jobs::RestorePlan planOf(const device::Servo& servo, const snapshot::Snapshot& snapshot)
{
    jobs::RestoreChoice choice;
    choice.consent = device::Consent::confirmed();
    return jobs::planRestore(servo, snapshot, choice);
}

/// The EPROM writes a restore sends, as it groups them.
std::vector<QByteArray> epromFrames(const QString& servos)
{
    support::SimFixture fixture(servos);
    std::vector<QByteArray> frames;
    for (const int id : {1, 2}) {
        device::Servo servo = support::identifyWithTable(fixture, id);
        const auto plan = planOf(servo, targetSnapshot(servo, rowsToChange(servo)));
        fixture.clearFrames();
        jobs::RestoreOptions options;
        options.consent = device::Consent::confirmed();
        if (!jobs::restore(fixture.context(), servo, plan, options))
            qFatal("restore");
        for (const base::Bytes& frame : fixture.tap().written) {
            constexpr int firstSram = 40;
            if (frame[4] == support::Write && frame[5] < firstSram)
                frames.push_back(bytesOf(frame));
        }
    }
    return frames;
}

void restoreRows(QTextStream& out)
{
    const QString servos = QStringLiteral("sts3215@1,sts3215@2");
    const std::vector<QByteArray> frames = epromFrames(servos);
    std::vector<double> ratios;
    for (int pair = 0; pair < pairs; ++pair) {
        const QStringList arguments{QStringLiteral("--servos"), servos, QStringLiteral("--baud"),
                                    QStringLiteral("1000000"), QStringLiteral("--wire-time")};
        double bare = 0;
        {
            const raw::Simulator simulator(arguments);
            const raw::Client client(simulator.port(), B1000000);
            wallClock.sleepFor(50ms);
            constexpr qsizetype acknowledgment = 6;
            const Duration start = wallClock.now();
            for (const QByteArray& frame : frames) {
                client.send(frame);
                client.receive(acknowledgment);
                wallClock.sleepFor(device::epromWriteTime);
            }
            bare = seconds(wallClock.now() - start);
        }
        const raw::Simulator simulator(arguments);
        Host host(simulator.port());
        std::vector<device::Servo> bothServos{whole(host, 1), whole(host, 2)};
        std::vector<jobs::RestorePlan> plans;
        std::size_t rows = 0;
        for (const device::Servo& servo : bothServos) {
            plans.push_back(planOf(servo, targetSnapshot(servo, rowsToChange(servo))));
            rows += jobs::plannedWrites(plans.back()).size();
        }
        jobs::RestoreOptions options;
        options.consent = device::Consent::confirmed();
        const Duration start = wallClock.now();
        for (std::size_t i = 0; i < bothServos.size(); ++i) {
            const auto outcome = jobs::restore(host.context(), bothServos[i], plans[i], options);
            if (!outcome || outcome->verdict != jobs::RestoreVerdict::Done)
                qFatal("not restored");
        }
        const double ours = seconds(wallClock.now() - start);
        ratios.push_back(ours / bare);
        out << QStringLiteral("restore of %1 rows in %2 frames: bare %3 ms, restore %4 ms, ratio "
                              "%5\n")
                   .arg(rows)
                   .arg(frames.size())
                   .arg(bare * 1000, 0, 'f', 1)
                   .arg(ours * 1000, 0, 'f', 1)
                   .arg(ours / bare, 0, 'f', 3);
        out.flush();
    }
    report(out, "restore", ratios, 1.1);
}
} // namespace

int main(int argc, char** argv)
{
    const QCoreApplication application(argc, argv);
    QTextStream out(stdout);
    compareTables(out);
    restoreRows(out);
    return 0;
}
