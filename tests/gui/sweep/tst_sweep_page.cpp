// SPDX-License-Identifier: GPL-3.0-or-later
// The sweep page on the simulated bus: opening it moves nothing, it proposes a range and a delay
// that fit, tells when the delay is too short, asks before the first move, shows what is measured
// while it runs, ends by Stop and by Esc, and writes its report.
#include "device/motion/motion.h"
#include "gui/dialogs.h"
#include "gui/main_window_fixture.h"
#include "results/sweep_json.h"
#include "session/history/history_service.h"
#include "session/motion/motion_controller.h"
#include "session/sweep/sweep_test.h"
#include "sim/host/sim_link.h"
#include "support/real_time.h"
#include "support/test_main.h"
#include "ui/charts/trend_chart.h"
#include "ui/sweep/limits_dialog.h"
#include "ui/sweep/sweep_results.h"
#include "ui/sweep/sweep_servos.h"
#include "ui/sweep/sweep_verdict_model.h"
#include "ui/widgets/error_histogram.h"
#include "ui/widgets/verdict_banner.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFileDialog>
#include <QLabel>
#include <QLineEdit>
#include <QPointer>
#include <QPushButton>
#include <QSpinBox>
#include <QTabWidget>
#include <QTableView>
#include <QTableWidget>
#include <QToolButton>

namespace {

struct SweepPageFixture : gui::MainWindowFixture {
    explicit SweepPageFixture(const QString& language = QStringLiteral("en"))
        : MainWindowFixture(language)
    {
        page = QStringLiteral("sweep");
    }
    session::SweepTest& test() { return context.workbench.sweepTest(); }
    QString text(const char* name) { return find<QLabel>(name)->text(); }
    void click(const char* name)
    {
        auto* button = find<QAbstractButton>(name);
        QVERIFY2(button != nullptr, name);
        QTRY_VERIFY2(button->isEnabled(), name);
        QTest::mouseClick(button, Qt::LeftButton);
    }
    void type(const char* name, const QString& words)
    {
        auto* edit = find<QLineEdit>(name);
        QVERIFY2(edit != nullptr, name);
        edit->setFocus();
        edit->selectAll();
        QTest::keyClicks(edit, words);
    }
    bool proposed()
    {
        return support::waitFor(
            [this] { return text("sweepOutlook").contains(QLatin1String(" s")); });
    }
    /// A short one: a few hundred steps to and fro.
    void prepare(int cycles = 2, int delay = 700)
    {
        QVERIFY(proposed());
        type("sweepStart", QStringLiteral("1800"));
        type("sweepEnd", QStringLiteral("2200"));
        find<QSpinBox>("sweepCycles")->setValue(cycles);
        find<QSpinBox>("sweepPause")->setValue(delay);
    }
    /// Presses Run, and agrees to the question of the first time.
    void run()
    {
        click("sweepRun");
        if (auto* yes = find<QPushButton>("questionYes"))
            QTest::mouseClick(yes, Qt::LeftButton);
        QTRY_VERIFY(test().isRunning());
    }
    bool begun()
    {
        return support::waitFor(
            [this] { return test().run() != nullptr && !test().run()->servos[0].legs.empty(); });
    }
    bool over()
    {
        return support::waitFor([this] { return !test().isRunning(); });
    }
    std::int64_t now(const char* key)
    {
        (void)waitUntilIdle();
        workbench().writes().readTable(selection().current());
        (void)waitUntilIdle();
        return raw(key).value_or(-1);
    }
};

class TestSweepPage : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { gui::failOnWarnings(); }

    void openingMovesNothingAndSuggestsFittingValues()
    {
        SweepPageFixture fixture;
        QVERIFY(fixture.ready(1, QStringLiteral("sim:sweep")));
        QVERIFY(fixture.proposed());
        const int from = fixture.find<QLineEdit>("sweepStart")->text().toInt();
        const int to = fixture.find<QLineEdit>("sweepEnd")->text().toInt();
        QVERIFY(from > *fixture.raw("min_angle_limit"));
        QVERIFY(to < *fixture.raw("max_angle_limit"));
        QVERIFY(to - from > 3000);
        QTRY_VERIFY(fixture.text("sweepOutlook").contains(QLatin1String("long enough")));
        QCOMPARE(fixture.now("torque_switch"), 0);
        // One sentence and what one can do, no empty tables.
        QVERIFY(fixture.find<QLabel>("sweepNothing")->isVisible());
        QVERIFY(fixture.find<QPushButton>("sweepEmptyEarlier")->isVisible());
        QVERIFY(!fixture.find<QWidget>("sweepVerdict")->isVisible());
        QVERIFY(!fixture.find<QWidget>("sweepVerdictTable")->isVisible());
        QVERIFY(!fixture.find<QPushButton>("sweepStop")->isEnabled());
        QVERIFY(!fixture.find<QPushButton>("sweepReport_html")->isEnabled());
    }

    void theListOfServosIsAsHighAsItsRows_data()
    {
        QTest::addColumn<QString>("bus");
        QTest::newRow("one") << QStringLiteral("sim:sts3215@1");
        QTest::newRow("three") << QStringLiteral("sim:sweep");
    }

