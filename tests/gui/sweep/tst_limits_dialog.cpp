// SPDX-License-Identifier: GPL-3.0-or-later
// The editor of a sweep test's limits: what is typed comes out, what is wrong is said and cannot be
// used, files come and go without the window waiting, and the keyboard alone is enough.
#include "gui/workbench_fixture.h"
#include "session/settings.h"
#include "support/test_main.h"
#include "support/text.h"
#include "text/language.h"
#include "ui/sweep/limits_dialog.h"
#include "ui/sweep/limits_model.h"

#include <QAbstractItemModelTester>
#include <QComboBox>
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QPointer>
#include <QPushButton>
#include <QSignalSpy>
#include <QTableView>
#include <QTemporaryDir>

using results::SweepLimits;
using support::utf8;
using ui::LimitColumn;
using ui::LimitsDialog;
using ui::LimitsModel;

namespace {
SweepLimits customLimits()
{
    SweepLimits limits;
    limits.name = utf8("shop");
    limits.models = QStringList{utf8("STS3215"), utf8("STS")};
    limits.tolerance = 12.5;
    limits.lines = {{utf8("overshoot"), utf8("%"), 3, 5, false},
                    {utf8("steady_error"), utf8("step"), {}, 8.125, false},
                    {utf8("voltage_min"), utf8("V"), 7, 6.5, true}};
    return limits;
}

/// The dialog deletes itself when it closes.
struct Fixture {
    QTemporaryDir folder;
    session::Settings settings{folder.filePath(utf8("servodesk.ini"))};
    explicit Fixture(const SweepLimits& limits = customLimits())
        : dialog(new LimitsDialog(settings, limits, utf8("STS3215"), utf8("STS")))
        , chosen(dialog, &LimitsDialog::limitsAccepted)
    {
        dialog->open();
    }
    ~Fixture() { delete dialog; }
    LimitsModel& model() const
    {
        return *qobject_cast<LimitsModel*>(dialog->findChild<QTableView*>()->model());
    }
    QTableView& table() const { return *dialog->findChild<QTableView*>(); }
    QPushButton& button(const char* name) const
    {
        return *dialog->findChild<QPushButton*>(utf8(name));
    }
    QLineEdit& field(const char* name) const { return *dialog->findChild<QLineEdit*>(utf8(name)); }
    QString said() const { return dialog->findChild<QLabel*>(utf8("limitsTrouble"))->text(); }
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
        text::installTranslator(utf8("en"));
    }
    void cleanup() { text::installTranslator(utf8("en")); }

    void valuesRoundTrip();
    void editedValuesAreUsed();
    void errorsAreReported_data();
    void errorsAreReported();
    void aNameIsRequired();
    void aLimitIsRequired();
    void aNewLineOffersUnusedMetrics();
    void aMetricSetsUnitAndDirection();
    void builtInValuesComeBack();
    void changedBuiltInValuesAreNotCalledBuiltIn_data();
    void changedBuiltInValuesAreNotCalledBuiltIn();
    void saveAndLoadRoundTrip();
    void aBadFileChangesNothing();
    void unwritableSettingsAreReported();
    void worksWithTheKeyboard();
    void followsTheLanguage();
};

void TestLimitsDialog::valuesRoundTrip()
{
    const Fixture fixture;
    const QAbstractItemModelTester tester(&fixture.model(),
                                          QAbstractItemModelTester::FailureReportingMode::QtTest);
    QVERIFY(fixture.dialog->problem().isEmpty());
    fixture.button("limitsUse").click();
    QCOMPARE(fixture.chosen.size(), 1);
    QCOMPARE(fixture.chosen.front().front().value<SweepLimits>(), customLimits());
    QTRY_VERIFY(fixture.dialog.isNull());
}

