// SPDX-License-Identifier: GPL-3.0-or-later
// Newer firmware is hinted at only where it is known for that very kind of servo.
#include "catalog/catalog.h"
#include "support/test_main.h"

#include <QFile>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QTest>

using catalog::Catalog;
using catalog::Identity;

namespace {
struct Case {
    base::Protocol protocol = base::Protocol::Feetech;
    int modelMajor = -1;
    int modelMinor = -1;
    int byteOrder = -1;
    int firmwareMajor = -1;
    int firmwareMinor = -1;
};
} // namespace

class TestFirmwareList : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { QTest::failOnWarning(QRegularExpression(QStringLiteral(".*"))); }

    void newerFirmwareIsReported_data();
    void newerFirmwareIsReported();
    void dateAndSourceAreShown();
    void theOddOnesAreFound();
    void userFilesAreUsed();
    void mistakesSkipTheirRow_data();
    void mistakesSkipTheirRow();
};

void TestFirmwareList::newerFirmwareIsReported_data()
{
    QTest::addColumn<Case>("servo");
    QTest::addColumn<QString>("newer");
    using base::Protocol;
    const auto row = [](const char* name, const Case& servo, const char* newer) {
        QTest::newRow(name) << servo << QString::fromLatin1(newer);
    };
    row("STS3215 3.9", {Protocol::Feetech, 9, 3, 0, 3, 9}, "3.10"); // ten is more than nine
    row("STS3215 3.10", {Protocol::Feetech, 9, 3, 0, 3, 10}, "");
    row("STS3215 newer than known", {Protocol::Feetech, 9, 3, 0, 3, 11}, "");
    row("first of the range", {Protocol::Feetech, 9, 2, 0, 3, 6}, "3.10");
    row("last of the range", {Protocol::Feetech, 9, 11, 0, 3, 6}, "3.10");
    row("before the range", {Protocol::Feetech, 9, 1, 0, 3, 6}, "");
    row("after the range", {Protocol::Feetech, 9, 12, 0, 3, 6}, "");
    row("HTS on HLS firmware", {Protocol::Feetech, 10, 4, 0, 3, 41}, "3.42");
    row("HTS on STS firmware", {Protocol::Feetech, 10, 4, 0, 3, 20}, ""); // another map
    row("HLS3620", {Protocol::Feetech, 10, 12, 0, 3, 42}, "3.43");
    row("SCS15-2", {Protocol::Feetech, 9, 15, 1, 3, 20}, "3.24");
    row("same number, other byte order", {Protocol::Feetech, 9, 15, 0, 3, 6}, "");
    row("SMS", {Protocol::Feetech, 8, 0, 0, 2, 48}, "2.53");
    row("SCS0009", {Protocol::Feetech, 5, 4, 1, 0, 4}, "");
    row("unknown model", {Protocol::Feetech, 99, 1, 0, 3, 6}, "");
    row("Modbus", {Protocol::Modbus, -1, -1, -1, 20, 6}, "20.8");
    row("Modbus, newest", {Protocol::Modbus, -1, -1, -1, 20, 8}, "");
    row("LX tells no version", {Protocol::Lx}, "");
    row("never read", {Protocol::Feetech, 9, 3, 0, -1, -1}, "");
}

void TestFirmwareList::newerFirmwareIsReported()
{
    QFETCH(const Case, servo);
    QFETCH(const QString, newer);
    const Catalog catalog = Catalog::load().catalog;
    const auto profile = catalog.resolve({servo.firmwareMajor, servo.firmwareMinor, servo.byteOrder,
                                          servo.modelMajor, servo.modelMinor, servo.protocol});
    const auto found = catalog.newerFirmware(*profile);
    QCOMPARE(found ? found->version() : QString(), newer);
}

void TestFirmwareList::dateAndSourceAreShown()
{
    const Catalog catalog = Catalog::load().catalog;
    const auto found = catalog.newerFirmware(*catalog.resolve({3, 9, 0, 9, 3}));
    QVERIFY(found.has_value());
    QCOMPARE(found->date, QDate(2025, 3, 6));
    QVERIFY(!found->source.isEmpty());
}