    void theListOfServosIsAsHighAsItsRows()
    {
        QFETCH(QString, bus);
        SweepPageFixture fixture;
        QVERIFY(fixture.ready(1, bus));
        auto* table = fixture.find<QTableWidget>("sweepServos");
        const int empty = 2 * table->rowHeight(0);
        const auto below = [&] {
            const QRect last = table->visualItemRect(table->item(table->rowCount() - 1, 0));
            return table->viewport()->height() - last.bottom();
        };
        QTRY_VERIFY2(below() >= 0 && below() < empty, qPrintable(QString::number(below())));
    }

    void aDelayShorterThanTheMoveIsReported()
    {
        SweepPageFixture fixture;
        QVERIFY(fixture.ready(1, QStringLiteral("sim:sweep")));
        QVERIFY(fixture.proposed());
        fixture.find<QSpinBox>("sweepPause")->setValue(200);
        QTRY_VERIFY(fixture.text("sweepOutlook").contains(QLatin1String("turn back")));
        // One click takes the time that is enough.
        Q_EMIT fixture.find<QLabel>("sweepOutlook")->linkActivated(QStringLiteral("enough"));
        QTRY_VERIFY(fixture.text("sweepOutlook").contains(QLatin1String("long enough")));
        QVERIFY(fixture.find<QSpinBox>("sweepPause")->value() > 1000);
    }

    void impossibleTestsAreReportedBeforehand_data()
    {
        QTest::addColumn<QString>("from");
        QTest::addColumn<QString>("to");
        QTest::addColumn<QString>("words");
        QTest::newRow("same") << "1000"
                              << "1000"
                              << "same position";
        QTest::newRow("outside") << "100"
                                 << "9000"
                                 << "outside";
        QTest::newRow("no number") << "abc"
                                   << "2000"
                                   << "whole raw number";
    }
    void impossibleTestsAreReportedBeforehand()
    {
        QFETCH(QString, from);
        QFETCH(QString, to);
        QFETCH(QString, words);
        SweepPageFixture fixture;
        QVERIFY(fixture.ready(1, QStringLiteral("sim:sweep")));
        QVERIFY(fixture.proposed());
        fixture.type("sweepStart", from);
        fixture.type("sweepEnd", to);
        QTRY_VERIFY2(fixture.text("sweepOutlook").contains(words),
                     qPrintable(fixture.text("sweepOutlook")));
        QVERIFY(!fixture.find<QPushButton>("sweepRun")->isEnabled());
    }

    void theFirstRunAsksAndNoCancels()
    {
        SweepPageFixture fixture;
        QVERIFY(fixture.ready(1, QStringLiteral("sim:sweep")));
        fixture.prepare();
        fixture.click("sweepRun");
        QDialog* question = fixture.question();
        QVERIFY(question != nullptr);
        const QString questionText = gui::labelsOf(question);
        QVERIFY2(questionText.contains(QStringLiteral("hold their position with torque on")),
                 qPrintable(questionText));
        gui::click(question, "questionNo");
        QVERIFY(!fixture.test().isRunning());
        QCOMPARE(fixture.now("torque_switch"), 0);
    }

    void runsShowsAndSaves()
    {
        SweepPageFixture fixture;
        QVERIFY(fixture.ready(1, QStringLiteral("sim:sweep")));
        fixture.prepare();
        fixture.run();
        QVERIFY(!fixture.find<QLineEdit>("sweepStart")->isEnabled());
        QVERIFY(fixture.begun());
        QTRY_VERIFY(fixture.test().store().count() > 50);
        QVERIFY(fixture.over());
        const results::SweepRun& run = *fixture.test().run();
        QCOMPARE(run.end, results::SweepEnd::Finished);
        QCOMPARE(int(run.servos[0].legs.size()), 4);
        QCOMPARE(fixture.find<QTableView>("sweepLegsTable")->model()->rowCount(), 4);
        QVERIFY(fixture.find<ui::ErrorHistogram>("sweepHistogram")->count() >= 3);
        QVERIFY(fixture.find<QTableView>("sweepVerdictTable")->model()->rowCount() > 5);
        const QString verdict = fixture.find<ui::VerdictBanner>("sweepVerdict")->text();
        QVERIFY2(verdict == QStringLiteral("✔ PASS") ||
                     verdict.startsWith(QStringLiteral("⚠ WARN: ")),
                 qPrintable(verdict));
        QCOMPARE(fixture.find<ui::TrendChart>("sweepChart")->channels().size(), std::size_t(2));
        QVERIFY(QFileInfo(fixture.test().readingsPath()).size() > 1000);
        QVERIFY(fixture.find<QLineEdit>("sweepStart")->isEnabled());
        QTemporaryDir place;
        for (const char* ending : {"json", "html", "csv", "pdf"}) {
            fixture.click(qPrintable(QStringLiteral("sweepReport_") + QLatin1String(ending)));
            auto* dialog = fixture.find<QFileDialog>("sweepReportDialog");
            QVERIFY(dialog != nullptr);
            const QString path = place.filePath(QStringLiteral("r.") + QLatin1String(ending));
            QSignalSpy saved(&fixture.test(), &session::SweepTest::saved);
            Q_EMIT dialog->fileSelected(path);
            dialog->close();
            QVERIFY(saved.wait(10000));
            QVERIFY(QFileInfo(path).size() > 100);
            const QString readings = place.filePath(QStringLiteral("r.readings.csv"));
            QVERIFY2(QFileInfo(readings).size() > 1000, ending);
            QVERIFY(QFile::remove(readings));
            QTRY_VERIFY(fixture.find<QFileDialog>("sweepReportDialog") == nullptr);
        }
        const auto read = results::loadSweepRun(place.filePath(QStringLiteral("r.json")));
        QVERIFY(read.has_value());
        QCOMPARE(read->servos[0].legs.size(), run.servos[0].legs.size());
        // A report that cannot be written is told, and the test is not lost.
        QSignalSpy failed(&fixture.test(), &session::SweepTest::saveFailed);
        fixture.test().save(QStringLiteral("/proc/none/r.html"), false);
        QVERIFY(failed.wait(10000));
        QVERIFY(fixture.find<QLabel>("sweepSaved")->isVisible());
    }

