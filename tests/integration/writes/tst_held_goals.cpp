// SPDX-License-Identifier: GPL-3.0-or-later
// Held moves of the window where frames get lost: Execute offers what may wait in a servo, and
// nothing else.
#include "session/motion/motion_controller.h"
#include "support/cli_program.h"
#include "support/cut_cable.h"
#include "support/sim_fixture.h"
#include "support/test_main.h"
#include "unit/session/session_fixture.h"

namespace {
struct StoredMoveFixture {
    StoredMoveFixture()
        : simulator(support::words("--servos sts3215@1,sts3215@2 --baud 1000000"))
        , cable(simulator.port(), false)
        , fixture(cable.port())
    {}
    bool ready()
    {
        if (!fixture.opened || !fixture.search({.firstId = 1, .lastId = 3, .bauds = {}}) ||
            fixture.workbench.registry().order().size() != 2)
            return false;
        drive.setServos(fixture.workbench.registry().order());
        drive.setTorque(device::Torque::On);
        return waitUntilIdle();
    }
    bool waitUntilIdle()
    {
        return support::waitFor(
            [this] { return !drive.isBusy() && !fixture.workbench.tasks().isBusy(); });
    }
    bool hold()
    {
        return drive.move({.goal = QStringLiteral("2300"), .how = device::MoveMethod::Async}) &&
               waitUntilIdle();
    }

    support::SimProgram simulator;
    support::CutCable cable;
    SessionFixture fixture;
    session::MotionController& drive = fixture.workbench.motion();
};
} // namespace

class TestHeldGoals : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void aLostStoredGoalCannotBeExecuted()
    {
        StoredMoveFixture fixture;
        QVERIFY(fixture.ready());
        QSignalSpy failed(&fixture.drive, &session::MotionController::failed);
        fixture.cable.dropInstruction(support::RegWrite);
        QVERIFY(fixture.hold());
        QCOMPARE(failed.count(), 1);
        QCOMPARE(fixture.drive.heldCount(), 0);
    }

    void aLostActionCanBeRepeated()
    {
        StoredMoveFixture fixture;
        QVERIFY(fixture.ready());
        QSignalSpy failed(&fixture.drive, &session::MotionController::failed);
        QVERIFY(fixture.hold());
        QCOMPARE(fixture.drive.heldCount(), 2);
        fixture.cable.dropInstruction(support::Action);
        fixture.drive.startHeldMoves();
        QVERIFY(fixture.waitUntilIdle());
        QCOMPARE(failed.count(), 1);
        QCOMPARE(fixture.drive.heldCount(), 2);
        fixture.cable.dropInstruction(0);
        fixture.drive.startHeldMoves();
        QVERIFY(fixture.waitUntilIdle());
        QCOMPARE(failed.count(), 1);
        QCOMPARE(fixture.drive.heldCount(), 0);
    }
};

SERVODESK_GUILESS_TEST(TestHeldGoals)
#include "tst_held_goals.moc"
