// SPDX-License-Identifier: GPL-3.0-or-later
// Bundles, templates and results of restores as files: what was saved comes back, and whatever
// somebody made of a file is named with its place.
#include "catalog/catalog.h"
#include "snapshot/bundle.h"
#include "snapshot/restore_result.h"
#include "snapshot/snapshot_template.h"
#include "support/test_main.h"
#include "support/text.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QTemporaryDir>
#include <QtTest>

using base::ErrorCode;
using snapshot::Bundle;
using snapshot::Snapshot;
using support::utf8;

namespace {
Snapshot servoSnapshot(int id)
{
    using catalog::Access;
    using catalog::Area;
    Snapshot one;
    one.program = utf8("ServoDesk 0.1.0");
    one.at = QDateTime({2025, 1, 31}, {12, 34, 56}, Qt::UTC);
    one.label = utf8("关节 %1").arg(id);
    one.note = utf8("two\nlines {\"raw\": 1, \"raw\": 2}");
    one.port = utf8("/dev/ttyUSB0");
    one.baud = 1000000;
    one.servo = {id, utf8("STS3215"), utf8("9.3"), utf8("3.10"), utf8("sts-sms"), utf8("feetech")};
    one.registers = {
        {utf8("firmware_major"), 0, 3, 3.0, {}, Area::Eprom, Access::ReadOnly},
        {utf8("id"), 5, id, double(id), {}, Area::Eprom, Access::ReadWrite},
        {utf8("position_p"), 21, 32, 32.0, {}, Area::Eprom, Access::ReadWrite},
        {utf8("position_d"), 22, {}, {}, {}, Area::Eprom, Access::ReadWrite},
    };
    return one;
}

Bundle bundle()
{
    Bundle all;
    all.program = utf8("ServoDesk 0.1.0");
    all.at = QDateTime({2025, 1, 31}, {12, 34, 56}, Qt::UTC);
    all.label = utf8("left arm");
    all.port = utf8("/dev/ttyUSB0");
    all.servos = {servoSnapshot(1), servoSnapshot(2), servoSnapshot(7)};
    return all;
}
} // namespace