void TestLimitsDialog::editedValuesAreUsed()
{
    const Fixture fixture;
    QVERIFY(fixture.type(0, LimitColumn::Warn, utf8(" 2,5 "))); // as typed on a German keyboard
    QVERIFY(fixture.type(1, LimitColumn::Fail, utf8("")));
    QVERIFY(fixture.type(1, LimitColumn::Warn, utf8("6")));
    fixture.field("limitsModels").setText(utf8(" STS3250 ,, HLS "));
    fixture.field("limitsTolerance").clear();
    const SweepLimits now = fixture.dialog->limits();
    QCOMPARE(now.lines[0].warn, std::optional(2.5));
    QCOMPARE(now.lines[1].fail, std::nullopt);
    QCOMPARE(now.lines[1].warn, std::optional(6.0));
    QCOMPARE(now.models, (QStringList{utf8("STS3250"), utf8("HLS")}));
    QCOMPARE(now.tolerance, std::nullopt);
    QVERIFY2(fixture.dialog->problem().isEmpty(), qPrintable(fixture.dialog->problem()));
}

void TestLimitsDialog::errorsAreReported_data()
{
    QTest::addColumn<int>("row");
    QTest::addColumn<int>("column");
    QTest::addColumn<QString>("typed");
    QTest::addColumn<QString>("said");
    QTest::newRow("no number") << 0 << int(LimitColumn::Warn) << utf8("abc")
                               << utf8("Row 1, Overshoot: \"abc\" is not a number");
    QTest::newRow("infinite") << 0 << int(LimitColumn::Fail) << utf8("inf") << utf8("not a number");
    QTest::newRow("negative") << 1 << int(LimitColumn::Fail) << utf8("-3")
                              << utf8("cannot be negative");
    QTest::newRow("neither") << 1 << int(LimitColumn::Fail) << utf8("")
                             << utf8("Enter a warning limit");
    QTest::newRow("crossed") << 0 << int(LimitColumn::Warn) << utf8("7")
                             << utf8("would be reached before the warning limit");
    QTest::newRow("crossed below")
        << 2 << int(LimitColumn::Warn) << utf8("6")
        << utf8("Row 3, Lowest voltage: The failure limit would be reached");
    QTest::newRow("twice") << 1 << int(LimitColumn::Metric) << utf8("overshoot")
                           << utf8("already has a limit of this kind");
}

void TestLimitsDialog::errorsAreReported()
{
    QFETCH(int, row);
    QFETCH(int, column);
    QFETCH(QString, typed);
    QFETCH(QString, said);
    const Fixture fixture;
    QVERIFY(fixture.said().isEmpty());
    QVERIFY(fixture.type(row, LimitColumn(column), typed));
    QVERIFY2(fixture.said().contains(said), qPrintable(fixture.said()));
    QVERIFY(!fixture.button("limitsUse").isEnabled());
    QVERIFY(!fixture.button("limitsSave").isEnabled());
    const QModelIndex wrong = fixture.model().index(row, int(LimitColumn::Metric));
    QVERIFY(!wrong.data(Qt::ToolTipRole).toString().isEmpty());
    fixture.model().setLines(customLimits().lines);
    QVERIFY(fixture.said().isEmpty());
    QVERIFY(fixture.button("limitsUse").isEnabled());
}

void TestLimitsDialog::aNameIsRequired()
{
    const Fixture fixture;
    fixture.field("limitsName").setText(utf8("  "));
    QVERIFY(fixture.said().contains(utf8("Enter a name")));
    QVERIFY(!fixture.button("limitsUse").isEnabled());
    fixture.field("limitsName").setText(utf8("mine"));
    QVERIFY(fixture.button("limitsUse").isEnabled());
    for (const char* tolerance : {"0", "-4", "near"}) {
        fixture.field("limitsTolerance").setText(utf8(tolerance));
        QVERIFY2(fixture.said().contains(utf8("tolerance")), tolerance);
    }
}

void TestLimitsDialog::aLimitIsRequired()
{
    const Fixture fixture;
    for (int left = 3; left > 0; --left) {
        QVERIFY(fixture.button("limitsRemove").isEnabled());
        fixture.button("limitsRemove").click();
        QCOMPARE(fixture.model().rowCount(), left - 1);
    }
    QVERIFY(fixture.said().contains(utf8("every servo would pass")));
    QVERIFY(!fixture.button("limitsRemove").isEnabled());
}

