// SPDX-License-Identifier: GPL-3.0-or-later
// The memory table as a model: the appearance of each state, what is never shown, which rows
// change, and what the filters show.
#include "gui/servo_entry_builder.h"
#include "support/test_main.h"
#include "text/language.h"
#include "ui/memory/memory_filter.h"
#include "ui/memory/memory_model.h"
#include "ui/memory/servo_history_model.h"

#include <QAbstractItemModelTester>
#include <QRegularExpression>
#include <QSignalSpy>
#include <QTest>

using namespace std::chrono_literals;
using device::WriteOutcome;
using guitest::entryOf;
using guitest::put;
using ui::MemoryColumn;
using ui::MemoryModel;
using ui::RowState;

class TestMemoryModel : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init();

    void emptyWithoutServo();
    void showsReadValues();
    void failedReadsShowNoValue();
    void oldValuesAreStale_data();
    void oldValuesAreStale();
    void valuesAreStaleWithoutALink();
    void writesEnd_data();
    void writesEnd();
    void pendingReplacesOlderOutcomes();
    void aChangedValueLosesItsSavedMark();
    void marksChangesSinceTheFirstRead();
    void onlyChangedRowsAreAnnounced();
    void editingRequestsAWriteAndChangesNothing();
    void readOnlyCellsCannotBeEdited();
    void unknownFirmwareIsReadOnly();
    void anUnclearFamilyShowsRawBytes();
    void physicalFirstShowsUnitsInDefaultAndRange();
    void isTranslatedToChinese();
    void everyCellHasATooltip();

    void findsByWord_data();
    void findsByWord();
    void groups();
    void onlyChanged();
    void unknownDefaultsAreNotDifferent();

    void historyIsNewestFirst();
};

namespace {
ui::RowContext at(base::Duration now)
{
    return {now, true};
}

QModelIndex cell(const MemoryModel& model, const char* key, MemoryColumn column)
{
    return model.index(model.rowOf(QString::fromLatin1(key)), static_cast<int>(column));
}

QString shown(const MemoryModel& model, const char* key, MemoryColumn column)
{
    return cell(model, key, column).data().toString();
}

QStringList keys(const QAbstractItemModel& model)
{
    QStringList keys;
    for (int row = 0; row < model.rowCount(); ++row)
        keys << model.index(row, 0).data(MemoryModel::KeyRole).toString();
    return keys;
}
} // namespace

void TestMemoryModel::init()
{
    QTest::failOnWarning(QRegularExpression(QStringLiteral(".*")));
    text::installTranslator(QStringLiteral("en"));
}

void TestMemoryModel::emptyWithoutServo()
{
    MemoryModel model;
    QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::QtTest);
    QCOMPARE(model.rowCount(), 0);
    const auto entry = entryOf(guitest::sts3215);
    model.setEntry(&entry, at(0s));
    QVERIFY(model.rowCount() > 50);
    session::ServoEntry silent;
    silent.ref = 7;
    model.setEntry(&silent, at(0s));
    QCOMPARE(model.rowCount(), 0);
    model.setEntry(nullptr, at(0s));
    QCOMPARE(model.rowCount(), 0);
}