class TestBundle : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { QTest::failOnWarning(QRegularExpression(utf8(".*"))); }

    void saveAndLoadRoundTrip()
    {
        const QTemporaryDir folder;
        const QString path = folder.filePath(utf8("arm.bundle.json"));
        QVERIFY(snapshot::saveBundle(bundle(), path));
        QCOMPARE(snapshot::loadBundle(path).value(), bundle());
    }

    void theTextIsStableWithOneRegisterPerLine()
    {
        Bundle shuffled = bundle();
        std::reverse(shuffled.servos.begin(), shuffled.servos.end());
        QCOMPARE(snapshot::encodeBundle(shuffled), snapshot::encodeBundle(bundle()));
        for (const QByteArray& line : snapshot::encodeBundle(bundle()).split('\n'))
            QVERIFY(line.count("\"key\"") <= 1);
    }

    void corruptBundlesAreRefusedWithThePosition_data()
    {
        QTest::addColumn<QByteArray>("old");
        QTest::addColumn<QByteArray>("changed");
        QTest::addColumn<QString>("place");
        const auto row = [](const char* name, const char* old, const char* changed,
                            const char* place) {
            QTest::newRow(name) << QByteArray(old) << QByteArray(changed) << utf8(place);
        };
        row("a snapshot instead", "servodesk-bundle", "servodesk-snapshot",
            "format: not a ServoDesk bundle");
        row("of a newer program", "\"version\": 1", "\"version\": 9",
            "version: format 9 is of a newer");
        row("a servo of a newer program", "\"servodesk-snapshot\",\n      \"version\": 1",
            "\"servodesk-snapshot\",\n      \"version\": 2", "servos[0].version: ");
        row("an ID twice", "\"id\": 2,", "\"id\": 1,", "servos[1].servo: ID 1 is there twice");
        row("a name twice", "\"raw\": 32,", "\"raw\": 32, \"raw\": 99,", "line ");
        row("the same name with an escape", "\"raw\": 32,", "\"raw\": 32, \"r\\u0061w\": 99,",
            "line ");
        row("servos a number", "\"servos\": [", "\"servos\": 5, \"x\": [", "servos: ");
        row("not UTF-8", "关节", "\xff\xfe", "line ");
    }
    void corruptBundlesAreRefusedWithThePosition()
    {
        QFETCH(const QByteArray, old);
        QFETCH(const QByteArray, changed);
        QFETCH(const QString, place);
        QByteArray content = snapshot::encodeBundle(bundle());
        const auto at = content.indexOf(old);
        QVERIFY(at >= 0);
        const auto loaded = snapshot::decodeBundle(content.replace(at, old.size(), changed));
        QVERIFY(!loaded);
        QCOMPARE(int(loaded.error().code), int(ErrorCode::FileFormat));
        QVERIFY2(loaded.error().detail.startsWith(place), qPrintable(loaded.error().detail));
    }

    void aTruncatedBundleIsRefused()
    {
        const QByteArray content = snapshot::encodeBundle(bundle()).trimmed();
        for (qsizetype length = 0; length < content.size(); ++length)
            QVERIFY(!snapshot::decodeBundle(content.left(length)));
    }

    void aDuplicateNameInASnapshotIsReported()
    {
        const QByteArray content = snapshot::encodeSnapshot(servoSnapshot(1));
        QVERIFY(snapshot::decodeSnapshot(content)); // the note only looks like it
        QByteArray twice = content;
        twice.replace("\"baud\": 1000000", "\"baud\": 1000000,\n  \"baud\": 500000");
        const auto loaded = snapshot::decodeSnapshot(twice);
        QVERIFY(!loaded);
        QCOMPARE(loaded.error().detail, utf8("line 10: \"baud\" is there twice"));
    }

    void aTemplateHasTheSelectedRowsOnly()
    {
        const auto chosen =
            snapshot::makeTemplate(servoSnapshot(3), {utf8("position_p"), utf8("position_p")});
        QVERIFY(chosen);
        QVERIFY(chosen->isTemplate);
        QCOMPARE(chosen->registers.size(), std::size_t(1));
        const auto loaded = snapshot::decodeSnapshot(snapshot::encodeSnapshot(*chosen));
        QCOMPARE(loaded.value(), *chosen);
        QVERIFY(!snapshot::encodeSnapshot(servoSnapshot(3)).contains("template"));
    }

    void aTemplateRefusesConflicts_data()
    {
        QTest::addColumn<QString>("key");
        QTest::addColumn<int>("code");
        QTest::addColumn<QString>("detail");
        QTest::addColumn<int>("reason");
        QTest::newRow("identity") << utf8("id") << int(ErrorCode::BadArgument) << utf8("identity")
                                  << int(base::Reason::IdentityRegister);
        QTest::newRow("read-only") << utf8("firmware_major") << int(ErrorCode::BadArgument)
                                   << utf8("read-only") << int(base::Reason::ReadOnlyRegister);
        QTest::newRow("no value") << utf8("position_d") << int(ErrorCode::BadArgument)
                                  << utf8("no-value") << int(base::Reason::NoValue);
        QTest::newRow("unknown") << utf8("mood") << int(ErrorCode::UnknownRegister) << QString()
                                 << int(base::Reason::None);
    }
    void aTemplateRefusesConflicts()
    {
        QFETCH(const QString, key);
        QFETCH(const int, code);
        QFETCH(const QString, detail);
        QFETCH(const int, reason);
        const auto refused = snapshot::makeTemplate(servoSnapshot(3), {utf8("position_p"), key});
        QVERIFY(!refused);
        QCOMPARE(int(refused.error().code), code);
        QCOMPARE(refused.error().registerKey, key);
        QCOMPARE(refused.error().detail, detail);
        QCOMPARE(int(refused.error().reason), reason);
        QVERIFY(snapshot::makeTemplate(servoSnapshot(3), {utf8("id")}, true));
        QVERIFY(!snapshot::makeTemplate(servoSnapshot(3), {}));
    }

    void identityKeysMatchTheMaps()
    {
        const auto loaded = catalog::Catalog::load();
        for (const catalog::ModelEntry& model : loaded.catalog.models()) {
            const auto profile = loaded.catalog.profileFor(model, 3, 10);
            for (const catalog::Register& reg : profile->registers)
                QVERIFY2(snapshot::isIdentityKey(reg.key) == reg.identity, qPrintable(reg.key));
        }
    }

    void aResultIsSavedAsJsonAndCsv()
    {
        snapshot::RestoreResult result;
        result.program = utf8("p");
        result.at = QDateTime({2025, 1, 31}, {12, 0, 0}, Qt::UTC);
        result.source = utf8("knee.servo.json");
        result.servo = servoSnapshot(4).servo;
        result.verdict = utf8("failed");
        result.lock = utf8("closed");
        result.rows = {
            {utf8("position_p"), 21, 40, 32, 40, {}, 32.0, utf8("refused"), utf8("refused"), true}};
        snapshot::RestoreResult silent;
        silent.servo.id = 9;
        silent.verdict = utf8("no-answer");
        const QTemporaryDir folder;
        const QString json = folder.filePath(utf8("r.json"));
        const QString csv = folder.filePath(utf8("r.CSV"));
        QVERIFY(snapshot::saveRestoreResults({result, silent}, json));
        QVERIFY(snapshot::saveRestoreResults({result, silent}, csv));
        QFile file(json);
        QVERIFY(file.open(QIODevice::ReadOnly));
        const QJsonArray servos =
            QJsonDocument::fromJson(file.readAll()).object()[utf8("servos")].toArray();
        QCOMPARE(servos.size(), 2);
        const QJsonObject row = servos[0][utf8("rows")].toArray().at(0).toObject();
        QCOMPARE(row[utf8("before")].toInt(), 40);
        QCOMPARE(row[utf8("outcome")].toString(), utf8("refused"));
        QCOMPARE(row[utf8("rolled_back")].toBool(), true);
        QFile table(csv);
        QVERIFY(table.open(QIODevice::ReadOnly));
        const QList<QByteArray> lines = table.readAll().trimmed().split('\n');
        QCOMPARE(lines.size(), 3);
        QVERIFY(lines[1].startsWith("4,STS3215,3.10,2025-01-31T12:00:00Z,knee.servo.json,failed,"
                                    "closed,position_p,21,40,32,32,,40,refused,refused,1"));
        QCOMPARE(lines[2].count(','), lines[0].count(','));
        QVERIFY(lines[2].startsWith("9,"));
        QVERIFY(lines[0].startsWith("id,"));
        table.close();
        QVERIFY(snapshot::saveRestoreResults({result}, csv, files::CsvReader::Spreadsheet));
        QVERIFY(table.open(QIODevice::ReadOnly));
        QVERIFY(table.readAll().startsWith("\xEF\xBB\xBFid,"));
    }
};

SERVODESK_GUILESS_TEST(TestBundle)
#include "tst_bundle.moc"
