// SPDX-License-Identifier: GPL-3.0-or-later
// Earlier tests in the window: listed, found, labeled, marked, held against each other, saved as
// pages, deleted after a question; in both languages.
#include "history/history_file.h"
#include "report/sweep_compare_text.h"
#include "report/sweep_html.h"
#include "session/history/history_service.h"
#include "support/test_main.h"
#include "support/text.h"
#include "ui/common/language_switch.h"
#include "ui/sweep/compare_dialog.h"
#include "ui/sweep/runs_dialog.h"
#include "unit/results/sweep_example.h"

#include <QAbstractItemModelTester>
#include <QDir>
#include <QFileDialog>
#include <QInputDialog>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QRegularExpression>
#include <QSignalSpy>
#include <QTableView>
#include <QTableWidget>
#include <QTemporaryDir>
#include <QTest>

using session::HistoryService;
using support::utf8;
using ui::RunColumn;
using ui::RunsDialog;

namespace {
session::SharedRun runOf(const char* model, int id, int day)
{
    auto run = std::make_shared<results::SweepRun>(sweep_example::finishedRun());
    run->servos.resize(1);
    run->servos[0].parameters.servo.model = utf8(model);
    run->servos[0].parameters.servo.id = id;
    run->servos[0].parameters.label.clear();
    run->spec.note = utf8("day %1").arg(day);
    run->at = run->at.addDays(day);
    return run;
}
} // namespace

class TestRunsDialog : public QObject {
    Q_OBJECT

private:
    template <typename Widget>
    Widget* part(QWidget* of, const char* name)
    {
        auto* found = of ? of->findChild<Widget*>(utf8(name)) : nullptr;
        [&] { QVERIFY2(found != nullptr, name); }();
        return found;
    }
    QTableView* table() { return part<QTableView>(m_dialog, "runs"); }
    QPushButton* button(const char* name) { return part<QPushButton>(m_dialog, name); }
    QString cell(int row, RunColumn column)
    {
        return table()->model()->index(row, int(column)).data().toString();
    }
    int rows() { return table()->model()->rowCount(); }
    void select(std::initializer_list<int> chosen)
    {
        table()->clearSelection();
        for (const int row : chosen)
            table()->selectionModel()->select(table()->model()->index(row, 0),
                                              QItemSelectionModel::Select |
                                                  QItemSelectionModel::Rows);
    }
    /// What a file dialog would answer.
    void choose(QWidget* of, const char* dialog, const QString& path)
    {
        QTRY_VERIFY(of->findChild<QFileDialog*>(utf8(dialog)));
        auto* files = of->findChild<QFileDialog*>(utf8(dialog));
        Q_EMIT files->fileSelected(path);
        delete files;
    }

    std::unique_ptr<QTemporaryDir> m_dir;
    std::unique_ptr<session::Settings> m_settings;
    std::unique_ptr<HistoryService> m_historyService;
    QPointer<RunsDialog> m_dialog;

private Q_SLOTS:
    void init();
    void cleanup();

    void listsAndFilters();
    void emptyListIsExplained();
    void labelAndReference();
    void twoRunsAreCompared();
    void incomparableRunsAreReportedFirst();
    void reportsAreSaved();
    void unfinishedRunsAreNoReference();
    void deletingAsksFirst();
    void anUnusableHistoryIsReported();
    void isTranslated();
    void theReferenceInAText();
};

void TestRunsDialog::init()
{
    QTest::failOnWarning(
        QRegularExpression(utf8("^(?!This plugin does not support propagateSizeHints)")));
    m_dir = std::make_unique<QTemporaryDir>();
    m_settings = std::make_unique<session::Settings>();
    m_historyService = std::make_unique<HistoryService>(m_dir->filePath(utf8("history.sqlite")));
    m_historyService->saveRun(runOf("STS3215", 1, 0));
    m_historyService->saveRun(runOf("STS3215", 2, 1));
    QFile readings(m_dir->filePath(utf8("kept.readings.csv")));
    QVERIFY(readings.open(QIODevice::WriteOnly) && readings.write("time_us\n1\n") > 0);
    m_historyService->saveRun(runOf("SCS15", 3, 2), {readings.fileName()});
    m_dialog = new RunsDialog(*m_historyService, *m_settings, nullptr);
    m_dialog->show();
}

void TestRunsDialog::cleanup()
{
    delete m_dialog;
    m_historyService.reset();
}