void TestMemoryModel::showsReadValues()
{
    auto entry = entryOf(guitest::sts3215);
    put(entry, QStringLiteral("max_voltage"), 85);
    put(entry, QStringLiteral("operating_mode"), 1);
    put(entry, QStringLiteral("unload_condition"), 44);
    MemoryModel model;
    model.setEntry(&entry, at(0s));
    QCOMPARE(shown(model, "max_voltage", MemoryColumn::Address), QStringLiteral("14"));
    QCOMPARE(shown(model, "max_voltage", MemoryColumn::Value), QStringLiteral("85"));
    QCOMPARE(shown(model, "max_voltage", MemoryColumn::Physical), QStringLiteral("8.5 V"));
    QCOMPARE(shown(model, "operating_mode", MemoryColumn::Value), QStringLiteral("1"));
    QVERIFY(!shown(model, "operating_mode", MemoryColumn::Physical).isEmpty());
    QCOMPARE(shown(model, "unload_condition", MemoryColumn::Value), QStringLiteral("44"));
    QVERIFY(shown(model, "unload_condition", MemoryColumn::Physical)
                .contains(QStringLiteral("overload")));
    QCOMPARE(shown(model, "max_voltage", MemoryColumn::Area), QStringLiteral("EPROM"));
    QCOMPARE(shown(model, "max_voltage", MemoryColumn::Access), QStringLiteral("rw"));
    QCOMPARE(shown(model, "phase", MemoryColumn::Access), QStringLiteral("⚠ rw"));
    QCOMPARE(shown(model, "present_position", MemoryColumn::Access), QStringLiteral("r"));
    QCOMPARE(shown(model, "position_p", MemoryColumn::Default), QStringLiteral("32"));
    QCOMPARE(shown(model, "position_p", MemoryColumn::Range), QStringLiteral("0–254"));
    QCOMPARE(shown(model, "goal_position", MemoryColumn::Range), QStringLiteral("±30719"));
    QCOMPARE(shown(model, "present_position", MemoryColumn::Range), QString());
    QCOMPARE(shown(model, "position_p", MemoryColumn::State), QStringLiteral("now"));
    QCOMPARE(cell(model, "max_voltage", MemoryColumn::Value).data(MemoryModel::RawRole), 85);
}

void TestMemoryModel::failedReadsShowNoValue()
{
    auto entry = entryOf(guitest::sts3215);
    put(entry, QStringLiteral("present_voltage"), 74);
    entry.unreadable.insert(QStringLiteral("present_voltage"));
    MemoryModel model;
    model.setEntry(&entry, at(0s));
    QCOMPARE(shown(model, "present_voltage", MemoryColumn::Value), QStringLiteral("—"));
    QCOMPARE(shown(model, "present_voltage", MemoryColumn::Physical), QString());
    QCOMPARE(shown(model, "present_voltage", MemoryColumn::State),
             QStringLiteral("✗ could not be read"));
    QVERIFY(
        !cell(model, "present_voltage", MemoryColumn::Value).data(MemoryModel::RawRole).isValid());
    for (int column = 0; column < ui::memoryColumns; ++column) {
        const QModelIndex index = cell(model, "present_voltage", static_cast<MemoryColumn>(column));
        QVERIFY(!index.data().toString().contains(QStringLiteral("74")));
        QVERIFY(!index.data(Qt::ToolTipRole).toString().contains(QStringLiteral("74")));
    }

    session::ServoEntry unread = entryOf(guitest::sts3215);
    unread.servo.image.clear();
    model.setEntry(&unread, at(0s));
    QCOMPARE(shown(model, "position_p", MemoryColumn::Value), QStringLiteral("—"));
    QCOMPARE(shown(model, "position_p", MemoryColumn::State), QStringLiteral("not read"));
}

void TestMemoryModel::oldValuesAreStale_data()
{
    QTest::addColumn<QString>("key");
    QTest::addColumn<int>("seconds");
    QTest::addColumn<QString>("age");
    QTest::addColumn<bool>("stale");
    QTest::newRow("measured now") << "present_voltage" << 0 << "now" << false;
    QTest::newRow("measured a moment ago") << "present_voltage" << 2 << "2 s" << false;
    QTest::newRow("measured long ago") << "present_voltage" << 4 << "3 s" << true;
    QTest::newRow("setting a while ago") << "position_p" << 59 << "45 s" << false;
    QTest::newRow("setting a minute ago") << "position_p" << 119 << "1 min" << false;
    QTest::newRow("setting long ago") << "position_p" << 301 << "5 min" << true;
    QTest::newRow("goal") << "goal_position" << 31 << "30 s" << true;
    QTest::newRow("hours") << "position_p" << 7300 << "2 h" << true;
}

void TestMemoryModel::oldValuesAreStale()
{
    QFETCH(QString, key);
    QFETCH(int, seconds);
    QFETCH(QString, age);
    QFETCH(bool, stale);
    const auto entry = entryOf(guitest::sts3215);
    MemoryModel model;
    model.setEntry(&entry, at(std::chrono::seconds(seconds)));
    const QModelIndex index = model.index(model.rowOf(key), static_cast<int>(MemoryColumn::State));
    QCOMPARE(index.data().toString(), age);
    QCOMPARE(index.data(MemoryModel::StaleRole).toBool(), stale);
}

