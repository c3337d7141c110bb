// SPDX-License-Identifier: GPL-3.0-or-later
// The snapshots page on a simulated bus: looking writes nothing, what differs is on top with a
// tick, what is written is what was shown and is asked of the servo again, several servos get a
// verdict each, and a file that is no snapshot is told about. The history is the real one.
#include "gui/window_bench.h"
#include "record/bundle.h"
#include "record/snapshot_template.h"
#include "session/paths.h"
#include "sim/sim_link.h"
#include "support/history_example.h"
#include "ui/models/compare_model.h"
#include "ui/pages/snapshots_page.h"
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
struct SnapshotsBench : gui::WindowBench {
    explicit SnapshotsBench(const QString& language = QStringLiteral("en"))
        : WindowBench(language)
    {
        page = QStringLiteral("snapshots");
    }
    QTreeWidget* shelf() { return find<QTreeWidget>("shelfTree"); }
    QTableView* table() { return find<QTableView>("compareTable"); }
    QPushButton* button(const char* name) { return find<QPushButton>(name); }
    void click(const char* name)
    {
        QVERIFY2(button(name) != nullptr, name);
        QTRY_VERIFY2(button(name)->isEnabled(), name);
        QTest::mouseClick(button(name), Qt::LeftButton);
    }
    /// Takes one and selects it.
    bool taken()
    {
        const int before = shelf()->topLevelItemCount();
        click("snapshotTake");
        if (!QTest::qWaitFor([&] { return shelf()->topLevelItemCount() > before; }, 20'000))
            return false;
        select(shelf()->topLevelItem(0));
        return true;
    }
    void select(QTreeWidgetItem* row)
    {
        shelf()->clearSelection();
        shelf()->setCurrentItem(row);
    }
    bool write(const char* key, std::int64_t value, bool dangerous = false)
    {
        desk().write(selection().current(),
                     {{{QString::fromLatin1(key), value}}, false, dangerous});
        return settled();
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
        (void)settled();
        desk().readTable(selection().current());
        (void)settled();
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
    record::Snapshot file()
    {
        session::Snapshots snapshots(desk(), bench.archive);
        return *snapshots.now(selection().current());
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

    void lookingWritesNothing()
    {
        SnapshotsBench bench;
        QVERIFY(bench.ready(1, two));
        QVERIFY(!bench.button("restoreWrite")->isEnabled());
        QVERIFY(bench.taken());
        QVERIFY(bench.shelf()->topLevelItem(0)->text(0).contains(QStringLiteral("STS3215 · ID 1")));
        QTRY_VERIFY(bench.find<QLabel>("compareNothing")->isVisible());
        QCOMPARE(bench.find<QLabel>("compareNothing")->text(),
                 QStringLiteral("Nothing to set differs."));
        bench.find<QToolButton>("compareAll")->click();
        QTRY_VERIFY(bench.rowOf("position_p") >= 0);
        QVERIFY(!bench.button("restoreWrite")->isEnabled());
        const auto intents = bench.session.journal().entries();
        QVERIFY(intents && intents->empty());
    }

    /// Another program writes, or the servo is exchanged for one of its kind.
    void theServosColumnFollowsTheServo()
    {
        SnapshotsBench bench;
        QVERIFY(bench.ready(1, two));
        QVERIFY(bench.taken());
        auto* different = bench.find<ui::Pill>("compareDifferent");
        auto* age = bench.find<ui::Pill>("compareAge");
        QTRY_COMPARE(different->words(), QStringLiteral("= no setting differs"));
        QTRY_VERIFY(!age->isVisible());
        bench.desk().connection()->simulation()->with([](sim::VirtualBus& bus) {
            bus.servo(1)->poke(QStringLiteral("max_temperature"), 60);
        });
        QTRY_COMPARE_WITH_TIMEOUT(different->words(), QStringLiteral("≠ 1 differ"), 20000);
        QVERIFY(bench.rowOf("max_temperature") >= 0);
    }

    /// What cannot be read is not said to be so now.
    void aSilentServosColumnSaysHowOldItIs()
    {
        SnapshotsBench bench;
        QVERIFY(bench.ready(1, two));
        QVERIFY(bench.taken());
        auto* different = bench.find<ui::Pill>("compareDifferent");
        auto* age = bench.find<ui::Pill>("compareAge");
        QTRY_VERIFY(different->isVisible() && !age->isVisible());
        const auto title = [&] {
            return bench.table()
                ->model()
                ->headerData(ui::CompareModel::FirstTable, Qt::Horizontal)
                .toString();
        };
        QTRY_COMPARE(title(), QStringLiteral("ID 1 now"));
        const auto lose = [&bench](double share) {
            bench.desk().connection()->simulation()->with(
                [share](sim::VirtualBus& bus) { bus.config().faults.dropRequest = share; });
        };
        lose(1);
        QTRY_VERIFY_WITH_TIMEOUT(age->isVisible(), 30000);
        QTRY_VERIFY2_WITH_TIMEOUT(
            age->words().startsWith(QStringLiteral("ID 1 · no answer · read ")),
            qPrintable(age->words()), 30000);
        QCOMPARE(different->words(), QStringLiteral("= no setting differed then"));
        QTRY_VERIFY_WITH_TIMEOUT(title().startsWith(QStringLiteral("ID 1 · ")), 30000);
        lose(0);
        QTRY_VERIFY_WITH_TIMEOUT(!age->isVisible(), 30000);
        QTRY_COMPARE(title(), QStringLiteral("ID 1 now"));
        QCOMPARE(different->words(), QStringLiteral("= no setting differs"));
    }

    /// A snapshot of a servo for 8 V is no reason to put one at 12 V into an alarm.
    void limitsOfAnotherModelNeedAConsciousClick()
    {
        SnapshotsBench bench;
        QVERIFY(bench.ready(1, QStringLiteral("sim:sts3215@1,sts3250@2")));
        QVERIFY(bench.write("max_voltage", 80));
        QVERIFY(bench.write("position_p", 50));
        QVERIFY(bench.taken());
        auto* title = bench.find<QLabel>("compareTitle");
        QTRY_VERIFY2(title->text().contains(QStringLiteral("STS3215 · ID 1 · ")),
                     qPrintable(title->text()));
        QVERIFY(!title->text().contains(QLatin1String("another model")));

        QVERIFY(bench.choose(2));
        const std::int64_t before = bench.now("max_voltage");
        QVERIFY(before > 120);
        bench.find<QComboBox>("shelfWhose")->setCurrentIndex(1);
        const auto ofTheFirst = [&] {
            for (int row = 0; row < bench.shelf()->topLevelItemCount(); ++row) {
                QTreeWidgetItem* item = bench.shelf()->topLevelItem(row);
                if (item->text(0).contains(QStringLiteral("STS3215 · ID 1\ntaken")))
                    return item;
            }
            return static_cast<QTreeWidgetItem*>(nullptr);
        };
        QTRY_VERIFY(ofTheFirst() != nullptr);
        bench.select(ofTheFirst());
        QTRY_VERIFY2(title->text().contains(QStringLiteral("STS3215 · ID 1")) &&
                         title->text().contains(QLatin1String("another model")),
                     qPrintable(title->text()));
        QTRY_VERIFY(bench.rowOf("max_voltage") >= 0);
        QTRY_COMPARE(bench.tick("position_p"), Qt::Checked);
        QCOMPARE(bench.tick("max_voltage"), Qt::Unchecked);

        bench.click("restoreDryRun");
        QLabel* warning = nullptr;
        QTRY_VERIFY((warning = bench.find<QLabel>("dryRunWarning")) != nullptr);
        QVERIFY2(warning->isVisible() && warning->text().contains(QLatin1String("STS3215")) &&
                     warning->text().contains(QLatin1String("not selected: voltage alarm at once")),
                 qPrintable(warning->text()));
        bench.click("dryRunClose");

        bench.click("restoreWrite");
        QTRY_VERIFY(!bench.bannerText().isEmpty());
        QCOMPARE(bench.now("position_p"), 50);
        QCOMPARE(bench.now("max_voltage"), before);

        // By hand: asked for, with what will happen.
        QTRY_VERIFY(bench.rowOf("max_voltage") >= 0);
        bench.table()->setCurrentIndex(bench.cell("max_voltage", 1));
        QTest::keyClick(bench.table(), Qt::Key_Space);
        QTRY_COMPARE(bench.tick("max_voltage"), Qt::Checked);
        bench.click("restoreWrite");
        QLabel* risk = nullptr;
        QTRY_VERIFY((risk = bench.find<QLabel>("questionRisk")) != nullptr);
        QVERIFY2(risk->text().contains(QLatin1String("limit of another model (STS3215)")) &&
                     risk->text().contains(QLatin1String("voltage alarm at once")),
                 qPrintable(risk->text()));
        QTest::mouseClick(bench.find<QPushButton>("questionNo"), Qt::LeftButton);
        QCOMPARE(bench.now("max_voltage"), before);
    }

    /// The servo reads as the file has it, but only until power-off.
    void aTemporaryValueIsOfferedToBeKept()
    {
        SnapshotsBench bench;
        QVERIFY(bench.ready(1, two));
        const std::int64_t asked = bench.now("position_p") + 8;
        bench.desk().write(bench.selection().current(),
                           {{{QStringLiteral("position_p"), asked}}, true, false});
        QVERIFY(bench.settled());
        QVERIFY(bench.taken());
        QTRY_COMPARE(bench.rowOf("position_p"), 0);
        QCOMPARE(bench.table()->model()->rowCount(), 1);
        QCOMPARE(bench.tick("position_p"), Qt::Checked);
        const auto* model = bench.table()->model();
        const QString state = model->index(0, model->columnCount() - 1).data().toString();
        QVERIFY2(state.contains(QLatin1String("not kept yet")), qPrintable(state));

        bench.click("restoreWrite");
        QTRY_VERIFY(!bench.bannerText().isEmpty());
        QTRY_COMPARE(bench.rowOf("position_p"), -1);
        bench.desk().connection()->simulation()->with(
            [](sim::VirtualBus& wire) { wire.powerCycle(); });
        QCOMPARE(bench.now("position_p"), asked);
    }

    void whatDiffersIsShownAndWrittenBack()
    {
        SnapshotsBench bench;
        QVERIFY(bench.ready(1, two));
        const std::int64_t before = bench.now("position_p");
        QVERIFY(bench.taken());
        QVERIFY(bench.write("position_p", before + 8));
        QVERIFY(bench.write("max_angle_limit", 3800));
        QTRY_COMPARE(bench.table()->model()->rowCount(), 2);
        QTRY_COMPARE(bench.tick("position_p"), Qt::Checked);
        QVERIFY(bench.cell("position_p", ui::CompareModel::FirstTable)
                    .data()
                    .toString()
                    .contains(QString::number(before + 8)));
        QTRY_COMPARE(bench.button("restoreWrite")->text(), QStringLiteral("Write 2 ticked rows"));

        // Taken off by hand: it stays off while the servo is read again.
        bench.table()->setCurrentIndex(bench.cell("max_angle_limit", 1));
        QTest::keyClick(bench.table(), Qt::Key_Space);
        QTRY_COMPARE(bench.button("restoreWrite")->text(), QStringLiteral("Write 1 ticked row"));
        const auto* filter = qobject_cast<QSortFilterProxyModel*>(bench.table()->model());
        QSignalSpy looked(qobject_cast<ui::CompareModel*>(filter->sourceModel()),
                          &ui::CompareModel::ticksChanged);
        (void)bench.now("position_p");
        QTRY_VERIFY(looked.count() > 0); // the page has looked again
        QCOMPARE(bench.tick("max_angle_limit"), Qt::Unchecked);

        bench.click("restoreDryRun");
        QTableWidget* steps = nullptr;
        QTRY_VERIFY((steps = bench.find<QTableWidget>("dryRunTable")) != nullptr);
        int writes = 0;
        for (int row = 0; row < steps->rowCount(); ++row)
            writes += steps->item(row, 3)->text().contains(QString::number(before)) ? 1 : 0;
        QCOMPARE(writes, 1);
        bench.click("dryRunClose");

        bench.click("restoreWrite");
        QTRY_VERIFY(bench.bannerText().contains(QLatin1String("1 row")));
        QCOMPARE(bench.now("position_p"), before);
        QCOMPARE(bench.raw("max_angle_limit"), 3800);
        QTRY_VERIFY(!bench.button("restoreWrite")->isEnabled());
        QVERIFY(bench.desk().nextUndo() != nullptr);
        QCOMPARE(bench.desk().nextUndo()->after.front().raw, before);

        // Taken back, it is no result any more.
        bench.desk().undo();
        QVERIFY(bench.settled());
        QTRY_VERIFY(bench.bannerText().isEmpty());
    }

    /// The servo falls silent in the middle, so the way back that was asked for fails as well.
    void aWayBackThatFailedIsSaid()
    {
        SnapshotsBench bench;
        QVERIFY(bench.ready(1, two));
        const std::int64_t voltage = bench.now("max_voltage");
        QVERIFY(bench.taken());
        QVERIFY(bench.write("max_voltage", voltage + 5));
        QVERIFY(bench.write("position_p", bench.now("position_p") + 8));
        QTRY_COMPARE(bench.button("restoreWrite")->text(), QStringLiteral("Write 2 ticked rows"));
        bench.find<QCheckBox>("restoreRollBack")->setChecked(true);
        const auto simulation = bench.desk().connection()->simulation();
        simulation->with([](sim::VirtualBus& wire) {
            wire.config().adapterLatency = std::chrono::milliseconds(150);
        });
        bench.click("restoreWrite");
        QTRY_VERIFY_WITH_TIMEOUT(simulation->with([&](sim::VirtualBus& wire) {
            const bool written = wire.servo(1)->raw(QStringLiteral("max_voltage")) == voltage;
            if (written)
                wire.config().faults.muteIds = {1};
            return written;
        }),
                                 60'000);
        QTRY_VERIFY_WITH_TIMEOUT(!bench.bannerText().isEmpty(), 60'000);
        const QString said = bench.bannerText();
        QVERIFY2(said.contains(QLatin1String("The old values could not be put back: Maximum")),
                 qPrintable(said));
        QVERIFY2(said.contains(QLatin1String("Interrupted writes")), qPrintable(said));
        QCOMPARE(bench.session.journal().open()->size(), std::size_t(1));
    }

    /// Consent was given for one write: after Undo the dangerous row is not ticked by itself.
    void aDangerousRowIsNotTickedAgainAfterUndo()
    {
        SnapshotsBench bench;
        QVERIFY(bench.ready(1));
        QVERIFY(bench.taken());
        const auto before = bench.raw("unload_condition").value_or(0);
        bench.desk().write(bench.selection().current(),
                           {{{QStringLiteral("unload_condition"), before ^ 1}}, false, true});
        QVERIFY(bench.settled());
        QTRY_VERIFY(bench.rowOf("unload_condition") >= 0);
        QTRY_COMPARE(bench.tick("unload_condition"), Qt::Unchecked);
        bench.table()->setCurrentIndex(bench.cell("unload_condition", 1));
        QTest::keyClick(bench.table(), Qt::Key_Space);
        QTRY_COMPARE(bench.tick("unload_condition"), Qt::Checked);
        bench.click("restoreWrite");
        QTRY_VERIFY(bench.find<QPushButton>("questionYes") != nullptr);
        QTest::mouseClick(bench.find<QPushButton>("questionYes"), Qt::LeftButton);
        QTRY_VERIFY(bench.bannerText().contains(QLatin1String("1 row")));
        QVERIFY(bench.settled());
        bench.desk().undo();
        QVERIFY(bench.settled());
        QTRY_VERIFY(bench.rowOf("unload_condition") >= 0);
        QTRY_COMPARE(bench.tick("unload_condition"), Qt::Unchecked);
    }

    /// The table was saved by itself before the first change, and can be chosen like any other.
    /// A row that is never restored is not counted among what differs; it is named, with the
    /// reason.
    void whatIsNeverRestoredIsNotCounted()
    {
        SnapshotsBench bench;
        QVERIFY(bench.ready(1));
        QVERIFY(bench.write("torque_switch", 1));
        QVERIFY(bench.taken());
        QVERIFY(bench.write("torque_switch", 0));
        QVERIFY(bench.write("position_p", 40));
        auto* different = bench.find<ui::Pill>("compareDifferent");
        auto* never = bench.find<ui::Pill>("compareNever");
        QTRY_COMPARE(different->words(), QStringLiteral("≠ 1 differ"));
        QVERIFY(never->isVisible());
        QCOMPARE(never->words(), QStringLiteral("≠ 1 not restored"));
        QVERIFY2(never->toolTip().contains(QStringLiteral("never restored")),
                 qPrintable(never->toolTip()));
        bench.click("restoreWrite");
        QTRY_COMPARE(different->words(), QStringLiteral("= no setting differs"));
        QVERIFY(never->isVisible());
    }

    void theTableBeforeTheFirstChangeIsThere()
    {
        SnapshotsBench bench;
        QVERIFY(bench.ready(1, two));
        const std::int64_t before = bench.now("position_p");
        QVERIFY(bench.write("position_p", before + 1));
        QTRY_COMPARE(bench.shelf()->topLevelItemCount(), 1);
        QVERIFY(bench.shelf()->topLevelItem(0)->text(0).contains(QLatin1String("before a change")));
        bench.select(bench.shelf()->topLevelItem(0));
        QTRY_VERIFY(bench.rowOf("position_p") == 0);
        QCOMPARE(bench.entry().servo.raw(QStringLiteral("position_p")), before + 1);
    }

    /// The table is kept either way.
    void theHistoryNamesNoFileThatIsNotThere()
    {
        SnapshotsBench bench;
        QVERIFY(bench.ready(1, QStringLiteral("sim:sts3215@1")));
        session::Snapshots snapshots(bench.desk(), bench.bench.archive);
        QSignalSpy taken(&snapshots, &session::Snapshots::taken);
        QSignalSpy failed(&snapshots, &session::Snapshots::failed);
        const QTemporaryDir folder;
        const QString good = folder.filePath(QStringLiteral("one.servo.json"));
        snapshots.take(bench.selection().current(), {{}, {}, good});
        QTRY_COMPARE(taken.count(), 1);
        snapshots.take(bench.selection().current(),
                       {{}, {}, folder.filePath(QStringLiteral("no/two.servo.json"))});
        QTRY_COMPARE(failed.count(), 1);
        QStringList files;
        const auto look = [&](const auto& found) {
            files.clear();
            for (const record::HistorySnapshot& one : *found)
                files += one.file;
        };
        const auto both = [&] {
            bench.bench.archive.snapshots({}, this, look);
            return files.size() == 2;
        };
        QTRY_VERIFY(both());
        QCOMPARE(files, (QStringList{QString(), good})); // the latest first
    }

    void identityIsLeftAloneUnlessAsked()
    {
        SnapshotsBench bench;
        QVERIFY(bench.ready(1, two));
        const QTemporaryDir folder;
        record::Snapshot other = bench.file();
        for (record::SnapshotRegister& row : other.registers) {
            if (row.key == QLatin1String("id"))
                row.raw = 7;
        }
        const QString path = folder.filePath(QStringLiteral("other.servo.json"));
        QVERIFY(record::saveSnapshot(other, path));
        bench.drop(path);
        QTRY_VERIFY(bench.find<QCheckBox>("restoreIdentity")->isEnabled()); // it is compared with
        QVERIFY(bench.rowOf("id") >= 0);
        QCOMPARE(bench.tick("id"), Qt::Unchecked);
        QVERIFY(!bench.button("restoreWrite")->isEnabled());
        QTest::mouseClick(bench.find<QCheckBox>("restoreIdentity"), Qt::LeftButton);
        QTRY_COMPARE(bench.tick("id"), Qt::Checked);
        bench.click("restoreWrite");
        auto* yes = bench.find<QPushButton>("questionYes");
        QTRY_VERIFY(yes != nullptr); // it answers elsewhere afterwards: asked
        QTest::mouseClick(yes, Qt::LeftButton);
        QTRY_COMPARE(bench.entry().servo.id, 7);
        QTRY_VERIFY(!bench.bannerText().isEmpty());
    }

    void factoryAndOtherServosAreColumns()
    {
        SnapshotsBench bench;
        QVERIFY(bench.ready(1, two));
        QVERIFY(bench.taken());
        QTRY_VERIFY(bench.table()->model()->columnCount() >= 4);
        const int before = bench.table()->model()->columnCount();
        auto* menu = bench.find<QMenu>("compareColumnsMenu");
        Q_EMIT menu->aboutToShow();
        QCOMPARE(menu->actions().size(), 3); // factory, line, the other servo
        menu->actions().front()->trigger();
        QCOMPARE(bench.table()->model()->columnCount(), before + 1);
        Q_EMIT menu->aboutToShow();
        menu->actions().back()->trigger();
        QTRY_COMPARE(bench.table()->model()->columnCount(), before + 2);
        QTRY_VERIFY(bench.rowOf("id") >= 0); // the two have different ones
    }

    void brokenFilesAreTold_data()
    {
        QTest::addColumn<QByteArray>("content");
        QTest::newRow("empty") << QByteArray();
        QTest::newRow("text") << QByteArray("shopping list");
        QTest::newRow("other JSON") << QByteArray("{\"format\":\"playlist\",\"version\":1}");
        QTest::newRow("newer") << QByteArray(
            "{\"format\":\"servodesk-snapshot\",\"version\":99,\"servo\":{},\"registers\":[]}");
    }
    void brokenFilesAreTold()
    {
        QFETCH(QByteArray, content);
        SnapshotsBench bench;
        QVERIFY(bench.ready(1, two));
        const QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("broken.servo.json"));
        QFile file(path);
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(content);
        file.close();
        bench.drop(path);
        QTRY_VERIFY(bench.bannerText().contains(QLatin1String("broken.servo.json")));
        QCOMPARE(bench.shelf()->topLevelItemCount(), 0);
    }

    void aTemplateGoesToSeveral()
    {
        SnapshotsBench bench;
        QVERIFY(bench.ready(1, two));
        const std::int64_t before = bench.now("position_p");
        const QTemporaryDir folder;
        record::Snapshot wanted = bench.file();
        for (record::SnapshotRegister& row : wanted.registers) {
            if (row.key == QLatin1String("position_p"))
                row.raw = before + 5;
        }
        const auto chosen = record::makeTemplate(wanted, {QStringLiteral("position_p")});
        QVERIFY(chosen);
        const QString path = folder.filePath(QStringLiteral("gripper.servo.json"));
        QVERIFY(record::saveSnapshot(*chosen, path));
        bench.drop(path);
        QTRY_COMPARE(bench.rowOf("position_p"), 0);
        bench.click("restoreSeveral");
        auto* servos = bench.find<QTableWidget>("applyTable");
        QVERIFY(servos != nullptr);
        QCOMPARE(servos->rowCount(), 2);
        bench.click("applyDryRun");
        QTRY_VERIFY(servos->item(1, 3)->text().startsWith(QStringLiteral("≠")));
        QCOMPARE(bench.now("position_p"), before);
        bench.click("applyWrite");
        auto* yes = bench.find<QPushButton>("questionYes");
        QTRY_VERIFY(yes != nullptr);
        QTest::mouseClick(yes, Qt::LeftButton);
        for (int row = 0; row < 2; ++row)
            QTRY_VERIFY_WITH_TIMEOUT(servos->item(row, 3)->text().startsWith(QStringLiteral("✔")),
                                     20'000);
        QTRY_VERIFY(bench.button("applySave")->isEnabled());
        for (const session::ServoRef ref : bench.desk().servos()) {
            bench.selection().select(ref);
            QCOMPARE(bench.now("position_p"), before + 5);
            QVERIFY(bench.desk().servo(ref)->snapshotPath.contains(QLatin1String("STS3215")));
        }
        QVERIFY(bench.desk().nextUndo() != nullptr);
    }

    /// A row that this servo has not is told, not passed over.
    void whatIsLeftOutIsSaid()
    {
        SnapshotsBench bench;
        QVERIFY(bench.ready(1, QStringLiteral("sim:scs15@1")));
        const QTemporaryDir folder;
        record::Snapshot foreign = bench.file();
        record::SnapshotRegister row = *foreign.find(QStringLiteral("position_p"));
        row.key = QStringLiteral("no_such_row");
        row.address = 200;
        foreign.registers.push_back(row);
        const auto chosen = record::makeTemplate(foreign, {QStringLiteral("no_such_row")});
        QVERIFY(chosen);
        const QString path = folder.filePath(QStringLiteral("foreign.servo.json"));
        QVERIFY(record::saveSnapshot(*chosen, path));
        bench.drop(path);
        bench.click("restoreSeveral");
        auto* servos = bench.find<QTableWidget>("applyTable");
        QVERIFY(servos != nullptr);
        bench.click("applyWrite");
        QTRY_VERIFY(bench.find<QPushButton>("questionYes") != nullptr);
        QTest::mouseClick(bench.find<QPushButton>("questionYes"), Qt::LeftButton);
        QTRY_VERIFY(servos->item(0, 3)->text().startsWith(QStringLiteral("⚠")));
        QVERIFY(servos->item(0, 3)->text().contains(QLatin1String("1 row left out")));
        QVERIFY(servos->item(0, 3)->toolTip().contains(QLatin1String("no_such_row")));
    }

    /// The page that is hidden tells of what was read last, and others make widgets of it.
    void theWindowIsWholeWhenThePageEnds()
    {
        SnapshotsBench bench;
        QVERIFY(bench.ready(1));
        QVERIFY(bench.taken());
        const base::Duration before = bench.desk().now();
        while (bench.desk().now() < before + std::chrono::milliseconds(1500))
            std::this_thread::yield(); // it is read twice a second, and nobody takes it
        const QObject* window = bench.window.get();
        bool told = false;
        bool whole = true;
        QObject::connect(&bench.desk(), &session::Desk::tableChanged, &bench.desk(), [&] {
            told = true;
            whole = whole && window->metaObject() == &ui::MainWindow::staticMetaObject;
        });
        bench.window.reset();
        QVERIFY(told && whole);
    }

    void aBundleGoesBackById()
    {
        SnapshotsBench bench;
        QVERIFY(bench.ready(2, two));
        const std::int64_t before = bench.now("position_p");
        const QTemporaryDir folder;
        record::Bundle bundle;
        bundle.program = QStringLiteral("servodesk");
        bundle.at = QDateTime::currentDateTimeUtc();
        bundle.servos = {bench.file()};
        const QString path = folder.filePath(QStringLiteral("arm.bundle.json"));
        QVERIFY(record::saveBundle(bundle, path));
        QVERIFY(bench.write("position_p", before + 3));
        bench.drop(path);
        QTRY_COMPARE(bench.button("restoreSeveral")->text(), QStringLiteral("Restore the bundle…"));
        QTreeWidgetItem* row = bench.shelf()->topLevelItem(0);
        QCOMPARE(row->childCount(), 1);
        bench.select(row->child(0));
        QTRY_COMPARE(bench.rowOf("position_p"), 0);
        bench.select(row);
        bench.click("restoreSeveral");
        auto* servos = bench.find<QTableWidget>("applyTable");
        QCOMPARE(servos->rowCount(), 1);
        bench.click("applyWrite");
        QTRY_VERIFY(bench.find<QPushButton>("questionYes") != nullptr);
        QTest::mouseClick(bench.find<QPushButton>("questionYes"), Qt::LeftButton);
        QTRY_VERIFY_WITH_TIMEOUT(servos->item(0, 3)->text().startsWith(QStringLiteral("✔")),
                                 20'000);
        QCOMPARE(bench.now("position_p"), before);
    }

    void filesAreLookedAtWithoutAPort()
    {
        const QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("kept.servo.json"));
        {
            SnapshotsBench bench;
            QVERIFY(bench.ready(1, two));
            QVERIFY(record::saveSnapshot(bench.file(), path));
        }
        SnapshotsBench bench;
        bench.action(ui::Command::PageSnapshots)->trigger();
        QVERIFY(bench.find<ui::SnapshotsPage>("snapshotsPage")->isVisible());
        bench.drop(path);
        QTRY_VERIFY(bench.table()->isVisible());
        QVERIFY(bench.rowOf("position_p") >= 0);
        QVERIFY(!bench.button("restoreWrite")->isEnabled());
        QVERIFY(!bench.button("snapshotTake")->isEnabled());
    }

    void aNoteIsKept()
    {
        SnapshotsBench bench;
        QVERIFY(bench.ready(1, two));
        QVERIFY(bench.taken());
        auto* note = bench.window->findChild<QAction*>(QStringLiteral("snapshotNote"));
        QTRY_VERIFY(note->isEnabled());
        QTRY_VERIFY(bench.table() != nullptr);
        bench.find<QToolButton>("compareAll")->setChecked(true);
        QTRY_VERIFY(bench.rowOf("position_p") >= 0); // it is loaded
        note->trigger();
        auto* label = bench.find<QLineEdit>("noteLabel");
        QTRY_VERIFY(label != nullptr);
        label->setFocus();
        QTest::keyClicks(label, QStringLiteral("reference, tested"));
        bench.find<QPlainTextEdit>("noteText")->setPlainText(QStringLiteral("gear changed"));
        bench.click("noteSave");
        QTRY_VERIFY(
            bench.shelf()->topLevelItem(0)->text(0).contains(QLatin1String("reference, tested")));
        bench.find<QLineEdit>("shelfSearch")->setText(QStringLiteral("gear"));
        QTRY_COMPARE(bench.shelf()->topLevelItemCount(), 1);
        bench.find<QLineEdit>("shelfSearch")->setText(QStringLiteral("nothing like it"));
        QTRY_COMPARE(bench.shelf()->topLevelItemCount(), 0);
    }

    /// As by servodesk-cli, with another connection; what is selected stays.
    void whatAnotherProgramKeepsIsListed()
    {
        SnapshotsBench bench;
        QVERIFY(bench.ready(1, two));
        QVERIFY(bench.taken());
        bench.find<QComboBox>("shelfWhose")->setCurrentIndex(1); // of all servos
        const auto history = record::History::open(session::historyFile()).value();
        const auto keep = [&](int id) {
            (void)history->log()
                .addSnapshot(history_example::snapshot(id, "one"), record::SnapshotReason::Asked)
                .value();
        };
        keep(7);
        QTRY_COMPARE(bench.shelf()->topLevelItemCount(), 2);
        bench.shelf()->selectAll();
        bench.shelf()->setCurrentItem(bench.shelf()->topLevelItem(1), 0,
                                      QItemSelectionModel::NoUpdate);
        const QString current = bench.shelf()->currentItem()->text(0);
        keep(8);
        QTRY_COMPARE(bench.shelf()->topLevelItemCount(), 3);
        QCOMPARE(bench.shelf()->selectedItems().size(), 2);
        QCOMPARE(bench.shelf()->currentItem()->text(0), current);
        bench.action(ui::Command::PageMemory)->trigger();
        QTRY_VERIFY(!bench.shelf()->isVisible());
        keep(9);
        bench.action(ui::Command::PageSnapshots)->trigger();
        QTRY_COMPARE(bench.shelf()->topLevelItemCount(), 4);
    }

    void itSpeaksChinese()
    {
        SnapshotsBench bench(QStringLiteral("zh_CN"));
        QVERIFY(bench.ready(1, two));
        QVERIFY(bench.taken());
        static const QRegularExpression han(QStringLiteral("\\p{Han}"));
        auto* page = bench.find<ui::SnapshotsPage>("snapshotsPage");
        for (const QAbstractButton* button : page->findChildren<QAbstractButton*>()) {
            if (button->isVisible() && !button->text().isEmpty())
                QVERIFY2(button->text().contains(han), qPrintable(button->text()));
        }
    }
};

QTEST_MAIN(TestSnapshotsPage)
#include "tst_snapshots_page.moc"
