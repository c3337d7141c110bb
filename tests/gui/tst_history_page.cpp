// SPDX-License-Identifier: GPL-3.0-or-later
// The history page: what was written at the bench is listed with its outcome, found by servo and
// register, exported, and leads back to the table as it was. Everything from the real database.
#include "gui/window_bench.h"
#include "record/history.h"
#include "session/paths.h"
#include "support/history_example.h"
#include "ui/models/compare_model.h"
#include "ui/pages/history_page.h"
#include "ui/pages/snapshots_page.h"

#include <QAbstractItemModelTester>
#include <QCheckBox>
#include <QComboBox>
#include <QDateEdit>
#include <QFileDialog>
#include <QLabel>
#include <QLineEdit>
#include <QPointer>
#include <QPushButton>
#include <QScrollBar>
#include <QTabWidget>
#include <QTableView>
#include <QTreeWidget>

namespace {
const QString two = QStringLiteral("sim:sts3215@1,sts3215@2");

struct HistoryBench : gui::WindowBench {
    explicit HistoryBench(const QString& language = QStringLiteral("en"))
        : WindowBench(language)
    {
        page = QStringLiteral("history");
    }
    QTableView* table() { return find<QTableView>("historyTable"); }
    int rows() { return table()->model()->rowCount(); }
    QString cell(int row, int column)
    {
        return table()->model()->index(row, column).data().toString();
    }
    using WindowBench::choose;
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
        desk().write(selection().current(), {{{QString::fromLatin1(key), value}}});
        return settled();
    }
};
} // namespace