void TestMemoryModel::valuesAreStaleWithoutALink()
{
    auto entry = entryOf(guitest::sts3215);
    MemoryModel model;
    model.setEntry(&entry, {0s, false});
    QVERIFY(cell(model, "position_p", MemoryColumn::Value).data(MemoryModel::StaleRole).toBool());
    entry.silent = true;
    model.setEntry(&entry, at(0s));
    QVERIFY(cell(model, "position_p", MemoryColumn::Value).data(MemoryModel::StaleRole).toBool());
}

void TestMemoryModel::writesEnd_data()
{
    QTest::addColumn<WriteOutcome>("outcome");
    QTest::addColumn<QString>("word");
    QTest::addColumn<RowState>("state");
    QTest::newRow("kept") << WriteOutcome::Kept << "✓ kept · now" << RowState::Kept;
    QTest::newRow("temporary") << WriteOutcome::Temporary << "◷ temporary · now"
                               << RowState::Temporary;
    QTest::newRow("mismatch") << WriteOutcome::Mismatch << "≠ mismatch · now" << RowState::Mismatch;
    QTest::newRow("refused") << WriteOutcome::Refused << "✗ refused · now" << RowState::Refused;
    QTest::newRow("not sent") << WriteOutcome::NotSent << "✗ not sent · now" << RowState::NotSent;
    QTest::newRow("no answer") << WriteOutcome::NoReply << "✗ write: no reply · now"
                               << RowState::NoReply;
    QTest::newRow("unknown") << WriteOutcome::Unknown << "? unknown · now" << RowState::Unknown;
}

void TestMemoryModel::writesEnd()
{
    QFETCH(WriteOutcome, outcome);
    QFETCH(QString, word);
    QFETCH(RowState, state);
    auto entry = entryOf(guitest::sts3215);
    session::RegisterWriteState& write = entry.writes[QStringLiteral("position_p")];
    write.requested = 32;
    write.outcome = outcome;
    MemoryModel model;
    model.setEntry(&entry, at(0s));
    const QModelIndex index = cell(model, "position_p", MemoryColumn::State);
    QCOMPARE(index.data().toString(), word);
    QCOMPARE(index.data(MemoryModel::StateRole).value<int>(), static_cast<int>(state));
    QVERIFY(index.data(Qt::ToolTipRole).toString().contains(QStringLiteral("32")));
}

void TestMemoryModel::pendingReplacesOlderOutcomes()
{
    auto entry = entryOf(guitest::sts3215);
    session::RegisterWriteState& write = entry.writes[QStringLiteral("position_p")];
    write.pending = 2;
    write.requested = 41;
    write.outcome = WriteOutcome::Kept;
    MemoryModel model;
    model.setEntry(&entry, at(0s));
    QVERIFY(shown(model, "position_p", MemoryColumn::State)
                .startsWith(QStringLiteral("… pending: 41")));
    // The number shown stays the one that was read; the editor goes on from the one on its way.
    QCOMPARE(shown(model, "position_p", MemoryColumn::Value), QStringLiteral("32"));
    QCOMPARE(cell(model, "position_p", MemoryColumn::Value).data(Qt::EditRole).toInt(), 41);
}

void TestMemoryModel::aChangedValueLosesItsSavedMark()
{
    auto entry = entryOf(guitest::sts3215);
    session::RegisterWriteState& write = entry.writes[QStringLiteral("position_p")];
    write.requested = 40;
    write.outcome = WriteOutcome::Temporary;
    write.at = 5s;
    put(entry, QStringLiteral("position_p"), 40, 5s);
    MemoryModel model;
    model.setEntry(&entry, at(5s));
    QVERIFY(shown(model, "position_p", MemoryColumn::State).contains(QStringLiteral("temporary")));
    put(entry, QStringLiteral("position_p"), 32, 9s); // the servo was switched off and on
    model.setEntry(&entry, at(9s));
    QVERIFY(shown(model, "position_p", MemoryColumn::State)
                .startsWith(QStringLiteral("≠ changed since the write")));

    // A goal changes by itself, which is nothing to wonder about.
    session::RegisterWriteState& goal = entry.writes[QStringLiteral("goal_position")];
    goal.requested = 100;
    goal.outcome = WriteOutcome::Temporary;
    goal.at = 5s;
    put(entry, QStringLiteral("goal_position"), 200, 9s);
    model.setEntry(&entry, at(9s));
    QCOMPARE(shown(model, "goal_position", MemoryColumn::State), QStringLiteral("now"));
}

