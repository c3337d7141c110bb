// SPDX-License-Identifier: GPL-3.0-or-later
// Nothing that appears or disappears in the window moves a control that moves a servo; a press on a
// control that has just moved does nothing; results and Undo stay where they are while the pointer
// moves over the window.
#include "gui/main_window_fixture.h"
#include "session/motion/motion_controller.h"
#include "sim/host/sim_link.h"
#include "support/deep_check.h"
#include "support/test_main.h"
#include "ui/commissioning/commission_page.h"
#include "ui/memory/memory_model.h"
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

using gui::MainWindowFixture;
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

QRect geometryIn(const QWidget& window, const QWidget& widget)
{
    return {widget.mapTo(&window, QPoint()), widget.size()};
}

std::map<QString, QRect> places(const QWidget& window, const QStringList& names)
{
    std::map<QString, QRect> found;
    for (const QString& name : names) {
        const auto* widget = window.findChild<QWidget*>(name);
        if (widget != nullptr && widget->isVisible())
            found[name] = geometryIn(window, *widget);
    }
    return found;
}

template <typename Function>
decltype(auto) withBus(MainWindowFixture& fixture, Function&& function)
{
    return fixture.workbench().link().connection()->simulation()->with(
        std::forward<Function>(function));
}

std::int64_t rawOf(MainWindowFixture& fixture, int id, const char* key)
{
    return withBus(fixture, [&](sim::VirtualBus& wire) {
        return wire.servo(id)->raw(QString::fromLatin1(key));
    });
}

/// The positions are compared after each event.
class LayoutObserver {
public:
    LayoutObserver(MainWindowFixture& fixture, const QStringList& names)
        : m_fixture(fixture)
        , m_names(names)
    {
        waitUntilStable();
        m_before = places(*fixture.window, names);
    }