    void stopHoldsOrReleasesTorque_data()
    {
        QTest::addColumn<int>("choice");
        QTest::addColumn<int>("torque");
        QTest::newRow("hold") << 0 << 1;
        QTest::newRow("release") << 1 << 0;
    }
    void stopHoldsOrReleasesTorque()
    {
        QFETCH(int, choice);
        QFETCH(int, torque);
        SweepPageFixture fixture;
        QVERIFY(fixture.ready(1, QStringLiteral("sim:sweep")));
        fixture.prepare(50);
        fixture.find<QComboBox>("sweepAfterwards")->setCurrentIndex(choice);
        fixture.run();
        QVERIFY(fixture.begun());
        fixture.click("sweepStop");
        QVERIFY(fixture.over());
        QCOMPARE(fixture.test().run()->end, results::SweepEnd::Stopped);
        QVERIFY(!fixture.test().run()->servos[0].legs.empty());
        QCOMPARE(fixture.test().run()->servos[0].verdict, results::Grade::NotMeasured);
        QCOMPARE(fixture.find<ui::VerdictBanner>("sweepVerdict")->text(),
                 QStringLiteral("– NO VERDICT: Stopped by the user."));
        QCOMPARE(int(fixture.now("torque_switch")), torque);
    }

    void escTakesTorqueOffAndEndsTheTest()
    {
        SweepPageFixture fixture;
        QVERIFY(fixture.ready(1, QStringLiteral("sim:sweep")));
        fixture.prepare(50);
        fixture.run();
        QVERIFY(fixture.begun());
        QTest::keyClick(fixture.window.get(), Qt::Key_Escape);
        QVERIFY(fixture.over());
        QCOMPARE(fixture.test().run()->end, results::SweepEnd::Emergency);
        QCOMPARE(fixture.now("torque_switch"), 0);
        QVERIFY(!fixture.test().run()->servos[0].legs.empty());
        // Until torque has been switched on again nothing moves, and it says so.
        QTRY_VERIFY(fixture.text("sweepOutlook").contains(QStringLiteral("torque is off: ID 1.")));
        QVERIFY(!fixture.find<QPushButton>("sweepRun")->isEnabled());
        QCOMPARE(fixture.now("torque_switch"), 0);
        // Nor when it is asked to in another way; then the banner says so.
        session::SweepTestRequest order;
        order.spec = fixture.test().run()->spec;
        order.servos = fixture.test().servos();
        order.limits = {fixture.test().run()->servos[0].limits};
        QVERIFY(fixture.test().start(order));
        QTRY_VERIFY(!fixture.test().isRunning());
        QVERIFY(fixture.find<QWidget>("sweepBanner")->isVisible());
        QCOMPARE(fixture.now("torque_switch"), 0);
        // One click beside Run allows it; the servo holds its place, and the next run asks again.
        QTRY_COMPARE(fixture.now("present_speed"), 0); // without torque it coasts
        const qint64 place = fixture.now("present_position");
        QVERIFY(fixture.find<QPushButton>("sweepAllow")->isVisible());
        fixture.click("sweepAllow");
        QVERIFY(gui::labelsOf(fixture.question()).contains(QStringLiteral("torque off for ID 1.")));
        gui::click(fixture.question(), "questionNo");
        QCOMPARE(fixture.now("torque_switch"), 0);
        fixture.click("sweepAllow");
        gui::click(fixture.question(), "questionYes");
        QTRY_VERIFY(fixture.find<QPushButton>("sweepRun")->isEnabled());
        QVERIFY(!fixture.find<QPushButton>("sweepAllow")->isVisible());
        QCOMPARE(fixture.now("torque_switch"), 1);
        const qint64 held = fixture.now("present_position");
        QVERIFY2(std::abs(held - place) < 20,
                 qPrintable(QStringLiteral("%1 %2").arg(place).arg(held)));
        fixture.click("sweepRun");
        QVERIFY(fixture.question() != nullptr);
    }