void TestMemoryModel::marksChangesSinceTheFirstRead()
{
    auto entry = entryOf(guitest::sts3215);
    put(entry, QStringLiteral("position_p"), 40);
    MemoryModel model;
    model.setEntry(&entry, at(0s));
    const QModelIndex name = cell(model, "position_p", MemoryColumn::Name);
    QVERIFY(name.data().toString().endsWith(QStringLiteral("•")));
    QVERIFY(name.data(Qt::ToolTipRole).toString().contains(QStringLiteral("32")));
    QVERIFY(!shown(model, "position_d", MemoryColumn::Name).contains(QStringLiteral("•")));
}

void TestMemoryModel::onlyChangedRowsAreAnnounced()
{
    auto entry = entryOf(guitest::sts3215);
    MemoryModel model;
    QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::QtTest);
    model.setEntry(&entry, at(0s));
    QSignalSpy changes(&model, &QAbstractItemModel::dataChanged);
    QSignalSpy resets(&model, &QAbstractItemModel::modelReset);
    model.setEntry(&entry, at(900ms));
    QCOMPARE(changes.count(), 0);
    put(entry, QStringLiteral("present_voltage"), 75);
    model.setEntry(&entry, at(900ms));
    QCOMPARE(changes.count(), 1);
    QCOMPARE(changes.at(0).at(0).toModelIndex().row(),
             model.rowOf(QStringLiteral("present_voltage")));
    QCOMPARE(changes.at(0).at(1).toModelIndex().row(),
             model.rowOf(QStringLiteral("present_voltage")));
    QCOMPARE(resets.count(), 0);
    const auto other = entryOf(guitest::sts3215, 2);
    model.setEntry(&other, at(900ms));
    QCOMPARE(resets.count(), 1);
}

void TestMemoryModel::editingRequestsAWriteAndChangesNothing()
{
    const auto entry = entryOf(guitest::sts3215);
    MemoryModel model;
    model.setEntry(&entry, at(0s));
    QSignalSpy wanted(&model, &MemoryModel::writeRequested);
    const QModelIndex value = cell(model, "position_p", MemoryColumn::Value);
    QVERIFY(model.setData(value, 40, Qt::EditRole));
    QCOMPARE(wanted.count(), 1);
    QCOMPARE(wanted.at(0).at(0).toString(), QStringLiteral("position_p"));
    QCOMPARE(wanted.at(0).at(1).toLongLong(), 40);
    QCOMPARE(value.data().toString(), QStringLiteral("32"));
    QVERIFY(!model.setData(value, QStringLiteral("rubbish"), Qt::EditRole));
    QCOMPARE(wanted.count(), 1);
}

void TestMemoryModel::readOnlyCellsCannotBeEdited()
{
    const auto entry = entryOf(guitest::sts3215);
    MemoryModel model;
    model.setEntry(&entry, at(0s));
    QSignalSpy wanted(&model, &MemoryModel::writeRequested);
    QVERIFY(!model.setData(cell(model, "present_voltage", MemoryColumn::Value), 1, Qt::EditRole));
    QVERIFY(!model.setData(cell(model, "position_p", MemoryColumn::Name), 1, Qt::EditRole));
    QVERIFY(!(cell(model, "position_p", MemoryColumn::Physical).flags() & Qt::ItemIsEditable));
    QVERIFY(cell(model, "max_voltage", MemoryColumn::Physical).flags() & Qt::ItemIsEditable);
    QCOMPARE(wanted.count(), 0);
}

