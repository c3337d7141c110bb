// SPDX-License-Identifier: GPL-3.0-or-later
// Step responses of the history in the window: listed, described, opened on the step page, compared
// with each other and with the present run, deleted after a question, and opened from the history
// page; in both languages.
#include "gui/main_window_fixture.h"
#include "session/history/history_service.h"
#include "session/step/step_test.h"
#include "support/test_main.h"
#include "support/text.h"
#include "ui/charts/trend_chart.h"
#include "ui/step/step_page.h"
#include "ui/step/step_runs_dialog.h"

#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSpinBox>
#include <QTabWidget>
#include <QTableView>
#include <QTableWidget>

using support::utf8;
using namespace std::chrono_literals;

namespace {
session::SharedStep stepOf(double size, double riseTime, std::vector<results::StepGain> trial = {})
{
    auto run = std::make_shared<results::StepRun>();
    run->program = utf8("test");
    run->at = QDateTime({2026, 3, 4}, {5, 6, 7}, Qt::UTC);
    run->port = utf8("sim:demo");
    run->parameters.servo = {
        3, utf8("STS3215"), utf8("9.3"), utf8("3.10"), utf8("sts-sms"), utf8("feetech")};
    run->parameters.program = run->program;
    run->parameters.at = run->at;
    run->axis.from = 1800;
    run->axis.to = 1800 + size;
    run->spec.trial = std::move(trial);
    run->gains = {{utf8("position_p"), 32}, {utf8("position_d"), 32}};
    run->mean.riseTime = riseTime;
    run->mean.overshoot = 20;
    run->mean.overshootSteps = size / 5;
    results::StepResponse response;
    response.number = 1;
    response.start = run->axis.from;
    response.target = run->axis.to;
    response.figures = run->mean;
    response.samples = {{0us, run->axis.from, {}, {}, {}}, {500ms, run->axis.to, {}, {}, {}}};
    run->responses = {response};
    return run;
}

struct StepRunsFixture : gui::MainWindowFixture {
    StepRunsFixture()
    {
        // 1: another step. 2: the servo's own values. 3: a trial.
        for (const auto& run :
             {stepOf(100, 40), stepOf(300, 80), stepOf(300, 60, {{utf8("position_p"), 40}})}) {
            workbench().history().saveRun(run);
        }
        action(ui::Command::PageStep)->trigger();
    }
    ui::StepPage* page() { return find<ui::StepPage>("stepPage"); }
    session::StepTest& test() { return page()->test(); }
    ui::StepRunsDialog* dialog()
    {
        QTest::mouseClick(find<QPushButton>("stepEarlier"), Qt::LeftButton);
        return window->findChild<ui::StepRunsDialog*>();
    }
    void open(const std::vector<std::int64_t>& numbers)
    {
        auto* runs = dialog();
        auto* table = runs->findChild<QTableView*>(utf8("runs"));
        QTRY_VERIFY(table->model()->rowCount() >= 3);
        table->clearSelection();
        for (int row = 0; row < table->model()->rowCount(); ++row) {
            const QModelIndex index = table->model()->index(row, int(ui::RunColumn::Number));
            if (std::count(numbers.begin(), numbers.end(), index.data().toString().toInt()) > 0)
                table->selectionModel()->select(index, QItemSelectionModel::Select |
                                                           QItemSelectionModel::Rows);
        }
        QSignalSpy opened(&test(), &session::StepTest::storedOpened);
        QTest::mouseClick(runs->findChild<QPushButton*>(utf8("runsOpen")), Qt::LeftButton);
        QTRY_COMPARE(opened.size(), 1);
        QCOMPARE(test().openedNumbers(), numbers);
    }
    QString cell(int row, int column)
    {
        const QTableWidgetItem* item = find<QTableWidget>("stepFigures")->item(row, column);
        return item != nullptr ? item->text() : QString();
    }
};
} // namespace