    std::size_t count() const { return m_before.size(); }
    /// What has moved; empty: nothing.
    QString moved(const char* after)
    {
        waitUntilStable();
        QStringList moved;
        for (const auto& [name, now] : places(*m_fixture.window, m_names)) {
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
    /// The panel refreshes 25 ms after a change, the layouts follow.
    void waitUntilStable()
    {
        QVERIFY(m_fixture.workbench().tasks().isTesting() || m_fixture.waitUntilIdle());
        QElapsedTimer since;
        since.start();
        auto last = places(*m_fixture.window, m_names);
        (void)support::waitFor([&] {
            if (auto now = places(*m_fixture.window, m_names); now != last) {
                last = std::move(now);
                since.restart();
            }
            return since.hasExpired(150);
        });
    }

    MainWindowFixture& m_fixture;
    QStringList m_names;
    std::map<QString, QRect> m_before;
};

#define VERIFY_UNMOVED(watch, after)                                                               \
    do {                                                                                           \
        const QString moved = (watch).moved(after);                                                \
        QVERIFY2(moved.isEmpty(), qPrintable(moved));                                              \
    } while (false)

void addSizesAndLanguages()
{
    QTest::addColumn<QString>("language");
    QTest::addColumn<QSize>("size");
    QTest::newRow("English, small") << "en" << QSize(1024, 700);
    QTest::newRow("Chinese") << "zh_CN" << QSize(1280, 800);
    if (!support::isDeepCheck())
        return;
    QTest::newRow("English") << "en" << QSize(1280, 800);
    QTest::newRow("Chinese, small") << "zh_CN" << QSize(1024, 700);
}

bool clickRow(MainWindowFixture& fixture, const char* key)
{
    auto* table = fixture.find<QTableView>("memoryTable");
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
bool takeSnapshotAndChange(MainWindowFixture& fixture)
{
    auto* snapshotTree = fixture.find<QTreeWidget>("shelfTree");
    auto* take = fixture.find<QPushButton>("snapshotTake");
    if (!support::waitFor([&] { return take->isEnabled(); }))
        return false;
    QTest::mouseClick(take, Qt::LeftButton);
    if (!support::waitFor([&] { return snapshotTree->topLevelItemCount() > 0; }))
        return false;
    fixture.workbench().writes().write(fixture.selection().current(),
                                       {{{QStringLiteral("position_p"), 40}}});
    if (!fixture.waitUntilIdle())
        return false;
    snapshotTree->setCurrentItem(snapshotTree->topLevelItem(snapshotTree->topLevelItemCount() - 1));
    auto* restore = fixture.find<QPushButton>("restoreWrite");
    return support::waitFor([&] { return restore->isEnabled(); });
}

/// The controls that are covered by a floating widget.
QString coveredControls(MainWindowFixture& fixture, const char* floating, const QStringList& names)
{
    const QRect place = geometryIn(*fixture.window, *fixture.find<QWidget>(floating));
    QStringList covered;
    for (const auto& [name, control] : places(*fixture.window, names)) {
        if (control.intersects(place))
            covered << name;
    }
    return covered.join(QLatin1Char(' '));
}

/// As a message, a hint or a longer line did before the controls were kept still.
void shiftLayout(MainWindowFixture& fixture, int by)
{
    auto* panel = fixture.find<QWidget>("controlPanel");
    auto* block = new QWidget(panel);
    block->setFixedHeight(by);
    qobject_cast<QBoxLayout*>(panel->layout())->insertWidget(0, block);
    QCoreApplication::processEvents();
}
} // namespace

class TestStableLayout : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { gui::failOnWarnings(); }

    void messagesDoNotMoveControls_data() { addSizesAndLanguages(); }
    void messagesDoNotMoveControls()
    {
        QFETCH(QString, language);
        QFETCH(QSize, size);
        MainWindowFixture fixture(language);
        fixture.window->resize(size);
        fixture.page = QStringLiteral("operate");
        QVERIFY(fixture.ready(1, QStringLiteral("sim:sts3215@1,sts3215@2,sts3215@3")));
        QTRY_VERIFY(fixture.find<QWidget>("goal") != nullptr);
        LayoutObserver watch(fixture, motionControls);
        QVERIFY(watch.count() >= 12);
        const auto seen = [&](const char* name) {
            return fixture.find<QWidget>(name)->isVisible();
        };

        QTest::mouseClick(fixture.find<QToolButton>("torqueSwitch"), Qt::LeftButton);
        QTRY_VERIFY(seen("torqueHint"));
        VERIFY_UNMOVED(watch, "the question before the first torque");
        QTest::mouseClick(fixture.find<QPushButton>("torqueHintGo"), Qt::LeftButton);
        QTRY_COMPARE(rawOf(fixture, 1, "torque_switch"), 1);
        QTRY_VERIFY(!fixture.find<QLabel>("controlSaid")->text().isEmpty());
        VERIFY_UNMOVED(watch, "torque on, and what was said of it");

        auto* goal = fixture.find<QAbstractSpinBox>("goal");
        goal->setFocus();
        goal->selectAll();
        QTest::keyClicks(goal, QStringLiteral("99999"));
        QTest::keyClick(goal, Qt::Key_Return);
        QTRY_VERIFY(seen("controlBanner"));
        VERIFY_UNMOVED(watch, "a banner");

        auto* speed = fixture.find<QAbstractSpinBox>("speed");
        speed->setFocus();
        speed->selectAll();
        QTest::keyClicks(speed, QStringLiteral("30000"));
        VERIFY_UNMOVED(watch, "a speed that is too high for the model");

        fixture.workbench().emergencyStop().trigger();
        QTRY_VERIFY(seen("controlStopped"));
        VERIFY_UNMOVED(watch, "the line after a stop");
        QTest::mouseClick(fixture.find<QToolButton>("torqueSwitch"), Qt::LeftButton);
        QTRY_VERIFY(!seen("controlStopped"));
        VERIFY_UNMOVED(watch, "going on after a stop");

        fixture.workbench().writes().write(
            fixture.selection().current(),
            {{{QStringLiteral("max_temperature"), 20}}, true, device::Consent::confirmed()});
        QTRY_VERIFY(seen("statusAlarm"));
        VERIFY_UNMOVED(watch, "an alarm, and a write that can be undone");

        fixture.find<ui::Banner>("banner")->showMessage(
            {base::ErrorCode::LinkLost, QStringLiteral("read"), QStringLiteral("/dev/ttyUSB0")});
        VERIFY_UNMOVED(watch, "the window's own banner");
        for (const char* floating : {"banner", "controlMessages"})
            QCOMPARE(coveredControls(fixture, floating, motionControls), QString());
        fixture.find<ui::Banner>("banner")->hideMessage();
        fixture.find<ui::Banner>("controlBanner")->hideMessage();
        VERIFY_UNMOVED(watch, "banners that go");
    }

    void newServosDoNotMoveControls_data() { addSizesAndLanguages(); }
    void newServosDoNotMoveControls()
    {
        QFETCH(QString, language);
        QFETCH(QSize, size);
        MainWindowFixture fixture(language);
        fixture.window->resize(size);
        fixture.page = QStringLiteral("operate");
        QVERIFY(fixture.ready(1, QStringLiteral("sim:sts3215@1,sts3215@22,sts3250@23")));
        QTRY_VERIFY(fixture.find<QWidget>("goal") != nullptr);
        LayoutObserver watch(fixture, motionControls);
        QVERIFY(!fixture.find<QWidget>("servoStrip")->isVisible());
        fixture.workbench().search().start({.firstId = 20, .lastId = 25, .bauds = {}});
        QTRY_VERIFY(fixture.find<QWidget>("servoStrip")->isVisible());
        VERIFY_UNMOVED(watch, "a strip of servos");
        withBus(fixture, [](sim::VirtualBus& wire) { wire.servo(1)->powerOff(); });
        QTRY_VERIFY(fixture.entry().silent || fixture.entry().linkMonitor.isLost());
        VERIFY_UNMOVED(watch, "a servo that is silent");
        withBus(fixture, [](sim::VirtualBus& wire) { wire.servo(1)->powerOn(); });
        QTRY_VERIFY(!fixture.entry().silent && !fixture.entry().linkMonitor.isLost());
        VERIFY_UNMOVED(watch, "a servo that is back");
    }

    void pagesThatRunTestsKeepTheirButtons_data() { addSizesAndLanguages(); }
    void pagesThatRunTestsKeepTheirButtons()
    {
        QFETCH(QString, language);
        QFETCH(QSize, size);
        MainWindowFixture fixture(language);
        fixture.window->resize(size);
        const std::array<std::array<const char*, 4>, 2> pages{
            {{"sweep", "sweepRun", "sweepBanner", "sweepOutlook"},
             {"step", "stepRun", "stepBanner", "stepWhy"}}};
        for (const auto& [page, run, banner, words] : pages) {
            fixture.page = QString::fromLatin1(page);
            QVERIFY(fixture.ready(1, QStringLiteral("sim:sts3215@1")));
            const QStringList names{QString::fromLatin1(run)};
            LayoutObserver watch(fixture, names);
            QCOMPARE(watch.count(), std::size_t(1));
            fixture.find<ui::Banner>(banner)->showMessage(
                {base::ErrorCode::LinkLost, QStringLiteral("read"), QString()});
            VERIFY_UNMOVED(watch, banner);
            QCOMPARE(coveredControls(fixture, banner, names), QString());
            fixture.find<ui::Banner>(banner)->hideMessage();
            VERIFY_UNMOVED(watch, "a banner that goes");
            fixture.find<QLabel>(words)->setText(QStringLiteral("one<br>two<br>three<br>four"));
            VERIFY_UNMOVED(watch, words);
        }
    }

    void theReportButtonsStayVisible_data() { addSizesAndLanguages(); }
    void theReportButtonsStayVisible()
    {
        QFETCH(QString, language);
        QFETCH(QSize, size);
        MainWindowFixture fixture(language);
        fixture.window->resize(size);
        fixture.page = QStringLiteral("sweep");
        QVERIFY(fixture.ready(1, QStringLiteral("sim:sts3215@1")));
        const QStringList names{QStringLiteral("sweepReport_html"),
                                QStringLiteral("sweepReport_pdf"), QStringLiteral("sweepEarlier")};
        fixture.find<QWidget>("sweepFindings")->show(); // as after a test
        if (size.width() < 1280)                        // the report is behind a tab
            fixture.find<QTabWidget>("sweepTabs")->setCurrentIndex(2);
        QCoreApplication::processEvents();
        LayoutObserver watch(fixture, names);
        QCOMPARE(watch.count(), std::size_t(3));
        for (const char* label : {"sweepSaved", "sweepComparison"}) {
            auto* words = fixture.find<QLabel>(label);
            words->setText(QStringLiteral("one<br>two<br>three"));
            words->show();
            VERIFY_UNMOVED(watch, label);
        }
        fixture.find<ui::Banner>("sweepBanner")
            ->showMessage({base::ErrorCode::LinkLost, QStringLiteral("read"), QString()});
        QCoreApplication::processEvents();
        QCOMPARE(coveredControls(fixture, "sweepBanner", names), QString());
    }

    void theMemoryPageKeepsItsWriteButtons_data() { addSizesAndLanguages(); }
    void theMemoryPageKeepsItsWriteButtons()
    {
        QFETCH(QString, language);
        QFETCH(QSize, size);
        MainWindowFixture fixture(language);
        fixture.window->resize(size);
        QVERIFY(fixture.ready(1, QStringLiteral("sim:sts3215@1")));
        QVERIFY(clickRow(fixture, "position_p"));
        const QStringList names{QStringLiteral("panelEditor"), QStringLiteral("writeValue"),
                                QStringLiteral("writeTemporarily"), QStringLiteral("memoryTable")};
        LayoutObserver watch(fixture, names);
        QCOMPARE(watch.count(), std::size_t(4));
        fixture.find<ui::Banner>("memoryBanner")
            ->showMessage({base::ErrorCode::LinkLost, QStringLiteral("read"), QString()});
        VERIFY_UNMOVED(watch, "a banner");
        QCOMPARE(coveredControls(fixture, "memoryBanner", names.mid(0, 3)), QString());
        const auto* panel = fixture.find<QWidget>("panelEditor");
        auto* editor = panel->findChild<QAbstractSpinBox*>();
        QVERIFY2(editor != nullptr, qPrintable(panel->accessibleName()));
        editor->setFocus();
        editor->selectAll();
        QTest::keyClicks(editor, QStringLiteral("999"));
        QVERIFY(fixture.find<QWidget>("registerComplaint")->isVisible());
        VERIFY_UNMOVED(watch, "a complaint");
        fixture.find<ui::Banner>("memoryBanner")->hideMessage();
        editor->selectAll();
        QTest::keyClicks(editor, QStringLiteral("40"));
        VERIFY_UNMOVED(watch, "no complaint any more");
        QTest::mouseClick(fixture.find<QPushButton>("writeValue"), Qt::LeftButton);
        QTRY_COMPARE(rawOf(fixture, 1, "position_p"), 40);
        VERIFY_UNMOVED(watch, "a write");
        withBus(fixture,
                [](sim::VirtualBus& wire) { wire.servo(1)->poke(QStringLiteral("lock"), 0); });
        fixture.workbench().writes().readTable(fixture.selection().current());
        QTRY_VERIFY(fixture.find<QWidget>("closeLock")->isVisible());
        VERIFY_UNMOVED(watch, "a lock that another program has opened");
    }

    void theSnapshotsPageKeepsItsRestoreButton_data() { addSizesAndLanguages(); }
    void theSnapshotsPageKeepsItsRestoreButton()
    {
        QFETCH(QString, language);
        QFETCH(QSize, size);
        MainWindowFixture fixture(language);
        fixture.window->resize(size);
        fixture.page = QStringLiteral("snapshots");
        QVERIFY(fixture.ready(1, QStringLiteral("sim:sts3215@1")));
        QVERIFY(takeSnapshotAndChange(fixture));
        const QStringList names{QStringLiteral("restoreWrite"), QStringLiteral("restoreDryRun"),
                                QStringLiteral("restoreSeveral"), QStringLiteral("snapshotTake"),
                                QStringLiteral("restoreIdentity")};
        LayoutObserver watch(fixture, names);
        QCOMPARE(watch.count(), std::size_t(5));
        fixture.find<ui::Banner>("snapshotsBanner")
            ->showMessage({base::ErrorCode::LinkLost, QStringLiteral("read"), QString()});
        VERIFY_UNMOVED(watch, "a banner");
        QCOMPARE(coveredControls(fixture, "snapshotsBanner", names), QString());
        fixture.find<ui::Banner>("snapshotsBanner")->hideMessage();
        VERIFY_UNMOVED(watch, "a banner that goes");
        LayoutObserver buttons(fixture, names.mid(0, 4));
        fixture.find<QLabel>("restoreOrder")
            ->setText(QStringLiteral("one\ntwo\nthree\nfour\nfive\nsix"));
        VERIFY_UNMOVED(buttons, "more words above the buttons");
    }

    void theCommissioningPageKeepsItsButtons_data() { addSizesAndLanguages(); }
    void theCommissioningPageKeepsItsButtons()
    {
        QFETCH(QString, language);
        QFETCH(QSize, size);
        MainWindowFixture fixture(language);
        fixture.window->resize(size);
        fixture.page = QStringLiteral("commission");
        QVERIFY(fixture.connectTo(QStringLiteral("sim:line")));
        QTRY_VERIFY(fixture.find<QPushButton>("commissionStart")->isEnabled());
        QTest::mouseClick(fixture.find<QPushButton>("commissionStart"), Qt::LeftButton);
        QTRY_VERIFY(fixture.workbench().commissioning().isRunning());
        QTest::mouseClick(fixture.find<QPushButton>("commissionPlug"), Qt::LeftButton);
        QTRY_VERIFY(fixture.find<QPushButton>("commissionContinue")->isVisible());
        const QStringList names{QStringLiteral("commissionStart"), QStringLiteral("commissionStop"),
                                QStringLiteral("commissionContinue"),
                                QStringLiteral("commissionAside")};
        LayoutObserver watch(fixture, names);
        QCOMPARE(watch.count(), std::size_t(4));
        fixture.find<ui::Banner>("commissionBanner")
            ->showMessage({base::ErrorCode::LinkLost, QStringLiteral("read"), QString()});
        VERIFY_UNMOVED(watch, "a banner");
        QCOMPARE(coveredControls(fixture, "commissionBanner", names), QString());
        fixture.find<ui::Banner>("commissionBanner")->hideMessage();
        for (const char* words :
             {"commissionWhy", "commissionHeadline", "commissionDetail", "commissionSaved"}) {
            auto* label = fixture.find<QLabel>(words);
            const bool shown = label->isVisible();
            const QString before = label->text();
            label->setText(QStringLiteral("one two three four five six seven eight nine ten "
                                          "eleven"));
            label->show();
            VERIFY_UNMOVED(watch, words);
            label->setText(before);
            label->setVisible(shown);
        }
        fixture.find<QWidget>("commissionDangerous")->show();
        VERIFY_UNMOVED(watch, "a template with dangerous rows");
        QTest::mouseClick(fixture.find<QPushButton>("commissionStop"), Qt::LeftButton);
        QTRY_VERIFY(!fixture.workbench().commissioning().isRunning());
    }

    void clicksRightAfterALayoutShiftWriteNothing_data()
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
    void clicksRightAfterALayoutShiftWriteNothing()
    {
        QFETCH(QString, page);
        QFETCH(QString, button);
        MainWindowFixture fixture;
        fixture.page = page;
        QVERIFY(fixture.ready(1, QStringLiteral("sim:sts3215@1")));
        if (page == QLatin1String("memory"))
            QVERIFY(clickRow(fixture, "position_p"));
        if (page == QLatin1String("snapshots"))
            QVERIFY(takeSnapshotAndChange(fixture));
        auto* pressed = fixture.find<QPushButton>(qPrintable(button));
        QTRY_VERIFY(pressed->isEnabled());
        const LayoutObserver layoutAfter(fixture, {button});
        const auto acted = [&] {
            return fixture.workbench().tasks().isBusy() ||
                   fixture.find<QWidget>("question") != nullptr ||
                   fixture.workbench().commissioning().isRunning();
        };
        gui::ManualPressClock clock;
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

    void aPressRightAfterALayoutShiftIsIgnored_data()
    {
        QTest::addColumn<QString>("control");
        for (const char* control : {"positionDial", "goalSlider", "setGoal"})
            QTest::newRow(control) << QString::fromLatin1(control);
    }
    void aPressRightAfterALayoutShiftIsIgnored()
    {
        QFETCH(QString, control);
        MainWindowFixture fixture;
        fixture.settings.setPageValue(QStringLiteral("operate/no_torque_hint"), true);
        fixture.page = QStringLiteral("operate");
        QVERIFY(fixture.ready(1, QStringLiteral("sim:sts3215@1")));
        fixture.context.workbench.motion().setTorque(device::Torque::On);
        QTRY_COMPARE(rawOf(fixture, 1, "torque_switch"), 1);
        auto* widget = fixture.find<QWidget>(qPrintable(control));
        QAbstractSpinBox* goal = nullptr; // comes when the panel shows the servo
        QTRY_VERIFY((goal = fixture.find<QAbstractSpinBox>("goal")) != nullptr);
        QTRY_VERIFY(widget->isEnabled());
        if (control == QLatin1String("setGoal")) {
            goal->selectAll();
            QTest::keyClicks(goal, QStringLiteral("2600"));
        }
        const LayoutObserver layoutAfter(fixture, {control});
        gui::ManualPressClock clock;
        clock.pass(1h);
        const std::int64_t before = rawOf(fixture, 1, "goal_position");
        const QPoint place = control == QLatin1String("setGoal")
                                 ? widget->rect().center()
                                 : QPoint(widget->width() * 4 / 5, widget->height() / 2);

        shiftLayout(fixture, 40);
        QTest::mouseClick(widget, Qt::LeftButton, {}, place);
        QVERIFY(fixture.waitUntilIdle());
        QCOMPARE(rawOf(fixture, 1, "goal_position"), before);
        QTRY_VERIFY(QToolTip::text().contains(QLatin1String("had just moved")));

        clock.pass(499ms);
        QTest::mouseClick(widget, Qt::LeftButton, {}, place);
        QVERIFY(fixture.waitUntilIdle());
        QCOMPARE(rawOf(fixture, 1, "goal_position"), before);

        clock.pass(1ms);
        QTest::mouseClick(widget, Qt::LeftButton, {}, place);
        QTRY_VERIFY(rawOf(fixture, 1, "goal_position") > before + 200);
    }

    void aModeIsNotRequestedRightAfterALayoutShift()
    {
        MainWindowFixture fixture;
        fixture.page = QStringLiteral("operate");
        QVERIFY(fixture.ready(1, QStringLiteral("sim:sts3215@1")));
        QAbstractButton* wheel = nullptr;
        QTRY_VERIFY((wheel = fixture.find<QAbstractButton>("mode_speed")) != nullptr);
        QTRY_VERIFY(wheel->isEnabled());
        const LayoutObserver layoutAfter(fixture, {QStringLiteral("mode_speed")});
        gui::ManualPressClock clock;
        clock.pass(1h);
        QSignalSpy planned(&fixture.context.workbench.motion(),
                           &session::MotionController::modePreviewed);
        shiftLayout(fixture, 40);
        QTest::mouseClick(wheel, Qt::LeftButton);
        QVERIFY(fixture.waitUntilIdle());
        QCOMPARE(planned.count(), 0);
        clock.pass(500ms);
        QTest::mouseClick(wheel, Qt::LeftButton);
        QTRY_COMPARE(planned.count(), 1);
    }

    /// The pointer stays, the dial goes away under it: the next move of the pointer is no new goal.
    void aDragEndsWhenTheControlMoves()
    {
        MainWindowFixture fixture;
        fixture.settings.setPageValue(QStringLiteral("operate/no_torque_hint"), true);
        fixture.page = QStringLiteral("operate");
        QVERIFY(fixture.ready(1, QStringLiteral("sim:sts3215@1")));
        auto* dial = fixture.find<QWidget>("positionDial");
        auto* slider = fixture.find<QWidget>("goalSlider");
        QTRY_VERIFY(slider->isVisible() && slider->isEnabled()); // it has its scale then
        const LayoutObserver layoutAfter(fixture, {QStringLiteral("positionDial")});
        const QPoint right(dial->width() * 4 / 5, dial->height() / 2);
        QTest::mousePress(dial, Qt::LeftButton, {}, right);
        QTRY_VERIFY(rawOf(fixture, 1, "goal_position") > 2800);
        QVERIFY(fixture.waitUntilIdle());
        const std::int64_t before = rawOf(fixture, 1, "goal_position");
        shiftLayout(fixture, 110);
        QTest::mouseMove(dial, right - QPoint(0, 60));
        QTest::mouseMove(dial, right - QPoint(0, 61));
        QVERIFY(fixture.waitUntilIdle());
        QCOMPARE(rawOf(fixture, 1, "goal_position"), before);
        QTest::mouseRelease(dial, Qt::LeftButton, {}, right);
        QTest::mousePress(dial, Qt::LeftButton, {}, right - QPoint(0, 60));
        QTRY_VERIFY(rawOf(fixture, 1, "goal_position") != before);
        QTest::mouseRelease(dial, Qt::LeftButton, {}, right);
    }

    /// Whatever the pointer rests on, the latest result and Undo stay.
    void undoStaysUnderThePointer()
    {
        MainWindowFixture fixture;
        QVERIFY(fixture.ready(1, QStringLiteral("sim:sts3215@1")));
        auto* undo = fixture.find<QToolButton>("undoButton");
        QVERIFY(undo != nullptr && undo->isVisible() && !undo->isEnabled());
        const QRect place = geometryIn(*fixture.window, *undo);
        const std::int64_t before = rawOf(fixture, 1, "position_p");
        fixture.workbench().writes().write(fixture.selection().current(),
                                           {{{QStringLiteral("position_p"), before + 8}}});
        QVERIFY(fixture.waitUntilIdle());
        QCOMPARE(rawOf(fixture, 1, "position_p"), before + 8);
        QTRY_VERIFY(undo->isEnabled());
        QCOMPARE(geometryIn(*fixture.window, *undo), place);
        auto* line = fixture.find<QLabel>("messageText");
        const QString result = line->text();
        QVERIFY(!result.isEmpty());

        for (auto* button : fixture.window->findChildren<QToolButton*>()) {
            if (!button->isVisible())
                continue;
            QTest::mouseMove(button, button->rect().center());
            QEnterEvent enter(button->rect().center(), button->rect().center(),
                              button->mapToGlobal(button->rect().center()));
            QApplication::sendEvent(button, &enter);
            QVERIFY2(line->isVisible() && undo->isVisible(), qPrintable(button->objectName()));
            QCOMPARE(line->text(), result);
        }
        for (QAction* menu : fixture.window->menuBar()->actions()) {
            for (QAction* action : menu->menu()->actions()) {
                action->showStatusText(fixture.window.get());
                QVERIFY2(line->isVisible() && undo->isVisible(), qPrintable(action->text()));
            }
        }
        QStatusTipEvent tip(QStringLiteral("something else"));
        QApplication::sendEvent(fixture.window.get(), &tip);
        QVERIFY(line->isVisible() && undo->isVisible());
        QCOMPARE(geometryIn(*fixture.window, *undo), place);

        QTest::mouseMove(undo, undo->rect().center());
        QTest::mouseClick(undo, Qt::LeftButton);
        QVERIFY(fixture.waitUntilIdle());
        QTRY_COMPARE(rawOf(fixture, 1, "position_p"), before);
        QTRY_VERIFY(!undo->isEnabled() && undo->isVisible());
    }
};

SERVODESK_TEST(TestStableLayout)
#include "tst_stable_layout.moc"
