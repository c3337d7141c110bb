// SPDX-License-Identifier: GPL-3.0-or-later
// The step page on a simulated bus: opening it moves nothing, the first run asks, a trial is over
// when its run is, both are laid over each other, advice goes into Try, Accept keeps and Back takes
// back. Whatever is written is asked of the simulation's own table by reading.
#include "gui/window_bench.h"
#include "record/step_json.h"
#include "sim/sim_link.h"
#include "ui/charts/trend_chart.h"
#include "ui/pages/step_page.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFileDialog>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSpinBox>
#include <QTableWidget>

namespace {
constexpr int runTime = 40'000;

/// The page beside the window, on the same bench.
struct StepBench : gui::WindowBench {
    explicit StepBench(const QString& language = QStringLiteral("en"))
        : WindowBench(language)
        , lab(std::make_unique<ui::StepPage>(bench, settings))
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
    void quick()
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
        return QTest::qWaitFor([&] { return !test().running() && test().runs().size() > runs; },
                               runTime);
    }
    std::int64_t now(const char* key)
    {
        (void)settled();
        desk().readTable(selection().current());
        (void)settled();
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
        StepBench bench;
        QVERIFY(!bench.own<QPushButton>("stepRun")->isEnabled());
        QCOMPARE(bench.own<QLabel>("stepWhy")->text(), QStringLiteral("Connect first."));
        QVERIFY(bench.ready(1, QStringLiteral("sim:sts3215@1")));
        QTRY_VERIFY(bench.own<QPushButton>("stepRun")->isEnabled());
        QCOMPARE(bench.now("torque_switch"), 0);
        QTRY_COMPARE(bench.tried("position_p")->value(), int(*bench.raw("position_p")));
        QVERIFY(!bench.own<QPushButton>("stepTry")->isEnabled());
        QVERIFY(bench.own<QPushButton>("stepTry")->toolTip().contains(QLatin1String("Change")));
        QVERIFY(!bench.own<QPushButton>("stepAccept")->isEnabled());
        QVERIFY(!bench.own<QPushButton>("stepBack")->isEnabled());
        QVERIFY(!bench.own<QLineEdit>("stepSize")->text().isEmpty());
        QVERIFY(bench.own<QLabel>("stepNothing")->isVisible());
    }

    void theFirstRunAsks()
    {
        StepBench bench;
        QVERIFY(bench.ready(1, QStringLiteral("sim:sts3215@1")));
        bench.quick();
        bench.click("stepRun");
        auto* no = bench.own<QPushButton>("questionNo");
        QVERIFY(no != nullptr);
        QTest::mouseClick(no, Qt::LeftButton);
        QVERIFY(!bench.test().running());
        QCOMPARE(bench.now("torque_switch"), 0);
    }

    void aTrialIsOverWhenItsRunIs()
    {
        StepBench bench;
        QVERIFY(bench.ready(1, QStringLiteral("sim:sts3215@1")));
        bench.quick();
        QTRY_VERIFY(bench.tried("position_p")->isEnabled());
        QVERIFY(bench.run("stepRun"));
        auto* figures = bench.own<QTableWidget>("stepFigures");
        QVERIFY(figures->rowCount() > 6);
        QVERIFY(figures->isColumnHidden(1)); // nothing to compare with
        bench.tried("position_p")->setValue(10);
        bench.tried("position_d")->setValue(0);
        QVERIFY(bench.run("stepTry"));
        QCOMPARE(bench.now("position_p"), 32);
        QCOMPARE(bench.now("position_d"), 32);
        QCOMPARE(bench.tried("position_p")->value(), 10); // still there to be accepted
        QVERIFY(!figures->isColumnHidden(1));
        const auto& channels = bench.own<ui::TrendChart>("stepChart")->channels();
        QCOMPARE(channels.size(), std::size_t(3)); // both runs and the target
        QVERIFY(channels[2].name.contains(QLatin1String("position_p 10")));
        // The weak one rests beside its target, and the sheet knows what to do.
        auto* take = bench.own<QPushButton>("stepTake_position_i");
        QVERIFY(take != nullptr);
        QTest::mouseClick(take, Qt::LeftButton);
        QCOMPARE(bench.tried("position_i")->value(), 1);
        QCOMPARE(bench.now("position_i"), 0);
        // The other direction can be looked at, too.
        auto* choice = bench.own<QComboBox>("stepChoice");
        QCOMPARE(choice->count(), 2);
        QTest::keyClick(choice, Qt::Key_Down);
        QCOMPARE(bench.own<ui::TrendChart>("stepChart")->channels().size(), std::size_t(3));
    }

    void acceptKeepsAndBackTakesBack()
    {
        StepBench bench;
        QVERIFY(bench.ready(1, QStringLiteral("sim:sts3215@1")));
        QTRY_VERIFY(bench.tried("position_p")->isEnabled());
        bench.tried("position_p")->setValue(36);
        bench.click("stepAccept");
        QTRY_COMPARE(*bench.raw("position_p"), 36);
        QTRY_VERIFY(bench.own<QPushButton>("stepBack")->isEnabled());
        QCOMPARE(bench.test().earlier(bench.selection().current()).size(), std::size_t(1));
        // For good: a power cycle does not change it.
        bench.desk().powerCycle();
        QCOMPARE(bench.now("position_p"), 36);
        QTRY_VERIFY(bench.own<QPushButton>("stepBack")->toolTip().contains(QLatin1String("32")));
        bench.click("stepBack");
        QTRY_COMPARE(*bench.raw("position_p"), 32);
        QTRY_VERIFY(bench.test().earlier(bench.selection().current()).empty());
        QTRY_VERIFY(!bench.own<QPushButton>("stepBack")->isEnabled());
    }

