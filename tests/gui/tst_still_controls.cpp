// SPDX-License-Identifier: GPL-3.0-or-later
// Nothing that comes and goes in the window moves a control that moves a servo; a press on one that
// has just moved does nothing; results and the way back stay where they are while the pointer
// wanders over the window.
#include "gui/window_bench.h"
#include "sim/sim_link.h"
#include "ui/models/memory_model.h"
#include "ui/pages/commission_page.h"
#include "ui/widgets/banner.h"

#include <QAbstractSpinBox>
#include <QBoxLayout>
#include <QLabel>
#include <QMenu>
#include <QMenuBar>
#include <QPushButton>
#include <QScrollArea>
#include <QSignalSpy>
#include <QStatusTipEvent>
#include <QTableView>
#include <QToolButton>
#include <QToolTip>
#include <QTreeWidget>

using gui::WindowBench;
using namespace std::chrono_literals;

namespace {
const QStringList motionControls{
    QStringLiteral("positionDial"),  QStringLiteral("goalSlider"),
    QStringLiteral("goal"),          QStringLiteral("speed"),
    QStringLiteral("acceleration"),  QStringLiteral("setGoal"),
    QStringLiteral("execute"),       QStringLiteral("torqueSwitch"),
    QStringLiteral("mode_position"), QStringLiteral("mode_speed"),
    QStringLiteral("mode_step"),     QStringLiteral("torqueLimitSlider"),
    QStringLiteral("howWrite"),      QStringLiteral("torqueLimitPercent")};

QRect placeIn(const QWidget& window, const QWidget& widget)
{
    return {widget.mapTo(&window, QPoint()), widget.size()};
}

std::map<QString, QRect> places(const QWidget& window, const QStringList& names)
{
    std::map<QString, QRect> found;
    for (const QString& name : names) {
        const auto* widget = window.findChild<QWidget*>(name);
        if (widget != nullptr && widget->isVisible())
            found[name] = placeIn(window, *widget);
    }
    return found;
}

template <typename Function>
decltype(auto) withWire(WindowBench& bench, Function&& function)
{
    return bench.desk().connection()->simulation()->with(std::forward<Function>(function));
}

std::int64_t rawOf(WindowBench& bench, int id, const char* key)
{
    return withWire(bench, [&](sim::VirtualBus& wire) {
        return wire.servo(id)->raw(QString::fromLatin1(key));
    });
}

/// The places are compared after each thing that happens.
class Watch {
public:
    Watch(WindowBench& bench, const QStringList& names)
        : m_bench(bench)
        , m_names(names)
    {
        settle();
        m_before = places(*bench.window, names);
    }

    std::size_t count() const { return m_before.size(); }
    /// What stands elsewhere now; empty: nothing.
    QString moved(const char* after)
    {
        settle();
        QStringList moved;
        for (const auto& [name, now] : places(*m_bench.window, m_names)) {
            const auto before = m_before.find(name);
            if (before != m_before.end() && before->second != now)
                moved << QStringLiteral("%1: %2,%3 %4×%5 → %6,%7 %8×%9")
                             .arg(name)
                             .arg(before->second.x())
                             .arg(before->second.y())
                             .arg(before->second.width())
                             .arg(before->second.height())
                             .arg(now.x())
                             .arg(now.y())
                             .arg(now.width())
                             .arg(now.height());
        }
        return moved.isEmpty()
                   ? QString()
                   : QString::fromLatin1(after) + QLatin1Char('\n') + moved.join(QLatin1Char('\n'));
    }

private:
    /// The panel shows anew 25 ms after something changed, the layouts follow.
    void settle()
    {
        QVERIFY(m_bench.desk().testing() || m_bench.settled());
        QElapsedTimer since;
        since.start();
        auto last = places(*m_bench.window, m_names);
        (void)QTest::qWaitFor([&] {
            if (auto now = places(*m_bench.window, m_names); now != last) {
                last = std::move(now);
                since.restart();
            }
            return since.hasExpired(150);
        });
    }

