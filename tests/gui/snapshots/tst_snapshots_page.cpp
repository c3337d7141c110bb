// SPDX-License-Identifier: GPL-3.0-or-later
// The snapshots page on a simulated bus: looking writes nothing, what differs is on top with a
// tick, what is written is what was shown and is asked of the servo again, several servos get a
// verdict each, and a file that is no snapshot is told about. The history is the real one.
#include "gui/main_window_fixture.h"
#include "session/history/history_service.h"
#include "session/paths.h"
#include "session/snapshot/snapshots.h"
#include "sim/host/sim_link.h"
#include "snapshot/bundle.h"
#include "snapshot/snapshot_template.h"
#include "support/history_example.h"
#include "support/test_main.h"
#include "ui/snapshots/compare_model.h"
#include "ui/snapshots/snapshot_row.h"
#include "ui/snapshots/snapshots_page.h"
#include "ui/widgets/banner.h"
#include "ui/widgets/pill.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialog>
#include <QFileDialog>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QTableView>
#include <QTableWidget>
#include <QTemporaryDir>
#include <QToolButton>
#include <QTreeWidget>

#include <thread>

namespace {
struct SnapshotsPageFixture : gui::MainWindowFixture {
    explicit SnapshotsPageFixture(const QString& language = QStringLiteral("en"))
        : MainWindowFixture(language)
    {
        page = QStringLiteral("snapshots");
    }
    QTreeWidget* snapshotTree() { return find<QTreeWidget>("shelfTree"); }
    QTableView* table() { return find<QTableView>("compareTable"); }
    QPushButton* button(const char* name) { return find<QPushButton>(name); }
    void click(const char* name)
    {
        QVERIFY2(button(name) != nullptr, name);
        QTRY_VERIFY2(button(name)->isEnabled(), name);
        QTest::mouseClick(button(name), Qt::LeftButton);
    }
    /// Those taken on the page, newest first; the one saved before a change may come at any time.
    std::vector<QTreeWidgetItem*> manual()
    {
        std::vector<QTreeWidgetItem*> found;
        for (int i = 0; i < snapshotTree()->topLevelItemCount(); ++i) {
            QTreeWidgetItem* row = snapshotTree()->topLevelItem(i);
            const ui::SnapshotItem* item = ui::SnapshotRow::itemOf(row);
            if (item->kept && item->kept->reason == history::SnapshotReason::Manual)
                found.push_back(row);
        }
        return found;
    }
    /// Takes one and selects it.
    bool taken()
    {
        const std::size_t before = manual().size();
        click("snapshotTake");
        if (!support::waitFor([&] { return manual().size() > before; }))
            return false;
        select(manual().front());
        return bannerText().contains(QStringLiteral("ID %1").arg(
            workbench().registry().servo(selection().current())->servo.id));
    }
    void select(QTreeWidgetItem* row)
    {
        snapshotTree()->clearSelection();
        snapshotTree()->setCurrentItem(row);
    }
    bool write(const char* key, std::int64_t value, bool dangerous = false)
    {
        workbench().writes().write(
            selection().current(),
            {{{QString::fromLatin1(key), value}}, false, device::Consent::byTask(dangerous)});
        return waitUntilIdle();
    }
    /// The row of this register, -1: it is not shown.
    int rowOf(const char* key)
    {
        for (int row = 0; row < table()->model()->rowCount(); ++row) {
            if (table()->model()->index(row, 0).data(ui::CompareModel::KeyRole) ==
                QString::fromLatin1(key))
                return row;
        }
        return -1;
    }
    QModelIndex cell(const char* key, int column = 0)
    {
        return table()->model()->index(rowOf(key), column);
    }
    Qt::CheckState tick(const char* key)
    {
        return cell(key).data(Qt::CheckStateRole).value<Qt::CheckState>();
    }
    std::int64_t now(const char* key)
    {
        (void)waitUntilIdle();
        workbench().writes().readTable(selection().current());
        (void)waitUntilIdle();
        return raw(key).value_or(-1);
    }
    QString bannerText()
    {
        QString all;
        auto* banner = find<ui::Banner>("snapshotsBanner");
        for (const QLabel* label : banner->findChildren<QLabel*>())
            all += label->text();
        return banner->isVisible() ? all : QString();
    }
    snapshot::Snapshot file()
    {
        session::Snapshots snapshots(workbench(), context.workbench.history());
        return *snapshots.currentSnapshot(selection().current());
    }
    void drop(const QString& path)
    {
        QMimeData data;
        data.setUrls({QUrl::fromLocalFile(path)});
        auto* page = find<ui::SnapshotsPage>("snapshotsPage");
        QDragEnterEvent enter(QPoint(10, 10), Qt::CopyAction, &data, Qt::LeftButton,
                              Qt::NoModifier);
        QCoreApplication::sendEvent(page, &enter);
        QDropEvent event(QPointF(10, 10), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
        QCoreApplication::sendEvent(page, &event);
    }
};

const QString two = QStringLiteral("sim:sts3215@1,sts3215@2");
} // namespace

class TestSnapshotsPage : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { gui::failOnWarnings(); }

