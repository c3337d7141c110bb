// SPDX-License-Identifier: GPL-3.0-or-later
// Leaving servos that turn: closing the window and the port ask first, stop by default, and say
// what came of it; an emergency stop that finds no port is said not to have been sent. What the
// servo does afterwards another program reads on the same terminal.
#include "device/move_limits.h"
#include "gui/dialogs.h"
#include "gui/window_bench.h"
#include "sim/sim_link.h"
#include "support/cli_program.h"
#include "support/cut_cable.h"
#include "ui/widgets/banner.h"

#include <QDialog>
#include <QJsonArray>
#include <QLabel>
#include <QPushButton>
#include <QToolButton>

using support::CliProgram;
using support::SimProgram;

namespace {
constexpr int longTime = 30'000;

struct Bench : gui::WindowBench {
    Bench()
        : simulator(support::words("--servos sts3215@1 --baud 1000000"))
        , cable(std::make_unique<support::CutCable>(simulator.port(), false))
    {
        settings.setChoice(QStringLiteral("operate/no_torque_hint"), true);
        page = QStringLiteral("operate");
    }
    /// Constant speed, torque on, 800.
    bool spins()
    {
        if (!ready(1, cable->port()))
            return false;
        session::Drive& drive = bench.drive;
        drive.setServos({selection().current()});
        const auto idle = [&] { return settled() && !drive.busy(); };
        drive.switchMode(QStringLiteral("speed"));
        if (!QTest::qWaitFor(idle, longTime))
            return false;
        drive.setTorque(device::Torque::On);
        if (!QTest::qWaitFor(idle, longTime))
            return false;
        drive.move({.goal = speedText()});
        return QTest::qWaitFor([&] { return idle() && raw("goal_speed") == 800; }, longTime);
    }
    QString speedText()
    {
        const device::Servo& servo = entry().servo;
        return device::exactText(800, servo.meaning(*device::goalRegister(servo)));
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
        return QTest::qWaitFor([&] { return desk().state() == state; }, longTime);
    }
    bool closed()
    {
        return QTest::qWaitFor([this] { return !window->isVisible(); }, longTime);
    }
    /// Of the servo, asked by another program after this one has let go of the port.
    int remaining(const char* key)
    {
        cable.reset();
        CliProgram other;
        other.setPort(simulator.port());
        const support::Ran ran =
            other.json(qPrintable(QStringLiteral("read 1 %1").arg(QLatin1String(key))));
        return ran.json()[QStringLiteral("registers")].toArray().at(0)[QStringLiteral("raw")].toInt(
            -1);
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

void leave(Bench& bench, bool closes)
{
    if (closes)
        bench.window->close();
    else
        bench.action(ui::Command::Disconnect)->trigger();
}

QDialog* askedToLeave(Bench& bench, bool closes)
{
    leave(bench, closes);
    return bench.question();
}
} // namespace

class TestLeaving : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { gui::failOnWarnings(); }

    void aTurningServoIsAskedAboutAndStopped_data() { ways(); }
    void aTurningServoIsAskedAboutAndStopped()
    {
        QFETCH(bool, closes);
        Bench bench;
        QDialog* dialog = bench.spins() ? askedToLeave(bench, closes) : nullptr;
        QVERIFY(dialog != nullptr);
        QVERIFY2(bench.title(dialog).startsWith(QLatin1String("Servo 1 is turning. Stop it")),
                 qPrintable(bench.title(dialog)));
        QCOMPARE(bench.desk().state(), session::LinkState::Open); // nothing has been done yet
        QCOMPARE(bench.raw("goal_speed"), 800);
        gui::click(dialog, "questionYes");
        QVERIFY(closes ? bench.closed() : bench.is(session::LinkState::Off));
        if (!closes)
            QVERIFY2(bench.line().contains(QLatin1String("Stopped before: ID 1")),
                     qPrintable(bench.line()));
        QCOMPARE(bench.remaining("goal_speed"), 0);
    }

    void itMayBeLeftTurning_data() { ways(); }
    void itMayBeLeftTurning()
    {
        QFETCH(bool, closes);
        Bench bench;
        QDialog* dialog = bench.spins() ? askedToLeave(bench, closes) : nullptr;
        QVERIFY(dialog != nullptr);
        gui::click(dialog, "questionOther");
        QVERIFY(closes ? bench.closed() : bench.is(session::LinkState::Off));
        QCOMPARE(bench.remaining("goal_speed"), 800);
    }