    /// What is looked at elsewhere is not what is tested.
    void checksStayWhenAnotherServoIsSelected()
    {
        SweepPageFixture fixture;
        QVERIFY(fixture.ready(1, QStringLiteral("sim:sts3215@1,sts3215@2,sts3215@3")));
        QTRY_COMPARE(fixture.workbench().registry().order().size(), std::size_t(3));
        auto* table = fixture.find<QTableWidget>("sweepServos");
        QTRY_COMPARE(table->rowCount(), 3);
        const auto ticks = [table] {
            QList<bool> selected;
            for (int row = 0; row < table->rowCount(); ++row)
                selected.append(table->item(row, 0)->checkState() == Qt::Checked);
            return selected;
        };
        QTRY_COMPARE(ticks(), (QList<bool>{true, false, false}));
        table->item(2, 0)->setCheckState(Qt::Checked);
        fixture.selection().select(fixture.workbench().registry().order()[1]);
        QTest::qWait(100); // a tick that must not change announces nothing to wait for
        QCOMPARE(ticks(), (QList<bool>{true, false, true}));
        // Without a tick of the user's own the selection is what is tested.
        table->item(0, 0)->setCheckState(Qt::Unchecked);
        table->item(2, 0)->setCheckState(Qt::Unchecked);
        fixture.selection().select(fixture.workbench().registry().order()[2]);
        QTRY_COMPARE(ticks(), (QList<bool>{false, false, true}));
    }

    /// The plug is out when the key is pressed: the stop waits for it, and is proved like any.
    void escWhileUnpluggedIsVerifiedToo()
    {
        SweepPageFixture fixture;
        QVERIFY(fixture.ready(1, QStringLiteral("sim:sweep")));
        fixture.prepare(50);
        fixture.run();
        QVERIFY(fixture.begun());
        bool proved = false;
        QObject::connect(&fixture.workbench(), &session::Workbench::eventOccurred,
                         &fixture.workbench(), [&](const session::Event& event) {
                             proved |= event.kind == session::Event::Kind::StopVerified &&
                                       !event.stop.off.empty();
                         });
        const auto wire = fixture.workbench().link().connection()->simulation();
        wire->with([](sim::VirtualBus& bus) { bus.cutLink(); });
        QTRY_VERIFY(fixture.workbench().link().connection()->bus().isReconnecting());
        QTest::keyClick(fixture.window.get(), Qt::Key_Escape);
        wire->with([](sim::VirtualBus& bus) { bus.restoreLink(); });
        QVERIFY(fixture.over());
        QTRY_VERIFY(proved);
        QCOMPARE(fixture.now("torque_switch"), 0);
    }

    /// While the test waits, in words and in the list; once the line is back Run can be used again.
    void aSilentBusIsReported()
    {
        SweepPageFixture fixture;
        QVERIFY(fixture.ready(1, QStringLiteral("sim:sweep")));
        fixture.prepare(50);
        fixture.run();
        QVERIFY(fixture.begun());
        const auto lose = [&fixture](double share) {
            fixture.workbench().link().connection()->simulation()->with(
                [share](sim::VirtualBus& bus) { bus.config().faults.dropRequest = share; });
        };
        lose(1);
        QTRY_COMPARE(fixture.find<ui::VerdictBanner>("sweepVerdict")->text(),
                     QStringLiteral("RUNNING: no reply"));
        QVERIFY(fixture.test().isRunning());
        QVERIFY2(fixture.text("sweepProgressWords").startsWith(QLatin1String("No reply from ID 1")),
                 qPrintable(fixture.text("sweepProgressWords")));
        QTRY_VERIFY(fixture.entry().silent);
        QVERIFY(fixture.over());
        QCOMPARE(fixture.test().run()->end, results::SweepEnd::LinkLost);
        QTRY_VERIFY(fixture.find<QWidget>("sweepBanner")->isVisible());
        QTRY_VERIFY(fixture.text("sweepOutlook").contains(QLatin1String("no reply")));
        QVERIFY(!fixture.find<QPushButton>("sweepRun")->isEnabled());
        lose(0);
        QTRY_VERIFY(!fixture.entry().silent);
        QTRY_VERIFY(fixture.find<QPushButton>("sweepRun")->isEnabled());
        QVERIFY(!fixture.text("sweepOutlook").contains(QLatin1String("no reply")));
        QCOMPARE(fixture.find<QLineEdit>("sweepStart")->text(), QStringLiteral("1800"));
    }

