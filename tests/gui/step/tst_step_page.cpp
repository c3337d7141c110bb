// SPDX-License-Identifier: GPL-3.0-or-later
// The step page on a simulated bus: opening it moves nothing, the first run asks, a trial is over
// when its run is, both are laid over each other, advice goes into Trial, Keep gains keeps and
// Discard takes back. Whatever is written is asked of the simulation's own table by reading.
#include "gui/main_window_fixture.h"
#include "results/step_json.h"
#include "session/motion/motion_controller.h"
#include "session/step/step_test.h"
#include "sim/host/sim_link.h"
#include "support/test_main.h"
#include "ui/charts/trend_chart.h"
#include "ui/step/step_page.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFileDialog>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSpinBox>
#include <QTableWidget>

namespace {

/// The page beside the window, on the same bench.
struct StepPageFixture : gui::MainWindowFixture {
    explicit StepPageFixture(const QString& language = QStringLiteral("en"))
        : MainWindowFixture(language)
        , lab(std::make_unique<ui::StepPage>(context, settings))
    {
        lab->resize(1000, 640);
        lab->show();
    }
    template <typename Widget>
    Widget* own(const char* name)
    {
        return lab->findChild<Widget*>(QString::fromLatin1(name));
    }
    session::StepTest& test() { return lab->test(); }
    QSpinBox* tried(const char* key)
    {
        return lab->findChild<QSpinBox*>(QStringLiteral("stepTry_") + QString::fromLatin1(key));
    }
    void click(const char* name)
    {
        auto* button = own<QPushButton>(name);
        QVERIFY2(button != nullptr, name);
        QTRY_VERIFY2(button->isEnabled(), name);
        QTest::mouseClick(button, Qt::LeftButton);
    }
    void type(const char* size)
    {
        auto* edit = own<QLineEdit>("stepSize");
        edit->setFocus();
        edit->selectAll();
        QTest::keyClicks(edit, QString::fromLatin1(size));
    }
    void setShortRun()
    {
        type("300");
        own<QSpinBox>("stepRepeats")->setValue(1);
        own<QSpinBox>("stepHold")->setValue(500);
    }
    /// Presses it, agrees to the question of the first time, and waits for the end.
    bool run(const char* name)
    {
        const std::size_t runs = test().runs().size();
        click(name);
        if (auto* yes = own<QPushButton>("questionYes"))
            QTest::mouseClick(yes, Qt::LeftButton);
        return support::waitFor([&] { return !test().isRunning() && test().runs().size() > runs; });
    }
    std::int64_t now(const char* key)
    {
        (void)waitUntilIdle();
        workbench().writes().readTable(selection().current());
        (void)waitUntilIdle();
        return raw(key).value_or(-1);
    }

    std::unique_ptr<ui::StepPage> lab;
};
} // namespace