void TestLimitsDialog::aNewLineOffersUnusedMetrics()
{
    const Fixture fixture;
    const QAbstractItemModelTester tester(&fixture.model(),
                                          QAbstractItemModelTester::FailureReportingMode::QtTest);
    fixture.button("limitsAdd").click();
    QCOMPARE(fixture.model().rowCount(), 4);
    const auto line = fixture.model().lines().back();
    QCOMPARE(line.metric, results::sweepMetricKinds().front().key);
    QVERIFY(fixture.said().contains(utf8("Enter a warning limit"))); // it judges nothing yet
    QVERIFY(fixture.type(3, LimitColumn::Fail, utf8("1600")));
    QVERIFY(fixture.said().isEmpty());
}

void TestLimitsDialog::aMetricSetsUnitAndDirection()
{
    const Fixture fixture;
    QVERIFY(fixture.type(1, LimitColumn::Metric, utf8("mean_speed")));
    auto line = fixture.model().lines()[1];
    QCOMPARE(line.unit, utf8("step/s"));
    QVERIFY(line.atLeast);
    QVERIFY(fixture.type(1, LimitColumn::Direction, false));
    line = fixture.model().lines()[1];
    QVERIFY(!line.atLeast);
    QVERIFY(!fixture.type(1, LimitColumn::Metric, utf8("beauty")));
    QVERIFY(!fixture.type(1, LimitColumn::Unit, utf8("kg")));
}

void TestLimitsDialog::builtInValuesComeBack()
{
    const Fixture fixture;
    fixture.button("limitsBuiltIn").click();
    QCOMPARE(fixture.dialog->limits(), results::builtInSweepLimits(utf8("STS3215"), utf8("STS")));
    QVERIFY(fixture.dialog->problem().isEmpty());
}

void TestLimitsDialog::changedBuiltInValuesAreNotCalledBuiltIn_data()
{
    QTest::addColumn<QString>("language");
    QTest::addColumn<QString>("series");
    QTest::addColumn<QString>("builtInName");
    QTest::addColumn<QString>("customName");
    QTest::newRow("English") << utf8("en") << utf8("STS") << utf8("4096 steps a turn, built in")
                             << utf8("STS3215, custom");
    QTest::newRow("Chinese") << utf8("zh_CN") << utf8("STS") << utf8("每圈 4096 步（内置）")
                             << utf8("STS3215（自定）");
    QTest::newRow("of another family")
        << utf8("zh_CN") << utf8("SCS") << utf8("SCS，1024 步（内置）") << utf8("STS3215（自定）");
}

void TestLimitsDialog::changedBuiltInValuesAreNotCalledBuiltIn()
{
    QFETCH(QString, language);
    QFETCH(QString, builtInName);
    QFETCH(QString, series);
    QFETCH(QString, customName);
    text::installTranslator(language);
    const SweepLimits builtIn = results::builtInSweepLimits({}, series);
    const Fixture fixture(builtIn);
    QCOMPARE(fixture.field("limitsName").text(), builtInName);
    QCOMPARE(fixture.dialog->limits(), builtIn);
    QVERIFY(fixture.type(0, LimitColumn::Warn, utf8("0.5")));
    const SweepLimits changed = fixture.dialog->limits();
    QCOMPARE(changed.name, utf8("STS3215, custom")); // in every language, as it is stored
    const Fixture again(changed);
    QCOMPARE(again.field("limitsName").text(), customName);
    QCOMPARE(again.dialog->limits(), changed);
    fixture.field("limitsName").setText(utf8("mine"));
    QCOMPARE(fixture.dialog->limits().name, utf8("mine"));
}