    /// Torque is switched off first, then the mode put back where interrupted writes are settled.
    static void verifyRestoredModeIsNotReported(SweepPageFixture& fixture)
    {
        auto* banner = fixture.find<QWidget>("sweepBanner");
        const auto says = [banner](const char* words) {
            return gui::labelsOf(banner).contains(QLatin1String(words));
        };
        QVERIFY(banner->isVisible() && says("Torque could not be turned off"));
        QString uuid;
        QObject::connect(&fixture.workbench().recovery(),
                         &session::RecoveryService::openIntentsFound, banner,
                         [&uuid](const std::vector<jobs::RecoveryResult>& found) {
                             if (!found.empty())
                                 uuid = found.front().before.intent.uuid;
                         });
        const auto search = [&fixture] {
            fixture.workbench().search().start(fixture.workbench().search().lastSpec());
            QTRY_VERIFY(!fixture.workbench().search().isSearching());
        };
        search();
        QVERIFY(fixture.workbench().registry().order().empty());
        fixture.workbench().link().connection()->simulation()->with([](sim::VirtualBus& bus) {
            bus.config().faults.dropRequest = 0;
            bus.servo(1)->poke(QStringLiteral("torque_switch"), 0);
        });
        search(); // it enters the list anew
        QTRY_VERIFY(!says("Torque could not be turned off"));
        QVERIFY(banner->isVisible() && says("Test settings are still in effect"));
        fixture.workbench().recovery().findOpenIntents();
        QTRY_VERIFY(!uuid.isEmpty());
        fixture.workbench().recovery().recoverIntent(uuid, jobs::RecoveryAction::Undo);
        QTRY_VERIFY(!banner->isVisible());
    }

    /// The test had switched the mode, and the link is lost before it could be put back.
    void anUnrestoredModeIsReported()
    {
        SweepPageFixture fixture;
        QVERIFY(fixture.ready(1, QStringLiteral("sim:sts3215@1")));
        fixture.context.workbench.motion().setServos({fixture.selection().current()});
        fixture.context.workbench.motion().switchMode(QStringLiteral("speed"));
        auto* tick = fixture.find<QCheckBox>("sweepSwitchMode");
        QTRY_VERIFY(tick->isVisible());
        tick->setChecked(true);
        fixture.type("sweepStart", QStringLiteral("1800"));
        fixture.type("sweepEnd", QStringLiteral("2200"));
        fixture.find<QSpinBox>("sweepCycles")->setValue(50);
        QTRY_VERIFY(fixture.find<QPushButton>("sweepRun")->isEnabled());
        fixture.run();
        QVERIFY(fixture.begun());
        fixture.workbench().link().connection()->simulation()->with(
            [](sim::VirtualBus& bus) { bus.config().faults.dropRequest = 1; });
        QVERIFY(fixture.over());
        QCOMPARE(fixture.test().run()->end, results::SweepEnd::LinkLost);
        QString questionText;
        for (const QLabel* label : fixture.find<QWidget>("sweepBanner")->findChildren<QLabel*>())
            questionText += label->text();
        for (const char* part : {"Test settings are still in effect: ID 1: ", "(old value 1)",
                                 "Interrupted writes", "Torque could not be turned off: ID 1"})
            QVERIFY2(questionText.contains(QLatin1String(part)), qPrintable(questionText));
        verifyRestoredModeIsNotReported(fixture);
    }

    /// However often its servos are read meanwhile, and also if nothing reads them.
    void aRestoredBusIsNoticed_data()
    {
        QTest::addColumn<bool>("polled");
        QTest::newRow("read all the time") << true;
        QTest::newRow("read by nothing else") << false;
    }
    void aRestoredBusIsNoticed()
    {
        QFETCH(const bool, polled);
        SweepPageFixture fixture;
        QVERIFY(fixture.ready(1, QStringLiteral("sim:sts3215@1,sts3215@2")));
        fixture.prepare();
        auto* table = fixture.find<QTableWidget>("sweepServos");
        table->item(1, 0)->setCheckState(Qt::Checked);
        QTRY_VERIFY(fixture.find<QPushButton>("sweepRun")->isEnabled());
        if (polled) {
            fixture.workbench().polling().subscribe(
                QStringLiteral("test"),
                {{{fixture.selection().current(), {QStringLiteral("present_position")}}}, {}});
        }
        const auto lose = [&fixture](double share) {
            fixture.workbench().link().connection()->simulation()->with(
                [share](sim::VirtualBus& bus) { bus.config().faults.dropRequest = share; });
        };
        lose(1);
        if (polled)
            QTRY_VERIFY(fixture.entry().silent);
        else
            fixture.find<QSpinBox>("sweepCycles")->setValue(3); // the test is looked at anew
        QTRY_VERIFY(fixture.text("sweepOutlook").contains(QLatin1String("no reply")));
        QVERIFY(!fixture.find<QPushButton>("sweepRun")->isEnabled());
        lose(0);
        QTRY_VERIFY(fixture.find<QPushButton>("sweepRun")->isEnabled());
        QVERIFY(!fixture.text("sweepOutlook").contains(QLatin1String("no reply")));
    }

