// SPDX-License-Identifier: GPL-3.0-or-later
// The history page: what was written at the bench is listed with its outcome, found by servo and
// register, exported, and leads back to the table as it was. Everything from the real database.
#include "gui/dialogs.h"
#include "gui/main_window_fixture.h"
#include "history/history.h"
#include "session/history/history_sender.h"
#include "session/history/history_service.h"
#include "session/paths.h"
#include "support/history_example.h"
#include "support/test_main.h"
#include "ui/history/history_formatter.h"
#include "ui/history/history_page.h"
#include "ui/snapshots/compare_model.h"
#include "ui/snapshots/snapshots_page.h"

#include <QAbstractItemModelTester>
#include <QCheckBox>
#include <QComboBox>
#include <QDateEdit>
#include <QFileDialog>
#include <QLabel>
#include <QLineEdit>
#include <QPointer>
#include <QPushButton>
#include <QRegularExpression>
#include <QScrollBar>
#include <QTabWidget>
#include <QTableView>
#include <QTreeWidget>

namespace {
const QString two = QStringLiteral("sim:sts3215@1,sts3215@2");

struct HistoryPageFixture : gui::MainWindowFixture {
    explicit HistoryPageFixture(const QString& language = QStringLiteral("en"))
        : MainWindowFixture(language)
    {
        page = QStringLiteral("history");
    }
    QTableView* table() { return find<QTableView>("historyTable"); }
    int rows() { return table()->model()->rowCount(); }
    QString cell(int row, int column)
    {
        return table()->model()->index(row, column).data().toString();
    }
    using MainWindowFixture::choose;
    void choose(const char* name, int index)
    {
        auto* box = find<QComboBox>(name);
        QVERIFY(box != nullptr && index < box->count());
        box->setCurrentIndex(index);
        Q_EMIT box->activated(index);
    }
    void choose(const char* name, const QString& text)
    {
        const int index = find<QComboBox>(name)->findText(text, Qt::MatchContains);
        QVERIFY2(index >= 0, qPrintable(text));
        choose(name, index);
    }
    bool write(const char* key, std::int64_t value)
    {
        workbench().writes().write(
            selection().current(),
            {{{QString::fromLatin1(key), value}}, false, device::Consent::confirmed()});
        return waitUntilIdle();
    }
};
} // namespace