/// Among servos of their model; 3.10 is newer than 3.9.
void TestFirmwareList::theOddOnesAreFound()
{
    const Catalog catalog = Catalog::load().catalog;
    const auto sts3215 = [&](int minor) { return catalog.resolve({3, minor, 0, 9, 3}); };
    const auto other = catalog.resolve({3, 9, 0, 9, 11});
    const auto silent = catalog.resolve({-1, -1, 0, 9, 3});
    using Flags = std::vector<bool>;
    QCOMPARE(catalog::differingFirmware({}), Flags());
    QCOMPARE(catalog::differingFirmware({sts3215(9), other, sts3215(9)}), (Flags{0, 0, 0}));
    QCOMPARE(catalog::differingFirmware({sts3215(9), sts3215(10), sts3215(9), other}),
             (Flags{0, 1, 0, 0}));
    QCOMPARE(catalog::differingFirmware({sts3215(9), sts3215(10)}), (Flags{1, 0}));
    QCOMPARE(catalog::differingFirmware({nullptr, silent, sts3215(10)}), (Flags{0, 0, 0}));
}

void TestFirmwareList::userFilesAreUsed()
{
    const QTemporaryDir folder;
    QFile file(folder.filePath(QStringLiteral("mine.json")));
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write(R"({"firmware": [{"from": "9.3", "to": "9.3", "byte_order": "little",
        "version": "3.12", "date": "2026-10-01", "source": "letter of the vendor"}]})");
    file.close();
    const auto loaded = Catalog::load({folder.path()});
    QVERIFY(loaded.warnings.empty());
    const auto found = loaded.catalog.newerFirmware(*loaded.catalog.resolve({3, 10, 0, 9, 3}));
    QVERIFY(found.has_value());
    QCOMPARE(found->version(), QStringLiteral("3.12"));
}

void TestFirmwareList::mistakesSkipTheirRow_data()
{
    QTest::addColumn<QByteArray>("row");
    QTest::newRow("no models") << QByteArray(
        R"({"byte_order": "little", "version": "3.12", "date": "2026-10-01", "source": "x"})");
    QTest::newRow("backwards") << QByteArray(
        R"({"from": "9.3", "to": "9.2", "byte_order": "little", "version": "3.12",
            "date": "2026-10-01", "source": "x"})");
    QTest::newRow("half a range") << QByteArray(
        R"({"from": "9.3", "byte_order": "little", "version": "3.12", "date": "2026-10-01",
            "source": "x"})");
    QTest::newRow("no version") << QByteArray(
        R"({"from": "9.3", "to": "9.3", "byte_order": "little", "date": "2026-10-01",
            "source": "x"})");
    QTest::newRow("no such day") << QByteArray(
        R"({"from": "9.3", "to": "9.3", "byte_order": "little", "version": "3.12",
            "date": "2026-02-30", "source": "x"})");
    QTest::newRow("typing slip") << QByteArray(
        R"({"from": "9.3", "to": "9.3", "byte_order": "little", "version": "3.12",
            "date": "2026-10-01", "sauce": "x"})");
    QTest::newRow("no object") << QByteArray("7");
}

void TestFirmwareList::mistakesSkipTheirRow()
{
    QFETCH(const QByteArray, row);
    const QTemporaryDir folder;
    QFile file(folder.filePath(QStringLiteral("mine.json")));
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write("{\"firmware\": [" + row + "]}");
    file.close();
    const auto loaded = Catalog::load({folder.path()});
    QCOMPARE(loaded.warnings.size(), std::size_t(1));
    QVERIFY(!loaded.catalog.newerFirmware(*loaded.catalog.resolve({3, 10, 0, 9, 3})));
}

SERVODESK_GUILESS_TEST(TestFirmwareList)
#include "tst_firmware_list.moc"