    void cancelChangesNothing_data() { ways(); }
    void cancelChangesNothing()
    {
        QFETCH(bool, closes);
        Bench bench;
        QDialog* dialog = bench.spins() ? askedToLeave(bench, closes) : nullptr;
        QVERIFY(dialog != nullptr);
        gui::click(dialog, "questionNo");
        QTRY_VERIFY(bench.window->findChild<QDialog*>(QStringLiteral("question")) == nullptr);
        QCOMPARE(bench.desk().state(), session::LinkState::Open);
        QVERIFY(bench.window->isVisible());
        leave(bench, closes); // and it can be asked again
        QVERIFY(bench.question() != nullptr);
    }

    /// Without anyone to ask it is stopped.
    void withoutAQuestionItIsStopped()
    {
        Bench bench;
        QVERIFY(bench.spins());
        bench.desk().close();
        QVERIFY(bench.closed());
        QCOMPARE(bench.remaining("goal_speed"), 0);
    }

    /// One that rests closes without a question.
    void aRestingServoIsNotAskedAbout()
    {
        Bench bench;
        QVERIFY(bench.spins());
        bench.bench.drive.halt();
        QVERIFY(bench.settled());
        bench.window->close();
        QVERIFY(bench.closed());
    }

    /// What does not answer cannot be stopped, and the window does not vanish over it.
    void aServoThatCannotBeStoppedKeepsTheWindowOpen()
    {
        Bench bench;
        QVERIFY(bench.ready(1, QStringLiteral("sim:sts3215@1")));
        session::Drive& drive = bench.bench.drive;
        drive.setServos({bench.selection().current()});
        drive.switchMode(QStringLiteral("speed"));
        QTRY_VERIFY_WITH_TIMEOUT(!drive.busy() && !bench.desk().busy(), longTime);
        drive.setTorque(device::Torque::On);
        QTRY_VERIFY_WITH_TIMEOUT(!drive.busy() && !bench.desk().busy(), longTime);
        drive.move({.goal = bench.speedText()});
        QTRY_VERIFY_WITH_TIMEOUT(bench.raw("goal_speed") == 800, longTime);
        bench.desk().connection()->simulation()->with(
            [](sim::VirtualBus& wire) { wire.config().faults.muteIds = {1}; });
        bench.window->close();
        QDialog* dialog = bench.question();
        QVERIFY(dialog != nullptr);
        gui::click(dialog, "questionYes");
        QTRY_VERIFY_WITH_TIMEOUT(
            bench.bannerText().contains(QLatin1String("ID 1 could not be stopped")), longTime);
        QCOMPARE(bench.desk().state(), session::LinkState::Open);
        QVERIFY(bench.window->isVisible());
        bench.window->close();
        dialog = bench.question();
        QVERIFY(dialog != nullptr);
        gui::click(dialog, "questionOther");
        QVERIFY(bench.closed());
    }

    void aStopWithoutAPortIsSaidAtOnce()
    {
        Bench bench;
        QTest::mouseClick(bench.find<QPushButton>("stopButton"), Qt::LeftButton);
        QVERIFY2(bench.line().startsWith(QLatin1String("Not sent: no port is open.")),
                 qPrintable(bench.line()));
        QVERIFY2(bench.bannerText().contains(QLatin1String("switch off their supply")),
                 qPrintable(bench.bannerText()));
        QTest::keyClick(bench.window.get(), Qt::Key_Escape);
        QVERIFY(bench.line().startsWith(QLatin1String("Not sent: no port is open.")));
    }

    /// Nobody may take the silence after connecting again for a stop that has come.
    void aStopAfterTheCableWasCutIsSaidAgainOnReconnecting()
    {
        Bench bench;
        QVERIFY(bench.spins());
        bench.cable->cut();
        QVERIFY(bench.is(session::LinkState::Lost));
        QTest::keyClick(bench.window.get(), Qt::Key_Escape);
        QVERIFY(bench.line().startsWith(QLatin1String("Not sent: no port is open.")));
        bench.desk().connectTo({.name = bench.simulator.port()});
        QVERIFY(bench.is(session::LinkState::Open));
        QTRY_VERIFY(bench.bannerText().contains(QLatin1String("was not sent")));
        QVERIFY(bench.settled());
        QVERIFY(bench.bannerText().contains(QLatin1String("was not sent"))); // a search later, too
        QTest::mouseClick(bench.find<QPushButton>("stopButton"), Qt::LeftButton);
        QTRY_VERIFY(bench.bannerText().isEmpty());
    }

    /// The line never goes on claiming what was true before the latest action.
    void aMoveReplacesWhatWasSaidBefore()
    {
        Bench bench;
        QVERIFY(bench.spins());
        QVERIFY2(bench.line().contains(QLatin1String("goal sent: 800")), qPrintable(bench.line()));
        QVERIFY(!bench.line().contains(QLatin1String("goal_speed = 0")));
    }
};

QTEST_MAIN(TestLeaving)
#include "tst_leaving.moc"