    void viewingWritesNothing()
    {
        SnapshotsPageFixture fixture;
        QVERIFY(fixture.ready(1, two));
        QVERIFY(!fixture.button("restoreWrite")->isEnabled());
        QVERIFY(fixture.taken());
        QVERIFY(fixture.snapshotTree()->topLevelItem(0)->text(0).contains(
            QStringLiteral("STS3215 · ID 1")));
        QTRY_VERIFY(fixture.find<QLabel>("compareNothing")->isVisible());
        QCOMPARE(fixture.find<QLabel>("compareNothing")->text(),
                 QStringLiteral("No writable setting differs."));
        fixture.find<QToolButton>("compareAll")->click();
        QTRY_VERIFY(fixture.rowOf("position_p") >= 0);
        QVERIFY(!fixture.button("restoreWrite")->isEnabled());
        const auto intents = fixture.session.journal().entries();
        QVERIFY(intents && intents->empty());
    }

    /// Another program writes, or the servo is exchanged for one of its kind.
    void theServoColumnFollowsTheServo()
    {
        SnapshotsPageFixture fixture;
        QVERIFY(fixture.ready(1, two));
        QVERIFY(fixture.taken());
        auto* different = fixture.find<ui::Pill>("compareDifferent");
        auto* age = fixture.find<ui::Pill>("compareAge");
        QTRY_COMPARE(different->text(), QStringLiteral("= no differences"));
        QTRY_VERIFY(!age->isVisible());
        fixture.workbench().link().connection()->simulation()->with([](sim::VirtualBus& bus) {
            bus.servo(1)->poke(QStringLiteral("max_temperature"), 60);
        });
        QTRY_COMPARE(different->text(), QStringLiteral("≠ 1 different"));
        QVERIFY(fixture.rowOf("max_temperature") >= 0);
    }

    /// What cannot be read is not said to be so now.
    void aSilentServosColumnShowsItsAge()
    {
        SnapshotsPageFixture fixture;
        QVERIFY(fixture.ready(1, two));
        QVERIFY(fixture.taken());
        auto* different = fixture.find<ui::Pill>("compareDifferent");
        auto* age = fixture.find<ui::Pill>("compareAge");
        QTRY_VERIFY(different->isVisible() && !age->isVisible());
        const auto title = [&] {
            return fixture.table()
                ->model()
                ->headerData(ui::CompareModel::FirstTable, Qt::Horizontal)
                .toString();
        };
        QTRY_COMPARE(title(), QStringLiteral("ID 1 now"));
        const auto lose = [&fixture](double share) {
            fixture.workbench().link().connection()->simulation()->with(
                [share](sim::VirtualBus& bus) { bus.config().faults.dropRequest = share; });
        };
        lose(1);
        QTRY_VERIFY(age->isVisible());
        QTRY_VERIFY2(age->text().startsWith(QStringLiteral("ID 1 · no reply · read ")),
                     qPrintable(age->text()));
        QCOMPARE(different->text(), QStringLiteral("= no differences at that time"));
        QTRY_VERIFY(title().startsWith(QStringLiteral("ID 1 · ")));
        lose(0);
        QTRY_VERIFY(!age->isVisible());
        QTRY_COMPARE(title(), QStringLiteral("ID 1 now"));
        QCOMPARE(different->text(), QStringLiteral("= no differences"));
    }

    /// A snapshot of a servo for 8 V is no reason to put one at 12 V into an alarm.
    void limitsOfAnotherModelAreNotPreselected()
    {
        SnapshotsPageFixture fixture;
        QVERIFY(fixture.ready(1, QStringLiteral("sim:sts3215@1,sts3250@2")));
        QVERIFY(fixture.write("max_voltage", 80));
        QVERIFY(fixture.write("position_p", 50));
        QVERIFY(fixture.taken());
        auto* title = fixture.find<QLabel>("compareTitle");
        QTRY_VERIFY2(title->text().contains(QStringLiteral("STS3215 · ID 1 · ")),
                     qPrintable(title->text()));
        QVERIFY(!title->text().contains(QLatin1String("another model")));

        QVERIFY(fixture.choose(2));
        const std::int64_t before = fixture.now("max_voltage");
        QVERIFY(before > 120);
        fixture.find<QComboBox>("shelfWhose")->setCurrentIndex(1);
        const auto firstServoValue = [&] {
            for (int row = 0; row < fixture.snapshotTree()->topLevelItemCount(); ++row) {
                QTreeWidgetItem* item = fixture.snapshotTree()->topLevelItem(row);
                if (item->text(0).contains(QStringLiteral("STS3215 · ID 1\nmanual")))
                    return item;
            }
            return static_cast<QTreeWidgetItem*>(nullptr);
        };
        QTRY_VERIFY(firstServoValue() != nullptr);
        fixture.select(firstServoValue());
        QTRY_VERIFY2(title->text().contains(QStringLiteral("STS3215 · ID 1")) &&
                         title->text().contains(QLatin1String("another model")),
                     qPrintable(title->text()));
        QTRY_VERIFY(fixture.rowOf("max_voltage") >= 0);
        QTRY_COMPARE(fixture.tick("position_p"), Qt::Checked);
        QCOMPARE(fixture.tick("max_voltage"), Qt::Unchecked);

        fixture.click("restoreDryRun");
        QLabel* warning = nullptr;
        QTRY_VERIFY((warning = fixture.find<QLabel>("dryRunWarning")) != nullptr);
        QVERIFY2(warning->isVisible() && warning->text().contains(QLatin1String("STS3215")) &&
                     warning->text().contains(
                         QLatin1String("not selected: would cause a voltage alarm now")),
                 qPrintable(warning->text()));
        fixture.click("dryRunClose");

        fixture.click("restoreWrite");
        QTRY_VERIFY(!fixture.bannerText().isEmpty());
        QCOMPARE(fixture.now("position_p"), 50);
        QCOMPARE(fixture.now("max_voltage"), before);

        // By hand: asked for, with what will happen.
        QTRY_VERIFY(fixture.rowOf("max_voltage") >= 0);
        fixture.table()->setCurrentIndex(fixture.cell("max_voltage", 1));
        QTest::keyClick(fixture.table(), Qt::Key_Space);
        QTRY_COMPARE(fixture.tick("max_voltage"), Qt::Checked);
        fixture.click("restoreWrite");
        QLabel* risk = nullptr;
        QTRY_VERIFY((risk = fixture.find<QLabel>("questionRisk")) != nullptr);
        QVERIFY2(risk->text().contains(QLatin1String("limit comes from another model (STS3215)")) &&
                     risk->text().contains(QLatin1String("would cause a voltage alarm now")),
                 qPrintable(risk->text()));
        QTest::mouseClick(fixture.find<QPushButton>("questionNo"), Qt::LeftButton);
        QCOMPARE(fixture.now("max_voltage"), before);
    }