    void aTrialThatIsStoppedIsBackAsWell()
    {
        StepBench bench;
        QVERIFY(bench.ready(1, QStringLiteral("sim:sts3215@1")));
        QTRY_VERIFY(bench.tried("position_p")->isEnabled());
        bench.type("300");
        bench.tried("position_p")->setValue(20);
        bench.click("stepTry");
        QTest::mouseClick(bench.own<QPushButton>("questionYes"), Qt::LeftButton);
        QTRY_VERIFY_WITH_TIMEOUT(!bench.test().live().empty(), runTime);
        QVERIFY(!bench.own<QLineEdit>("stepSize")->isEnabled());
        bench.click("stepStop");
        QTRY_VERIFY_WITH_TIMEOUT(!bench.test().running(), runTime);
        QCOMPARE(bench.now("position_p"), 32);
        QCOMPARE(bench.test().runs().back().end, record::SweepEnd::Stopped);
    }

    /// The link is lost in the middle of a trial: the page says so, and what it has left.
    void aTrialThatIsBrokenOffIsReported()
    {
        StepBench bench;
        QVERIFY(bench.ready(1, QStringLiteral("sim:sts3215@1")));
        bench.quick();
        QTRY_VERIFY(bench.tried("position_p")->isEnabled());
        QVERIFY(bench.run("stepRun"));
        bench.own<QSpinBox>("stepRepeats")->setValue(20);
        bench.tried("position_p")->setValue(12);
        bench.click("stepTry");
        QTRY_VERIFY_WITH_TIMEOUT(!bench.test().live().empty(), runTime);
        bench.desk().connection()->simulation()->with(
            [](sim::VirtualBus& bus) { bus.config().faults.dropRequest = 1; });
        QTRY_VERIFY_WITH_TIMEOUT(!bench.test().running(), runTime);
        QCOMPARE(bench.test().runs().back().end, record::SweepEnd::LinkLost);
        QString said;
        for (const QLabel* label : bench.own<QWidget>("stepBanner")->findChildren<QLabel*>())
            said += label->text();
        for (const char* part : {"link was lost", "12 (own value 32)", "Interrupted writes",
                                 "Torque could not be switched off: ID 1"})
            QVERIFY2(said.contains(QLatin1String(part)), qPrintable(said));
        auto* figures = bench.own<QTableWidget>("stepFigures");
        QVERIFY(figures->horizontalHeaderItem(2)->text().contains(QLatin1String("broken off")));
        QVERIFY(figures->isColumnHidden(4)); // nothing is better or worse
    }

    void anotherModeIsOffered()
    {
        StepBench bench;
        QVERIFY(bench.ready(1, QStringLiteral("sim:sts3215@1")));
        bench.quick();
        bench.bench.drive.setServos({bench.selection().current()});
        bench.bench.drive.switchMode(QStringLiteral("speed"));
        QTRY_VERIFY(bench.own<QCheckBox>("stepSwitchMode")->isVisible());
        QVERIFY(!bench.own<QPushButton>("stepRun")->isEnabled());
        bench.own<QCheckBox>("stepSwitchMode")->setChecked(true);
        QVERIFY(bench.run("stepRun"));
        QCOMPARE(bench.now("operating_mode"), 1);
        QCOMPARE(bench.now("torque_switch"), 0);
    }

    void whatCannotBeRunIsSaid()
    {
        StepBench bench;
        QVERIFY(bench.ready(1, QStringLiteral("sim:sts3215@1")));
        bench.type("far");
        bench.click("stepRun");
        QTest::mouseClick(bench.own<QPushButton>("questionYes"), Qt::LeftButton);
        QTRY_VERIFY(!bench.test().running());
        QTRY_VERIFY(bench.own<QWidget>("stepBanner")->isVisible());
        QCOMPARE(bench.now("torque_switch"), 0);
    }

    void runsAreSaved()
    {
        StepBench bench;
        QVERIFY(bench.ready(1, QStringLiteral("sim:sts3215@1")));
        bench.quick();
        QVERIFY(bench.run("stepRun"));
        QTemporaryDir folder;
        QSignalSpy saved(&bench.test(), &session::StepTest::saved);
        for (const char* ending : {"json", "csv", "html"}) {
            const QString path = folder.filePath(QStringLiteral("run.") + QLatin1String(ending));
            bench.test().save(path, false);
            QVERIFY(saved.wait());
            QVERIFY(QFileInfo(path).size() > 1000);
        }
        const auto back = record::loadStepRuns(folder.filePath(QStringLiteral("run.json")));
        QVERIFY(back && back->size() == 1);
        QTRY_VERIFY(bench.own<QLabel>("stepSaved")->isVisible());
    }

    void itFitsAndSpeaksChinese()
    {
        StepBench bench;
        QVERIFY(bench.ready(1, QStringLiteral("sim:sts3215@1")));
        bench.lab->resize(760, 560); // what a window of 1024 × 700 leaves
        for (const char* name : {"stepRun", "stepTry", "stepStop", "stepAccept", "stepBack"}) {
            auto* button = bench.own<QPushButton>(name);
            QVERIFY2(!button->accessibleName().isEmpty(), name);
            QVERIFY2(!button->toolTip().isEmpty(), name);
            QVERIFY2(button->width() >= button->minimumSizeHint().width(), name);
            const QPoint end = button->mapTo(bench.lab.get(), button->rect().bottomRight());
            QVERIFY2(bench.lab->rect().contains(end), name);
        }
    }
};

QTEST_MAIN(TestStepPage)
#include "tst_step_page.moc"