    /// Run is blocked with the first word of it, not only once the silent servos have been read.
    void silentServosBlockRun()
    {
        SweepPageFixture fixture;
        QVERIFY(fixture.ready(1, QStringLiteral("sim:sts3215@1,sts3215@2")));
        fixture.prepare();
        fixture.find<QTableWidget>("sweepServos")->item(1, 0)->setCheckState(Qt::Checked);
        auto* run = fixture.find<QPushButton>("sweepRun");
        QTRY_VERIFY(run->isEnabled());
        session::Subscription subscription;
        const auto servos = fixture.workbench().registry().order();
        for (const session::ServoRef ref : servos)
            subscription.parts.push_back({ref, {QStringLiteral("present_position")}});
        fixture.workbench().polling().subscribe(QStringLiteral("test"), subscription);
        const auto silent = [&] {
            return std::any_of(servos.begin(), servos.end(), [&](session::ServoRef ref) {
                return fixture.workbench().registry().servo(ref)->silent;
            });
        };
        bool blocked = true;
        int seen = 0;
        QObject::connect(&fixture.workbench().registry(), &session::ServoRegistry::servoChanged,
                         run, [&](session::ServoRef ref) {
                             if (!fixture.workbench().registry().servo(ref)->silent)
                                 return;
                             ++seen;
                             blocked =
                                 blocked && !run->isEnabled() &&
                                 fixture.text("sweepOutlook").contains(QLatin1String("no reply"));
                         });
        const auto lose = [&fixture](double share) {
            fixture.workbench().link().connection()->simulation()->with(
                [share](sim::VirtualBus& bus) { bus.config().faults.dropRequest = share; });
        };
        lose(1);
        QTRY_VERIFY(seen > 0 && silent());
        QVERIFY(blocked);
        QVERIFY(!run->isEnabled());
        lose(0);
        QTRY_VERIFY(run->isEnabled() && !silent());
        QVERIFY(blocked);
    }

    void inputForAServoIsRestoredWithIt()
    {
        SweepPageFixture fixture;
        QVERIFY(fixture.ready(1, QStringLiteral("sim:sts3215@1,sts3215@2")));
        fixture.prepare(2, 900);
        QVERIFY(fixture.choose(2));
        auto* start = fixture.find<QLineEdit>("sweepStart");
        QTRY_VERIFY(start->text() != QLatin1String("1800")); // its own proposal
        const QString proposed = start->text();
        QVERIFY(fixture.choose(1));
        QTRY_COMPARE(start->text(), QStringLiteral("1800"));
        QCOMPARE(fixture.find<QLineEdit>("sweepEnd")->text(), QStringLiteral("2200"));
        QCOMPARE(fixture.find<QSpinBox>("sweepPause")->value(), 900);
        fixture.click("sweepRun");
        QDialog* question = fixture.question();
        QVERIFY(question != nullptr);
        const QString questionText = gui::labelsOf(question);
        QVERIFY2(questionText.contains(QStringLiteral("1800 … 2200")), qPrintable(questionText));
        gui::click(question, "questionNo");
        QVERIFY(fixture.choose(2));
        QTRY_COMPARE(start->text(), proposed);
    }

    void closingThePortEndsAndSavesTheTest()
    {
        SweepPageFixture fixture;
        QVERIFY(fixture.ready(1, QStringLiteral("sim:sweep")));
        fixture.prepare(5000);
        fixture.run();
        QVERIFY(fixture.begun());
        QSignalSpy kept(&fixture.context.workbench.history(), &session::HistoryService::runSaved);
        const auto answer = [&fixture](const char* button) {
            fixture.action(ui::Command::Disconnect)->trigger();
            auto* choice = fixture.find<QPushButton>(button);
            QVERIFY(choice != nullptr);
            QPointer<QWidget> dialog = choice->window();
            QTest::mouseClick(choice, Qt::LeftButton);
            QTRY_VERIFY(dialog == nullptr);
        };
        answer("questionNo");
        QVERIFY(fixture.test().isRunning());
        QCOMPARE(fixture.workbench().link().state(), session::LinkState::Open);
        answer("questionYes");
        QTRY_COMPARE(fixture.workbench().link().state(), session::LinkState::Off);
        QVERIFY(!fixture.test().isRunning());
        QCOMPARE(fixture.test().run()->end, results::SweepEnd::Stopped);
        QTRY_COMPARE(kept.size(), 1);
    }

    void aTestThatCannotStartKeepsThePreviousResult()
    {
        SweepPageFixture fixture;
        QVERIFY(fixture.ready(1, QStringLiteral("sim:sweep")));
        fixture.prepare(1);
        fixture.run();
        QVERIFY(fixture.begun());
        QVERIFY(fixture.over());
        session::SweepTestRequest wrong;
        wrong.spec.range = {QStringLiteral("1000"), QStringLiteral("1000")};
        wrong.servos = {fixture.selection().current()};
        wrong.limits.resize(1);
        QSignalSpy failed(&fixture.test(), &session::SweepTest::failed);
        QVERIFY(fixture.test().start(wrong));
        QVERIFY(failed.wait(10000));
        QTemporaryDir place;
        QSignalSpy saved(&fixture.test(), &session::SweepTest::saved);
        fixture.test().save(place.filePath(QStringLiteral("r.csv")), false);
        QVERIFY(saved.wait(10000));
        QVERIFY(QFileInfo::exists(place.filePath(QStringLiteral("r.readings.csv"))));
    }