void TestRunsDialog::listsAndFilters()
{
    const QAbstractItemModelTester tester(table()->model());
    QTRY_COMPARE(rows(), 3);
    QCOMPARE(cell(0, RunColumn::Servo), utf8("3")); // newest first
    QVERIFY(cell(0, RunColumn::Model).startsWith(utf8("SCS15")));
    QCOMPARE(cell(0, RunColumn::Note), utf8("day 2"));
    QVERIFY(cell(0, RunColumn::Verdict).size() > 2); // a sign and a word
    part<QLineEdit>(m_dialog, "runsFilter")->setText(utf8("sts32"));
    QTRY_COMPARE(rows(), 2);
    part<QLineEdit>(m_dialog, "runsFilter")->setText(utf8("nothing like it"));
    QTRY_COMPARE(rows(), 0);
    QVERIFY(part<QLabel>(m_dialog, "runsHint")->text().contains(utf8("filter")));
    part<QLineEdit>(m_dialog, "runsFilter")->clear();
    QTRY_COMPARE(rows(), 3);
    m_historyService->saveRun(runOf("HLS3606", 9, 5)); // another test ends meanwhile
    QTRY_COMPARE(rows(), 4);
    QCOMPARE(cell(0, RunColumn::Servo), utf8("9"));
}

void TestRunsDialog::emptyListIsExplained()
{
    delete m_dialog;
    HistoryService empty(m_dir->filePath(utf8("other.sqlite")));
    m_dialog = new RunsDialog(empty, *m_settings, nullptr);
    m_dialog->show();
    QTRY_VERIFY(part<QLabel>(m_dialog, "runsHint")->text().contains(utf8("No tests yet")));
    for (const char* name :
         {"runsReport", "runsCompare", "runsReference", "runsLabel", "runsDelete"})
        QVERIFY(!button(name)->isEnabled());
    delete m_dialog;
}

void TestRunsDialog::labelAndReference()
{
    QTRY_COMPARE(rows(), 3);
    select({1});
    button("runsLabel")->click();
    QTRY_VERIFY(m_dialog->findChild<QInputDialog*>());
    auto* input = m_dialog->findChild<QInputDialog*>();
    input->setTextValue(utf8("left knee"));
    input->accept();
    QTRY_COMPARE(cell(1, RunColumn::Label), utf8("left knee"));
    QTRY_COMPARE(table()->selectionModel()->selectedRows().size(), 1); // stays selected
    QVERIFY(cell(1, RunColumn::Reference).isEmpty());
    const QString mark = button("runsReference")->text();
    button("runsReference")->click();
    QTRY_VERIFY(!cell(1, RunColumn::Reference).isEmpty());
    QVERIFY(button("runsReference")->text() != mark);
    select({2}); // the other one of the model takes the mark over
    button("runsReference")->click();
    QTRY_VERIFY(!cell(2, RunColumn::Reference).isEmpty());
    QVERIFY(cell(1, RunColumn::Reference).isEmpty());
    button("runsReference")->click();
    QTRY_VERIFY(cell(2, RunColumn::Reference).isEmpty());
}

void TestRunsDialog::twoRunsAreCompared()
{
    QTRY_COMPARE(rows(), 3);
    select({1});
    QVERIFY(!button("runsCompare")->isEnabled());
    select({1, 2});
    QVERIFY(button("runsCompare")->isEnabled());
    button("runsCompare")->click();
    QTRY_VERIFY(m_dialog->findChild<QDialog*>(utf8("compareDialog")));
    auto* compare = m_dialog->findChild<QDialog*>(utf8("compareDialog"));
    const QString sides = part<QLabel>(compare, "compareSides")->text();
    QVERIFY2(sides.startsWith(utf8("A: test 1 ·")), qPrintable(sides)); // the older one
    QVERIFY(sides.contains(utf8("B: test 2 ·")));
    auto* figures = part<QTableWidget>(compare, "compareFigures");
    QCOMPARE(figures->rowCount(), int(results::sweepMetricKinds().size()));
    QCOMPARE(figures->item(2, 0)->text(), utf8("Overshoot"));
    QCOMPARE(figures->item(2, 1)->text(), utf8("8.06"));
    QCOMPARE(figures->item(2, 3)->text(), utf8("0"));
    QVERIFY(part<QLabel>(compare, "compareWarnings")->text().startsWith(utf8("✓")));
    QVERIFY(!part<QTableWidget>(compare, "compareTests")->isVisible());

    const QString path = m_dir->filePath(utf8("pair.html"));
    part<QPushButton>(compare, "compareSave")->click();
    choose(compare, "compareFileDialog", path);
    QTRY_VERIFY(QFile::exists(path));
    QTRY_VERIFY(compare->findChild<ui::TaskResult*>()->text().message.contains(utf8("pair.html")));
    part<QPushButton>(compare, "compareSave")->click();
    choose(compare, "compareFileDialog", m_dir->path()); // a folder
    QTRY_VERIFY(!compare->findChild<ui::TaskResult*>()->text().message.contains(utf8("pair.html")));
    compare->close();
}