class TestHistoryPage : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { gui::failOnWarnings(); }

    /// A server that cannot be used is named with the cause and what to do, in the window itself.
    void aServersTroubleIsExplained_data()
    {
        QTest::addColumn<QString>("language");
        QTest::addColumn<QString>("what");
        QTest::addColumn<QString>("remedy");
        QTest::newRow("en") << "en"
                            << "cannot be reached"
                            << "Check host and port";
        QTest::newRow("zh") << "zh_CN"
                            << "无法连接"
                            << "检查";
    }

    void aServersTroubleIsExplained()
    {
        QFETCH(QString, language);
        QFETCH(QString, what);
        QFETCH(QString, remedy);
        HistoryBench bench(language);
        QVERIFY(bench.ready(1, two));
        QVERIFY(bench.write("position_p", 40));
        bench.WindowBench::bench.sender.setServer(
            QStringLiteral("host=127.0.0.1 port=1 dbname=shop"), QStringLiteral("Bench"));
        auto* state = bench.find<QLabel>("historyServerState");
        QTRY_VERIFY2(state->text().contains(what), qPrintable(state->text()));
        QVERIFY2(state->text().contains(remedy), qPrintable(state->text()));
        QVERIFY(state->isVisible() && state->wordWrap());
        QTRY_VERIFY(state->height() >= state->heightForWidth(state->width()));
    }

    /// A password is refused beside the field, and neither kept nor sent anywhere.
    void aPasswordIsRefused()
    {
        HistoryBench bench;
        QVERIFY(bench.ready(1, two));
        const auto openDialog = [&] {
            QTest::mouseClick(bench.find<QPushButton>("historyServer"), Qt::LeftButton);
            return bench.find<QDialog>("historyServerDialog");
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
        QVERIFY(!bench.settings.choice(QStringLiteral("history/server"), QString())
                     .toString()
                     .contains(QStringLiteral("swordfish")));
        QCOMPARE(int(bench.WindowBench::bench.sender.state().phase),
                 int(session::SendState::Phase::Off));
        address->clear();
        QTest::keyClicks(address, QStringLiteral("postgresql://u@127.0.0.1:1/db"));
        QVERIFY(!refusal->isVisible());
        QTest::mouseClick(save, Qt::LeftButton);
        QTRY_VERIFY(dialog == nullptr);
        QCOMPARE(bench.settings.choice(QStringLiteral("history/server"), QString()).toString(),
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
        QCOMPARE(bench.settings.choice(QStringLiteral("history/server"), QString()).toString(),
                 QStringLiteral("postgresql://u@127.0.0.1:1/db"));
        QVERIFY(bench.WindowBench::bench.sender.state().phase != session::SendState::Phase::Off);
    }

    void writesAreListedWithTheirOutcome()
    {
        HistoryBench bench;
        QVERIFY(bench.ready(1, two));
        const QAbstractItemModelTester tester(bench.table()->model());
        QTRY_COMPARE(bench.find<QLabel>("historyCount")->text(), QStringLiteral("Nothing"));
        QVERIFY(bench.write("position_p", 40));
        QTRY_COMPARE(bench.rows(), 1);
        QVERIFY(bench.cell(0, 1).contains(QStringLiteral("STS3215 · ID 1")));
        QCOMPARE(bench.cell(0, 3), QStringLiteral("32"));
        QCOMPARE(bench.cell(0, 4), QStringLiteral("40"));
        QTRY_VERIFY(bench.cell(0, 5).startsWith(QStringLiteral("✔")));
        // Its name, not its key; a list asked for while the servo was being met is asked for again.
        QTRY_VERIFY2(!bench.cell(0, 2).contains(QLatin1Char('_')), qPrintable(bench.cell(0, 2)));
    }

    void anUndoIsCalledOneAndValuesHaveUnits()
    {
        HistoryBench bench;
        QVERIFY(bench.ready(1, two));
        QVERIFY(bench.write("max_temperature", 61));
        bench.desk().undo();
        QVERIFY(bench.settled());
        QTRY_COMPARE(bench.rows(), 2);
        QTRY_COMPARE(bench.cell(0, 6), QStringLiteral("undo"));
        QCOMPARE(bench.cell(1, 6), QStringLiteral("write"));
        QTRY_COMPARE(bench.cell(1, 4), QStringLiteral("61 · 61 °C"));
        QCOMPARE(bench.cell(0, 3), QStringLiteral("61 · 61 °C"));
    }

    /// A label stays with the servo when its ID changes, and so does its list.
    void aLabelledServoIsOneThroughAChangeOfId()
    {
        HistoryBench bench;
        QVERIFY(bench.ready(1, two));
        QVERIFY(bench.write("position_p", 40));
        const auto servo = record::History::open(session::historyFile())
                               .value()
                               ->log()
                               .of(bench.entry().servo.identity())
                               .value();
        QVERIFY(servo);
        bench.WindowBench::bench.archive.setServoLabel(servo->number, QStringLiteral("Elbow"));
        QTRY_VERIFY(bench.find<QComboBox>("historyServo")
                        ->findText(QStringLiteral("Elbow"), Qt::MatchContains) > 0);
        QVERIFY(bench.write("id", 7));
        QVERIFY(bench.write("position_p", 41));
        QTRY_COMPARE(bench.rows(), 3);
        auto* servos = bench.find<QComboBox>("historyServo");
        const auto named = [&] {
            int count = 0;
            for (int i = 0; i < servos->count(); ++i)
                count += servos->itemText(i).contains(QStringLiteral("Elbow")) ? 1 : 0;
            return count;
        };
        QTRY_COMPARE(named(), 1);
        QTRY_VERIFY(servos->findText(QStringLiteral("ID 7 · Elbow"), Qt::MatchContains) > 0);
        bench.choose("historyServo", QStringLiteral("Elbow"));
        QTRY_COMPARE(bench.rows(), 3);
        // The next one that comes to the old ID is not the elbow.
        base::ServoIdentity next = bench.entry().servo.identity();
        next.id = 1;
        const auto there =
            record::History::open(session::historyFile()).value()->log().of(next).value();
        QVERIFY(there && there->label.isEmpty());
    }

    /// As by servodesk-cli, with another connection: the page shows it by itself, and what was
    /// selected and scrolled to stays.
    void whatAnotherProgramWritesIsShown()
    {
        HistoryBench bench;
        QVERIFY(bench.ready(1, two));
        const QAbstractItemModelTester tester(bench.table()->model());
        QTRY_COMPARE(bench.find<QLabel>("historyCount")->text(), QStringLiteral("Nothing"));
        record::HistoryJournal other(session::historyFile(), QStringLiteral("servodesk-cli"));
        history_example::write(other, 4, 0);
        QTRY_COMPARE(bench.rows(), 2); // it writes two registers at once
        QTRY_COMPARE(bench.find<QLabel>("historyCount")->text(), QStringLiteral("2 rows"));
        for (int i = 1; i < 40; ++i)
            history_example::write(other, 4, i);
        QTRY_COMPARE(bench.rows(), 80);
        bench.table()->selectRow(41);
        auto* bar = bench.table()->verticalScrollBar();
        bar->setValue(bar->maximum() / 2);
        QVERIFY(bar->value() > 0);
        const auto top = [&] {
            const int row = bench.table()->rowAt(0);
            return bench.cell(row, 2) + bench.cell(row, 4);
        };
        const QString before = top();
        const QString selected = bench.cell(41, 2) + bench.cell(41, 4);
        history_example::write(other, 5, 1000);
        QTRY_COMPARE(bench.rows(), 82);
        const QModelIndexList rows = bench.table()->selectionModel()->selectedRows();
        QCOMPARE(rows.size(), 1);
        QCOMPARE(bench.cell(rows[0].row(), 2) + bench.cell(rows[0].row(), 4), selected);
        QCOMPARE(top(), before);
    }

    /// What ended elsewhere meanwhile gets its outcome, what was deleted goes.
    void whatAnotherProgramChangesIsShownInPlace()
    {
        HistoryBench bench;
        QVERIFY(bench.ready(1, two));
        record::HistoryJournal other(session::historyFile(), QStringLiteral("servodesk-cli"));
        const QString open = history_example::write(other, 4, 7, "");
        QTRY_COMPARE(bench.rows(), 2);
        bench.table()->selectRow(0);
        const QString unfinished = bench.cell(0, 5);
        history_example::must(other.end(open, {QStringLiteral("done"), QString()}));
        QTRY_VERIFY(bench.cell(0, 5) != unfinished);
        QCOMPARE(bench.table()->selectionModel()->selectedRows().size(), 1);
        bench.choose("historyKind", QStringLiteral("Snapshots"));
        QTRY_COMPARE(bench.rows(), 0);
        const auto history = record::History::open(session::historyFile()).value();
        const auto number =
            history->log()
                .addSnapshot(history_example::snapshot(4, "one"), record::SnapshotReason::Asked)
                .value();
        QTRY_COMPARE(bench.rows(), 1);
        history_example::must(history->log().removeSnapshot(number));
        QTRY_COMPARE(bench.rows(), 0);
    }

    void aPageShownAgainIsUpToDate()
    {
        HistoryBench bench;
        QVERIFY(bench.ready(1, two));
        QTRY_COMPARE(bench.find<QLabel>("historyCount")->text(), QStringLiteral("Nothing"));
        bench.action(ui::Command::PageMemory)->trigger();
        QTRY_VERIFY(!bench.table()->isVisible());
        record::HistoryJournal other(session::historyFile(), QStringLiteral("servodesk-cli"));
        history_example::write(other, 4, 7);
        bench.action(ui::Command::PageHistory)->trigger();
        QTRY_VERIFY(bench.table()->isVisible());
        QTRY_COMPARE(bench.rows(), 2);
    }

    void filteredByServoRegisterAndTime()
    {
        HistoryBench bench;
        QVERIFY(bench.ready(1, two));
        QVERIFY(bench.write("position_p", 40));
        QVERIFY(bench.write("position_d", 30));
        QVERIFY(bench.choose(2));
        QVERIFY(bench.write("position_p", 41));
        QTRY_COMPARE(bench.rows(), 3);
        QTRY_COMPARE(bench.find<QComboBox>("historyServo")->count(), 3);
        bench.choose("historyServo", QStringLiteral("ID 1"));
        QTRY_COMPARE(bench.rows(), 2);
        bench.choose("historyRegister", QStringLiteral("position_d"));
        QTRY_COMPARE(bench.rows(), 1);
        bench.choose("historyServo", 0);
        bench.choose("historyRegister", 0);
        QTRY_COMPARE(bench.rows(), 3);
        bench.choose("historyPeriod", bench.find<QComboBox>("historyPeriod")->count() - 1);
        QTRY_VERIFY(bench.find<QDateEdit>("historyFrom")->isVisible());
        bench.find<QDateEdit>("historyFrom")->setDate(QDate(2001, 1, 1));
        bench.find<QDateEdit>("historyUntil")->setDate(QDate(2001, 1, 2));
        QTRY_COMPARE(bench.rows(), 0);
        bench.choose("historyPeriod", 1); // today
        QTRY_COMPARE(bench.rows(), 3);
        QTest::mouseClick(bench.find<QCheckBox>("historyTrouble"), Qt::LeftButton);
        QTRY_COMPARE(bench.rows(), 0);
    }

    /// From a write back to the table before it, which can be restored.
    void theTableAtAnyMomentCanBeRestored()
    {
        HistoryBench bench;
        QVERIFY(bench.ready(1, two));
        QVERIFY(bench.write("position_p", 40));
        QVERIFY(bench.write("position_p", 50));
        QTRY_COMPARE(bench.rows(), 2);
        bench.table()->selectRow(0);
        QCOMPARE(bench.cell(0, 4), QStringLiteral("50"));
        QTRY_VERIFY(bench.find<QPushButton>("historyOpen")->isEnabled());
        QTest::mouseClick(bench.find<QPushButton>("historyOpen"), Qt::LeftButton);
        QTRY_VERIFY(bench.find<ui::SnapshotsPage>("snapshotsPage")->isVisible());
        auto* write = bench.find<QPushButton>("restoreWrite");
        QTRY_COMPARE(write->text(), QStringLiteral("Write 1 ticked row"));
        QTRY_VERIFY(write->isEnabled());
        QTest::mouseClick(write, Qt::LeftButton);
        QTRY_COMPARE(bench.raw("position_p"), 40);
    }

    void aServoGetsALabel()
    {
        HistoryBench bench;
        QVERIFY(bench.ready(1, two));
        QVERIFY(bench.write("position_p", 40));
        bench.choose("historyKind", QStringLiteral("Servos"));
        QTRY_COMPARE(bench.rows(), 1);
        bench.table()->selectRow(0);
        QTRY_VERIFY(bench.find<QPushButton>("historyLabel")->isEnabled());
        QTest::mouseClick(bench.find<QPushButton>("historyLabel"), Qt::LeftButton);
        auto* label = bench.find<QLineEdit>("noteLabel");
        QTRY_VERIFY(label != nullptr);
        label->setText(QStringLiteral("left elbow"));
        QTest::mouseClick(bench.find<QPushButton>("noteSave"), Qt::LeftButton);
        QTRY_COMPARE(bench.cell(0, 2), QStringLiteral("left elbow"));
        bench.choose("historyKind", QStringLiteral("Writes"));
        QTRY_VERIFY(bench.cell(0, 1).contains(QLatin1String("left elbow")));
    }

    void snapshotsLeadToTheirPage()
    {
        HistoryBench bench;
        QVERIFY(bench.ready(1, two));
        QVERIFY(bench.write("position_p", 40));
        bench.choose("historyKind", QStringLiteral("Snapshots"));
        QTRY_COMPARE(bench.rows(), 1);
        bench.table()->selectRow(0);
        QTest::mouseClick(bench.find<QPushButton>("historyOpen"), Qt::LeftButton);
        QTRY_VERIFY(bench.find<ui::SnapshotsPage>("snapshotsPage")->isVisible());
        QTRY_COMPARE(bench.find<QTreeWidget>("shelfTree")->selectedItems().size(), 1);
        QTRY_COMPARE(bench.find<QPushButton>("restoreWrite")->text(),
                     QStringLiteral("Write 1 ticked row"));
    }

    void theListIsExportedAsItIsFiltered()
    {
        HistoryBench bench;
        QVERIFY(bench.ready(1, two));
        QVERIFY(bench.write("position_p", 40));
        QVERIFY(bench.write("position_d", 30));
        QTRY_COMPARE(bench.rows(), 2);
        QTRY_VERIFY(bench.find<QComboBox>("historyRegister")->count() == 3);
        bench.choose("historyRegister", QStringLiteral("position_d"));
        QTRY_COMPARE(bench.rows(), 1);
        const QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("out.csv"));
        QTest::mouseClick(bench.find<QPushButton>("historyExport"), Qt::LeftButton);
        auto* dialog = bench.find<QFileDialog>("historyFileDialog");
        QTRY_VERIFY(dialog != nullptr);
        Q_EMIT dialog->fileSelected(path);
        QTRY_VERIFY(QFile::exists(path));
        QFile file(path);
        QVERIFY(file.open(QIODevice::ReadOnly));
        const QByteArray text = file.readAll();
        QVERIFY(text.contains("position_d"));
        QVERIFY(!text.contains("position_p"));
    }

    void itSaysThatServosHaveNoSerialNumber()
    {
        HistoryBench bench(QStringLiteral("zh_CN"));
        QVERIFY(bench.ready(1, two));
        QVERIFY(bench.find<QLabel>("historyHonest")->text().contains(QStringLiteral("序列号")));
        QVERIFY(bench.write("position_p", 40));
        QTRY_COMPARE(bench.rows(), 1);
        static const QRegularExpression han(QStringLiteral("\\p{Han}"));
        QTRY_VERIFY(bench.cell(0, 5).contains(han));
        QVERIFY(bench.cell(0, 2).contains(han));
    }
};

QTEST_MAIN(TestHistoryPage)
#include "tst_history_page.moc"
