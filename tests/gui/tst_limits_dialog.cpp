// SPDX-License-Identifier: GPL-3.0-or-later
// The editor of a sweep test's limits: what is typed comes out, what is wrong is said and cannot be
// used, files come and go without the window waiting, and the keyboard alone is enough.
#include "gui/desk_bench.h"
#include "text/language.h"
#include "ui/dialogs/limits_dialog.h"
#include "ui/dialogs/limits_model.h"

#include <QAbstractItemModelTester>
#include <QComboBox>
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QPointer>
#include <QPushButton>
#include <QSignalSpy>
#include <QTableView>

using record::SweepLimits;
using ui::LimitColumn;
using ui::LimitsDialog;
using ui::LimitsModel;

namespace {
QString q(const char* text)
{
    return QString::fromUtf8(text);
}

SweepLimits shop()
{
    SweepLimits limits;
    limits.name = q("shop");
    limits.models = QStringList{q("STS3215"), q("STS")};
    limits.tolerance = 12.5;
    limits.lines = {{q("overshoot"), q("%"), 3, 5, false},
                    {q("steady_error"), q("step"), {}, 8.125, false},
                    {q("voltage_min"), q("V"), 7, 6.5, true}};
    return limits;
}

/// The dialog deletes itself when it closes.
struct Bench {
    explicit Bench(const SweepLimits& limits = shop())
        : dialog(new LimitsDialog(limits, q("STS3215"), q("STS")))
        , chosen(dialog, &LimitsDialog::chosen)
    {
        dialog->open();
    }
    ~Bench() { delete dialog; }
    LimitsModel& model() const
    {
        return *qobject_cast<LimitsModel*>(dialog->findChild<QTableView*>()->model());
    }
    QTableView& table() const { return *dialog->findChild<QTableView*>(); }
    QPushButton& button(const char* name) const
    {
        return *dialog->findChild<QPushButton*>(q(name));
    }
    QLineEdit& field(const char* name) const { return *dialog->findChild<QLineEdit*>(q(name)); }
    QString said() const { return dialog->findChild<QLabel*>(q("limitsTrouble"))->text(); }
    bool type(int row, LimitColumn column, const QVariant& value) const
    {
        return model().setData(model().index(row, int(column)), value);
    }

    QPointer<LimitsDialog> dialog;
    QSignalSpy chosen;
};
} // namespace

class TestLimitsDialog : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init()
    {
        gui::failOnWarnings();
        text::installTranslator(q("en"));
    }
    void cleanup() { text::installTranslator(q("en")); }

    void whatGoesInComesOut();
    void editedNumbersAreUsed();
    void whatIsWrongIsSaid_data();
    void whatIsWrongIsSaid();
    void aNameIsNeeded();
    void aLineIsNeeded();
    void aNewLineIsAFigureWithoutOne();
    void aFigureBringsUnitAndDirection();
    void builtInValuesComeBack();
    void savedAndLoadedIsTheSame();
    void aFileThatIsWrongChangesNothing();
    void whereNothingCanBeKeptSaysSo();
    void theKeyboardIsEnough();
    void itFollowsTheLanguage();
};

void TestLimitsDialog::whatGoesInComesOut()
{
    const Bench bench;
    const QAbstractItemModelTester tester(&bench.model(),
                                          QAbstractItemModelTester::FailureReportingMode::QtTest);
    QVERIFY(bench.dialog->trouble().isEmpty());
    bench.button("limitsUse").click();
    QCOMPARE(bench.chosen.size(), 1);
    QCOMPARE(bench.chosen.front().front().value<SweepLimits>(), shop());
    QTRY_VERIFY(bench.dialog.isNull());
}

void TestLimitsDialog::editedNumbersAreUsed()
{
    const Bench bench;
    QVERIFY(bench.type(0, LimitColumn::Warn, q(" 2,5 "))); // as typed on a German keyboard
    QVERIFY(bench.type(1, LimitColumn::Fail, q("")));
    QVERIFY(bench.type(1, LimitColumn::Warn, q("6")));
    bench.field("limitsModels").setText(q(" STS3250 ,, HLS "));
    bench.field("limitsTolerance").clear();
    const SweepLimits now = bench.dialog->limits();
    QCOMPARE(now.lines[0].warn, std::optional(2.5));
    QCOMPARE(now.lines[1].fail, std::nullopt);
    QCOMPARE(now.lines[1].warn, std::optional(6.0));
    QCOMPARE(now.models, (QStringList{q("STS3250"), q("HLS")}));
    QCOMPARE(now.tolerance, std::nullopt);
    QVERIFY2(bench.dialog->trouble().isEmpty(), qPrintable(bench.dialog->trouble()));
}

