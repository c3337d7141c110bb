// SPDX-License-Identifier: GPL-3.0-or-later
// Esc stops from anywhere: the first one in an editor, menu or dialog only cancels that, unless a
// servo is driven; the next one always stops, and so do Shift+Esc and the red button.
#include "device/motion/move_limits.h"
#include "gui/main_window_fixture.h"
#include "session/motion/motion_controller.h"
#include "sim/host/sim_link.h"
#include "support/test_main.h"
#include "ui/widgets/question_dialog.h"

#include <QAbstractSpinBox>
#include <QComboBox>
#include <QDialog>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QMenuBar>
#include <QPointer>
#include <QPushButton>
#include <QSignalSpy>
#include <QTableView>
#include <QToolButton>

namespace {
/// Counts the stops that were sent.
struct StopCounter {
    explicit StopCounter(session::Workbench& workbench)
    {
        QObject::connect(&workbench, &session::Workbench::eventOccurred, &guard,
                         [this](const session::Event& event) {
                             if (event.kind == session::Event::Kind::Stopped)
                                 ++count;
                         });
    }
    QObject guard;
    int count = 0;
};

/// By another program.
void setTurning(gui::MainWindowFixture& fixture, int id)
{
    fixture.workbench().link().connection()->simulation()->with([id](sim::VirtualBus& bus) {
        bus.servo(id)->poke(QStringLiteral("operating_mode"), 1);
        bus.servo(id)->poke(QStringLiteral("torque_switch"), 1);
        bus.servo(id)->poke(QStringLiteral("goal_speed"), 800);
    });
}

/// A menu, or a question; null: it did not open.
QWidget* openPopupOver(gui::MainWindowFixture& fixture, bool menu)
{
    QMenu* first = fixture.window->menuBar()->actions().front()->menu();
    if (menu)
        first->popup(fixture.window->mapToGlobal(QPoint(10, 40)));
    else
        ui::ask(fixture.window.get(),
                {.title = QStringLiteral("?"), .acceptText = QStringLiteral("yes")}, [] {});
    const auto shown = [&] { return menu ? first : QApplication::activeModalWidget(); };
    const bool opened =
        support::waitFor([&] { return shown() != nullptr && shown()->isVisible(); });
    return opened ? shown() : nullptr;
}
} // namespace