    /// The servo reads as the file has it, but only until power-off.
    void aTemporaryValueIsOfferedForSaving()
    {
        SnapshotsPageFixture fixture;
        QVERIFY(fixture.ready(1, two));
        const std::int64_t asked = fixture.now("position_p") + 8;
        fixture.workbench().writes().write(fixture.selection().current(),
                                           {{{QStringLiteral("position_p"), asked}}, true, {}});
        QVERIFY(fixture.waitUntilIdle());
        QVERIFY(fixture.taken());
        QTRY_COMPARE(fixture.rowOf("position_p"), 0);
        QCOMPARE(fixture.table()->model()->rowCount(), 1);
        QCOMPARE(fixture.tick("position_p"), Qt::Checked);
        const auto* model = fixture.table()->model();
        const auto state = [model] {
            return model->index(0, model->columnCount() - 1).data().toString();
        };
        QTRY_VERIFY2(state().contains(QLatin1String("not permanent yet")), qPrintable(state()));

        fixture.click("restoreWrite");
        QTRY_VERIFY(!fixture.bannerText().isEmpty());
        QTRY_COMPARE(fixture.rowOf("position_p"), -1);
        fixture.workbench().link().connection()->simulation()->with(
            [](sim::VirtualBus& wire) { wire.powerCycle(); });
        QCOMPARE(fixture.now("position_p"), asked);
    }

    void differencesAreShownAndRestored()
    {
        SnapshotsPageFixture fixture;
        QVERIFY(fixture.ready(1, two));
        const std::int64_t before = fixture.now("position_p");
        QVERIFY(fixture.taken());
        QVERIFY(fixture.write("position_p", before + 8));
        QVERIFY(fixture.write("max_angle_limit", 3800));
        QTRY_COMPARE(fixture.table()->model()->rowCount(), 2);
        QTRY_COMPARE(fixture.tick("position_p"), Qt::Checked);
        QVERIFY(fixture.cell("position_p", ui::CompareModel::FirstTable)
                    .data()
                    .toString()
                    .contains(QString::number(before + 8)));
        QTRY_COMPARE(fixture.button("restoreWrite")->text(),
                     QStringLiteral("Write 2 selected rows"));

        // Taken off by hand: it stays off while the servo is read again.
        fixture.table()->setCurrentIndex(fixture.cell("max_angle_limit", 1));
        QTest::keyClick(fixture.table(), Qt::Key_Space);
        QTRY_COMPARE(fixture.button("restoreWrite")->text(),
                     QStringLiteral("Write 1 selected row"));
        const auto* filter = qobject_cast<QSortFilterProxyModel*>(fixture.table()->model());
        QSignalSpy compareSpy(filter->sourceModel(), &QAbstractItemModel::dataChanged);
        (void)fixture.now("position_p");
        QTRY_VERIFY(compareSpy.count() > 0); // the page has compared again
        QCOMPARE(fixture.tick("max_angle_limit"), Qt::Unchecked);

        fixture.click("restoreDryRun");
        QTableWidget* steps = nullptr;
        QTRY_VERIFY((steps = fixture.find<QTableWidget>("dryRunTable")) != nullptr);
        int writes = 0;
        for (int row = 0; row < steps->rowCount(); ++row)
            writes += steps->item(row, 3)->text().contains(QString::number(before)) ? 1 : 0;
        QCOMPARE(writes, 1);
        fixture.click("dryRunClose");

        fixture.click("restoreWrite");
        QTRY_VERIFY(fixture.bannerText().contains(QLatin1String("1 row")));
        QCOMPARE(fixture.now("position_p"), before);
        QCOMPARE(fixture.raw("max_angle_limit"), 3800);
        QTRY_VERIFY(!fixture.button("restoreWrite")->isEnabled());
        QVERIFY(fixture.workbench().writes().undoStep() != nullptr);
        QCOMPARE(fixture.workbench().writes().undoStep()->newItems.front().raw, before);

        // Taken back, it is no result any more.
        fixture.workbench().writes().undo();
        QVERIFY(fixture.waitUntilIdle());
        QTRY_VERIFY(fixture.bannerText().isEmpty());
    }