class TestHistoryPage : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { gui::failOnWarnings(); }

    /// A server that cannot be used is named with the cause and what to do, in the window itself.
    void aServerErrorIsExplained_data()
    {
        QTest::addColumn<QString>("language");
        QTest::addColumn<QString>("what");
        QTest::addColumn<QString>("remedy");
        QTest::newRow("en") << "en"
                            << "cannot be reached"
                            << "Check the host and port";
        QTest::newRow("zh") << "zh_CN"
                            << "无法连接"
                            << "检查";
    }

    void aServerErrorIsExplained()
    {
        QFETCH(QString, language);
        QFETCH(QString, what);
        QFETCH(QString, remedy);
        HistoryPageFixture fixture(language);
        QVERIFY(fixture.ready(1, two));
        QVERIFY(fixture.write("position_p", 40));
        fixture.MainWindowFixture::context.workbench.historySender().setServer(
            QStringLiteral("host=127.0.0.1 port=1 dbname=shop"), QStringLiteral("Bench"));
        auto* state = fixture.find<QLabel>("historyServerState");
        QTRY_VERIFY2(state->text().contains(what), qPrintable(state->text()));
        QVERIFY2(state->text().contains(remedy), qPrintable(state->text()));
        QVERIFY(state->isVisible() && state->wordWrap());
        QTRY_VERIFY(state->height() >= state->heightForWidth(state->width()));
    }

    /// A password is refused beside the field, and neither kept nor sent anywhere.
    void aPasswordIsRefused()
    {
        HistoryPageFixture fixture;
        QVERIFY(fixture.ready(1, two));
        const auto openDialog = [&] {
            QTest::mouseClick(fixture.find<QPushButton>("historyServer"), Qt::LeftButton);
            return fixture.find<QDialog>("historyServerDialog");
        };
        QPointer<QDialog> dialog = openDialog();
        QVERIFY(dialog != nullptr);
        auto* address = dialog->findChild<QLineEdit*>(QStringLiteral("serverAddress"));
        auto* refusal = dialog->findChild<QLabel*>(QStringLiteral("serverRefusal"));
        auto* save = dialog->findChild<QPushButton*>(QStringLiteral("serverSave"));
        QVERIFY(!refusal->isVisible());
        QTest::keyClicks(address, QStringLiteral("postgresql://u:swordfish@127.0.0.1:1/db"));
        QTest::mouseClick(save, Qt::LeftButton);
        QVERIFY(dialog != nullptr && dialog->isVisible());
        QVERIFY(refusal->isVisible());
        QVERIFY2(refusal->text().contains(QStringLiteral("~/.pgpass")),
                 qPrintable(refusal->text()));
        QVERIFY(!refusal->text().contains(QStringLiteral("swordfish")));
        QVERIFY(!fixture.settings.pageValue(QStringLiteral("history/server"), QString())
                     .toString()
                     .contains(QStringLiteral("swordfish")));
        QCOMPARE(int(fixture.MainWindowFixture::context.workbench.historySender().state().phase),
                 int(session::SendState::Phase::Off));
        address->clear();
        QTest::keyClicks(address, QStringLiteral("postgresql://u@127.0.0.1:1/db"));
        QVERIFY(!refusal->isVisible());
        QTest::mouseClick(save, Qt::LeftButton);
        QTRY_VERIFY(dialog == nullptr);
        QCOMPARE(fixture.settings.pageValue(QStringLiteral("history/server"), QString()).toString(),
                 QStringLiteral("postgresql://u@127.0.0.1:1/db"));
        // One from the environment is shown masked, and not kept either.
        qputenv("SERVODESK_HISTORY_SERVER", "postgresql://u:swordfish@127.0.0.1:1/db");
        dialog = openDialog();
        address = dialog->findChild<QLineEdit*>(QStringLiteral("serverAddress"));
        QVERIFY(!address->text().contains(QStringLiteral("swordfish")));
        QTest::mouseClick(dialog->findChild<QPushButton*>(QStringLiteral("serverSave")),
                          Qt::LeftButton);
        QTRY_VERIFY(dialog == nullptr);
        qunsetenv("SERVODESK_HISTORY_SERVER");
        QCOMPARE(fixture.settings.pageValue(QStringLiteral("history/server"), QString()).toString(),
                 QStringLiteral("postgresql://u@127.0.0.1:1/db"));
        QVERIFY(fixture.MainWindowFixture::context.workbench.historySender().state().phase !=
                session::SendState::Phase::Off);
    }

    void writesAreListedWithTheirOutcome()
    {
        HistoryPageFixture fixture;
        QVERIFY(fixture.ready(1, two));
        const QAbstractItemModelTester tester(fixture.table()->model());
        QTRY_COMPARE(fixture.find<QLabel>("historyCount")->text(), QStringLiteral("No entries"));
        auto* nothing = fixture.find<QLabel>("historyNothing");
        QVERIFY2(nothing->text().startsWith(QStringLiteral("No entries under “Writes” yet.")),
                 qPrintable(nothing->text()));
        fixture.find<QCheckBox>("historyTrouble")->click();
        QTRY_VERIFY2(nothing->text().contains(QStringLiteral("match the filters")),
                     qPrintable(nothing->text()));
        fixture.find<QCheckBox>("historyTrouble")->click();
        QVERIFY(fixture.write("position_p", 40));
        QTRY_COMPARE(fixture.rows(), 1);
        QVERIFY(fixture.cell(0, 1).contains(QStringLiteral("STS3215 · ID 1")));
        QCOMPARE(fixture.cell(0, 3), QStringLiteral("32"));
        QCOMPARE(fixture.cell(0, 4), QStringLiteral("40"));
        QTRY_VERIFY(fixture.cell(0, 5).startsWith(QStringLiteral("✔")));
        // Its name, not its key; a list asked for while the servo was being met is asked for again.
        QTRY_VERIFY2(!fixture.cell(0, 2).contains(QLatin1Char('_')),
                     qPrintable(fixture.cell(0, 2)));
    }

    /// The list is narrow; the details have the whole time.
    void theListNamesTimesInFewLetters()
    {
        const QDateTime at(QDate(2026, 3, 1), QTime(9, 5, 7));
        QCOMPARE(ui::HistoryFormatter::listTime(at, at.date()), QStringLiteral("09:05:07"));
        QCOMPARE(ui::HistoryFormatter::listTime(at, at.date().addDays(1)),
                 QStringLiteral("2026-03-01 09:05"));
        HistoryPageFixture fixture;
        QVERIFY(fixture.ready(1, two));
        QVERIFY(fixture.write("position_p", 40));
        QTRY_COMPARE(fixture.rows(), 1);
        QVERIFY(!fixture.cell(0, 0).isEmpty() && fixture.cell(0, 0).size() < 17);
        const QString tip = fixture.table()->model()->index(0, 0).data(Qt::ToolTipRole).toString();
        QVERIFY2(tip.contains(QRegularExpression(
                     QStringLiteral("\\d{4}-\\d\\d-\\d\\d \\d\\d:\\d\\d:\\d\\d"))),
                 qPrintable(tip));
    }

    void undosAreLabeledAndValuesHaveUnits()
    {
        HistoryPageFixture fixture;
        QVERIFY(fixture.ready(1, two));
        QVERIFY(fixture.write("max_temperature", 61));
        fixture.workbench().writes().undo();
        QVERIFY(fixture.waitUntilIdle());
        QTRY_COMPARE(fixture.rows(), 2);
        QTRY_COMPARE(fixture.cell(0, 6), QStringLiteral("undo"));
        QCOMPARE(fixture.cell(1, 6), QStringLiteral("write"));
        QTRY_COMPARE(fixture.cell(1, 4), QStringLiteral("61 · 61 °C"));
        QCOMPARE(fixture.cell(0, 3), QStringLiteral("61 · 61 °C"));
    }

    /// A label stays with the servo when its ID changes, and so does its list.
    void aLabeledServoKeepsItsHistoryThroughAnIdChange()
    {
        HistoryPageFixture fixture;
        QVERIFY(fixture.ready(1, two));
        QVERIFY(fixture.write("position_p", 40));
        const auto servo = history::History::open(session::historyFile())
                               .value()
                               ->log()
                               .of(fixture.entry().servo.identity())
                               .value();
        QVERIFY(servo);
        fixture.MainWindowFixture::context.workbench.history().setServoLabel(
            servo->number, QStringLiteral("Elbow"));
        QTRY_VERIFY(fixture.find<QComboBox>("historyServo")
                        ->findText(QStringLiteral("Elbow"), Qt::MatchContains) > 0);
        QVERIFY(fixture.write("id", 7));
        QVERIFY(fixture.write("position_p", 41));
        QTRY_COMPARE(fixture.rows(), 3);
        auto* servos = fixture.find<QComboBox>("historyServo");
        const auto named = [&] {
            int count = 0;
            for (int i = 0; i < servos->count(); ++i)
                count += servos->itemText(i).contains(QStringLiteral("Elbow")) ? 1 : 0;
            return count;
        };
        QTRY_COMPARE(named(), 1);
        QTRY_VERIFY(servos->findText(QStringLiteral("ID 7 · Elbow"), Qt::MatchContains) > 0);
        fixture.choose("historyServo", QStringLiteral("Elbow"));
        QTRY_COMPARE(fixture.rows(), 3);
        // The next one that comes to the old ID is not the elbow.
        base::ServoIdentity next = fixture.entry().servo.identity();
        next.id = 1;
        const auto there =
            history::History::open(session::historyFile()).value()->log().of(next).value();
        QVERIFY(there && there->label.isEmpty());
    }

    /// As by servodesk-cli, with another connection: the page shows it by itself, and what was
    /// selected and scrolled to stays.
    void writesOfAnotherProgramAreShown()
    {
        HistoryPageFixture fixture;
        QVERIFY(fixture.ready(1, two));
        const QAbstractItemModelTester tester(fixture.table()->model());
        QTRY_COMPARE(fixture.find<QLabel>("historyCount")->text(), QStringLiteral("No entries"));
        history::HistoryJournal other(session::historyFile(), QStringLiteral("servodesk-cli"));
        history_example::write(other, 4, 0);
        QTRY_COMPARE(fixture.rows(), 2); // it writes two registers at once
        QTRY_COMPARE(fixture.find<QLabel>("historyCount")->text(), QStringLiteral("2 rows"));
        for (int i = 1; i < 40; ++i)
            history_example::write(other, 4, i);
        QTRY_COMPARE(fixture.rows(), 80);
        fixture.table()->selectRow(41);
        auto* bar = fixture.table()->verticalScrollBar();
        bar->setValue(bar->maximum() / 2);
        QVERIFY(bar->value() > 0);
        const auto top = [&] {
            const int row = fixture.table()->rowAt(0);
            return fixture.cell(row, 2) + fixture.cell(row, 4);
        };
        const QString before = top();
        const QString selected = fixture.cell(41, 2) + fixture.cell(41, 4);
        history_example::write(other, 5, 1000);
        QTRY_COMPARE(fixture.rows(), 82);
        const QModelIndexList rows = fixture.table()->selectionModel()->selectedRows();
        QCOMPARE(rows.size(), 1);
        QCOMPARE(fixture.cell(rows[0].row(), 2) + fixture.cell(rows[0].row(), 4), selected);
        QCOMPARE(top(), before);
    }

    /// What ended elsewhere meanwhile gets its outcome, what was deleted goes.
    void changesOfAnotherProgramAreShownInPlace()
    {
        HistoryPageFixture fixture;
        QVERIFY(fixture.ready(1, two));
        history::HistoryJournal other(session::historyFile(), QStringLiteral("servodesk-cli"));
        const QString open = history_example::write(other, 4, 7, "");
        QTRY_COMPARE(fixture.rows(), 2);
        fixture.table()->selectRow(0);
        const QString unfinished = fixture.cell(0, 5);
        history_example::requireOk(other.end(open, {QStringLiteral("done"), QString()}));
        QTRY_VERIFY(fixture.cell(0, 5) != unfinished);
        QCOMPARE(fixture.table()->selectionModel()->selectedRows().size(), 1);
        fixture.choose("historyKind", QStringLiteral("Snapshots"));
        QTRY_COMPARE(fixture.rows(), 0);
        const auto history = history::History::open(session::historyFile()).value();
        const auto number =
            history->log()
                .addSnapshot(history_example::snapshot(4, "one"), history::SnapshotReason::Manual)
                .value();
        QTRY_COMPARE(fixture.rows(), 1);
        history_example::requireOk(history->log().removeSnapshot(number));
        QTRY_COMPARE(fixture.rows(), 0);
    }

    void aReshownPageIsUpToDate()
    {
        HistoryPageFixture fixture;
        QVERIFY(fixture.ready(1, two));
        QTRY_COMPARE(fixture.find<QLabel>("historyCount")->text(), QStringLiteral("No entries"));
        fixture.action(ui::Command::PageMemory)->trigger();
        QTRY_VERIFY(!fixture.table()->isVisible());
        history::HistoryJournal other(session::historyFile(), QStringLiteral("servodesk-cli"));
        history_example::write(other, 4, 7);
        fixture.action(ui::Command::PageHistory)->trigger();
        QTRY_VERIFY(fixture.table()->isVisible());
        QTRY_COMPARE(fixture.rows(), 2);
    }

    void filteredByServoRegisterAndTime()
    {
        HistoryPageFixture fixture;
        QVERIFY(fixture.ready(1, two));
        QVERIFY(fixture.write("position_p", 40));
        QVERIFY(fixture.write("position_d", 30));
        QVERIFY(fixture.choose(2));
        QVERIFY(fixture.write("position_p", 41));
        QTRY_COMPARE(fixture.rows(), 3);
        QTRY_COMPARE(fixture.find<QComboBox>("historyServo")->count(), 3);
        fixture.choose("historyServo", QStringLiteral("ID 1"));
        QTRY_COMPARE(fixture.rows(), 2);
        fixture.choose("historyRegister", QStringLiteral("position_d"));
        QTRY_COMPARE(fixture.rows(), 1);
        fixture.choose("historyServo", 0);
        fixture.choose("historyRegister", 0);
        QTRY_COMPARE(fixture.rows(), 3);
        fixture.choose("historyPeriod", fixture.find<QComboBox>("historyPeriod")->count() - 1);
        QTRY_VERIFY(fixture.find<QDateEdit>("historyFrom")->isVisible());
        fixture.find<QDateEdit>("historyFrom")->setDate(QDate(2001, 1, 1));
        fixture.find<QDateEdit>("historyUntil")->setDate(QDate(2001, 1, 2));
        QTRY_COMPARE(fixture.rows(), 0);
        fixture.choose("historyPeriod", 1); // today
        QTRY_COMPARE(fixture.rows(), 3);
        QTest::mouseClick(fixture.find<QCheckBox>("historyTrouble"), Qt::LeftButton);
        QTRY_COMPARE(fixture.rows(), 0);
    }

    /// From a write back to the table before it, which can be restored.
    void theTableOfAnyTimeCanBeRestored()
    {
        HistoryPageFixture fixture;
        QVERIFY(fixture.ready(1, two));
        QVERIFY(fixture.write("position_p", 40));
        QVERIFY(fixture.write("position_p", 50));
        QTRY_COMPARE(fixture.rows(), 2);
        fixture.table()->selectRow(0);
        QCOMPARE(fixture.cell(0, 4), QStringLiteral("50"));
        QTRY_VERIFY(fixture.find<QPushButton>("historyOpen")->isEnabled());
        QTest::mouseClick(fixture.find<QPushButton>("historyOpen"), Qt::LeftButton);
        QTRY_VERIFY(fixture.isShown("snapshotsPage"));
        auto* write = fixture.find<QPushButton>("restoreWrite");
        QTRY_COMPARE(write->text(), QStringLiteral("Write 1 selected row"));
        QTRY_VERIFY(write->isEnabled());
        QTest::mouseClick(write, Qt::LeftButton);
        QTRY_COMPARE(fixture.raw("position_p"), 40);
    }

    /// Beside the list: everything about the entry, and the way back, after asking.
    void aWriteOfTheListIsUndone()
    {
        HistoryPageFixture fixture;
        QVERIFY(fixture.ready(1, two));
        QVERIFY(fixture.write("position_p", 40));
        QVERIFY(fixture.write("position_d", 30));
        QTRY_COMPARE(fixture.rows(), 2);
        auto* undo = fixture.find<QPushButton>("historyUndo");
        QTRY_VERIFY(undo->isEnabled()); // the newest is selected by itself
        fixture.table()->selectRow(1);
        QTRY_VERIFY(gui::labelsOf(fixture.find<QWidget>("historyDetails"))
                        .contains(QStringLiteral("21 (position_p)")));
        QTest::mouseClick(undo, Qt::LeftButton);
        auto* question = fixture.find<QDialog>("question");
        QVERIFY(question != nullptr);
        const QString words = gui::labelsOf(question);
        QVERIFY2(words.contains(QStringLiteral("from 40 to 32")), qPrintable(words));
        QVERIFY(!words.contains(QStringLiteral("again")));
        gui::click(question, "questionNo");
        QCOMPARE(fixture.raw("position_p"), 40);
        QTest::mouseClick(undo, Qt::LeftButton);
        gui::click(fixture.find<QDialog>("question"), "questionYes");
        QTRY_COMPARE(fixture.raw("position_p"), 32);
        QCOMPARE(fixture.raw("position_d"), 30);
        QTRY_COMPARE(fixture.rows(), 3);
        QTRY_COMPARE(fixture.cell(0, 4), QStringLiteral("32"));
        // Nothing is left to undo in the write itself, and it says so.
        fixture.table()->selectRow(2);
        QTRY_VERIFY(!undo->isEnabled());
        QCOMPARE(undo->toolTip(), QStringLiteral("The register already holds the old value."));
    }

    void undoingARiskyWriteNamesTheRisk()
    {
        HistoryPageFixture fixture;
        QVERIFY(fixture.ready(1, two));
        const auto before = fixture.raw("unload_condition");
        QVERIFY(fixture.write("unload_condition", 32));
        QTRY_COMPARE(fixture.rows(), 1);
        auto* undo = fixture.find<QPushButton>("historyUndo");
        QTRY_VERIFY(undo->isEnabled());
        QTest::mouseClick(undo, Qt::LeftButton);
        auto* question = fixture.find<QDialog>("question");
        QVERIFY(question != nullptr);
        const auto* risk = question->findChild<QLabel*>(QStringLiteral("questionRisk"));
        QVERIFY(risk != nullptr && risk->text().contains(QStringLiteral("burn out")));
        gui::click(question, "questionYes");
        QTRY_COMPARE(fixture.raw("unload_condition"), before);
    }

    void whatCannotBeUndoneSaysWhy()
    {
        HistoryPageFixture fixture;
        QVERIFY(fixture.ready(1, two));
        QVERIFY(fixture.write("position_p", 40));
        QVERIFY(fixture.write("position_p", 50));
        QTRY_COMPARE(fixture.rows(), 2);
        auto* undo = fixture.find<QPushButton>("historyUndo");
        fixture.table()->selectRow(1);
        QTRY_VERIFY(undo->isEnabled());
        QTest::mouseClick(undo, Qt::LeftButton);
        auto* question = fixture.find<QDialog>("question");
        const QString words = gui::labelsOf(question);
        QVERIFY2(words.contains(QStringLiteral("changed again after this write")),
                 qPrintable(words));
        gui::click(question, "questionNo");
        // Another servo is not touched: without this one there is nothing to write to.
        fixture.action(ui::Command::Disconnect)->trigger();
        QTRY_VERIFY(!undo->isEnabled());
        QCOMPARE(undo->toolTip(), QStringLiteral("This servo is not connected."));
    }

    void theEntriesOfOneServoAreListed()
    {
        HistoryPageFixture fixture;
        QVERIFY(fixture.ready(1, two));
        QVERIFY(fixture.write("position_p", 40));
        QVERIFY(fixture.choose(2));
        QVERIFY(fixture.write("position_p", 41));
        QTRY_COMPARE(fixture.rows(), 2);
        QTRY_COMPARE(fixture.find<QComboBox>("historyServo")->count(), 3);
        fixture.table()->selectRow(1);
        QTest::mouseClick(fixture.find<QPushButton>("historyOfServo"), Qt::LeftButton);
        QTRY_COMPARE(fixture.rows(), 1);
        QCOMPARE(fixture.cell(0, 4), QStringLiteral("40"));
    }

    void aServoGetsALabel()
    {
        HistoryPageFixture fixture;
        QVERIFY(fixture.ready(1, two));
        QVERIFY(fixture.write("position_p", 40));
        fixture.choose("historyKind", QStringLiteral("Servos"));
        QTRY_COMPARE(fixture.rows(), 1);
        fixture.table()->selectRow(0);
        QTRY_VERIFY(fixture.find<QPushButton>("historyLabel")->isEnabled());
        QTest::mouseClick(fixture.find<QPushButton>("historyLabel"), Qt::LeftButton);
        auto* label = fixture.find<QLineEdit>("noteLabel");
        QTRY_VERIFY(label != nullptr);
        label->setText(QStringLiteral("left elbow"));
        QTest::mouseClick(fixture.find<QPushButton>("noteSave"), Qt::LeftButton);
        QTRY_COMPARE(fixture.cell(0, 2), QStringLiteral("left elbow"));
        fixture.choose("historyKind", QStringLiteral("Writes"));
        QTRY_VERIFY(fixture.cell(0, 1).contains(QLatin1String("left elbow")));
    }

    void snapshotsOpenTheirPage()
    {
        HistoryPageFixture fixture;
        QVERIFY(fixture.ready(1, two));
        QVERIFY(fixture.write("position_p", 40));
        fixture.choose("historyKind", QStringLiteral("Snapshots"));
        QTRY_COMPARE(fixture.rows(), 1);
        fixture.table()->selectRow(0);
        QCOMPARE(fixture.find<QLabel>("historyTitle")->text(), QStringLiteral("before a change"));
        QTest::mouseClick(fixture.find<QPushButton>("historyOpen"), Qt::LeftButton);
        QTRY_VERIFY(fixture.isShown("snapshotsPage"));
        QTRY_COMPARE(fixture.find<QTreeWidget>("shelfTree")->selectedItems().size(), 1);
        QTRY_COMPARE(fixture.find<QPushButton>("restoreWrite")->text(),
                     QStringLiteral("Write 1 selected row"));
    }

    void theFilteredListIsExported()
    {
        HistoryPageFixture fixture;
        QVERIFY(fixture.ready(1, two));
        QVERIFY(fixture.write("position_p", 40));
        QVERIFY(fixture.write("position_d", 30));
        QTRY_COMPARE(fixture.rows(), 2);
        QTRY_VERIFY(fixture.find<QComboBox>("historyRegister")->count() == 3);
        fixture.choose("historyRegister", QStringLiteral("position_d"));
        QTRY_COMPARE(fixture.rows(), 1);
        const QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("out.csv"));
        QTest::mouseClick(fixture.find<QPushButton>("historyExport"), Qt::LeftButton);
        auto* dialog = fixture.find<QFileDialog>("historyFileDialog");
        QTRY_VERIFY(dialog != nullptr);
        Q_EMIT dialog->fileSelected(path);
        QTRY_VERIFY(QFile::exists(path));
        QFile file(path);
        QVERIFY(file.open(QIODevice::ReadOnly));
        const QByteArray text = file.readAll();
        QVERIFY(text.startsWith("\xEF\xBB\xBF")); // or a spreadsheet shows no Chinese
        QVERIFY(text.contains("position_d"));
        QVERIFY(!text.contains("position_p"));
    }

    void explainsThatServosHaveNoSerialNumber()
    {
        HistoryPageFixture fixture(QStringLiteral("zh_CN"));
        QVERIFY(fixture.ready(1, two));
        QVERIFY(fixture.find<QLabel>("historyHonest")->text().contains(QStringLiteral("序列号")));
        QVERIFY(fixture.write("position_p", 40));
        QTRY_COMPARE(fixture.rows(), 1);
        static const QRegularExpression han(QStringLiteral("\\p{Han}"));
        QTRY_VERIFY(fixture.cell(0, 5).contains(han));
        QVERIFY(fixture.cell(0, 2).contains(han));
    }
};

SERVODESK_TEST(TestHistoryPage)
#include "tst_history_page.moc"