class TestEscapeKey : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { gui::failOnWarnings(); }

    void escTakesTorqueOff()
    {
        gui::MainWindowFixture fixture;
        QVERIFY(fixture.ready(1));
        fixture.workbench().writes().write(
            fixture.selection().current(),
            {{{QStringLiteral("torque_switch"), 1}}, false, device::Consent::confirmed()});
        QVERIFY(fixture.waitUntilIdle());
        QCOMPARE(fixture.raw("torque_switch"), std::optional<std::int64_t>(1));
        QTest::keyClick(fixture.window.get(), Qt::Key_Escape);
        QTRY_VERIFY([&] {
            fixture.workbench().writes().readTable(fixture.selection().current());
            return fixture.waitUntilIdle() && fixture.raw("torque_switch") == 0;
        }());
    }

    void theButtonStops()
    {
        gui::MainWindowFixture fixture;
        QVERIFY(fixture.ready(1));
        StopCounter stops(fixture.workbench());
        QTest::mouseClick(fixture.find<QPushButton>("stopButton"), Qt::LeftButton);
        QCOMPARE(stops.count, 1);
    }

    void theFirstEscInACellEditorCancelsIt()
    {
        gui::MainWindowFixture fixture;
        QVERIFY(fixture.ready(1));
        StopCounter stops(fixture.workbench());
        auto* table = fixture.find<QTableView>("memoryTable");
        QVERIFY(table != nullptr);
        table->setFocus();
        QModelIndex cell;
        for (int row = 0; row < table->model()->rowCount() && !cell.isValid(); ++row) {
            for (int column = 0; column < table->model()->columnCount(); ++column) {
                const QModelIndex index = table->model()->index(row, column);
                if (index.flags().testFlag(Qt::ItemIsEditable)) {
                    cell = index;
                    break;
                }
            }
        }
        QVERIFY(cell.isValid());
        table->setCurrentIndex(cell);
        table->edit(cell);
        QWidget* editor = table->viewport()->findChild<QWidget*>();
        QVERIFY(editor != nullptr);
        QPointer<QWidget> open = editor;
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_Escape);
        QCOMPARE(stops.count, 0);
        QTRY_VERIFY(open.isNull() || !open->isVisible());
        QTest::keyClick(QApplication::focusWidget() != nullptr ? QApplication::focusWidget()
                                                               : fixture.window.get(),
                        Qt::Key_Escape);
        QCOMPARE(stops.count, 1);
        QVERIFY(fixture.entry().writes.empty());
    }

    void theFirstEscInAMenuClosesIt()
    {
        gui::MainWindowFixture fixture;
        QVERIFY(fixture.ready(1));
        StopCounter stops(fixture.workbench());
        QMenu* menu = fixture.window->menuBar()->actions().front()->menu();
        menu->popup(fixture.window->mapToGlobal(QPoint(10, 40)));
        QTRY_VERIFY(menu->isVisible());
        QTest::keyClick(menu, Qt::Key_Escape);
        QVERIFY(!menu->isVisible());
        QCOMPARE(stops.count, 0);
        QTest::keyClick(fixture.window.get(), Qt::Key_Escape);
        QCOMPARE(stops.count, 1);
    }

    void theFirstEscInADialogClosesIt()
    {
        gui::MainWindowFixture fixture;
        QVERIFY(fixture.ready(1));
        StopCounter stops(fixture.workbench());
        ui::ask(fixture.window.get(),
                {.title = QStringLiteral("?"), .acceptText = QStringLiteral("yes")}, [] {});
        QTRY_VERIFY(QApplication::activeModalWidget() != nullptr);
        QTest::keyClick(QApplication::activeModalWidget(), Qt::Key_Escape);
        QTRY_VERIFY(QApplication::activeModalWidget() == nullptr);
        QCOMPARE(stops.count, 0);
        QTest::keyClick(fixture.window.get(), Qt::Key_Escape);
        QCOMPARE(stops.count, 1);
    }

    /// What the start of a test promises holds while a menu or a question is open.
    void escStopsAMovingServoFromAMenuOrAQuestion_data()
    {
        QTest::addColumn<bool>("menu");
        QTest::addColumn<bool>("moves");
        QTest::newRow("menu") << true << true;
        QTest::newRow("question") << false << true;
        QTest::newRow("menu, holding") << true << false;
        QTest::newRow("question, holding") << false << false;
    }
    void escStopsAMovingServoFromAMenuOrAQuestion()
    {
        QFETCH(bool, menu);
        QFETCH(bool, moves);
        gui::MainWindowFixture fixture;
        fixture.page = QStringLiteral("operate");
        QVERIFY(fixture.ready(1));
        StopCounter stops(fixture.workbench());
        session::MotionController& drive = fixture.context.workbench.motion();
        drive.setServos({fixture.selection().current()});
        const auto idle = [&] { return fixture.waitUntilIdle() && !drive.isBusy(); };
        drive.switchMode(QStringLiteral("speed"));
        QTRY_VERIFY(idle());
        drive.setTorque(device::Torque::On);
        QTRY_VERIFY(idle());
        const device::Servo& servo = fixture.entry().servo;
        if (moves)
            drive.move(
                {.goal = device::exactValueText(800, servo.meaning(*device::goalRegister(servo)))});
        QTRY_COMPARE(fixture.workbench().closing().isMotionPossible(), moves);
        QTRY_VERIFY(idle());
        const QPointer<QWidget> open = openPopupOver(fixture, menu);
        QVERIFY(open != nullptr);
        QTest::keyClick(open, Qt::Key_Escape);
        QCOMPARE(stops.count, moves ? 1 : 0);
        QTRY_VERIFY(open.isNull() || !open->isVisible());
        if (moves)
            QTRY_COMPARE(fixture.raw("torque_switch"), std::int64_t(0));
        QTRY_VERIFY(!moves || !fixture.workbench().closing().isMotionPossible());
    }

    /// It does not turn, but pushes against an obstacle.
    void escStopsAJammedServoFromAMenuOrAQuestion_data()
    {
        QTest::addColumn<bool>("menu");
        QTest::addColumn<bool>("overloaded"); ///< its protection has tripped
        QTest::addColumn<int>("limit");       ///< of its torque, 0.1 %
        QTest::newRow("menu") << true << false << 1000;
        QTest::newRow("menu, low torque limit") << true << false << 150;
        QTest::newRow("question") << false << false << 1000;
        QTest::newRow("question, overload") << false << true << 1000;
    }
    void escStopsAJammedServoFromAMenuOrAQuestion()
    {
        QFETCH(bool, menu);
        QFETCH(bool, overloaded);
        QFETCH(int, limit);
        gui::MainWindowFixture fixture;
        fixture.page = QStringLiteral("operate");
        QVERIFY(fixture.ready(1, QStringLiteral("sim:sts3215@1+stop=200")));
        StopCounter stops(fixture.workbench());
        session::MotionController& drive = fixture.context.workbench.motion();
        drive.setServos({fixture.selection().current()});
        drive.setTorqueLimit(limit);
        QTRY_VERIFY(fixture.waitUntilIdle() && !drive.isBusy());
        drive.setTorque(device::Torque::On);
        QTRY_VERIFY(fixture.waitUntilIdle() && !drive.isBusy());
        QTRY_VERIFY(!fixture.workbench().closing().isMotionPossible()); // it holds
        QCOMPARE(fixture.raw("torque_limit"), std::int64_t(limit));
        const device::Servo& servo = fixture.entry().servo;
        drive.move(
            {.goal = device::exactValueText(3000, servo.meaning(*device::goalRegister(servo)))});
        QTRY_VERIFY(fixture.waitUntilIdle() && !drive.isBusy());
        const auto stands = [&] {
            const auto place = fixture.raw("present_position");
            return place && *place > 2150 && *place < 2900 && fixture.raw("moving") == 0 &&
                   (!overloaded || fixture.entry().servo.status != 0);
        };
        QTRY_VERIFY(stands());
        QVERIFY(fixture.workbench().closing().isMotionPossible());
        const QPointer<QWidget> open = openPopupOver(fixture, menu);
        QVERIFY(open != nullptr);
        QTest::keyClick(open, Qt::Key_Escape);
        QCOMPARE(stops.count, 1);
        QTRY_COMPARE(fixture.raw("torque_switch"), std::int64_t(0));
        QTRY_VERIFY(!fixture.workbench().closing().isMotionPossible());
    }

    /// A servo that holds a position other than its goal register does not push against anything.
    void theFirstEscKeepsAHaltedServoHolding()
    {
        gui::MainWindowFixture fixture;
        fixture.page = QStringLiteral("operate");
        QVERIFY(fixture.ready(5, QStringLiteral("sim:lx")));
        StopCounter stops(fixture.workbench());
        session::MotionController& drive = fixture.context.workbench.motion();
        drive.setServos({fixture.selection().current()});
        const auto raw = [&](catalog::Role role) { return fixture.entry().servo.raw(role); };
        const auto idle = [&] { return fixture.waitUntilIdle() && !drive.isBusy(); };
        drive.setTorque(device::Torque::On);
        QTRY_VERIFY(idle());
        const auto start = raw(catalog::Role::PresentPosition);
        QVERIFY(start);
        const std::int64_t goal = *start > 500 ? 50 : 950;
        drive.move({.goal = QString::number(goal), .time = QStringLiteral("30000")});
        QTRY_VERIFY(idle());
        QTRY_VERIFY(raw(catalog::Role::PresentPosition) != start);
        QVERIFY(fixture.workbench().closing().isMotionPossible());
        drive.halt();
        QTRY_VERIFY(idle());
        QTRY_VERIFY(std::abs(raw(catalog::Role::PresentPosition).value_or(goal) - goal) > 100);
        QCOMPARE(raw(catalog::Role::TorqueSwitch), std::int64_t(1));
        QVERIFY(!fixture.workbench().closing().isMotionPossible());
        const QPointer<QWidget> open = openPopupOver(fixture, true);
        QVERIFY(open != nullptr);
        QTest::keyClick(open, Qt::Key_Escape);
        QCOMPARE(stops.count, 0);
        drive.move({.goal = QString::number(goal), .time = QStringLiteral("30000")});
        QTRY_VERIFY(idle());
        QVERIFY(fixture.workbench().closing().isMotionPossible());
    }

    /// Another program has switched its torque on and given it no goal.
    void theFirstEscKeepsAServoWithoutGoalHolding()
    {
        gui::MainWindowFixture fixture;
        fixture.page = QStringLiteral("operate");
        QVERIFY(fixture.ready(1, QStringLiteral("sim:sts3215@1")));
        StopCounter stops(fixture.workbench());
        fixture.workbench().link().connection()->simulation()->with(
            [](sim::VirtualBus& bus) { bus.servo(1)->poke(QStringLiteral("torque_switch"), 1); });
        QTRY_COMPARE(fixture.raw("torque_switch"), std::int64_t(1));
        QTRY_COMPARE(fixture.raw("moving"), std::int64_t(0));
        const auto away =
            fixture.raw("present_position").value_or(0) - fixture.raw("goal_position").value_or(0);
        QVERIFY2(std::abs(away) > 200, qPrintable(QString::number(away)));
        const QPointer<QWidget> open = openPopupOver(fixture, true);
        QVERIFY(open != nullptr);
        QTRY_VERIFY(!fixture.workbench().closing().isMotionPossible());
        QTest::keyClick(open, Qt::Key_Escape);
        QCOMPARE(stops.count, 0);
        QCOMPARE(fixture.raw("torque_switch"), std::int64_t(1));
    }

    /// Another program has set it turning.
    void escStopsAServoSeenTurning()
    {
        gui::MainWindowFixture fixture;
        QVERIFY(fixture.ready(1, QStringLiteral("sim:sts3215@1")));
        StopCounter stops(fixture.workbench());
        setTurning(fixture, 1);
        fixture.workbench().writes().readTable(fixture.selection().current());
        QVERIFY(fixture.waitUntilIdle());
        QTRY_COMPARE(fixture.raw("goal_speed"), std::int64_t(800));
        QVERIFY(fixture.workbench().closing().isMotionPossible());
        QWidget* menu = openPopupOver(fixture, true);
        QVERIFY(menu != nullptr);
        QTest::keyClick(menu, Qt::Key_Escape);
        QCOMPARE(stops.count, 1);
        QTRY_COMPARE(fixture.raw("torque_switch"), std::int64_t(0));
        QTRY_VERIFY(!fixture.workbench().closing().isMotionPossible());
    }

    /// Another program has set it turning before it was found; only its feedback is read.
    void escStopsAnUnselectedTurningServo()
    {
        gui::MainWindowFixture fixture;
        fixture.page = QStringLiteral("operate");
        QVERIFY(fixture.ready(1, QStringLiteral("sim:sts3215@1,sts3215@2")));
        StopCounter stops(fixture.workbench());
        setTurning(fixture, 2);
        QTRY_VERIFY(fixture.workbench().closing().isMotionPossible());
        QWidget* menu = openPopupOver(fixture, true);
        QVERIFY(menu != nullptr);
        QTest::keyClick(menu, Qt::Key_Escape);
        QCOMPARE(stops.count, 1);
        QTRY_VERIFY(!fixture.workbench().closing().isMotionPossible());
    }

    /// It turns on: no servo has heard the stop, or another program switched it on again.
    void escStopsAgainWhileTheServoTurns_data()
    {
        QTest::addColumn<bool>("lost");
        QTest::newRow("stop lost") << true;
        QTest::newRow("switched on by another program") << false;
    }
    void escStopsAgainWhileTheServoTurns()
    {
        QFETCH(bool, lost);
        gui::MainWindowFixture fixture;
        fixture.page = QStringLiteral("operate");
        QVERIFY(fixture.ready(1, QStringLiteral("sim:sts3215@1")));
        StopCounter stops(fixture.workbench());
        QSignalSpy checked(&fixture.workbench(), &session::Workbench::eventOccurred);
        const auto isChecked = [&] {
            return std::any_of(checked.begin(), checked.end(), [](const auto& one) {
                return one.front().template value<session::Event>().kind ==
                       session::Event::Kind::StopVerified;
            });
        };
        const auto loseRequests = [&](double part) {
            fixture.workbench().link().connection()->simulation()->with(
                [part](sim::VirtualBus& bus) { bus.config().faults.dropRequest = part; });
        };
        setTurning(fixture, 1);
        QTRY_VERIFY(fixture.workbench().closing().isMotionPossible());
        if (lost)
            loseRequests(1);
        QTest::keyClick(fixture.window.get(), Qt::Key_Escape);
        QCOMPARE(stops.count, 1);
        QTRY_VERIFY(isChecked());
        if (lost)
            loseRequests(0);
        else
            setTurning(fixture, 1);
        QTRY_COMPARE(fixture.raw("moving"), std::int64_t(1));
        auto* stopped = fixture.find<QLabel>("controlStopped");
        QTRY_VERIFY(stopped->text().contains(QLatin1String("torque is on")));
        QWidget* menu = openPopupOver(fixture, true);
        QVERIFY(menu != nullptr);
        QTest::keyClick(menu, Qt::Key_Escape);
        QCOMPARE(stops.count, 2);
        QTRY_COMPARE(fixture.raw("torque_switch"), std::int64_t(0));
        QTRY_VERIFY(!fixture.workbench().closing().isMotionPossible());
        QTRY_VERIFY(!stopped->text().contains(QLatin1String("torque is on")));
    }

    void theFirstEscInAListOfChoicesClosesIt()
    {
        gui::MainWindowFixture fixture;
        fixture.page = QStringLiteral("operate");
        QVERIFY(fixture.ready(1));
        StopCounter stops(fixture.workbench());
        auto* choices = fixture.find<QComboBox>("trendWidth");
        choices->showPopup();
        QTRY_VERIFY(QApplication::activePopupWidget() != nullptr);
        QTest::keyClick(QApplication::activePopupWidget(), Qt::Key_Escape);
        QTRY_VERIFY(QApplication::activePopupWidget() == nullptr);
        QCOMPARE(stops.count, 0);
        QTest::keyClick(fixture.window.get(), Qt::Key_Escape);
        QCOMPARE(stops.count, 1);
    }

    /// The list of curves is not modal.
    void theFirstEscInAModelessDialogClosesIt()
    {
        gui::MainWindowFixture fixture;
        fixture.page = QStringLiteral("operate");
        QVERIFY(fixture.ready(1));
        StopCounter stops(fixture.workbench());
        QTest::mouseClick(fixture.find<QToolButton>("trendChannels"), Qt::LeftButton);
        QPointer<QDialog> dialog = fixture.find<QDialog>("channelsDialog");
        QVERIFY(dialog != nullptr);
        QTest::keyClick(dialog, Qt::Key_Escape);
        QCOMPARE(stops.count, 0);
        QTRY_VERIFY(dialog == nullptr);
        QTest::keyClick(fixture.window.get(), Qt::Key_Escape);
        QCOMPARE(stops.count, 1);
    }

    void escInTheMiddleOfASearch()
    {
        gui::MainWindowFixture fixture;
        fixture.page = QStringLiteral("operate");
        QVERIFY(fixture.ready(1));
        fixture.context.workbench.motion().setTorque(device::Torque::On);
        QTRY_COMPARE(fixture.raw("torque_switch"), std::int64_t(1));
        jobs::ScanSpec all;
        all.bauds = {1'000'000, 500'000, 115'200};
        fixture.workbench().search().start(all);
        QVERIFY(fixture.workbench().search().isSearching());
        QTest::keyClick(fixture.window.get(), Qt::Key_Escape);
        const auto torque = [&] {
            std::int64_t value = -1;
            fixture.workbench().link().connection()->simulation()->with([&](sim::VirtualBus& bus) {
                value = bus.servo(1)->raw(QStringLiteral("torque_switch"));
            });
            return value;
        };
        QTRY_COMPARE(torque(), 0);
        fixture.workbench().search().stop();
        QVERIFY(fixture.waitUntilIdle());
    }

    void escInTheMiddleOfADrag()
    {
        gui::MainWindowFixture fixture;
        fixture.page = QStringLiteral("operate");
        QVERIFY(fixture.ready(1));
        fixture.context.workbench.motion().setTorque(device::Torque::On);
        QTRY_COMPARE(fixture.raw("torque_switch"), std::int64_t(1));
        QVERIFY(fixture.waitUntilIdle()); // then the goal follows the position no more
        auto* slider = fixture.find<QWidget>("goalSlider");
        QTRY_VERIFY(slider->isVisible() && slider->isEnabled()); // it has its scale then
        const auto servo = [&](const char* key) {
            std::int64_t value = -1;
            fixture.workbench().link().connection()->simulation()->with(
                [&](sim::VirtualBus& bus) { value = bus.servo(1)->raw(QString::fromLatin1(key)); });
            return value;
        };
        const QPoint middle = slider->rect().center();
        QTest::mousePress(slider, Qt::LeftButton, {}, middle);
        QTest::mouseMove(slider, middle + QPoint(30, 0));
        QTRY_VERIFY(servo("goal_position") > 2100);
        QTest::mouseMove(slider, middle + QPoint(60, 0));
        QTest::keyClick(fixture.window.get(), Qt::Key_Escape);
        QTRY_COMPARE(servo("torque_switch"), 0);
        QVERIFY(fixture.waitUntilIdle());
        const auto goal = servo("goal_position");
        for (int x = 65; x < 90; x += 5)
            QTest::mouseMove(slider, middle + QPoint(x, 0));
        QTest::mouseRelease(slider, Qt::LeftButton, {}, middle + QPoint(90, 0));
        QVERIFY(fixture.waitUntilIdle());
        QCOMPARE(servo("torque_switch"), 0);
        QCOMPARE(servo("goal_position"), goal);
        QVERIFY(fixture.find<QLabel>("controlStopped")->isVisible());
    }

    /// The first one already, and what was typed is not sent by a later Enter.
    void escInAFieldOfTheMotionPanelStopsAtOnce_data()
    {
        QTest::addColumn<QString>("field");
        for (const char* field : {"goal", "speed", "acceleration", "torqueLimitPercent"})
            QTest::newRow(field) << QString::fromLatin1(field);
    }
    void escInAFieldOfTheMotionPanelStopsAtOnce()
    {
        QFETCH(QString, field);
        gui::MainWindowFixture fixture;
        fixture.page = QStringLiteral("operate");
        QVERIFY(fixture.ready(1));
        StopCounter stops(fixture.workbench());
        QAbstractSpinBox* box = nullptr;
        QTRY_VERIFY((box = fixture.find<QAbstractSpinBox>(qPrintable(field))) != nullptr);
        // Shown only once it is filled; until then it has the text it was made with.
        QTRY_VERIFY(box->isVisible() && box->isEnabled() && !box->text().isEmpty());
        const QString before = box->text();
        box->setFocus();
        box->selectAll();
        QTest::keyClicks(box, QStringLiteral("77"));
        QVERIFY(box->text() != before);
        QTest::keyClick(box, Qt::Key_Escape);
        QCOMPARE(stops.count, 1);
        QTRY_COMPARE(box->text(), before);
        QVERIFY(fixture.waitUntilIdle());
        QVERIFY(box->toolTip().contains(QLatin1String("Esc turns torque off on the whole bus")));
    }

    void escInTheRegisterPanelStopsAtOnce()
    {
        gui::MainWindowFixture fixture;
        QVERIFY(fixture.ready(1));
        StopCounter stops(fixture.workbench());
        auto* table = fixture.find<QTableView>("memoryTable");
        for (int row = 0; row < table->model()->rowCount(); ++row) {
            if (table->model()->index(row, 0).data().toString() == QLatin1String("9"))
                table->selectRow(row);
        }
        auto* editor = fixture.find<QWidget>("panelEditor");
        QVERIFY(editor != nullptr);
        auto* box = editor->findChild<QAbstractSpinBox*>();
        QVERIFY(box != nullptr);
        const QString before = box->text();
        box->setFocus();
        box->selectAll();
        QTest::keyClicks(box, QStringLiteral("77"));
        QTest::keyClick(box, Qt::Key_Escape);
        QCOMPARE(stops.count, 1);
        QTRY_COMPARE(box->text(), before);
        QVERIFY(box->toolTip().contains(QLatin1String("Esc turns torque off on the whole bus")));
    }

    void shiftEscStopsFromAnywhere()
    {
        gui::MainWindowFixture fixture;
        QVERIFY(fixture.ready(1));
        StopCounter stops(fixture.workbench());
        ui::ask(fixture.window.get(),
                {.title = QStringLiteral("?"), .acceptText = QStringLiteral("yes")}, [] {});
        QTRY_VERIFY(QApplication::activeModalWidget() != nullptr);
        QTest::keyClick(QApplication::activeModalWidget(), Qt::Key_Escape, Qt::ShiftModifier);
        QCOMPARE(stops.count, 1);
        QVERIFY(QApplication::activeModalWidget() != nullptr);
    }
};

SERVODESK_TEST(TestEscapeKey)
#include "tst_escape_key.moc"