    void theTestHasTheBusExclusively()
    {
        SweepPageFixture fixture;
        QVERIFY(fixture.ready(1, QStringLiteral("sim:sweep")));
        fixture.prepare(50);
        fixture.run();
        QVERIFY(fixture.begun());
        QVERIFY(!fixture.action(ui::Command::Search)->isEnabled());
        QVERIFY(!fixture.action(ui::Command::SetId)->isEnabled());
        QSignalSpy eventSpy(&fixture.workbench(), &session::Workbench::eventOccurred);
        fixture.workbench().writes().write(fixture.selection().current(),
                                           {{{QStringLiteral("position_p"), 20}}});
        QTRY_VERIFY(!eventSpy.empty());
        fixture.workbench().search().start({});
        QVERIFY(!fixture.workbench().search().isSearching());
        fixture.click("sweepStop");
        QVERIFY(fixture.over());
        QTRY_VERIFY(fixture.action(ui::Command::Search)->isEnabled());
        QCOMPARE(fixture.now("position_p"), 32);
    }

    void severalServosEachWithItsRange()
    {
        SweepPageFixture fixture;
        QVERIFY(fixture.ready(1, QStringLiteral("sim:sweep")));
        fixture.prepare(1);
        auto* table = fixture.find<QTableWidget>("sweepServos");
        QTRY_COMPARE(table->rowCount(), 3);
        table->item(1, 0)->setCheckState(Qt::Checked);
        table->item(1, 1)->setText(QStringLiteral("1000"));
        table->item(1, 2)->setText(QStringLiteral("1300"));
        fixture.run();
        QVERIFY(fixture.begun());
        QVERIFY(fixture.over());
        const results::SweepRun& run = *fixture.test().run();
        QCOMPARE(int(run.servos.size()), 2);
        QCOMPARE(run.servos[0].axis.from, 1800.0);
        QCOMPARE(run.servos[1].axis.from, 1000.0);
        QCOMPARE(run.servos[1].axis.to, 1300.0);
        auto* second = fixture.find<QAbstractButton>("verdictChip_1");
        QVERIFY(second->isVisible());
        QVERIFY(fixture.find<QAbstractButton>("verdictChip_2") == nullptr);
        second->click();
        QVERIFY(second->isChecked());
        QCOMPARE(int(fixture.find<ui::SweepResults>("sweepResults")->shownServo()), 1);
    }

    /// Of two servos only the second one fails: the banner says so whichever is shown.
    void theWorstServoCounts()
    {
        const support::RealTime realTime;
        SweepPageFixture fixture;
        QVERIFY(fixture.ready(1, QStringLiteral("sim:sts3215@1,sts3215@2+overshoot=12")));
        fixture.prepare(1, 1500);
        auto* table = fixture.find<QTableWidget>("sweepServos");
        QTRY_COMPARE(table->rowCount(), 2);
        QVERIFY(table->isColumnHidden(3)); // nothing has been tested
        table->item(1, 0)->setCheckState(Qt::Checked);
        fixture.run();
        QVERIFY(fixture.begun());
        // While it runs a click shows a servo, but takes none out of the test or gives it a range.
        auto* results = fixture.find<ui::SweepResults>("sweepResults");
        for (const int row : {1, 0}) {
            const QRect servo = table->visualItemRect(table->item(row, 0));
            QTest::mouseClick(table->viewport(), Qt::LeftButton, {}, servo.center());
            QCOMPARE(int(results->shownServo()), row);
            QTest::keyClick(table, Qt::Key_Space);
            QCOMPARE(table->item(row, 0)->checkState(), Qt::Checked);
            QTest::mouseDClick(table->viewport(), Qt::LeftButton, {},
                               table->visualItemRect(table->item(row, 1)).center());
            QVERIFY(table->viewport()->findChild<QLineEdit*>() == nullptr);
        }
        QVERIFY(!fixture.find<QWidget>("sweepCycles")->isEnabled());
        QVERIFY(!fixture.find<QWidget>("sweepLimits")->isEnabled());
        QVERIFY(fixture.test().isRunning());
        QVERIFY(fixture.over());
        QTRY_VERIFY(fixture.find<QWidget>("sweepCycles")->isEnabled());
        const results::SweepRun& run = *fixture.test().run();
        QCOMPARE(int(run.servos.size()), 2);
        QVERIFY(run.servos[0].verdict != results::Grade::Fail);
        QCOMPARE(run.servos[1].verdict, results::Grade::Fail);
        auto* verdict = fixture.find<ui::VerdictBanner>("sweepVerdict");
        const QString failed = QStringLiteral("✘ FAIL: ID 2");
        QCOMPARE(int(results->shownServo()), 0);
        QVERIFY2(verdict->text().startsWith(failed), qPrintable(verdict->text()));
        QVERIFY(verdict->text().contains(QStringLiteral("Overshoot")));
        QVERIFY(!table->isColumnHidden(3));
        QVERIFY(!table->item(0, 3)->text().contains(QLatin1String("Fail")));
        QCOMPARE(table->item(1, 3)->text(), QStringLiteral("✘ Fail"));
        const auto cell = [&](int row) { return table->visualItemRect(table->item(row, 3)); };
        for (const int row : {1, 0}) {
            QTest::mouseClick(table->viewport(), Qt::LeftButton, {}, cell(row).center());
            QCOMPARE(int(results->shownServo()), row);
            QVERIFY(verdict->text().startsWith(failed));
        }
        auto* second = fixture.find<QAbstractButton>("verdictChip_1");
        QCOMPARE(second->text(), QStringLiteral("✘ ID 2"));
        second->click();
        QCOMPARE(table->currentRow(), 1);
        // What failed stands on top, and is in sight in the smallest window.
        auto* metrics = fixture.find<QTableView>("sweepVerdictTable");
        const int grade = static_cast<int>(ui::VerdictColumn::Grade);
        QCOMPARE(metrics->model()->index(0, grade).data().toString(), QStringLiteral("✘ Fail"));
        fixture.window->resize(1024, 700);
        QTRY_VERIFY(!fixture.find<QPushButton>("sweepReport_html")->isVisible()); // behind a tab
        QTRY_VERIFY(metrics->viewport()->rect().contains(
            metrics->visualRect(metrics->model()->index(0, grade))));
        // Where no servo was chosen, the worst one is shown at the end.
        QTRY_VERIFY(fixture.find<QPushButton>("sweepRun")->isEnabled());
        fixture.click("sweepRun");
        QTRY_VERIFY(fixture.test().isRunning());
        QTRY_COMPARE(int(results->shownServo()), 0);
        QVERIFY(fixture.over());
        QCOMPARE(int(results->shownServo()), 1);
    }

