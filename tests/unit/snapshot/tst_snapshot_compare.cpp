// SPDX-License-Identifier: GPL-3.0-or-later
// Tables side by side: what differs is found, by raw number within a map and by physical value
// between maps; what nobody knows is never called different. Factory defaults as a table. CSV.
#include "snapshot/factory_snapshot.h"
#include "snapshot/snapshot_compare.h"
#include "support/test_main.h"
#include "support/text.h"

#include <QtTest>

using catalog::Access;
using catalog::Area;
using snapshot::CellState;
using snapshot::CompareRow;
using snapshot::RowVerdict;
using snapshot::Snapshot;
using support::utf8;

namespace {
snapshot::SnapshotRegister row(const char* key, int address, std::optional<std::int64_t> raw,
                               double scale = 1, const char* unit = "",
                               Access access = Access::ReadWrite)
{
    snapshot::SnapshotRegister reg;
    reg.key = utf8(key);
    reg.address = address;
    reg.raw = raw;
    if (raw)
        reg.value = double(*raw) * scale;
    reg.unit = utf8(unit);
    reg.access = access;
    reg.area = access == Access::ReadOnly ? Area::Feedback : Area::Eprom;
    return reg;
}

Snapshot table(const char* map, std::vector<snapshot::SnapshotRegister> rows)
{
    Snapshot snapshot;
    snapshot.servo = {1, utf8("X"), utf8("9.3"), utf8("3.10"), utf8(map), utf8("feetech")};
    snapshot.registers = std::move(rows);
    return snapshot;
}

const CompareRow* find(const snapshot::SnapshotComparison& comparison, const char* key)
{
    for (const CompareRow& row : comparison.rows) {
        if (row.key == utf8(key))
            return &row;
    }
    return nullptr;
}

const catalog::Catalog& models()
{
    static const catalog::Catalog catalog = catalog::Catalog::load().catalog;
    return catalog;
}

catalog::ProfilePtr sts()
{
    return models().profileFor(*models().model(utf8("STS3215")), 3, 10);
}
} // namespace