void TestMemoryModel::unknownFirmwareIsReadOnly()
{
    const auto entry = entryOf(catalog::Identity{200, 200, 0, 1, 1});
    QVERIFY(!entry.servo.profile->writable);
    MemoryModel model;
    model.setEntry(&entry, at(0s));
    QVERIFY(model.rowCount() > 5);
    for (int row = 0; row < model.rowCount(); ++row) {
        for (int column = 0; column < ui::memoryColumns; ++column)
            QVERIFY(!(model.index(row, column).flags() & Qt::ItemIsEditable));
    }
}

void TestMemoryModel::anUnclearFamilyShowsRawBytes()
{
    MemoryModel model;
    const auto entry = entryOf({3, 25, 1, 9, 3});
    model.setEntry(&entry, at({}));
    for (int place = 0; place <= 70; ++place) {
        QCOMPARE(model.index(place, int(MemoryColumn::Address)).data().toInt(), place);
        for (int column = 0; column < model.columnCount(); ++column)
            QVERIFY(!model.index(place, column).flags().testFlag(Qt::ItemIsEditable));
    }
}

void TestMemoryModel::physicalFirstShowsUnitsInDefaultAndRange()
{
    const auto entry = entryOf(guitest::sts3215);
    MemoryModel model;
    model.setEntry(&entry, at(0s));
    QCOMPARE(shown(model, "min_voltage", MemoryColumn::Range), QStringLiteral("0–254"));
    QSignalSpy changes(&model, &QAbstractItemModel::dataChanged);
    model.setPhysicalFirst(true);
    QVERIFY(changes.count() > 0);
    QCOMPARE(shown(model, "min_voltage", MemoryColumn::Range), QStringLiteral("0.0 V–25.4 V"));
    QCOMPARE(shown(model, "min_voltage", MemoryColumn::Default), QStringLiteral("4.0 V"));
    QCOMPARE(shown(model, "min_voltage", MemoryColumn::Value), QStringLiteral("40"));
}

void TestMemoryModel::isTranslatedToChinese()
{
    const auto entry = entryOf(guitest::sts3215);
    MemoryModel model;
    model.setEntry(&entry, at(0s));
    text::installTranslator(QStringLiteral("zh_CN"));
    QSignalSpy headers(&model, &QAbstractItemModel::headerDataChanged);
    model.retranslate();
    QCOMPARE(headers.count(), 1);
    QCOMPARE(shown(model, "unload_condition", MemoryColumn::Name), QStringLiteral("卸载条件"));
}

void TestMemoryModel::everyCellHasATooltip()
{
    auto entry = entryOf(guitest::sts3215);
    entry.unreadable.insert(QStringLiteral("position_p"));
    MemoryModel model;
    model.setEntry(&entry, at(0s));
    for (int column = 0; column < ui::memoryColumns; ++column) {
        QVERIFY(!model.headerData(column, Qt::Horizontal, Qt::DisplayRole).toString().isEmpty());
        QVERIFY(!model.headerData(column, Qt::Horizontal, Qt::ToolTipRole).toString().isEmpty());
        for (int row = 0; row < model.rowCount(); ++row)
            QVERIFY(!model.index(row, column).data(Qt::ToolTipRole).toString().isEmpty());
    }
}

void TestMemoryModel::findsByWord_data()
{
    QTest::addColumn<QString>("typed");
    QTest::addColumn<QString>("found");
    QTest::newRow("address") << "33"
                             << "operating_mode";
    QTest::newRow("key") << "unload_cond"
                         << "unload_condition";
    QTest::newRow("English name, any case") << "OPERATING mode"
                                            << "operating_mode";
    QTest::newRow("Chinese name in the English interface") << "卸载"
                                                           << "unload_condition";
    QTest::newRow("word of the help") << "oscillate draw"
                                      << "position_p";
    QTest::newRow("value of a list") << "500000"
                                     << "baud_rate";
}

void TestMemoryModel::findsByWord()
{
    QFETCH(QString, typed);
    QFETCH(QString, found);
    const auto entry = entryOf(guitest::sts3215);
    MemoryModel model;
    ui::MemoryFilter filter;
    QAbstractItemModelTester tester(&filter,
                                    QAbstractItemModelTester::FailureReportingMode::QtTest);
    filter.setSourceModel(&model);
    model.setEntry(&entry, at(0s));
    const int all = filter.rowCount();
    filter.setText(typed);
    QVERIFY(filter.rowCount() < all / 3);
    QVERIFY2(keys(filter).contains(found), qPrintable(keys(filter).join(u' ')));
    filter.setText(QStringLiteral("  "));
    QCOMPARE(filter.rowCount(), all);
    filter.setText(QStringLiteral("no such thing"));
    QCOMPARE(filter.rowCount(), 0);
}