    void switchingFromWheelModeIsOffered()
    {
        SweepPageFixture fixture;
        QVERIFY(fixture.ready(1, QStringLiteral("sim:sweep")));
        fixture.workbench().writes().write(
            fixture.selection().current(),
            {{{QStringLiteral("operating_mode"), 1}}, true, device::Consent::confirmed()});
        QVERIFY(fixture.waitUntilIdle());
        fixture.find<QSpinBox>("sweepPause")->setValue(700);
        auto* tick = fixture.find<QCheckBox>("sweepSwitchMode");
        QTRY_VERIFY(tick->isVisible());
        QVERIFY(!fixture.find<QPushButton>("sweepRun")->isEnabled());
        tick->click();
        fixture.type("sweepStart", QStringLiteral("1800"));
        fixture.type("sweepEnd", QStringLiteral("2200"));
        fixture.find<QSpinBox>("sweepCycles")->setValue(1);
        fixture.click("sweepRun");
        QDialog* question = fixture.question();
        QVERIFY(question != nullptr);
        const QString questionText = gui::labelsOf(question);
        QVERIFY2(questionText.contains(QLatin1String("torque is off on servos")),
                 qPrintable(questionText));
        gui::click(question, "questionYes");
        QVERIFY(fixture.begun());
        QVERIFY(fixture.over());
        QVERIFY(fixture.test().run() != nullptr);
        QCOMPARE(fixture.test().run()->end, results::SweepEnd::Finished);
        QCOMPARE(fixture.now("operating_mode"), 1);
        QCOMPARE(fixture.now("torque_switch"), 0);
    }

    void limitsAreEditedForTheModel()
    {
        const support::RealTime realTime;
        SweepPageFixture fixture;
        QVERIFY(fixture.ready(1, QStringLiteral("sim:sweep")));
        fixture.prepare(1);
        fixture.click("sweepLimits");
        auto* dialog = fixture.window->findChild<ui::LimitsDialog*>();
        QVERIFY(dialog != nullptr);
        results::SweepLimits strict = dialog->limits();
        strict.name = QStringLiteral("strict");
        strict.lines = {{QStringLiteral("time_to_target"), QStringLiteral("ms"), {}, 1.0}};
        Q_EMIT dialog->limitsAccepted(strict);
        dialog->close();
        QVERIFY(fixture.text("sweepLimitsName").contains(QLatin1String("strict")));
        // The next start of the program knows them, too.
        ui::SweepServos later(fixture.workbench().registry(), fixture.selection(), fixture.settings,
                              nullptr);
        QCOMPARE(later.limits(fixture.selection().current()), strict);
        fixture.run();
        QVERIFY(fixture.begun());
        QVERIFY(fixture.over());
        QCOMPARE(fixture.test().run()->servos[0].verdict, results::Grade::Fail);
        QVERIFY(fixture.find<ui::VerdictBanner>("sweepVerdict")
                    ->text()
                    .contains(QLatin1String("time"), Qt::CaseInsensitive));
    }

    void isTranslatedToChinese()
    {
        SweepPageFixture fixture(QStringLiteral("zh_CN"));
        QVERIFY(fixture.ready(1, QStringLiteral("sim:sweep")));
        QVERIFY(fixture.find<QPushButton>("sweepRun")->text().contains(QChar(0x8fd0)));
        QTRY_VERIFY(fixture.text("sweepOutlook").contains(QStringLiteral("延时")));
        fixture.setLanguage(QStringLiteral("en"));
        QTRY_VERIFY(fixture.text("sweepOutlook").contains(QLatin1String("delay")));
    }
};
} // namespace

SERVODESK_TEST(TestSweepPage)
#include "tst_sweep_page.moc"