void TestRunsDialog::incomparableRunsAreReportedFirst()
{
    auto other = std::make_shared<results::SweepRun>(*runOf("STS3215", 4, 9));
    other->servos[0].axis.to = 2000;
    other->servos[0].parameters.registers[0].raw = 600;
    m_historyService->saveRun(other);
    QTRY_COMPARE(rows(), 4);
    select({3}); // the oldest is the reference, so it is A
    button("runsReference")->click();
    QTRY_VERIFY(!cell(3, RunColumn::Reference).isEmpty());
    select({0, 3});
    button("runsCompare")->click();
    QTRY_VERIFY(m_dialog->findChild<QDialog*>(utf8("compareDialog")));
    auto* compare = m_dialog->findChild<QDialog*>(utf8("compareDialog"));
    QVERIFY(part<QLabel>(compare, "compareWarnings")
                ->text()
                .contains(report::compareTexts().notComparable.en));
    auto* tests = part<QTableWidget>(compare, "compareTests");
    QVERIFY(tests->isVisible());
    QCOMPARE(tests->item(0, 2)->text(), utf8("1000 … 2000"));
    auto* settings = part<QTableWidget>(compare, "compareSettings");
    QCOMPARE(settings->rowCount(), 1);
    QCOMPARE(settings->item(0, 0)->text(), utf8("min_angle"));
    compare->close();
}

void TestRunsDialog::reportsAreSaved()
{
    QTRY_COMPARE(rows(), 3);
    select({0});
    const QString path = m_dir->filePath(utf8("report.html"));
    button("runsReport")->click();
    choose(m_dialog, "runsReportDialog", path);
    QTRY_VERIFY(QFile::exists(path));
    QFile file(path);
    QVERIFY(file.open(QIODevice::ReadOnly));
    QCOMPARE(file.readAll(), report::sweepHtml(*runOf("SCS15", 3, 2), {}, false));
    QTRY_VERIFY(
        m_dialog->findChild<ui::TaskResult*>()->text().message.contains(utf8("report.html")));
    QFile readings(m_dir->filePath(utf8("report.readings.csv")));
    QVERIFY(readings.open(QIODevice::ReadOnly));
    QCOMPARE(readings.readAll(), QByteArray("time_us\n1\n"));
}

/// Neither a mark nor a comparison: it has no verdict on a good servo.
void TestRunsDialog::unfinishedRunsAreNoReference()
{
    auto stopped = std::make_shared<results::SweepRun>(*runOf("STS3215", 4, 9));
    stopped->end = results::SweepEnd::Stopped;
    m_historyService->saveRun(stopped);
    QTRY_COMPARE(rows(), 4);
    QVERIFY(cell(0, RunColumn::Verdict).contains(utf8("No verdict")));
    QVERIFY(!cell(1, RunColumn::Verdict).contains(utf8("No verdict")));
    select({1});
    QVERIFY(button("runsReference")->isEnabled());
    select({0});
    QVERIFY(!button("runsReference")->isEnabled());
    QVERIFY(button("runsReference")->toolTip().contains(utf8("did not finish")));
    // An earlier version marked it all the same.
    const auto file = history::HistoryFile::open(m_dir->filePath(utf8("history.sqlite")),
                                                 std::chrono::seconds(5));
    QVERIFY(file && (*file)->run(utf8("UPDATE run_servos SET reference = 1 WHERE id = 4")));
    std::optional<std::vector<session::ReferenceResult>> results;
    m_historyService->compareWithReference(runOf("STS3215", 5, 20), this,
                                           [&](const auto& answer) { results = answer.value(); });
    QTRY_VERIFY(results && results->size() == 1);
    const QString words = ui::referenceText(results->front());
    QVERIFY2(words.contains(utf8("is ignored")), qPrintable(words));
    m_historyService->setNote(4, utf8("marked")); // the list is asked again
    QTRY_COMPARE(cell(0, RunColumn::Note), utf8("marked"));
    QVERIFY(cell(0, RunColumn::Reference).contains(utf8("ignored")));
    select({0});
    button("runsReference")->click(); // the mark can be taken away
    QTRY_VERIFY(cell(0, RunColumn::Reference).isEmpty());
}