void TestMemoryModel::groups()
{
    const auto entry = entryOf(guitest::sts3215);
    MemoryModel model;
    ui::MemoryFilter filter;
    filter.setSourceModel(&model);
    model.setEntry(&entry, at(0s));
    int sum = 0;
    for (const auto area : {catalog::Area::Eprom, catalog::Area::Sram, catalog::Area::Feedback,
                            catalog::Area::Factory}) {
        filter.setGroup(area);
        QVERIFY(filter.rowCount() > 0);
        sum += filter.rowCount();
        for (int row = 0; row < filter.rowCount(); ++row)
            QCOMPARE(filter.index(row, 0).data(MemoryModel::AreaRole).toInt(),
                     static_cast<int>(area));
    }
    QCOMPARE(sum, model.rowCount());
}

void TestMemoryModel::onlyChanged()
{
    auto entry = entryOf(guitest::sts3215);
    MemoryModel model;
    ui::MemoryFilter filter;
    filter.setSourceModel(&model);
    model.setEntry(&entry, at(0s));
    filter.setRowFilter(ui::RowFilter::Changed);
    QCOMPARE(filter.rowCount(), 0);
    put(entry, QStringLiteral("position_p"), 40);
    model.setEntry(&entry, at(0s)); // the row comes in while the filter is on
    QCOMPARE(keys(filter), QStringList{QStringLiteral("position_p")});
}

void TestMemoryModel::unknownDefaultsAreNotDifferent()
{
    auto entry = entryOf(guitest::sts3215);
    QVERIFY(!entry.servo.profile->find(QStringLiteral("max_voltage"))->defaultRaw);
    put(entry, QStringLiteral("max_voltage"), 123);
    put(entry, QStringLiteral("position_p"), 40);
    MemoryModel model;
    ui::MemoryFilter filter;
    filter.setSourceModel(&model);
    model.setEntry(&entry, at(0s));
    filter.setRowFilter(ui::RowFilter::Different);
    QCOMPARE(keys(filter), QStringList{QStringLiteral("position_p")});
    QVERIFY(
        !cell(model, "max_voltage", MemoryColumn::Value).data(MemoryModel::DiffersRole).isValid());
}

void TestMemoryModel::historyIsNewestFirst()
{
    auto entry = entryOf(guitest::sts3215);
    const auto remember = [&entry](const char* key, int from, int to, const char* end) {
        base::JournalEntry one;
        one.intent.uuid = QString::number(entry.history.size());
        one.intent.at = QDateTime::currentDateTimeUtc();
        one.intent.items.push_back({QString::fromLatin1(key), 0, from, to});
        if (end != nullptr)
            one.end = base::IntentResult{QString::fromLatin1(end), {}};
        entry.history.push_back(one);
    };
    remember("position_p", 32, 40, "done");
    remember("max_angle_limit", 4095, 3800, "failed");
    ui::ServoHistoryModel model;
    QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::QtTest);
    model.setEntry(&entry);
    QCOMPARE(model.rowCount(), 2);
    const QString newest = model.index(0).data().toString();
    QVERIFY2(newest.contains(QStringLiteral("Maximum angle limit 359.91° → 333.98° ✗")),
             qPrintable(newest));
    QVERIFY(model.index(1).data().toString().contains(QStringLiteral("Position loop P 32 → 40 ✓")));
    QSignalSpy resets(&model, &QAbstractItemModel::modelReset);
    model.setEntry(&entry);
    QCOMPARE(resets.count(), 0);
    remember("position_p", 40, 32, nullptr);
    model.setEntry(&entry);
    QVERIFY(model.index(0).data().toString().endsWith(QStringLiteral("…")));
    model.setEntry(nullptr);
    QCOMPARE(model.rowCount(), 0);
}

SERVODESK_TEST(TestMemoryModel)
#include "tst_memory_model.moc"