void TestLimitsDialog::saveAndLoadRoundTrip()
{
    const QTemporaryDir folder;
    const QString path = folder.filePath(utf8("限值.json"));
    const Fixture fixture;
    QSignalSpy saved(fixture.dialog, &LimitsDialog::saved);
    fixture.dialog->save(path);
    QTRY_COMPARE(saved.size(), 1);
    QVERIFY(fixture.said().contains(utf8("限值.json")));
    const auto kept = results::loadSweepLimits(path);
    QVERIFY(kept);
    QCOMPARE(*kept, customLimits());
    const Fixture other(results::builtInSweepLimits(QString(), QString()));
    QSignalSpy loaded(other.dialog, &LimitsDialog::loaded);
    other.dialog->load(path);
    QTRY_COMPARE(loaded.size(), 1);
    QCOMPARE(other.dialog->limits(), customLimits());
}

void TestLimitsDialog::aBadFileChangesNothing()
{
    const QTemporaryDir folder;
    const QString path = folder.filePath(utf8("bad.json"));
    QFile file(path);
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write("{\"format\": \"servodesk-limits\", \"version\": 1, \"name\": \"x\", \"lines\": "
               "[{\"metric\": \"beauty\", \"unit\": \"kg\", \"fail\": 1}]}");
    file.close();
    const Fixture fixture;
    for (const QString& wrong : {path, folder.filePath(utf8("no-such-file.json"))}) {
        fixture.dialog->load(wrong);
        QTRY_VERIFY(fixture.said().contains(QFileInfo(wrong).fileName()));
        QCOMPARE(fixture.dialog->limits(), customLimits());
        fixture.model().setLines(customLimits().lines);
    }
    // Closed while a file is read: nobody is there to be told.
    fixture.dialog->load(path);
    fixture.button("limitsCancel").click();
    QTRY_VERIFY(fixture.dialog.isNull());
    QCOMPARE(fixture.chosen.size(), 0);
}

void TestLimitsDialog::unwritableSettingsAreReported()
{
    const QTemporaryDir folder;
    const Fixture fixture;
    fixture.dialog->save(folder.filePath(utf8("no/such/folder.json")));
    QTRY_VERIFY(fixture.said().contains(utf8("folder.json")));
}

void TestLimitsDialog::worksWithTheKeyboard()
{
    const Fixture fixture;
    QVERIFY(QTest::qWaitForWindowActive(fixture.dialog));
    QTableView& table = fixture.table();
    table.setFocus();
    table.setCurrentIndex(fixture.model().index(0, int(LimitColumn::Warn)));
    QTest::keyClick(&table, Qt::Key_F2);
    auto* line = table.findChild<QLineEdit*>(utf8("limitEditor"));
    QVERIFY(line != nullptr);
    line->selectAll();
    QTest::keyClicks(line, utf8("1.5"));
    QTest::keyClick(line, Qt::Key_Return);
    QTRY_COMPARE(fixture.model().lines()[0].warn, std::optional(1.5));
    QVERIFY(fixture.dialog); // Return ended the cell, not the dialog

    table.setCurrentIndex(fixture.model().index(1, int(LimitColumn::Metric)));
    QTest::keyClick(&table, Qt::Key_F2);
    auto* box = table.findChild<QComboBox*>(utf8("limitEditor"));
    QVERIFY(box != nullptr);
    QTest::keyClick(box, Qt::Key_Down);
    QTest::keyClick(box, Qt::Key_Return);
    QTRY_COMPARE(fixture.model().lines()[1].metric, utf8("hysteresis"));
}

void TestLimitsDialog::followsTheLanguage()
{
    const Fixture fixture;
    text::installTranslator(utf8("zh_CN"));
    QEvent change(QEvent::LanguageChange);
    QCoreApplication::sendEvent(fixture.dialog, &change);
    QCOMPARE(fixture.model().index(0, int(LimitColumn::Metric)).data().toString(), utf8("超调"));
    QCOMPARE(fixture.dialog->limits(), customLimits());
}

SERVODESK_TEST(TestLimitsDialog)
#include "tst_limits_dialog.moc"
