// SPDX-License-Identifier: GPL-3.0-or-later
// Leaving servos that turn: closing the window or the port asks first, stops by default, and
// reports the result; an emergency stop without a port is reported as not sent. Another program on
// the same terminal reads what the servo does afterwards.
#include "device/motion/move_limits.h"
#include "gui/dialogs.h"
#include "gui/main_window_fixture.h"
#include "session/motion/motion_controller.h"
#include "sim/host/sim_link.h"
#include "support/cli_program.h"
#include "support/cut_cable.h"
#include "support/test_main.h"
#include "ui/widgets/banner.h"

#include <QDialog>
#include <QJsonArray>
#include <QLabel>
#include <QPushButton>
#include <QToolButton>

using support::CliProgram;
using support::SimProgram;

namespace {

struct CloseConfirmationFixture : gui::MainWindowFixture {
    CloseConfirmationFixture()
        : simulator(support::words("--servos sts3215@1 --baud 1000000"))
        , cable(std::make_unique<support::CutCable>(simulator.port(), false))
    {
        settings.setPageValue(QStringLiteral("operate/no_torque_hint"), true);
        page = QStringLiteral("operate");
    }
    /// Speed mode, torque on, 800.
    bool startSpinning()
    {
        if (!ready(1, cable->port()))
            return false;
        session::MotionController& drive = context.workbench.motion();
        drive.setServos({selection().current()});
        const auto idle = [&] { return waitUntilIdle() && !drive.isBusy(); };
        drive.switchMode(QStringLiteral("speed"));
        if (!support::waitFor(idle))
            return false;
        drive.setTorque(device::Torque::On);
        if (!support::waitFor(idle))
            return false;
        drive.move({.goal = speedText()});
        return support::waitFor([&] { return idle() && raw("goal_speed") == 800; });
    }
    QString speedText()
    {
        const device::Servo& servo = entry().servo;
        return device::exactValueText(800, servo.meaning(*device::goalRegister(servo)));
    }
    QString title(QDialog* dialog)
    {
        return dialog->findChild<QLabel*>(QStringLiteral("questionTitle"))->text();
    }
    QString line() { return find<QLabel>("messageText")->toolTip(); }
    QString bannerText()
    {
        const auto* banner = find<ui::Banner>("banner");
        QString all;
        for (const QLabel* label : banner->findChildren<QLabel*>())
            all += label->text() + QLatin1Char('\n');
        return banner->isVisible() ? all : QString();
    }
    bool is(session::LinkState state)
    {
        return support::waitFor([&] { return workbench().link().state() == state; });
    }
    bool closed()
    {
        return support::waitFor([this] { return !window->isVisible(); });
    }
    /// Read by another program after this one has closed the port.
    int remaining(const char* key)
    {
        cable.reset();
        CliProgram other;
        other.setPort(simulator.port());
        const support::ProgramResult result =
            other.json(qPrintable(QStringLiteral("read 1 %1").arg(QLatin1String(key))));
        return result.json()[QStringLiteral("registers")]
            .toArray()
            .at(0)[QStringLiteral("raw")]
            .toInt(-1);
    }

    SimProgram simulator;
    std::unique_ptr<support::CutCable> cable; ///< goes before the simulator
};

void ways()
{
    QTest::addColumn<bool>("closes");
    QTest::newRow("close") << true;
    QTest::newRow("disconnect") << false;
}

void leave(CloseConfirmationFixture& fixture, bool closes)
{
    if (closes)
        fixture.window->close();
    else
        fixture.action(ui::Command::Disconnect)->trigger();
}

QDialog* requestLeaving(CloseConfirmationFixture& fixture, bool closes)
{
    leave(fixture, closes);
    return fixture.question();
}
} // namespace