    /// The servo falls silent in the middle, so the way back that was asked for fails as well.
    void aFailedRollbackIsReported()
    {
        SnapshotsPageFixture fixture;
        QVERIFY(fixture.ready(1, two));
        const std::int64_t voltage = fixture.now("max_voltage");
        QVERIFY(fixture.taken());
        QVERIFY(fixture.write("max_voltage", voltage + 5));
        QVERIFY(fixture.write("position_p", fixture.now("position_p") + 8));
        QTRY_COMPARE(fixture.button("restoreWrite")->text(),
                     QStringLiteral("Write 2 selected rows"));
        fixture.find<QCheckBox>("restoreRollBack")->setChecked(true);
        fixture.workbench().link().connection()->simulation()->with([&](sim::VirtualBus& wire) {
            wire.config().faults.muteWhen = [voltage](const sim::VirtualServo& servo) {
                return servo.raw(QStringLiteral("max_voltage")) == voltage;
            };
        });
        fixture.click("restoreWrite");
        QTRY_VERIFY(!fixture.bannerText().isEmpty());
        const QString message = fixture.bannerText();
        QVERIFY2(message.contains(QLatin1String("The old values could not be restored: Maximum")),
                 qPrintable(message));
        QVERIFY2(message.contains(QLatin1String("Interrupted writes")), qPrintable(message));
        QCOMPARE(fixture.session.journal().open()->size(), std::size_t(1));
    }