void TestRunsDialog::deletingAsksFirst()
{
    QTRY_COMPARE(rows(), 3);
    select({0, 2});
    button("runsDelete")->click();
    QTRY_VERIFY(m_dialog->findChild<QDialog*>(utf8("question")));
    part<QPushButton>(m_dialog, "questionNo")->click();
    QTRY_VERIFY(!m_dialog->findChild<QDialog*>(utf8("question")));
    QCOMPARE(rows(), 3);
    button("runsDelete")->click();
    QTRY_VERIFY(m_dialog->findChild<QDialog*>(utf8("question")));
    part<QPushButton>(m_dialog, "questionYes")->click();
    QTRY_COMPARE(rows(), 1);
    QCOMPARE(cell(0, RunColumn::Servo), utf8("2"));
}

void TestRunsDialog::anUnusableHistoryIsReported()
{
    delete m_dialog;
    const QString path = m_dir->filePath(utf8("folder.sqlite"));
    QVERIFY(QDir().mkpath(path));
    HistoryService broken(path);
    m_dialog = new RunsDialog(broken, *m_settings, nullptr);
    m_dialog->show();
    QTRY_VERIFY(!m_dialog->findChild<ui::TaskResult*>()->text().message.isEmpty());
    delete m_dialog;
}

void TestRunsDialog::isTranslated()
{
    QTRY_COMPARE(rows(), 3);
    select({1, 2});
    button("runsCompare")->click();
    QTRY_VERIFY(m_dialog->findChild<QDialog*>(utf8("compareDialog")));
    auto* compare = m_dialog->findChild<QDialog*>(utf8("compareDialog"));
    const auto complete = [&](QWidget* of) {
        const auto widgets = of->findChildren<QWidget*>();
        for (const QWidget* widget : widgets) {
            const bool used = qobject_cast<const QPushButton*>(widget) ||
                              qobject_cast<const QLineEdit*>(widget) ||
                              qobject_cast<const QTableView*>(widget);
            if (!used || widget->objectName().startsWith(utf8("qt_")))
                continue;
            QVERIFY2(!widget->accessibleName().isEmpty(), qPrintable(widget->objectName()));
            QVERIFY2(!widget->toolTip().isEmpty(), qPrintable(widget->objectName()));
        }
    };
    complete(m_dialog);
    complete(compare);
    auto* figures = part<QTableWidget>(compare, "compareFigures");
    ui::LanguageSwitch language;
    language.apply(utf8("zh_CN"));
    QTRY_COMPARE(figures->item(2, 0)->text(), utf8("超调"));
    QCOMPARE(compare->windowTitle(), utf8("两次扫描测试对比"));
    language.apply(utf8("en"));
    QTRY_COMPARE(figures->item(2, 0)->text(), utf8("Overshoot"));
}

void TestRunsDialog::theReferenceInAText()
{
    QTRY_COMPARE(rows(), 3);
    m_historyService->setReference(1, 1, true);
    auto worse = std::make_shared<results::SweepRun>(*runOf("STS3215", 5, 20));
    worse->servos[0].metrics[4].value = *worse->servos[0].metrics[4].value + 50;
    std::optional<std::vector<session::ReferenceResult>> results;
    m_historyService->compareWithReference(worse, this,
                                           [&](const auto& answer) { results = answer.value(); });
    QTRY_VERIFY(results && results->size() == 1);
    const QString words = ui::referenceText(results->front());
    QVERIFY2(words.contains(utf8("STS3215")), qPrintable(words));
    QVERIFY2(words.contains(utf8("Hysteresis, both directions +50 step (worse)")),
             qPrintable(words));
    worse->servos[0].axis.to = 5;
    results.reset();
    m_historyService->compareWithReference(worse, this,
                                           [&](const auto& answer) { results = answer.value(); });
    QTRY_VERIFY(results && results->size() == 1);
    QVERIFY(ui::referenceText(results->front()).contains(report::compareTexts().notComparable.en));
}

SERVODESK_TEST(TestRunsDialog)
#include "tst_runs_dialog.moc"