class TestSnapshotCompare : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { QTest::failOnWarning(QRegularExpression(utf8(".*"))); }

    void differingRowsComeFirst()
    {
        const Snapshot a =
            table("m", {row("one", 1, 5), row("two", 2, 6), row("three", 3, 7), row("four", 4, {}),
                        row("seen", 60, 1, 1, "", Access::ReadOnly)});
        const Snapshot b =
            table("m", {row("one", 1, 5), row("two", 2, 9), row("five", 5, 7), row("four", 4, 4),
                        row("seen", 60, 2, 1, "", Access::ReadOnly)});
        const auto comparison = snapshot::compareSnapshots({&a, &b});
        QStringList order;
        for (const CompareRow& one : comparison.rows)
            order << one.key;
        QCOMPARE(order, (QStringList{utf8("two"), utf8("three"), utf8("five"), utf8("four"),
                                     utf8("one"), utf8("seen")}));
        QCOMPARE(comparison.different, 1);
        QCOMPARE(comparison.missing, 2);
        QCOMPARE(comparison.unknown, 1);
        QCOMPARE(comparison.identical, 1);
        QCOMPARE(comparison.readOnly, 1);
        QVERIFY(find(comparison, "seen")->differs);
        QCOMPARE(find(comparison, "four")->cells[0].state, CellState::Unknown);
        QCOMPARE(find(comparison, "five")->cells[0].state, CellState::Missing);
        QCOMPARE(*find(comparison, "two")->cells[1].raw, 9);
    }

    void oneUnknownDoesNotHideADifference()
    {
        const Snapshot a = table("m", {row("p", 1, 5)});
        const Snapshot b = table("m", {row("p", 1, {})});
        const Snapshot c = table("m", {row("p", 1, 6)});
        const auto comparison = snapshot::compareSnapshots({&a, &b, &c});
        QCOMPARE(find(comparison, "p")->verdict, RowVerdict::Different);
        QCOMPARE(snapshot::compareSnapshots({&a, &b}).rows[0].verdict, RowVerdict::Unknown);
        QCOMPARE(snapshot::compareSnapshots({&b, &b}).rows[0].verdict, RowVerdict::Unknown);
    }

    void otherMapsAreComparedByMeaning()
    {
        const Snapshot a = table(
            "m", {row("v", 1, 80, 0.1, "V"), row("t", 2, 60, 1, "degC"), row("x", 3, 5, 1, "ms")});
        const Snapshot b = table("n", {row("v", 9, 8000, 0.001, "V"), row("t", 8, 61, 1, "degC"),
                                       row("x", 7, 5, 1, "s")});
        const auto comparison = snapshot::compareSnapshots({&a, &b});
        QCOMPARE(find(comparison, "v")->verdict, RowVerdict::Identical);
        QCOMPARE(find(comparison, "t")->verdict, RowVerdict::Different);
        QCOMPARE(find(comparison, "x")->verdict, RowVerdict::Different);
    }

    void decimalDigitsMakeNoDifference()
    {
        Snapshot a = table("m", {row("angle", 1, 2345, 360.0 / 4096, "deg")});
        a.at = QDateTime({2025, 1, 31}, {12, 0, 0}, Qt::UTC);
        const Snapshot b = snapshot::decodeSnapshot(snapshot::encodeSnapshot(a)).value();
        const Snapshot c = table("n", {row("angle", 1, 2345, 360.0 / 4096, "deg")});
        QCOMPARE(snapshot::compareSnapshots({&a, &b}).rows[0].verdict, RowVerdict::Identical);
        QCOMPARE(snapshot::compareSnapshots({&b, &c}).rows[0].verdict, RowVerdict::Identical);
    }

    void aTemplateComparesOnlyItsRows()
    {
        const Snapshot a = table("m", {row("one", 1, 5), row("two", 2, 6)});
        Snapshot b = table("m", {row("two", 2, 6)});
        b.isTemplate = true;
        const auto pair = snapshot::compareSnapshots({&a, &b});
        QCOMPARE(pair.rows.size(), std::size_t(1));
        QCOMPARE(pair.identical, 1);
        const auto three = snapshot::compareSnapshots({&a, &b, &a});
        QCOMPARE(three.rows.size(), std::size_t(2));
        QCOMPARE(find(three, "one")->verdict, RowVerdict::Identical);
        QCOMPARE(find(three, "one")->cells[1].state, CellState::NotChosen);
    }

    void aSingleTableIsShownCompletely()
    {
        const Snapshot a = table("m", {row("one", 1, 5), row("two", 2, {})});
        QCOMPARE(snapshot::compareSnapshots({&a}).rows.size(), std::size_t(2));
        QVERIFY(snapshot::compareSnapshots({}).rows.empty());
    }

    void unknownDefaultsAreUnknown()
    {
        const Snapshot factory = snapshot::factorySnapshot(*sts());
        QVERIFY(!factory.find(utf8("max_voltage"))->raw); // the sheet states none
        QCOMPARE(factory.find(utf8("position_p"))->raw.value(), 32);
        QCOMPARE(factory.find(utf8("max_angle_limit"))->value.value(), 4095 * 360.0 / 4096);
        Snapshot servo = factory;
        for (snapshot::SnapshotRegister& reg : servo.registers) {
            if (reg.key == utf8("max_voltage"))
                reg.raw = 80;
            if (reg.key == utf8("position_p"))
                reg.raw = 40;
        }
        const auto comparison = snapshot::compareSnapshots({&servo, &factory});
        QCOMPARE(comparison.different, 1);
        QCOMPARE(comparison.rows[0].key, utf8("position_p"));
        QCOMPARE(find(comparison, "max_voltage")->verdict, RowVerdict::Unknown);
        QCOMPARE(comparison.missing, 0);
    }

    void everyModelMatchesItsFactoryTable()
    {
        int tables = 0;
        for (const catalog::ModelEntry& model : models().models()) {
            const auto profile = models().profileFor(model, 3, 10);
            if (!profile)
                continue;
            const Snapshot factory = snapshot::factorySnapshot(*profile);
            QCOMPARE(snapshot::compareSnapshots({&factory, &factory}).different, 0);
            ++tables;
        }
        QVERIFY(tables > 20);
    }

    void aFileIdentifiesItsServoType()
    {
        Snapshot snapshot = snapshot::factorySnapshot(*sts());
        snapshot.servo.id = 1;
        QCOMPARE(snapshot::profileOf(snapshot, models())->modelName, utf8("STS3215"));
        snapshot.servo.map = utf8("a map of long ago");
        QVERIFY(!snapshot::profileOf(snapshot, models()));
        snapshot.servo.protocol = utf8("telegraph");
        QVERIFY(!snapshot::profileOf(snapshot, models()));
    }

    void csvHasEveryRowAndItsServo()
    {
        Snapshot a = table("m", {row("b", 2, {}), row("a", 1, -5, 0.5, "deg")});
        a.at = QDateTime({2025, 1, 31}, {12, 0, 0}, Qt::UTC);
        a.label = utf8("left, \"knee\"");
        const QList<QByteArray> lines = snapshot::encodeSnapshotCsv(a).split('\n');
        QCOMPARE(lines.size(), 4);
        QCOMPARE(lines[0], QByteArray("id,model,firmware,map,label,time,key,address,raw,value,unit,"
                                      "area,access"));
        QCOMPARE(lines[1], QByteArray("1,X,3.10,m,\"left, \"\"knee\"\"\",2025-01-31T12:00:00Z,a,1,"
                                      "-5,-2.5,deg,EPROM,rw"));
        QCOMPARE(lines[2], QByteArray("1,X,3.10,m,\"left, \"\"knee\"\"\",2025-01-31T12:00:00Z,b,2,"
                                      ",,,EPROM,rw"));
        a.label = utf8("=1+1"); // a spreadsheet would work it out
        QVERIFY(snapshot::encodeSnapshotCsv(a).contains(",'=1+1,"));
    }
};

SERVODESK_GUILESS_TEST(TestSnapshotCompare)
#include "tst_snapshot_compare.moc"