void TestLimitsDialog::whatIsWrongIsSaid_data()
{
    QTest::addColumn<int>("row");
    QTest::addColumn<int>("column");
    QTest::addColumn<QString>("typed");
    QTest::addColumn<QString>("said");
    QTest::newRow("no number") << 0 << int(LimitColumn::Warn) << q("abc")
                               << q("Line 1, Overshoot: \"abc\" is not a number");
    QTest::newRow("infinite") << 0 << int(LimitColumn::Fail) << q("inf") << q("not a number");
    QTest::newRow("negative") << 1 << int(LimitColumn::Fail) << q("-3") << q("never negative");
    QTest::newRow("neither") << 1 << int(LimitColumn::Fail) << q("") << q("Give a number");
    QTest::newRow("crossed") << 0 << int(LimitColumn::Warn) << q("7")
                             << q("would fail before it warns");
    QTest::newRow("crossed below") << 2 << int(LimitColumn::Warn) << q("6")
                                   << q("Line 3, Lowest voltage: It would fail before it warns");
    QTest::newRow("twice") << 1 << int(LimitColumn::Figure) << q("overshoot")
                           << q("has a limit in the same direction already");
}

void TestLimitsDialog::whatIsWrongIsSaid()
{
    QFETCH(int, row);
    QFETCH(int, column);
    QFETCH(QString, typed);
    QFETCH(QString, said);
    const Bench bench;
    QVERIFY(bench.said().isEmpty());
    QVERIFY(bench.type(row, LimitColumn(column), typed));
    QVERIFY2(bench.said().contains(said), qPrintable(bench.said()));
    QVERIFY(!bench.button("limitsUse").isEnabled());
    QVERIFY(!bench.button("limitsSave").isEnabled());
    const QModelIndex wrong = bench.model().index(row, int(LimitColumn::Figure));
    QVERIFY(!wrong.data(Qt::ToolTipRole).toString().isEmpty());
    bench.model().setLines(shop().lines);
    QVERIFY(bench.said().isEmpty());
    QVERIFY(bench.button("limitsUse").isEnabled());
}

void TestLimitsDialog::aNameIsNeeded()
{
    const Bench bench;
    bench.field("limitsName").setText(q("  "));
    QVERIFY(bench.said().contains(q("name")));
    QVERIFY(!bench.button("limitsUse").isEnabled());
    bench.field("limitsName").setText(q("mine"));
    QVERIFY(bench.button("limitsUse").isEnabled());
    for (const char* tolerance : {"0", "-4", "near"}) {
        bench.field("limitsTolerance").setText(q(tolerance));
        QVERIFY2(bench.said().contains(q("tolerance")), tolerance);
    }
}

void TestLimitsDialog::aLineIsNeeded()
{
    const Bench bench;
    for (int left = 3; left > 0; --left) {
        QVERIFY(bench.button("limitsRemove").isEnabled());
        bench.button("limitsRemove").click();
        QCOMPARE(bench.model().rowCount(), left - 1);
    }
    QVERIFY(bench.said().contains(q("every servo would pass")));
    QVERIFY(!bench.button("limitsRemove").isEnabled());
}

void TestLimitsDialog::aNewLineIsAFigureWithoutOne()
{
    const Bench bench;
    const QAbstractItemModelTester tester(&bench.model(),
                                          QAbstractItemModelTester::FailureReportingMode::QtTest);
    bench.button("limitsAdd").click();
    QCOMPARE(bench.model().rowCount(), 4);
    const auto line = bench.model().lines().back();
    QCOMPARE(line.metric, record::sweepMetricKinds().front().key);
    QVERIFY(bench.said().contains(q("Give a number"))); // it judges nothing yet
    QVERIFY(bench.type(3, LimitColumn::Fail, q("1600")));
    QVERIFY(bench.said().isEmpty());
}

void TestLimitsDialog::aFigureBringsUnitAndDirection()
{
    const Bench bench;
    QVERIFY(bench.type(1, LimitColumn::Figure, q("mean_speed")));
    auto line = bench.model().lines()[1];
    QCOMPARE(line.unit, q("step/s"));
    QVERIFY(line.atLeast);
    QVERIFY(bench.type(1, LimitColumn::Direction, false));
    line = bench.model().lines()[1];
    QVERIFY(!line.atLeast);
    QVERIFY(!bench.type(1, LimitColumn::Figure, q("beauty")));
    QVERIFY(!bench.type(1, LimitColumn::Unit, q("kg")));
}