    void aSnapshotIsSavedForPaper()
    {
        SnapshotsPageFixture fixture;
        QVERIFY(fixture.ready(1));
        QVERIFY(fixture.taken());
        auto* save = fixture.find<QAction>("snapshotSaveCopy");
        QTRY_VERIFY(save->isEnabled());
        save->trigger();
        auto* dialog = fixture.find<QFileDialog>("snapshotFileDialog");
        QVERIFY(dialog != nullptr);
        QCOMPARE(dialog->nameFilters().filter(QStringLiteral("*.pdf")).size(), 1);
        const QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("knee.pdf"));
        Q_EMIT dialog->fileSelected(path);
        dialog->close();
        QTRY_VERIFY2(fixture.bannerText().contains(QStringLiteral("knee.pdf")),
                     qPrintable(fixture.bannerText()));
        QFile file(path);
        QVERIFY(file.open(QIODevice::ReadOnly));
        QVERIFY(file.read(5) == "%PDF-");
    }

    /// Consent was given for one write: after Undo the dangerous row is not ticked by itself.
    void aDangerousRowStaysUncheckedAfterUndo()
    {
        SnapshotsPageFixture fixture;
        QVERIFY(fixture.ready(1));
        QVERIFY(fixture.taken());
        const auto before = fixture.raw("unload_condition").value_or(0);
        fixture.workbench().writes().write(fixture.selection().current(),
                                           {{{QStringLiteral("unload_condition"), before ^ 1}},
                                            false,
                                            device::Consent::confirmed()});
        QVERIFY(fixture.waitUntilIdle());
        QTRY_VERIFY(fixture.rowOf("unload_condition") >= 0);
        QTRY_COMPARE(fixture.tick("unload_condition"), Qt::Unchecked);
        fixture.table()->setCurrentIndex(fixture.cell("unload_condition", 1));
        QTest::keyClick(fixture.table(), Qt::Key_Space);
        QTRY_COMPARE(fixture.tick("unload_condition"), Qt::Checked);
        fixture.click("restoreWrite");
        QTRY_VERIFY(fixture.find<QPushButton>("questionYes") != nullptr);
        QTest::mouseClick(fixture.find<QPushButton>("questionYes"), Qt::LeftButton);
        QTRY_VERIFY(fixture.bannerText().contains(QLatin1String("1 row")));
        QVERIFY(fixture.waitUntilIdle());
        fixture.workbench().writes().undo(device::Consent::confirmed());
        QVERIFY(fixture.waitUntilIdle());
        QTRY_VERIFY(fixture.rowOf("unload_condition") >= 0);
        QTRY_COMPARE(fixture.tick("unload_condition"), Qt::Unchecked);
    }

    /// The table was saved by itself before the first change, and can be chosen like any other.
    /// A row that is never restored is not counted among what differs; it is named, with the
    /// reason.
    void nonRestorableRowsAreNotCounted()
    {
        SnapshotsPageFixture fixture;
        QVERIFY(fixture.ready(1));
        QVERIFY(fixture.write("torque_switch", 1));
        QVERIFY(fixture.taken());
        QVERIFY(fixture.write("torque_switch", 0));
        QVERIFY(fixture.write("position_p", 40));
        auto* different = fixture.find<ui::Pill>("compareDifferent");
        auto* never = fixture.find<ui::Pill>("compareNever");
        QTRY_COMPARE(different->text(), QStringLiteral("≠ 1 different"));
        QVERIFY(never->isVisible());
        QCOMPARE(never->text(), QStringLiteral("≠ 1 never restored"));
        QVERIFY2(never->toolTip().contains(QStringLiteral("never restored")),
                 qPrintable(never->toolTip()));
        fixture.click("restoreWrite");
        QTRY_COMPARE(different->text(), QStringLiteral("= no differences"));
        QVERIFY(never->isVisible());
    }

    void theTableBeforeTheFirstChangeIsListed()
    {
        SnapshotsPageFixture fixture;
        QVERIFY(fixture.ready(1, two));
        const std::int64_t before = fixture.now("position_p");
        QVERIFY(fixture.write("position_p", before + 1));
        QTRY_COMPARE(fixture.snapshotTree()->topLevelItemCount(), 1);
        QVERIFY(fixture.snapshotTree()->topLevelItem(0)->text(0).contains(
            QLatin1String("before a change")));
        fixture.select(fixture.snapshotTree()->topLevelItem(0));
        QTRY_VERIFY(fixture.rowOf("position_p") == 0);
        QCOMPARE(fixture.entry().servo.raw(QStringLiteral("position_p")), before + 1);
    }

    /// The table is kept either way.
    void theHistoryNamesNoMissingFile()
    {
        SnapshotsPageFixture fixture;
        QVERIFY(fixture.ready(1, QStringLiteral("sim:sts3215@1")));
        session::Snapshots snapshots(fixture.workbench(), fixture.context.workbench.history());
        QSignalSpy taken(&snapshots, &session::Snapshots::snapshotTaken);
        QSignalSpy failed(&snapshots, &session::Snapshots::failed);
        const QTemporaryDir folder;
        const QString good = folder.filePath(QStringLiteral("one.servo.json"));
        snapshots.take(fixture.selection().current(), {{}, {}, good});
        QTRY_COMPARE(taken.count(), 1);
        snapshots.take(fixture.selection().current(),
                       {{}, {}, folder.filePath(QStringLiteral("no/two.servo.json"))});
        QTRY_COMPARE(failed.count(), 1);
        QStringList files;
        const auto look = [&](const auto& found) {
            files.clear();
            for (const history::HistorySnapshot& one : *found)
                files += one.file;
        };
        const auto both = [&] {
            fixture.context.workbench.history().snapshots({}, this, look);
            return files.size() == 2;
        };
        QTRY_VERIFY(both());
        QCOMPARE(files, (QStringList{QString(), good})); // the latest first
    }

    void identityIsRestoredOnlyOnRequest()
    {
        SnapshotsPageFixture fixture;
        QVERIFY(fixture.ready(1, two));
        const QTemporaryDir folder;
        snapshot::Snapshot other = fixture.file();
        for (snapshot::SnapshotRegister& row : other.registers) {
            if (row.key == QLatin1String("id"))
                row.raw = 7;
        }
        const QString path = folder.filePath(QStringLiteral("other.servo.json"));
        QVERIFY(snapshot::saveSnapshot(other, path));
        fixture.drop(path);
        QTRY_VERIFY(fixture.find<QCheckBox>("restoreIdentity")->isEnabled()); // it is compared with
        QVERIFY(fixture.rowOf("id") >= 0);
        QCOMPARE(fixture.tick("id"), Qt::Unchecked);
        QVERIFY(!fixture.button("restoreWrite")->isEnabled());
        QTest::mouseClick(fixture.find<QCheckBox>("restoreIdentity"), Qt::LeftButton);
        QTRY_COMPARE(fixture.tick("id"), Qt::Checked);
        fixture.click("restoreWrite");
        auto* yes = fixture.find<QPushButton>("questionYes");
        QTRY_VERIFY(yes != nullptr); // it answers elsewhere afterwards: asked
        QTest::mouseClick(yes, Qt::LeftButton);
        QTRY_COMPARE(fixture.entry().servo.id, 7);
        QTRY_VERIFY(!fixture.bannerText().isEmpty());
    }

    void factoryAndOtherServosAreColumns()
    {
        SnapshotsPageFixture fixture;
        QVERIFY(fixture.ready(1, two));
        QVERIFY(fixture.taken());
        QTRY_VERIFY(fixture.table()->model()->columnCount() >= 4);
        const int before = fixture.table()->model()->columnCount();
        auto* menu = fixture.find<QMenu>("compareColumnsMenu");
        Q_EMIT menu->aboutToShow();
        QCOMPARE(menu->actions().size(), 3); // factory, line, the other servo
        menu->actions().front()->trigger();
        QCOMPARE(fixture.table()->model()->columnCount(), before + 1);
        Q_EMIT menu->aboutToShow();
        menu->actions().back()->trigger();
        QTRY_COMPARE(fixture.table()->model()->columnCount(), before + 2);
        QTRY_VERIFY(fixture.rowOf("id") >= 0); // the two have different ones
    }

    void brokenFilesAreReported_data()
    {
        QTest::addColumn<QByteArray>("content");
        QTest::newRow("empty") << QByteArray();
        QTest::newRow("text") << QByteArray("shopping list");
        QTest::newRow("other JSON") << QByteArray("{\"format\":\"playlist\",\"version\":1}");
        QTest::newRow("newer") << QByteArray(
            "{\"format\":\"servodesk-snapshot\",\"version\":99,\"servo\":{},\"registers\":[]}");
    }
    void brokenFilesAreReported()
    {
        QFETCH(QByteArray, content);
        SnapshotsPageFixture fixture;
        QVERIFY(fixture.ready(1, two));
        const QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("broken.servo.json"));
        QFile file(path);
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(content);
        file.close();
        fixture.drop(path);
        QTRY_VERIFY(fixture.bannerText().contains(QLatin1String("broken.servo.json")));
        QCOMPARE(fixture.snapshotTree()->topLevelItemCount(), 0);
    }

    void aTemplateIsAppliedToSeveralServos()
    {
        SnapshotsPageFixture fixture;
        QVERIFY(fixture.ready(1, two));
        const std::int64_t before = fixture.now("position_p");
        const QTemporaryDir folder;
        snapshot::Snapshot wanted = fixture.file();
        for (snapshot::SnapshotRegister& row : wanted.registers) {
            if (row.key == QLatin1String("position_p"))
                row.raw = before + 5;
        }
        const auto chosen = snapshot::makeTemplate(wanted, {QStringLiteral("position_p")});
        QVERIFY(chosen);
        const QString path = folder.filePath(QStringLiteral("gripper.servo.json"));
        QVERIFY(snapshot::saveSnapshot(*chosen, path));
        fixture.drop(path);
        QTRY_COMPARE(fixture.rowOf("position_p"), 0);
        fixture.click("restoreSeveral");
        auto* servos = fixture.find<QTableWidget>("applyTable");
        QVERIFY(servos != nullptr);
        QCOMPARE(servos->rowCount(), 2);
        fixture.click("applyDryRun");
        QTRY_VERIFY(servos->item(1, 3)->text().startsWith(QStringLiteral("≠")));
        QCOMPARE(fixture.now("position_p"), before);
        fixture.click("applyWrite");
        auto* yes = fixture.find<QPushButton>("questionYes");
        QTRY_VERIFY(yes != nullptr);
        QTest::mouseClick(yes, Qt::LeftButton);
        for (int row = 0; row < 2; ++row)
            QTRY_VERIFY(servos->item(row, 3)->text().startsWith(QStringLiteral("✔")));
        QTRY_VERIFY(fixture.button("applySave")->isEnabled());
        for (const session::ServoRef ref : fixture.workbench().registry().order()) {
            fixture.selection().select(ref);
            QCOMPARE(fixture.now("position_p"), before + 5);
            QVERIFY(fixture.workbench().registry().servo(ref)->snapshotPath.contains(
                QLatin1String("STS3215")));
        }
        QVERIFY(fixture.workbench().writes().undoStep() != nullptr);
    }

    /// This servo has no angle limits, like the snapshot: that is nothing to tick, and others keep
    /// theirs.
    void untickedLimitsAreNotTakenFromOthers()
    {
        SnapshotsPageFixture fixture;
        QVERIFY(fixture.ready(1, two));
        fixture.workbench().writes().write(
            fixture.selection().current(),
            {{{QStringLiteral("min_angle_limit"), 0}, {QStringLiteral("max_angle_limit"), 0}},
             false,
             device::Consent::confirmed()});
        QVERIFY(fixture.waitUntilIdle());
        QVERIFY(fixture.taken());
        const std::int64_t before = fixture.now("position_p");
        QVERIFY(fixture.write("position_p", before + 5));
        QTRY_COMPARE(fixture.tick("position_p"), Qt::Checked);
        fixture.click("restoreSeveral");
        auto* servos = fixture.find<QTableWidget>("applyTable");
        QVERIFY(servos != nullptr);
        fixture.click("applyWrite");
        QTRY_VERIFY(fixture.find<QPushButton>("questionYes") != nullptr);
        QVERIFY(fixture.find<QLabel>("questionRisk") == nullptr);
        QTest::mouseClick(fixture.find<QPushButton>("questionYes"), Qt::LeftButton);
        for (int row = 0; row < 2; ++row)
            QTRY_VERIFY(servos->item(row, 3)->text().startsWith(QStringLiteral("✔")));
        QCOMPARE(fixture.now("position_p"), before);
        fixture.selection().select(fixture.workbench().registry().order()[1]);
        QCOMPARE(fixture.now("max_angle_limit"), 4095);
    }

    /// One that is ticked takes the other along, or a servo with a lower limit would refuse it.
    void tickedLimitsAreTakenFromOthersTogether()
    {
        SnapshotsPageFixture fixture;
        QVERIFY(fixture.ready(2, two));
        QVERIFY(fixture.write("min_angle_limit", 100));
        QVERIFY(fixture.choose(1));
        const auto writeMax = [&](std::int64_t raw) {
            fixture.workbench().writes().write(
                fixture.selection().current(),
                {{{QStringLiteral("max_angle_limit"), raw}}, false, device::Consent::confirmed()});
            return fixture.waitUntilIdle();
        };
        QVERIFY(writeMax(0));
        QVERIFY(fixture.taken());
        QVERIFY(writeMax(4095));
        QTRY_VERIFY(fixture.rowOf("max_angle_limit") >= 0);
        fixture.table()->setCurrentIndex(fixture.cell("max_angle_limit", 1));
        QTest::keyClick(fixture.table(), Qt::Key_Space);
        QTRY_COMPARE(fixture.tick("max_angle_limit"), Qt::Checked);
        fixture.click("restoreSeveral");
        auto* servos = fixture.find<QTableWidget>("applyTable");
        QVERIFY(servos != nullptr);
        fixture.click("applyWrite");
        QTRY_VERIFY(fixture.find<QPushButton>("questionYes") != nullptr);
        QVERIFY(fixture.find<QLabel>("questionRisk") != nullptr);
        QTest::mouseClick(fixture.find<QPushButton>("questionYes"), Qt::LeftButton);
        for (int row = 0; row < 2; ++row)
            QTRY_VERIFY2(servos->item(row, 3)->text().startsWith(QStringLiteral("✔")),
                         qPrintable(servos->item(row, 3)->toolTip()));
        fixture.selection().select(fixture.workbench().registry().order()[1]);
        QCOMPARE(fixture.now("min_angle_limit"), 0);
    }

    /// A row that this servo has not is told, not passed over.
    void skippedRowsAreReported()
    {
        SnapshotsPageFixture fixture;
        QVERIFY(fixture.ready(1, QStringLiteral("sim:scs15@1")));
        const QTemporaryDir folder;
        snapshot::Snapshot foreign = fixture.file();
        snapshot::SnapshotRegister row = *foreign.find(QStringLiteral("position_p"));
        row.key = QStringLiteral("no_such_row");
        row.address = 200;
        foreign.registers.push_back(row);
        const auto chosen = snapshot::makeTemplate(foreign, {QStringLiteral("no_such_row")});
        QVERIFY(chosen);
        const QString path = folder.filePath(QStringLiteral("foreign.servo.json"));
        QVERIFY(snapshot::saveSnapshot(*chosen, path));
        fixture.drop(path);
        fixture.click("restoreSeveral");
        auto* servos = fixture.find<QTableWidget>("applyTable");
        QVERIFY(servos != nullptr);
        fixture.click("applyWrite");
        QTRY_VERIFY(fixture.find<QPushButton>("questionYes") != nullptr);
        QTest::mouseClick(fixture.find<QPushButton>("questionYes"), Qt::LeftButton);
        QTRY_VERIFY(servos->item(0, 3)->text().startsWith(QStringLiteral("⚠")));
        QVERIFY(servos->item(0, 3)->text().contains(QLatin1String("1 row skipped")));
        QVERIFY(servos->item(0, 3)->toolTip().contains(QLatin1String("no_such_row")));
    }

    /// The page that is hidden tells of what was read last, and others make widgets of it.
    void theWindowIsWholeWhenThePageEnds()
    {
        SnapshotsPageFixture fixture;
        QVERIFY(fixture.ready(1));
        QVERIFY(fixture.taken());
        const base::Duration before = fixture.workbench().now();
        while (fixture.workbench().now() < before + std::chrono::milliseconds(1500))
            std::this_thread::yield(); // it is read twice a second, and nobody takes it
        const QObject* window = fixture.window.get();
        bool told = false;
        bool whole = true;
        QObject::connect(&fixture.workbench().registry(), &session::ServoRegistry::tableChanged,
                         &fixture.workbench(), [&] {
                             told = true;
                             whole =
                                 whole && window->metaObject() == &ui::MainWindow::staticMetaObject;
                         });
        fixture.window.reset();
        QVERIFY(told && whole);
    }

    void aBundleIsRestoredById()
    {
        SnapshotsPageFixture fixture;
        QVERIFY(fixture.ready(2, two));
        const std::int64_t before = fixture.now("position_p");
        const QTemporaryDir folder;
        snapshot::Bundle bundle;
        bundle.program = QStringLiteral("servodesk");
        bundle.at = QDateTime::currentDateTimeUtc();
        bundle.servos = {fixture.file()};
        const QString path = folder.filePath(QStringLiteral("arm.bundle.json"));
        QVERIFY(snapshot::saveBundle(bundle, path));
        QVERIFY(fixture.write("position_p", before + 3));
        fixture.drop(path);
        QTRY_COMPARE(fixture.button("restoreSeveral")->text(),
                     QStringLiteral("Restore the bundle…"));
        QTreeWidgetItem* row = fixture.snapshotTree()->topLevelItem(0);
        QCOMPARE(row->childCount(), 1);
        fixture.select(row->child(0));
        QTRY_COMPARE(fixture.rowOf("position_p"), 0);
        fixture.select(row);
        fixture.click("restoreSeveral");
        auto* servos = fixture.find<QTableWidget>("applyTable");
        QCOMPARE(servos->rowCount(), 1);
        fixture.click("applyWrite");
        QTRY_VERIFY(fixture.find<QPushButton>("questionYes") != nullptr);
        QTest::mouseClick(fixture.find<QPushButton>("questionYes"), Qt::LeftButton);
        QTRY_VERIFY(servos->item(0, 3)->text().startsWith(QStringLiteral("✔")));
        QCOMPARE(fixture.now("position_p"), before);
    }

    void filesCanBeViewedWithoutAPort()
    {
        const QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("kept.servo.json"));
        {
            SnapshotsPageFixture fixture;
            QVERIFY(fixture.ready(1, two));
            QVERIFY(snapshot::saveSnapshot(fixture.file(), path));
        }
        SnapshotsPageFixture fixture;
        fixture.action(ui::Command::PageSnapshots)->trigger();
        QVERIFY(fixture.find<ui::SnapshotsPage>("snapshotsPage")->isVisible());
        fixture.drop(path);
        QTRY_VERIFY(fixture.table()->isVisible());
        QVERIFY(fixture.rowOf("position_p") >= 0);
        QVERIFY(!fixture.button("restoreWrite")->isEnabled());
        QVERIFY(!fixture.button("snapshotTake")->isEnabled());
    }

    void aNoteIsSaved()
    {
        SnapshotsPageFixture fixture;
        QVERIFY(fixture.ready(1, two));
        QVERIFY(fixture.taken());
        auto* note = fixture.window->findChild<QAction*>(QStringLiteral("snapshotNote"));
        QTRY_VERIFY(note->isEnabled());
        QTRY_VERIFY(fixture.table() != nullptr);
        fixture.find<QToolButton>("compareAll")->setChecked(true);
        QTRY_VERIFY(fixture.rowOf("position_p") >= 0); // it is loaded
        note->trigger();
        auto* label = fixture.find<QLineEdit>("noteLabel");
        QTRY_VERIFY(label != nullptr);
        label->setFocus();
        QTest::keyClicks(label, QStringLiteral("reference, tested"));
        fixture.find<QPlainTextEdit>("noteText")->setPlainText(QStringLiteral("gear changed"));
        fixture.click("noteSave");
        QTRY_VERIFY(fixture.snapshotTree()->topLevelItem(0)->text(0).contains(
            QLatin1String("reference, tested")));
        fixture.find<QLineEdit>("shelfSearch")->setText(QStringLiteral("gear"));
        QTRY_COMPARE(fixture.snapshotTree()->topLevelItemCount(), 1);
        fixture.find<QLineEdit>("shelfSearch")->setText(QStringLiteral("nothing like it"));
        QTRY_COMPARE(fixture.snapshotTree()->topLevelItemCount(), 0);
    }

    /// As by servodesk-cli, with another connection; what is selected stays.
    void snapshotsOfAnotherProgramAreListed()
    {
        SnapshotsPageFixture fixture;
        QVERIFY(fixture.ready(1, two));
        QVERIFY(fixture.taken());
        fixture.find<QComboBox>("shelfWhose")->setCurrentIndex(1); // of all servos
        const auto history = history::History::open(session::historyFile()).value();
        const auto keep = [&](int id) {
            (void)history->log()
                .addSnapshot(history_example::snapshot(id, "one"), history::SnapshotReason::Manual)
                .value();
        };
        keep(7);
        QTRY_COMPARE(fixture.snapshotTree()->topLevelItemCount(), 2);
        fixture.snapshotTree()->selectAll();
        fixture.snapshotTree()->setCurrentItem(fixture.snapshotTree()->topLevelItem(1), 0,
                                               QItemSelectionModel::NoUpdate);
        const QString current = fixture.snapshotTree()->currentItem()->text(0);
        keep(8);
        QTRY_COMPARE(fixture.snapshotTree()->topLevelItemCount(), 3);
        QCOMPARE(fixture.snapshotTree()->selectedItems().size(), 2);
        QCOMPARE(fixture.snapshotTree()->currentItem()->text(0), current);
        fixture.action(ui::Command::PageMemory)->trigger();
        QTRY_VERIFY(!fixture.snapshotTree()->isVisible());
        keep(9);
        fixture.action(ui::Command::PageSnapshots)->trigger();
        QTRY_COMPARE(fixture.snapshotTree()->topLevelItemCount(), 4);
    }

    void isTranslatedToChinese()
    {
        SnapshotsPageFixture fixture(QStringLiteral("zh_CN"));
        QVERIFY(fixture.ready(1, two));
        QVERIFY(fixture.taken());
        static const QRegularExpression han(QStringLiteral("\\p{Han}"));
        auto* page = fixture.find<ui::SnapshotsPage>("snapshotsPage");
        for (const QAbstractButton* button : page->findChildren<QAbstractButton*>()) {
            const bool isSign = button->objectName() == QLatin1String("bannerClose");
            if (button->isVisible() && !isSign && !button->text().isEmpty())
                QVERIFY2(button->text().contains(han), qPrintable(button->text()));
        }
    }
};

SERVODESK_TEST(TestSnapshotsPage)
#include "tst_snapshots_page.moc"