class TestStepRuns : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { gui::failOnWarnings(); }

    void aRunIsDescribedAndOpened()
    {
        StepRunsFixture fixture;
        auto* dialog = fixture.dialog();
        QVERIFY(dialog != nullptr);
        auto* table = dialog->findChild<QTableView*>(utf8("runs"));
        auto* open = dialog->findChild<QPushButton*>(utf8("runsOpen"));
        QTRY_COMPARE(table->model()->rowCount(), 3);
        QVERIFY(table->isColumnHidden(int(ui::RunColumn::Verdict)));
        QVERIFY(!open->isEnabled());
        table->selectRow(0); // the newest
        auto* hint = dialog->findChild<QLabel*>(utf8("runsHint"));
        QTRY_VERIFY2(hint->text().contains(utf8("1800 → 2100 · Position loop P 40")),
                     qPrintable(hint->text()));
        table->selectAll();
        QVERIFY(!open->isEnabled()); // two at most
        fixture.open({3});
        auto* stored = fixture.find<QLabel>("stepStored");
        QVERIFY(stored->isVisible());
        QVERIFY2(stored->text().contains(utf8("Test 3 (")), qPrintable(stored->text()));
        QCOMPARE(fixture.find<ui::TrendChart>("stepChart")->channels().size(), std::size_t(2));
        QVERIFY(fixture.find<QTableWidget>("stepFigures")->isColumnHidden(1));
        QCOMPARE(fixture.cell(0, 2), utf8("60"));
        // The advice is worked out anew: this one overshoots.
        QVERIFY(!fixture.test().advice().empty());
        QTest::mouseClick(fixture.find<QPushButton>("stepForget"), Qt::LeftButton);
        QVERIFY(!stored->isVisible());
        QVERIFY(fixture.test().runs().empty());
        QTRY_COMPARE(fixture.dialog()->findChild<QTableView*>(utf8("runs"))->model()->rowCount(),
                     3); // the history keeps them
    }

    void twoRunsAreCompared()
    {
        StepRunsFixture fixture;
        fixture.open({2, 3});
        QVERIFY(!fixture.find<QTableWidget>("stepFigures")->isColumnHidden(1));
        QCOMPARE(fixture.cell(0, 1), utf8("80"));
        QCOMPARE(fixture.cell(0, 2), utf8("60"));
        QCOMPARE(fixture.cell(0, 3), utf8("−20 better"));
        // Steps of another size are shown, but not compared; what was open before is gone.
        fixture.open({1, 2});
        QVERIFY(fixture.find<QTableWidget>("stepFigures")->isColumnHidden(1));
        QVERIFY(fixture.find<QLabel>("stepStored")->text().contains(utf8("not compared")));
    }

    void thePresentRunIsComparedWithAnOpenedOne()
    {
        StepRunsFixture fixture;
        QVERIFY(fixture.ready(1, utf8("sim:sts3215@1")));
        fixture.find<QTabWidget>("pages")->setCurrentWidget(fixture.page());
        fixture.open({2});
        auto* size = fixture.find<QLineEdit>("stepSize");
        size->selectAll();
        QTest::keyClicks(size, utf8("300"));
        fixture.find<QSpinBox>("stepRepeats")->setValue(1);
        fixture.find<QSpinBox>("stepHold")->setValue(500);
        auto* run = fixture.find<QPushButton>("stepRun");
        QTRY_VERIFY(run->isEnabled());
        QTest::mouseClick(run, Qt::LeftButton);
        QTRY_VERIFY(fixture.find<QPushButton>("questionYes"));
        QTest::mouseClick(fixture.find<QPushButton>("questionYes"), Qt::LeftButton);
        QTRY_VERIFY(fixture.test().runs().size() == 2);
        QVERIFY(fixture.test().previousRun() == &fixture.test().runs().front());
        auto* figures = fixture.find<QTableWidget>("stepFigures");
        QVERIFY(!figures->isColumnHidden(1));
        QStringList before;
        for (int row = 0; row < figures->rowCount(); ++row)
            before << fixture.cell(row, 1);
        QVERIFY2(before.contains(utf8("80")), qPrintable(before.join(QLatin1Char(' '))));
        // Without the opened one nothing is left to compare with.
        fixture.test().openStored({});
        QVERIFY(fixture.test().previousRun() == nullptr);
        QCOMPARE(fixture.test().runs().size(), std::size_t(1));
        // The runs of another servo go, an opened one stays.
        fixture.open({2});
        fixture.selection().select(0);
        QTRY_COMPARE(fixture.test().runs().size(), std::size_t(1));
        QCOMPARE(fixture.test().openedNumbers().size(), std::size_t(1));
    }

    void theHistoryPageOpensOne()
    {
        StepRunsFixture fixture;
        fixture.action(ui::Command::PageHistory)->trigger();
        auto* kinds = fixture.find<QComboBox>("historyKind");
        kinds->setCurrentIndex(kinds->findData(int(history::HistoryKind::Runs)));
        Q_EMIT kinds->activated(kinds->currentIndex());
        auto* table = fixture.find<QTableView>("historyTable");
        QTRY_COMPARE(table->model()->rowCount(), 3);
        auto* open = fixture.find<QPushButton>("historyOpen");
        table->clearSelection();
        QCOMPARE(open->text(), utf8("Earlier tests…"));
        table->selectRow(1);
        QCOMPARE(open->text(), utf8("Open step response"));
        QTest::mouseClick(open, Qt::LeftButton);
        QTRY_COMPARE(fixture.test().openedNumbers(), std::vector<std::int64_t>{2});
        QTRY_VERIFY(fixture.page()->isVisible());
    }

    void aRunThatIsGoneIsReported()
    {
        StepRunsFixture fixture;
        fixture.page()->openStored({99});
        QTRY_VERIFY(fixture.find<QWidget>("stepBanner")->isVisible());
        QVERIFY(fixture.test().runs().empty());
    }

    void deletingAsksFirst()
    {
        StepRunsFixture fixture;
        auto* dialog = fixture.dialog();
        auto* table = dialog->findChild<QTableView*>(utf8("runs"));
        QTRY_COMPARE(table->model()->rowCount(), 3);
        table->selectRow(0);
        QTest::mouseClick(dialog->findChild<QPushButton*>(utf8("runsDelete")), Qt::LeftButton);
        QTRY_VERIFY(dialog->findChild<QPushButton*>(utf8("questionYes")));
        QCOMPARE(table->model()->rowCount(), 3);
        QTest::mouseClick(dialog->findChild<QPushButton*>(utf8("questionYes")), Qt::LeftButton);
        QTRY_COMPARE(table->model()->rowCount(), 2);
    }

    void isTranslated()
    {
        StepRunsFixture fixture;
        fixture.open({2, 3});
        auto* dialog = fixture.dialog();
        fixture.setLanguage(utf8("zh_CN"));
        QCOMPARE(dialog->windowTitle(), utf8("以往阶跃响应"));
        QVERIFY(fixture.find<QLabel>("stepStored")->text().contains(utf8("测试 2")));
        QCOMPARE(fixture.find<QPushButton>("stepEarlier")->text(), utf8("以往的运行…"));
        QList<QPushButton*> buttons = dialog->findChildren<QPushButton*>();
        buttons << fixture.find<QPushButton>("stepEarlier");
        for (const QPushButton* button : std::as_const(buttons)) {
            QVERIFY2(!button->accessibleName().isEmpty(), qPrintable(button->objectName()));
            QVERIFY2(!button->toolTip().isEmpty(), qPrintable(button->objectName()));
        }
    }
};

SERVODESK_TEST(TestStepRuns)
#include "tst_step_runs.moc"