void TestLimitsDialog::builtInValuesComeBack()
{
    const Bench bench;
    bench.button("limitsBuiltIn").click();
    QCOMPARE(bench.dialog->limits(), record::builtInSweepLimits(q("STS3215"), q("STS")));
    QVERIFY(bench.dialog->trouble().isEmpty());
}

void TestLimitsDialog::savedAndLoadedIsTheSame()
{
    const QTemporaryDir folder;
    const QString path = folder.filePath(q("限值.json"));
    const Bench bench;
    QSignalSpy saved(bench.dialog, &LimitsDialog::saved);
    bench.dialog->save(path);
    QTRY_COMPARE(saved.size(), 1);
    QVERIFY(bench.said().contains(q("限值.json")));
    const auto kept = record::loadSweepLimits(path);
    QVERIFY(kept);
    QCOMPARE(*kept, shop());
    const Bench other(record::builtInSweepLimits(QString(), QString()));
    QSignalSpy loaded(other.dialog, &LimitsDialog::loaded);
    other.dialog->load(path);
    QTRY_COMPARE(loaded.size(), 1);
    QCOMPARE(other.dialog->limits(), shop());
}

void TestLimitsDialog::aFileThatIsWrongChangesNothing()
{
    const QTemporaryDir folder;
    const QString path = folder.filePath(q("bad.json"));
    QFile file(path);
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write("{\"format\": \"servodesk-limits\", \"version\": 1, \"name\": \"x\", \"lines\": "
               "[{\"metric\": \"beauty\", \"unit\": \"kg\", \"fail\": 1}]}");
    file.close();
    const Bench bench;
    for (const QString& wrong : {path, folder.filePath(q("no-such-file.json"))}) {
        bench.dialog->load(wrong);
        QTRY_VERIFY(bench.said().contains(QFileInfo(wrong).fileName()));
        QCOMPARE(bench.dialog->limits(), shop());
        bench.model().setLines(shop().lines);
    }
    // Closed while a file is read: nobody is there to be told.
    bench.dialog->load(path);
    bench.button("limitsCancel").click();
    QTRY_VERIFY(bench.dialog.isNull());
    QCOMPARE(bench.chosen.size(), 0);
}

void TestLimitsDialog::whereNothingCanBeKeptSaysSo()
{
    const QTemporaryDir folder;
    const Bench bench;
    bench.dialog->save(folder.filePath(q("no/such/folder.json")));
    QTRY_VERIFY(bench.said().contains(q("folder.json")));
}

void TestLimitsDialog::theKeyboardIsEnough()
{
    const Bench bench;
    QVERIFY(QTest::qWaitForWindowActive(bench.dialog));
    QTableView& table = bench.table();
    table.setFocus();
    table.setCurrentIndex(bench.model().index(0, int(LimitColumn::Warn)));
    QTest::keyClick(&table, Qt::Key_F2);
    auto* line = table.findChild<QLineEdit*>(q("limitEditor"));
    QVERIFY(line != nullptr);
    line->selectAll();
    QTest::keyClicks(line, q("1.5"));
    QTest::keyClick(line, Qt::Key_Return);
    QTRY_COMPARE(bench.model().lines()[0].warn, std::optional(1.5));
    QVERIFY(bench.dialog); // Return ended the cell, not the dialog

    table.setCurrentIndex(bench.model().index(1, int(LimitColumn::Figure)));
    QTest::keyClick(&table, Qt::Key_F2);
    auto* box = table.findChild<QComboBox*>(q("limitEditor"));
    QVERIFY(box != nullptr);
    QTest::keyClick(box, Qt::Key_Down);
    QTest::keyClick(box, Qt::Key_Return);
    QTRY_COMPARE(bench.model().lines()[1].metric, q("hysteresis"));
}

void TestLimitsDialog::itFollowsTheLanguage()
{
    const Bench bench;
    text::installTranslator(q("zh_CN"));
    QEvent change(QEvent::LanguageChange);
    QCoreApplication::sendEvent(bench.dialog, &change);
    QCOMPARE(bench.model().index(0, int(LimitColumn::Figure)).data().toString(), q("超调"));
    QCOMPARE(bench.dialog->limits(), shop());
}

QTEST_MAIN(TestLimitsDialog)
#include "tst_limits_dialog.moc"