    WindowBench& m_bench;
    QStringList m_names;
    std::map<QString, QRect> m_before;
};

#define VERIFY_STILL(watch, after)                                                                 \
    do {                                                                                           \
        const QString moved = (watch).moved(after);                                                \
        QVERIFY2(moved.isEmpty(), qPrintable(moved));                                              \
    } while (false)

void sizesAndLanguages()
{
    QTest::addColumn<QString>("language");
    QTest::addColumn<QSize>("size");
    QTest::newRow("English, small") << "en" << QSize(1024, 700);
    QTest::newRow("English") << "en" << QSize(1280, 800);
    QTest::newRow("Chinese, small") << "zh_CN" << QSize(1024, 700);
    QTest::newRow("Chinese") << "zh_CN" << QSize(1280, 800);
}

bool chooseRow(WindowBench& bench, const char* key)
{
    auto* table = bench.find<QTableView>("memoryTable");
    for (int row = 0; row < table->model()->rowCount(); ++row) {
        const QModelIndex cell = table->model()->index(row, 0);
        if (cell.data(ui::MemoryModel::KeyRole).toString() == QLatin1String(key)) {
            table->setCurrentIndex(cell);
            return true;
        }
    }
    return false;
}

/// A snapshot is chosen from which the servo differs.
bool takeSnapshotAndChange(WindowBench& bench)
{
    auto* shelf = bench.find<QTreeWidget>("shelfTree");
    auto* take = bench.find<QPushButton>("snapshotTake");
    if (!QTest::qWaitFor([&] { return take->isEnabled(); }, 20'000))
        return false;
    QTest::mouseClick(take, Qt::LeftButton);
    if (!QTest::qWaitFor([&] { return shelf->topLevelItemCount() > 0; }, 20'000))
        return false;
    bench.desk().write(bench.selection().current(), {{{QStringLiteral("position_p"), 40}}});
    if (!bench.settled())
        return false;
    shelf->setCurrentItem(shelf->topLevelItem(shelf->topLevelItemCount() - 1));
    auto* restore = bench.find<QPushButton>("restoreWrite");
    return QTest::qWaitFor([&] { return restore->isEnabled(); }, 20'000);
}

/// The controls on which something that floats lies.
QString coveredBy(WindowBench& bench, const char* floating, const QStringList& names)
{
    const QRect place = placeIn(*bench.window, *bench.find<QWidget>(floating));
    QStringList covered;
    for (const auto& [name, control] : places(*bench.window, names)) {
        if (control.intersects(place))
            covered << name;
    }
    return covered.join(QLatin1Char(' '));
}

/// As a message, a hint or a longer line did before the controls were kept still.
void pushDown(WindowBench& bench, int by)
{
    QWidget* body = bench.find<QScrollArea>("controlScroll")->widget();
    auto* block = new QWidget(body);
    block->setFixedHeight(by);
    qobject_cast<QBoxLayout*>(body->layout())->insertWidget(0, block);
    QCoreApplication::processEvents();
}
} // namespace

class TestStillControls : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { gui::failOnWarnings(); }

    void messagesMoveNoControl_data() { sizesAndLanguages(); }
    void messagesMoveNoControl()
    {
        QFETCH(QString, language);
        QFETCH(QSize, size);
        WindowBench bench(language);
        bench.window->resize(size);
        bench.page = QStringLiteral("operate");
        QVERIFY(bench.ready(1, QStringLiteral("sim:sts3215@1,sts3215@2,sts3215@3")));
        QTRY_VERIFY(bench.find<QWidget>("goal") != nullptr);
        Watch watch(bench, motionControls);
        QVERIFY(watch.count() >= 12);
        const auto seen = [&](const char* name) { return bench.find<QWidget>(name)->isVisible(); };

        QTest::mouseClick(bench.find<QToolButton>("torqueSwitch"), Qt::LeftButton);
        QTRY_VERIFY(seen("torqueHint"));
        VERIFY_STILL(watch, "the question before the first torque");
        QTest::mouseClick(bench.find<QPushButton>("torqueHintGo"), Qt::LeftButton);
        QTRY_COMPARE(rawOf(bench, 1, "torque_switch"), 1);
        QTRY_VERIFY(!bench.find<QLabel>("controlSaid")->text().isEmpty());
        VERIFY_STILL(watch, "torque on, and what was said of it");

        auto* goal = bench.find<QAbstractSpinBox>("goal");
        goal->setFocus();
        goal->selectAll();
        QTest::keyClicks(goal, QStringLiteral("99999"));
        QTest::keyClick(goal, Qt::Key_Return);
        QTRY_VERIFY(seen("controlBanner"));
        VERIFY_STILL(watch, "a banner");

        auto* speed = bench.find<QAbstractSpinBox>("speed");
        speed->setFocus();
        speed->selectAll();
        QTest::keyClicks(speed, QStringLiteral("30000"));
        VERIFY_STILL(watch, "a speed that is too high for the model");

        bench.desk().emergencyStop();
        QTRY_VERIFY(seen("controlStopped"));
        VERIFY_STILL(watch, "the line after a stop");
        QTest::mouseClick(bench.find<QToolButton>("torqueSwitch"), Qt::LeftButton);
        QTRY_VERIFY(!seen("controlStopped"));
        VERIFY_STILL(watch, "going on after a stop");

        bench.desk().write(bench.selection().current(),
                           {{{QStringLiteral("max_temperature"), 20}}, true, true});
        QTRY_VERIFY(seen("statusAlarm"));
        VERIFY_STILL(watch, "an alarm, and a write that can be undone");

        bench.find<ui::Banner>("banner")->present(
            {base::ErrorCode::LinkLost, QStringLiteral("read"), QStringLiteral("/dev/ttyUSB0")});
        VERIFY_STILL(watch, "the window's own banner");
        for (const char* floating : {"banner", "controlMessages"})
            QCOMPARE(coveredBy(bench, floating, motionControls), QString());
        bench.find<ui::Banner>("banner")->clear();
        bench.find<ui::Banner>("controlBanner")->clear();
        VERIFY_STILL(watch, "banners that go");
    }

    void servosThatComeMoveNoControl_data() { sizesAndLanguages(); }
    void servosThatComeMoveNoControl()
    {
        QFETCH(QString, language);
        QFETCH(QSize, size);
        WindowBench bench(language);
        bench.window->resize(size);
        bench.page = QStringLiteral("operate");
        QVERIFY(bench.ready(1, QStringLiteral("sim:sts3215@1,sts3215@22,sts3250@23")));
        QTRY_VERIFY(bench.find<QWidget>("goal") != nullptr);
        Watch watch(bench, motionControls);
        QVERIFY(!bench.find<QWidget>("servoStrip")->isVisible());
        bench.desk().search({.firstId = 20, .lastId = 25, .bauds = {}});
        QTRY_VERIFY(bench.find<QWidget>("servoStrip")->isVisible());
        VERIFY_STILL(watch, "a strip of servos");
        withWire(bench, [](sim::VirtualBus& wire) { wire.servo(1)->powerOff(); });
        QTRY_VERIFY(bench.entry().silent || bench.entry().link.lost());
        VERIFY_STILL(watch, "a servo that is silent");
        withWire(bench, [](sim::VirtualBus& wire) { wire.servo(1)->powerOn(); });
        QTRY_VERIFY(!bench.entry().silent && !bench.entry().link.lost());
        VERIFY_STILL(watch, "a servo that is back");
    }

    void pagesThatRunTestsKeepTheirButtons_data() { sizesAndLanguages(); }
    void pagesThatRunTestsKeepTheirButtons()
    {
        QFETCH(QString, language);
        QFETCH(QSize, size);
        WindowBench bench(language);
        bench.window->resize(size);
        const std::array<std::array<const char*, 4>, 2> pages{
            {{"sweep", "sweepRun", "sweepBanner", "sweepOutlook"},
             {"step", "stepRun", "stepBanner", "stepWhy"}}};
        for (const auto& [page, run, banner, words] : pages) {
            bench.page = QString::fromLatin1(page);
            QVERIFY(bench.ready(1, QStringLiteral("sim:sts3215@1")));
            const QStringList names{QString::fromLatin1(run)};
            Watch watch(bench, names);
            QCOMPARE(watch.count(), std::size_t(1));
            bench.find<ui::Banner>(banner)->present(
                {base::ErrorCode::LinkLost, QStringLiteral("read"), QString()});
            VERIFY_STILL(watch, banner);
            QCOMPARE(coveredBy(bench, banner, names), QString());
            bench.find<ui::Banner>(banner)->clear();
            VERIFY_STILL(watch, "a banner that goes");
            bench.find<QLabel>(words)->setText(QStringLiteral("one<br>two<br>three<br>four"));
            VERIFY_STILL(watch, words);
        }
    }

    void theReportButtonsStayInSight_data() { sizesAndLanguages(); }
    void theReportButtonsStayInSight()
    {
        QFETCH(QString, language);
        QFETCH(QSize, size);
        WindowBench bench(language);
        bench.window->resize(size);
        bench.page = QStringLiteral("sweep");
        QVERIFY(bench.ready(1, QStringLiteral("sim:sts3215@1")));
        const QStringList names{QStringLiteral("sweepReport_html"),
                                QStringLiteral("sweepReport_pdf"), QStringLiteral("sweepEarlier")};
        Watch watch(bench, names);
        QCOMPARE(watch.count(), std::size_t(3));
        for (const char* label : {"sweepSaved", "sweepEnd", "sweepComparison"}) {
            auto* words = bench.find<QLabel>(label);
            words->setText(QStringLiteral("one<br>two<br>three"));
            words->show();
            VERIFY_STILL(watch, label);
        }
        bench.find<ui::Banner>("sweepBanner")
            ->present({base::ErrorCode::LinkLost, QStringLiteral("read"), QString()});
        QCoreApplication::processEvents();
        QCOMPARE(coveredBy(bench, "sweepBanner", names), QString());
    }

    void theMemoryPageKeepsItsWriteButtons_data() { sizesAndLanguages(); }
    void theMemoryPageKeepsItsWriteButtons()
    {
        QFETCH(QString, language);
        QFETCH(QSize, size);
        WindowBench bench(language);
        bench.window->resize(size);
        QVERIFY(bench.ready(1, QStringLiteral("sim:sts3215@1")));
        QVERIFY(chooseRow(bench, "position_p"));
        const QStringList names{QStringLiteral("panelEditor"), QStringLiteral("writeValue"),
                                QStringLiteral("writeTemporarily"), QStringLiteral("memoryTable")};
        Watch watch(bench, names);
        QCOMPARE(watch.count(), std::size_t(4));
        bench.find<ui::Banner>("memoryBanner")
            ->present({base::ErrorCode::LinkLost, QStringLiteral("read"), QString()});
        VERIFY_STILL(watch, "a banner");
        QCOMPARE(coveredBy(bench, "memoryBanner", names.mid(0, 3)), QString());
        auto* editor = bench.find<QWidget>("panelEditor")->findChild<QAbstractSpinBox*>();
        editor->setFocus();
        editor->selectAll();
        QTest::keyClicks(editor, QStringLiteral("999"));
        QVERIFY(bench.find<QWidget>("registerComplaint")->isVisible());
        VERIFY_STILL(watch, "a complaint");
        bench.find<ui::Banner>("memoryBanner")->clear();
        editor->selectAll();
        QTest::keyClicks(editor, QStringLiteral("40"));
        VERIFY_STILL(watch, "no complaint any more");
        QTest::mouseClick(bench.find<QPushButton>("writeValue"), Qt::LeftButton);
        QTRY_COMPARE(rawOf(bench, 1, "position_p"), 40);
        VERIFY_STILL(watch, "a write");
        withWire(bench,
                 [](sim::VirtualBus& wire) { wire.servo(1)->poke(QStringLiteral("lock"), 0); });
        bench.desk().readTable(bench.selection().current());
        QTRY_VERIFY(bench.find<QWidget>("closeLock")->isVisible());
        VERIFY_STILL(watch, "a lock that another program has opened");
    }

    void theSnapshotsPageKeepsItsRestoreButton_data() { sizesAndLanguages(); }
    void theSnapshotsPageKeepsItsRestoreButton()
    {
        QFETCH(QString, language);
        QFETCH(QSize, size);
        WindowBench bench(language);
        bench.window->resize(size);
        bench.page = QStringLiteral("snapshots");
        QVERIFY(bench.ready(1, QStringLiteral("sim:sts3215@1")));
        QVERIFY(takeSnapshotAndChange(bench));
        const QStringList names{QStringLiteral("restoreWrite"), QStringLiteral("restoreDryRun"),
                                QStringLiteral("restoreSeveral"), QStringLiteral("snapshotTake"),
                                QStringLiteral("restoreIdentity")};
        Watch watch(bench, names);
        QCOMPARE(watch.count(), std::size_t(5));
        bench.find<ui::Banner>("snapshotsBanner")
            ->present({base::ErrorCode::LinkLost, QStringLiteral("read"), QString()});
        VERIFY_STILL(watch, "a banner");
        QCOMPARE(coveredBy(bench, "snapshotsBanner", names), QString());
        bench.find<ui::Banner>("snapshotsBanner")->clear();
        VERIFY_STILL(watch, "a banner that goes");
        Watch buttons(bench, names.mid(0, 4));
        bench.find<QLabel>("restoreOrder")
            ->setText(QStringLiteral("one\ntwo\nthree\nfour\nfive\nsix"));
        VERIFY_STILL(buttons, "more words above the buttons");
    }

    void theCommissioningPageKeepsItsButtons_data() { sizesAndLanguages(); }
    void theCommissioningPageKeepsItsButtons()
    {
        QFETCH(QString, language);
        QFETCH(QSize, size);
        WindowBench bench(language);
        bench.window->resize(size);
        bench.page = QStringLiteral("commission");
        QVERIFY(bench.connectTo(QStringLiteral("sim:line")));
        QTRY_VERIFY(bench.find<QPushButton>("commissionStart")->isEnabled());
        QTest::mouseClick(bench.find<QPushButton>("commissionStart"), Qt::LeftButton);
        QTRY_VERIFY(bench.find<ui::CommissionPage>("commissionPage")->line().running());
        QTest::mouseClick(bench.find<QPushButton>("commissionPlug"), Qt::LeftButton);
        QTRY_VERIFY_WITH_TIMEOUT(bench.find<QPushButton>("commissionContinue")->isVisible(),
                                 30'000);
        const QStringList names{QStringLiteral("commissionStart"), QStringLiteral("commissionStop"),
                                QStringLiteral("commissionContinue"),
                                QStringLiteral("commissionAside")};
        Watch watch(bench, names);
        QCOMPARE(watch.count(), std::size_t(4));
        bench.find<ui::Banner>("commissionBanner")
            ->present({base::ErrorCode::LinkLost, QStringLiteral("read"), QString()});
        VERIFY_STILL(watch, "a banner");
        QCOMPARE(coveredBy(bench, "commissionBanner", names), QString());
        bench.find<ui::Banner>("commissionBanner")->clear();
        for (const char* words :
             {"commissionWhy", "commissionHeadline", "commissionDetail", "commissionSaved"}) {
            auto* label = bench.find<QLabel>(words);
            const bool shown = label->isVisible();
            const QString before = label->text();
            label->setText(QStringLiteral("one two three four five six seven eight nine ten "
                                          "eleven"));
            label->show();
            VERIFY_STILL(watch, words);
            label->setText(before);
            label->setVisible(shown);
        }
        bench.find<QWidget>("commissionDangerous")->show();
        VERIFY_STILL(watch, "a template with dangerous rows");
        QTest::mouseClick(bench.find<QPushButton>("commissionStop"), Qt::LeftButton);
        QTRY_VERIFY(!bench.find<ui::CommissionPage>("commissionPage")->line().running());
    }

    void nothingIsWrittenRightAfterAShift_data()
    {
        QTest::addColumn<QString>("page");
        QTest::addColumn<QString>("button");
        QTest::newRow("memory") << "memory"
                                << "writeValue";
        QTest::newRow("snapshots") << "snapshots"
                                   << "restoreWrite";
        QTest::newRow("commissioning") << "commission"
                                       << "commissionStart";
    }
    void nothingIsWrittenRightAfterAShift()
    {
        QFETCH(QString, page);
        QFETCH(QString, button);
        WindowBench bench;
        bench.page = page;
        QVERIFY(bench.ready(1, QStringLiteral("sim:sts3215@1")));
        if (page == QLatin1String("memory"))
            QVERIFY(chooseRow(bench, "position_p"));
        if (page == QLatin1String("snapshots"))
            QVERIFY(takeSnapshotAndChange(bench));
        auto* pressed = bench.find<QPushButton>(qPrintable(button));
        QTRY_VERIFY(pressed->isEnabled());
        const Watch settledNow(bench, {button});
        const auto acted = [&] {
            return bench.desk().busy() || bench.find<QWidget>("question") != nullptr ||
                   bench.find<ui::CommissionPage>("commissionPage")->line().running();
        };
        gui::PressClock clock;
        clock.pass(1h);
        QSignalSpy clicked(pressed, &QPushButton::clicked);
        pressed->move(pressed->pos() + QPoint(0, 10));
        QTest::mouseClick(pressed, Qt::LeftButton);
        QCOMPARE(clicked.count(), 0);
        QVERIFY(!acted());
        clock.pass(500ms);
        QTest::mouseClick(pressed, Qt::LeftButton);
        QCOMPARE(clicked.count(), 1);
        QTRY_VERIFY(acted());
    }

    void aPressRightAfterAShiftIsIgnored_data()
    {
        QTest::addColumn<QString>("control");
        for (const char* control : {"positionDial", "goalSlider", "setGoal"})
            QTest::newRow(control) << QString::fromLatin1(control);
    }
    void aPressRightAfterAShiftIsIgnored()
    {
        QFETCH(QString, control);
        WindowBench bench;
        bench.settings.setChoice(QStringLiteral("operate/no_torque_hint"), true);
        bench.page = QStringLiteral("operate");
        QVERIFY(bench.ready(1, QStringLiteral("sim:sts3215@1")));
        bench.bench.drive.setTorque(device::Torque::On);
        QTRY_COMPARE(rawOf(bench, 1, "torque_switch"), 1);
        auto* widget = bench.find<QWidget>(qPrintable(control));
        QTRY_VERIFY(widget->isEnabled());
        if (control == QLatin1String("setGoal")) {
            auto* goal = bench.find<QAbstractSpinBox>("goal");
            goal->selectAll();
            QTest::keyClicks(goal, QStringLiteral("2600"));
        }
        const Watch settledNow(bench, {control});
        gui::PressClock clock;
        clock.pass(1h);
        const std::int64_t before = rawOf(bench, 1, "goal_position");
        const QPoint place = control == QLatin1String("setGoal")
                                 ? widget->rect().center()
                                 : QPoint(widget->width() * 4 / 5, widget->height() / 2);

        pushDown(bench, 40);
        QTest::mouseClick(widget, Qt::LeftButton, {}, place);
        QVERIFY(bench.settled());
        QCOMPARE(rawOf(bench, 1, "goal_position"), before);
        QTRY_VERIFY(QToolTip::text().contains(QLatin1String("moved just now")));

        clock.pass(499ms);
        QTest::mouseClick(widget, Qt::LeftButton, {}, place);
        QVERIFY(bench.settled());
        QCOMPARE(rawOf(bench, 1, "goal_position"), before);

        clock.pass(1ms);
        QTest::mouseClick(widget, Qt::LeftButton, {}, place);
        QTRY_VERIFY(rawOf(bench, 1, "goal_position") > before + 200);
    }

    void aModeIsNotAskedForRightAfterAShift()
    {
        WindowBench bench;
        bench.page = QStringLiteral("operate");
        QVERIFY(bench.ready(1, QStringLiteral("sim:sts3215@1")));
        QToolButton* wheel = nullptr;
        QTRY_VERIFY((wheel = bench.find<QToolButton>("mode_speed")) != nullptr);
        QTRY_VERIFY(wheel->isEnabled());
        const Watch settledNow(bench, {QStringLiteral("mode_speed")});
        gui::PressClock clock;
        clock.pass(1h);
        QSignalSpy planned(&bench.bench.drive, &session::Drive::modePlanned);
        pushDown(bench, 40);
        QTest::mouseClick(wheel, Qt::LeftButton);
        QVERIFY(bench.settled());
        QCOMPARE(planned.count(), 0);
        clock.pass(500ms);
        QTest::mouseClick(wheel, Qt::LeftButton);
        QTRY_COMPARE(planned.count(), 1);
    }

    /// The pointer stays, the dial goes away under it: the next move of the pointer is no new goal.
    void aDragEndsWhereTheControlMoves()
    {
        WindowBench bench;
        bench.settings.setChoice(QStringLiteral("operate/no_torque_hint"), true);
        bench.page = QStringLiteral("operate");
        QVERIFY(bench.ready(1, QStringLiteral("sim:sts3215@1")));
        auto* dial = bench.find<QWidget>("positionDial");
        QTRY_VERIFY(bench.find<QWidget>("goalSlider")->isEnabled());
        const Watch settledNow(bench, {QStringLiteral("positionDial")});
        const QPoint right(dial->width() * 4 / 5, dial->height() / 2);
        QTest::mousePress(dial, Qt::LeftButton, {}, right);
        QTRY_VERIFY(rawOf(bench, 1, "goal_position") > 2800);
        QVERIFY(bench.settled());
        const std::int64_t before = rawOf(bench, 1, "goal_position");
        pushDown(bench, 110);
        QTest::mouseMove(dial, right - QPoint(0, 60));
        QTest::mouseMove(dial, right - QPoint(0, 61));
        QVERIFY(bench.settled());
        QCOMPARE(rawOf(bench, 1, "goal_position"), before);
        QTest::mouseRelease(dial, Qt::LeftButton, {}, right);
        QTest::mousePress(dial, Qt::LeftButton, {}, right - QPoint(0, 60));
        QTRY_VERIFY(rawOf(bench, 1, "goal_position") != before);
        QTest::mouseRelease(dial, Qt::LeftButton, {}, right);
    }

    /// Whatever the pointer rests on, the latest result and Undo stay.
    void undoStaysUnderThePointer()
    {
        WindowBench bench;
        QVERIFY(bench.ready(1, QStringLiteral("sim:sts3215@1")));
        auto* undo = bench.find<QToolButton>("undoButton");
        QVERIFY(undo != nullptr && undo->isVisible() && !undo->isEnabled());
        const QRect place = placeIn(*bench.window, *undo);
        const std::int64_t before = rawOf(bench, 1, "position_p");
        bench.desk().write(bench.selection().current(),
                           {{{QStringLiteral("position_p"), before + 8}}});
        QVERIFY(bench.settled());
        QCOMPARE(rawOf(bench, 1, "position_p"), before + 8);
        QTRY_VERIFY(undo->isEnabled());
        QCOMPARE(placeIn(*bench.window, *undo), place);
        auto* line = bench.find<QLabel>("messageText");
        const QString result = line->text();
        QVERIFY(!result.isEmpty());

        for (auto* button : bench.window->findChildren<QToolButton*>()) {
            if (!button->isVisible())
                continue;
            QTest::mouseMove(button, button->rect().center());
            QEnterEvent enter(button->rect().center(), button->rect().center(),
                              button->mapToGlobal(button->rect().center()));
            QApplication::sendEvent(button, &enter);
            QVERIFY2(line->isVisible() && undo->isVisible(), qPrintable(button->objectName()));
            QCOMPARE(line->text(), result);
        }
        for (QAction* menu : bench.window->menuBar()->actions()) {
            for (QAction* action : menu->menu()->actions()) {
                action->showStatusText(bench.window.get());
                QVERIFY2(line->isVisible() && undo->isVisible(), qPrintable(action->text()));
            }
        }
        QStatusTipEvent tip(QStringLiteral("something else"));
        QApplication::sendEvent(bench.window.get(), &tip);
        QVERIFY(line->isVisible() && undo->isVisible());
        QCOMPARE(placeIn(*bench.window, *undo), place);

        QTest::mouseMove(undo, undo->rect().center());
        QTest::mouseClick(undo, Qt::LeftButton);
        QVERIFY(bench.settled());
        QTRY_COMPARE(rawOf(bench, 1, "position_p"), before);
        QTRY_VERIFY(!undo->isEnabled() && undo->isVisible());
    }
};

QTEST_MAIN(TestStillControls)
#include "tst_still_controls.moc"
