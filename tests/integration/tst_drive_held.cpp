// SPDX-License-Identifier: GPL-3.0-or-later
// Held moves of the window where frames get lost: Execute offers what may wait in a servo, and
// nothing else.
#include "session/drive.h"
#include "support/cli_program.h"
#include "support/cut_cable.h"
#include "support/sim_bench.h"
#include "unit/session/session_bench.h"

namespace {
struct DriveBench {
    DriveBench()
        : simulator(support::words("--servos sts3215@1,sts3215@2 --baud 1000000"))
        , cable(simulator.port(), false)
        , bench(cable.port())
    {}
    bool ready()
    {
        if (!bench.opened || !bench.search({.firstId = 1, .lastId = 3, .bauds = {}}) ||
            bench.desk.servos().size() != 2)
            return false;
        drive.setServos(bench.desk.servos());
        drive.setTorque(device::Torque::On);
        return settled();
    }
    bool settled()
    {
        return QTest::qWaitFor([this] { return !drive.busy() && !bench.desk.busy(); }, 20'000);
    }
    bool hold()
    {
        return drive.move({.goal = QStringLiteral("2300"), .how = device::MoveHow::Async}) &&
               settled();
    }

    support::SimProgram simulator;
    support::CutCable cable;
    Bench bench;
    session::Drive drive{bench.desk};
};
} // namespace

class TestDriveHeld : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void aHoldThatWasNeverHeardIsNotOffered()
    {
        DriveBench bench;
        QVERIFY(bench.ready());
        QSignalSpy failed(&bench.drive, &session::Drive::failed);
        bench.cable.lose(support::RegWrite);
        QVERIFY(bench.hold());
        QCOMPARE(failed.count(), 1);
        QCOMPARE(bench.drive.held(), 0);
    }

    void aStartThatWasNeverHeardCanBeRepeated()
    {
        DriveBench bench;
        QVERIFY(bench.ready());
        QSignalSpy failed(&bench.drive, &session::Drive::failed);
        QSignalSpy started(&bench.drive, &session::Drive::started);
        QVERIFY(bench.hold());
        QCOMPARE(bench.drive.held(), 2);
        bench.cable.lose(support::Action);
        bench.drive.execute();
        QVERIFY(bench.settled());
        QCOMPARE(failed.count(), 1);
        QCOMPARE(bench.drive.held(), 2);
        bench.cable.lose(0);
        bench.drive.execute();
        QVERIFY(bench.settled());
        QCOMPARE(started.count(), 1);
        QCOMPARE(bench.drive.held(), 0);
    }
};

QTEST_GUILESS_MAIN(TestDriveHeld)
#include "tst_drive_held.moc"