class TestStepPage : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { gui::failOnWarnings(); }

    void openingMovesNothing()
    {
        StepPageFixture fixture;
        QVERIFY(!fixture.own<QPushButton>("stepRun")->isEnabled());
        QCOMPARE(fixture.own<QLabel>("stepWhy")->text(),
                 QStringLiteral("Connect to a port first."));
        QVERIFY(fixture.ready(1, QStringLiteral("sim:sts3215@1")));
        QTRY_VERIFY(fixture.own<QPushButton>("stepRun")->isEnabled());
        QCOMPARE(fixture.now("torque_switch"), 0);
        QTRY_COMPARE(fixture.tried("position_p")->value(), int(*fixture.raw("position_p")));
        QVERIFY(!fixture.own<QPushButton>("stepTry")->isEnabled());
        QVERIFY(fixture.own<QPushButton>("stepTry")->toolTip().contains(
            QLatin1String("Change a value")));
        QVERIFY(!fixture.own<QPushButton>("stepAccept")->isEnabled());
        QVERIFY(!fixture.own<QPushButton>("stepBack")->isEnabled());
        QVERIFY(!fixture.own<QLineEdit>("stepSize")->text().isEmpty());
        QVERIFY(fixture.own<QLabel>("stepNothing")->isVisible());
    }

    void theFirstRunAsksForConfirmation()
    {
        StepPageFixture fixture;
        QVERIFY(fixture.ready(1, QStringLiteral("sim:sts3215@1")));
        fixture.setShortRun();
        fixture.click("stepRun");
        auto* no = fixture.own<QPushButton>("questionNo");
        QVERIFY(no != nullptr);
        QTest::mouseClick(no, Qt::LeftButton);
        QVERIFY(!fixture.test().isRunning());
        QCOMPARE(fixture.now("torque_switch"), 0);
    }

    void aTrialEndsWithItsRun()
    {
        StepPageFixture fixture;
        QVERIFY(fixture.ready(1, QStringLiteral("sim:sts3215@1")));
        fixture.setShortRun();
        QTRY_VERIFY(fixture.tried("position_p")->isEnabled());
        QVERIFY(fixture.run("stepRun"));
        auto* figures = fixture.own<QTableWidget>("stepFigures");
        QVERIFY(figures->rowCount() > 6);
        QVERIFY(figures->isColumnHidden(1)); // nothing to compare with
        fixture.tried("position_p")->setValue(10);
        fixture.tried("position_d")->setValue(0);
        QVERIFY(fixture.run("stepTry"));
        QCOMPARE(fixture.now("position_p"), 32);
        QCOMPARE(fixture.now("position_d"), 32);
        QCOMPARE(fixture.tried("position_p")->value(), 10); // still there to be accepted
        QVERIFY(!figures->isColumnHidden(1));
        const auto& channels = fixture.own<ui::TrendChart>("stepChart")->channels();
        QCOMPARE(channels.size(), std::size_t(3)); // both runs and the target
        QVERIFY(channels[2].name.contains(QLatin1String("Position loop P 10")));
        // The weak one rests beside its target, and the sheet knows what to do.
        auto* take = fixture.own<QPushButton>("stepTake_position_i");
        QVERIFY(take != nullptr);
        QTest::mouseClick(take, Qt::LeftButton);
        QCOMPARE(fixture.tried("position_i")->value(), 1);
        QCOMPARE(fixture.now("position_i"), 0);
        // The other direction can be looked at, too.
        auto* choice = fixture.own<QComboBox>("stepChoice");
        QCOMPARE(choice->count(), 2);
        QTest::keyClick(choice, Qt::Key_Down);
        QCOMPARE(fixture.own<ui::TrendChart>("stepChart")->channels().size(), std::size_t(3));
    }

    void acceptSavesAndRevertRestores()
    {
        StepPageFixture fixture;
        QVERIFY(fixture.ready(1, QStringLiteral("sim:sts3215@1")));
        QTRY_VERIFY(fixture.tried("position_p")->isEnabled());
        fixture.tried("position_p")->setValue(36);
        fixture.click("stepAccept");
        QTRY_COMPARE(*fixture.raw("position_p"), 36);
        QTRY_VERIFY(fixture.own<QPushButton>("stepBack")->isEnabled());
        QCOMPARE(fixture.test().previousValues(fixture.selection().current()).size(),
                 std::size_t(1));
        // For good: a power cycle does not change it.
        fixture.workbench().link().powerCycle();
        QCOMPARE(fixture.now("position_p"), 36);
        QTRY_VERIFY(fixture.own<QPushButton>("stepBack")->toolTip().contains(QLatin1String("32")));
        // Discarding other values to try writes nothing.
        fixture.tried("position_p")->setValue(50);
        QCOMPARE(fixture.own<QPushButton>("stepBack")->text(), QStringLiteral("Discard"));
        fixture.click("stepBack");
        QCOMPARE(fixture.tried("position_p")->value(), 36);
        QCOMPARE(fixture.now("position_p"), 36);
        QCOMPARE(fixture.own<QPushButton>("stepBack")->text(),
                 QStringLiteral("Restore old values"));
        fixture.click("stepBack");
        QTRY_COMPARE(*fixture.raw("position_p"), 32);
        QTRY_VERIFY(fixture.test().previousValues(fixture.selection().current()).empty());
        QTRY_VERIFY(!fixture.own<QPushButton>("stepBack")->isEnabled());
    }

    void aStoppedTrialIsRevertedToo()
    {
        StepPageFixture fixture;
        QVERIFY(fixture.ready(1, QStringLiteral("sim:sts3215@1")));
        QTRY_VERIFY(fixture.tried("position_p")->isEnabled());
        fixture.type("300");
        fixture.tried("position_p")->setValue(20);
        fixture.click("stepTry");
        QTest::mouseClick(fixture.own<QPushButton>("questionYes"), Qt::LeftButton);
        QTRY_VERIFY(!fixture.test().liveResponses().empty());
        QVERIFY(!fixture.own<QLineEdit>("stepSize")->isEnabled());
        fixture.click("stepStop");
        QTRY_VERIFY(!fixture.test().isRunning());
        QCOMPARE(fixture.now("position_p"), 32);
        QCOMPARE(fixture.test().runs().back().end, results::SweepEnd::Stopped);
    }

    /// The link is lost in the middle of a trial: the page says so, and what it has left.
    void anInterruptedTrialIsReported()
    {
        StepPageFixture fixture;
        QVERIFY(fixture.ready(1, QStringLiteral("sim:sts3215@1")));
        fixture.setShortRun();
        QTRY_VERIFY(fixture.tried("position_p")->isEnabled());
        QVERIFY(fixture.run("stepRun"));
        fixture.own<QSpinBox>("stepRepeats")->setValue(20);
        fixture.tried("position_p")->setValue(12);
        fixture.click("stepTry");
        QTRY_VERIFY(!fixture.test().liveResponses().empty());
        fixture.workbench().link().connection()->simulation()->with(
            [](sim::VirtualBus& bus) { bus.config().faults.dropRequest = 1; });
        QTRY_VERIFY(!fixture.test().isRunning());
        QCOMPARE(fixture.test().runs().back().end, results::SweepEnd::LinkLost);
        QString message;
        for (const QLabel* label : fixture.own<QWidget>("stepBanner")->findChildren<QLabel*>())
            message += label->text();
        for (const char* part : {"connection was lost", "12 (old value 32)", "Interrupted writes",
                                 "Torque could not be turned off: ID 1"})
            QVERIFY2(message.contains(QLatin1String(part)), qPrintable(message));
        auto* figures = fixture.own<QTableWidget>("stepFigures");
        QVERIFY(figures->horizontalHeaderItem(2)->text().contains(QLatin1String("interrupted")));
        QVERIFY(figures->isColumnHidden(3)); // nothing is better or worse
    }

    void anEmergencyStopIsLiftedBesideMeasure()
    {
        StepPageFixture fixture;
        QVERIFY(fixture.ready(1, QStringLiteral("sim:sts3215@1")));
        auto* allow = fixture.own<QPushButton>("stepAllow");
        QVERIFY(!allow->isVisible());
        fixture.workbench().emergencyStop().trigger();
        QTRY_VERIFY(allow->isVisible());
        QVERIFY(!fixture.own<QPushButton>("stepRun")->isEnabled());
        // Not during a search: torque would come on when hands may be back on the servo.
        fixture.workbench().search().start({.firstId = 20, .lastId = 25, .bauds = {}});
        QTRY_VERIFY(!allow->isEnabled());
        QVERIFY(!fixture.workbench().emergencyStop().allowMovement({fixture.selection().current()},
                                                                   nullptr, {}));
        QTRY_VERIFY(!fixture.workbench().search().isSearching());
        QTRY_VERIFY(allow->isEnabled());
        QCOMPARE(fixture.now("torque_switch"), 0);
        QTest::mouseClick(allow, Qt::LeftButton);
        QTest::mouseClick(fixture.own<QPushButton>("questionYes"), Qt::LeftButton);
        QTRY_VERIFY(fixture.own<QPushButton>("stepRun")->isEnabled());
        QVERIFY(!allow->isVisible());
        QCOMPARE(fixture.now("torque_switch"), 1);
        QVERIFY(!fixture.test().isRunning());
    }

    void anotherModeIsOffered()
    {
        StepPageFixture fixture;
        QVERIFY(fixture.ready(1, QStringLiteral("sim:sts3215@1")));
        fixture.setShortRun();
        fixture.context.workbench.motion().setServos({fixture.selection().current()});
        fixture.context.workbench.motion().switchMode(QStringLiteral("speed"));
        QTRY_VERIFY(fixture.own<QCheckBox>("stepSwitchMode")->isVisible());
        QVERIFY(!fixture.own<QPushButton>("stepRun")->isEnabled());
        fixture.own<QCheckBox>("stepSwitchMode")->setChecked(true);
        QVERIFY(fixture.run("stepRun"));
        QCOMPARE(fixture.now("operating_mode"), 1);
        QCOMPARE(fixture.now("torque_switch"), 0);
    }

    void impossibleRunsAreReported()
    {
        StepPageFixture fixture;
        QVERIFY(fixture.ready(1, QStringLiteral("sim:sts3215@1")));
        fixture.type("far");
        fixture.click("stepRun");
        QTest::mouseClick(fixture.own<QPushButton>("questionYes"), Qt::LeftButton);
        QTRY_VERIFY(!fixture.test().isRunning());
        QTRY_VERIFY(fixture.own<QWidget>("stepBanner")->isVisible());
        QCOMPARE(fixture.now("torque_switch"), 0);
    }

    void runsAreSaved()
    {
        StepPageFixture fixture;
        QVERIFY(fixture.ready(1, QStringLiteral("sim:sts3215@1")));
        fixture.setShortRun();
        QVERIFY(fixture.run("stepRun"));
        QTemporaryDir folder;
        QSignalSpy saved(&fixture.test(), &session::StepTest::saved);
        for (const char* ending : {"json", "csv", "html"}) {
            const QString path = folder.filePath(QStringLiteral("run.") + QLatin1String(ending));
            fixture.test().save(path, false);
            QVERIFY(saved.wait());
            QVERIFY(QFileInfo(path).size() > 1000);
        }
        const auto back = results::loadStepRuns(folder.filePath(QStringLiteral("run.json")));
        QVERIFY(back && back->size() == 1);
        QTRY_VERIFY(fixture.own<QLabel>("stepSaved")->isVisible());
    }

    void fitsAndIsTranslatedToChinese()
    {
        StepPageFixture fixture;
        QVERIFY(fixture.ready(1, QStringLiteral("sim:sts3215@1")));
        fixture.lab->resize(760, 560); // what a window of 1024 × 700 leaves
        for (const char* name : {"stepRun", "stepTry", "stepStop", "stepAccept", "stepBack"}) {
            auto* button = fixture.own<QPushButton>(name);
            QVERIFY2(!button->accessibleName().isEmpty(), name);
            QVERIFY2(!button->toolTip().isEmpty(), name);
            QVERIFY2(button->width() >= button->minimumSizeHint().width(), name);
            const QPoint end = button->mapTo(fixture.lab.get(), button->rect().bottomRight());
            QVERIFY2(fixture.lab->rect().contains(end), name);
        }
    }
};

SERVODESK_TEST(TestStepPage)
#include "tst_step_page.moc"