class TestCloseConfirmation : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { gui::failOnWarnings(); }

    void aTurningServoIsStoppedAfterConfirmation_data() { ways(); }
    void aTurningServoIsStoppedAfterConfirmation()
    {
        QFETCH(bool, closes);
        CloseConfirmationFixture fixture;
        QDialog* dialog = fixture.startSpinning() ? requestLeaving(fixture, closes) : nullptr;
        QVERIFY(dialog != nullptr);
        QVERIFY2(fixture.title(dialog).startsWith(QLatin1String("Servo 1 is turning. Stop it")),
                 qPrintable(fixture.title(dialog)));
        QCOMPARE(fixture.workbench().link().state(),
                 session::LinkState::Open); // nothing has been done yet
        QCOMPARE(fixture.raw("goal_speed"), 800);
        gui::click(dialog, "questionYes");
        QVERIFY(closes ? fixture.closed() : fixture.is(session::LinkState::Off));
        if (!closes)
            QVERIFY2(fixture.line().contains(QLatin1String("Stopped before closing: ID 1")),
                     qPrintable(fixture.line()));
        QCOMPARE(fixture.remaining("goal_speed"), 0);
    }

    void itMayBeLeftTurning_data() { ways(); }
    void itMayBeLeftTurning()
    {
        QFETCH(bool, closes);
        CloseConfirmationFixture fixture;
        QDialog* dialog = fixture.startSpinning() ? requestLeaving(fixture, closes) : nullptr;
        QVERIFY(dialog != nullptr);
        gui::click(dialog, "questionOther");
        QVERIFY(closes ? fixture.closed() : fixture.is(session::LinkState::Off));
        QCOMPARE(fixture.remaining("goal_speed"), 800);
    }

    void cancelChangesNothing_data() { ways(); }
    void cancelChangesNothing()
    {
        QFETCH(bool, closes);
        CloseConfirmationFixture fixture;
        QDialog* dialog = fixture.startSpinning() ? requestLeaving(fixture, closes) : nullptr;
        QVERIFY(dialog != nullptr);
        gui::click(dialog, "questionNo");
        QTRY_VERIFY(fixture.window->findChild<QDialog*>(QStringLiteral("question")) == nullptr);
        QCOMPARE(fixture.workbench().link().state(), session::LinkState::Open);
        QVERIFY(fixture.window->isVisible());
        leave(fixture, closes); // and it can be asked again
        QVERIFY(fixture.question() != nullptr);
    }

    /// Without a user to ask it is stopped.
    void stopsWithoutAQuestionWhenDisabled()
    {
        CloseConfirmationFixture fixture;
        QVERIFY(fixture.startSpinning());
        fixture.workbench().closing().closeForExit();
        QVERIFY(fixture.closed());
        QCOMPARE(fixture.remaining("goal_speed"), 0);
    }

    /// A servo at rest needs no question.
    void aServoAtRestNeedsNoConfirmation()
    {
        CloseConfirmationFixture fixture;
        QVERIFY(fixture.startSpinning());
        fixture.context.workbench.motion().halt();
        QVERIFY(fixture.waitUntilIdle());
        fixture.window->close();
        QVERIFY(fixture.closed());
    }

    /// What does not answer cannot be stopped, and the window does not vanish over it.
    void anUnstoppableServoKeepsTheWindowOpen()
    {
        CloseConfirmationFixture fixture;
        QVERIFY(fixture.ready(1, QStringLiteral("sim:sts3215@1")));
        session::MotionController& drive = fixture.context.workbench.motion();
        drive.setServos({fixture.selection().current()});
        drive.switchMode(QStringLiteral("speed"));
        QTRY_VERIFY(!drive.isBusy() && !fixture.workbench().tasks().isBusy());
        drive.setTorque(device::Torque::On);
        QTRY_VERIFY(!drive.isBusy() && !fixture.workbench().tasks().isBusy());
        drive.move({.goal = fixture.speedText()});
        QTRY_VERIFY(fixture.raw("goal_speed") == 800);
        fixture.workbench().link().connection()->simulation()->with(
            [](sim::VirtualBus& wire) { wire.config().faults.muteIds = {1}; });
        fixture.window->close();
        QDialog* dialog = fixture.question();
        QVERIFY(dialog != nullptr);
        gui::click(dialog, "questionYes");
        QTRY_VERIFY(fixture.bannerText().contains(QLatin1String("ID 1 could not be stopped")));
        QCOMPARE(fixture.workbench().link().state(), session::LinkState::Open);
        QVERIFY(fixture.window->isVisible());
        fixture.window->close();
        dialog = fixture.question();
        QVERIFY(dialog != nullptr);
        gui::click(dialog, "questionOther");
        QVERIFY(fixture.closed());
    }

    void aStopWithoutAPortIsReportedAtOnce()
    {
        CloseConfirmationFixture fixture;
        QTest::mouseClick(fixture.find<QPushButton>("stopButton"), Qt::LeftButton);
        QVERIFY2(fixture.line().startsWith(QLatin1String("Emergency stop not sent: no port is "
                                                         "open.")),
                 qPrintable(fixture.line()));
        QVERIFY2(fixture.bannerText().contains(QLatin1String("Turn off their power supply")),
                 qPrintable(fixture.bannerText()));
        QTest::keyClick(fixture.window.get(), Qt::Key_Escape);
        QVERIFY(fixture.line().startsWith(QLatin1String("Emergency stop not sent: no port is "
                                                        "open.")));
    }

    /// The silence after reconnecting must not be taken for a stop that has arrived.
    void aStopAfterALostLinkIsReportedAgainOnReconnecting()
    {
        CloseConfirmationFixture fixture;
        QVERIFY(fixture.startSpinning());
        fixture.cable->cut();
        QVERIFY(fixture.is(session::LinkState::Lost));
        QTest::keyClick(fixture.window.get(), Qt::Key_Escape);
        QVERIFY(fixture.line().startsWith(QLatin1String("Emergency stop not sent: no port is "
                                                        "open.")));
        fixture.workbench().link().connectTo({.name = fixture.simulator.port()});
        QVERIFY(fixture.is(session::LinkState::Open));
        QTRY_VERIFY(fixture.bannerText().contains(QLatin1String("was not sent")));
        QVERIFY(fixture.waitUntilIdle());
        QVERIFY(
            fixture.bannerText().contains(QLatin1String("was not sent"))); // a search later, too
        QTest::mouseClick(fixture.find<QPushButton>("stopButton"), Qt::LeftButton);
        QTRY_VERIFY(fixture.bannerText().isEmpty());
    }

    /// The message line never shows what was true only before the last action.
    void aMoveReplacesThePreviousMessage()
    {
        CloseConfirmationFixture fixture;
        QVERIFY(fixture.startSpinning());
        QVERIFY2(fixture.line().contains(QLatin1String("goal sent: 800")),
                 qPrintable(fixture.line()));
        QVERIFY(!fixture.line().contains(QLatin1String("goal_speed = 0")));
    }
};

SERVODESK_TEST(TestCloseConfirmation)
#include "tst_close_confirmation.moc"
