// SPDX-License-Identifier: GPL-3.0-or-later
// Maps of servos that speak Modbus or LX: where their registers lie in the flat table, what travels
// together, numbers worked by hand, and what bad rows of such maps cost.
#include "catalog/catalog.h"
#include "catalog/value.h"
#include "support/test_main.h"

#include <QTemporaryDir>
#include <QtTest>

using namespace catalog;
using base::Protocol;

namespace {
const Identity Lx{-1, -1, -1, -1, -1, Protocol::Lx};
const Identity Modbus{20, 8, -1, -1, -1, Protocol::Modbus};
} // namespace

class TestCatalogProtocols : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { QTest::failOnWarning(QRegularExpression(QStringLiteral(".*"))); }
    void protocolDeterminesTheFamily_data();
    void protocolDeterminesTheFamily();
    void feetechNeverGetsOtherMaps();
    void modelsOfTheOtherProtocols();
    void protocolsAt_data();
    void protocolsAt();
    void modbusOffsets();
    void lxOffsetsAndBlocks_data();
    void lxOffsetsAndBlocks();
    void onlyLxHasBlocks();
    void lxFlags();
    void modbusFlags();
    void workedValues_data();
    void workedValues();
    void speedOfModbusFollowsItsMode();
    void currentOfHlsFollowsItsMode();
    void lxVoltageLimits();
    void baudCodesOfModbus();
    void badRowSkipsOnlyThatRow_data();
    void badRowSkipsOnlyThatRow();
    void conflictsOfLxRows_data();
    void conflictsOfLxRows();
    void seriesUsesItsMapsProtocol();

private:
    const Catalog m_catalog = Catalog::load().catalog;
};

void TestCatalogProtocols::protocolDeterminesTheFamily_data()
{
    QTest::addColumn<Identity>("identity");
    QTest::addColumn<QString>("series");
    QTest::addColumn<QString>("map");
    QTest::addColumn<bool>("big");
    QTest::addColumn<int>("readGap");
    const QString modbus = QStringLiteral("SMSMB");
    const QString modbusMap = QStringLiteral("sms-modbus");
    QTest::newRow("LX") << Lx << QStringLiteral("LX") << QStringLiteral("lx") << false << -1;
    QTest::newRow("Modbus") << Modbus << modbus << modbusMap << true << 0;
    // How the version words are split is not documented: no value of theirs may cost the map.
    QTest::newRow("Modbus, one word for both")
        << Identity{2008, 3, -1, -1, -1, Protocol::Modbus} << modbus << modbusMap << true << 0;
    QTest::newRow("Modbus, nothing read")
        << Identity{-1, -1, -1, -1, -1, Protocol::Modbus} << modbus << modbusMap << true << 0;
}

void TestCatalogProtocols::protocolDeterminesTheFamily()
{
    QFETCH(Identity, identity);
    QFETCH(bool, big);
    const ProfilePtr profile = m_catalog.resolve(identity);
    QTEST(profile->series, "series");
    QTEST(profile->modelName, "series");
    QTEST(profile->mapKey, "map");
    QTEST(profile->readGap, "readGap");
    QVERIFY(!profile->modelKnown && profile->writable);
    QCOMPARE(profile->protocol, identity.protocol);
    QCOMPARE(profile->identity, identity);
    QCOMPARE(profile->byteOrder, big ? base::ByteOrder::Big : base::ByteOrder::Little);
    QCOMPARE(*profile->defaultBaud, 115200);
}

void TestCatalogProtocols::feetechNeverGetsOtherMaps()
{
    for (int major = 0; major <= 25; ++major) {
        for (int flag = -1; flag <= 1; ++flag) {
            const ProfilePtr profile = m_catalog.resolve({major, 8, flag, -1, -1});
            QCOMPARE(profile->protocol, Protocol::Feetech);
            QVERIFY(profile->mapKey != QStringLiteral("lx"));
            QVERIFY(profile->mapKey != QStringLiteral("sms-modbus"));
            QCOMPARE(profile->readGap, 8);
            // An unclear family is read in short pieces.
            QCOMPARE(profile->maxRead, profile->conflict ? 36 : 128);
        }
    }
}

void TestCatalogProtocols::modelsOfTheOtherProtocols()
{
    const ModelEntry* lx = m_catalog.model(QStringLiteral("lx224hv"));
    QVERIFY(lx);
    const ProfilePtr profile = m_catalog.profileFor(*lx, 1, 0);
    QCOMPARE(profile->modelName, QStringLiteral("LX-224HV"));
    QVERIFY(profile->modelKnown);
    QCOMPARE(profile->identity, Lx); // an LX servo tells nothing of itself
    QCOMPARE(*profile->minVoltage, 9.0);
    QCOMPARE(*profile->angleRangeDeg, 240.0);
    QCOMPARE(profile->line, Line::Ttl);

    const ModelEntry* modbus = m_catalog.model(QStringLiteral("smsmb"));
    QVERIFY(modbus);
    const ProfilePtr smsmb = m_catalog.profileFor(*modbus, 20, 8);
    QCOMPARE(smsmb->identity, Modbus);
    QCOMPARE(smsmb->maxRead, 58);
    QCOMPARE(smsmb->line, Line::Rs485);
    QCOMPARE(smsmb->centering, Centering::FaultReset4);
    QCOMPARE(*smsmb->mode(QStringLiteral("step"))->operatingMode, 4);
    QCOMPARE(m_catalog.model(QStringLiteral("SM-80BL-MB"))->series, QStringLiteral("SMSMB"));
}

void TestCatalogProtocols::protocolsAt_data()
{
    QTest::addColumn<int>("baud");
    QTest::addColumn<bool>("lx");
    QTest::addColumn<bool>("modbus");
    for (const int baud : {1000000, 500000, 250000, 76800})
        QTest::addRow("%d", baud) << baud << false << false;
    QTest::newRow("115200") << 115200 << true << true;
    for (const int baud : {256000, 128000, 57600, 56000, 38400, 19200, 14400, 9600, 4800})
        QTest::addRow("%d", baud) << baud << false << true;
    QTest::newRow("named by nobody") << 123456 << false << false;
}

void TestCatalogProtocols::protocolsAt()
{
    QFETCH(int, baud);
    QFETCH(bool, lx);
    QFETCH(bool, modbus);
    std::vector<Protocol> expected{Protocol::Feetech};
    if (lx)
        expected.push_back(Protocol::Lx);
    if (modbus)
        expected.push_back(Protocol::Modbus);
    QCOMPARE(m_catalog.protocolsAt(baud), expected);
}

void TestCatalogProtocols::modbusOffsets()
{
    const ProfilePtr profile = m_catalog.resolve(Modbus);
    for (const Register& reg : profile->registers) {
        QCOMPARE(reg.offset, 2 * reg.address);
        QCOMPARE(reg.writeOffset, reg.offset);
        QCOMPARE(reg.size, 2);
    }
    QCOMPARE(profile->find(QStringLiteral("present_position"))->offset, 514);
    QCOMPARE(profile->at(515)->key, QStringLiteral("present_position"));
    QCOMPARE(profile->byRole(Role::FaultReset)->address, 134);
}

void TestCatalogProtocols::lxOffsetsAndBlocks_data()
{
    QTest::addColumn<QString>("key");
    QTest::addColumn<int>("offset");
    QTest::addColumn<int>("writeOffset");
    QTest::addColumn<int>("blockOffset");
    QTest::addColumn<int>("blockSize");
    QTest::addColumn<int>("blockWrite");
    const auto row = [](const char* key, int offset, int write, int block, int size, int to) {
        QTest::newRow(key) << QString::fromLatin1(key) << offset << write << block << size << to;
    };
    row("id", 8 * 14, 8 * 13, 8 * 14, 1, 8 * 13);
    row("angle_offset", 8 * 19, 8 * 17, 8 * 19, 1, 8 * 17);
    row("angle_limit_min", 8 * 21, 8 * 20, 8 * 21, 4, 8 * 20);
    row("angle_limit_max", 8 * 21 + 2, 8 * 20 + 2, 8 * 21, 4, 8 * 20);
    row("vin_limit_max", 8 * 23 + 2, 8 * 22 + 2, 8 * 23, 4, 8 * 22);
    row("mode", 8 * 30, 8 * 29, 8 * 30, 4, 8 * 29); // its second byte has no register
    row("motor_speed", 8 * 30 + 2, 8 * 29 + 2, 8 * 30, 4, 8 * 29);
    row("wait_time", 8 * 8 + 2, 8 * 7 + 2, 8 * 8, 4, 8 * 7);
    row("position", 8 * 28, 8 * 28, 8 * 28, 2, 8 * 28);
}

void TestCatalogProtocols::lxOffsetsAndBlocks()
{
    QFETCH(QString, key);
    QFETCH(int, blockOffset);
    QFETCH(int, blockSize);
    QFETCH(int, blockWrite);
    const ProfilePtr profile = m_catalog.resolve(Lx);
    const Register* reg = profile->find(key);
    QVERIFY(reg);
    QTEST(reg->offset, "offset");
    QTEST(reg->writeOffset, "writeOffset");
    QVERIFY(reg->block);
    QCOMPARE(*reg->block, (Block{blockOffset, blockSize, blockWrite}));
}

void TestCatalogProtocols::onlyLxHasBlocks()
{
    const ProfilePtr lx = m_catalog.resolve(Lx);
    for (const Register& reg : lx->registers) {
        QVERIFY(reg.block);
        const bool saves = reg.key == QStringLiteral("angle_offset");
        QCOMPARE(reg.saveOffset, saves ? 8 * 18 : -1);
        QCOMPARE(reg.persistence == Persistence::AfterSave, saves);
    }
    for (const Identity& identity : {Modbus, Identity{3, 10, 0, 9, 3}}) {
        const ProfilePtr other = m_catalog.resolve(identity);
        for (const Register& reg : other->registers) {
            QVERIFY(!reg.block);
            // No sheet says it of 85 of STS and SMS servos.
            const bool unknown = other->protocol == Protocol::Feetech &&
                                 reg.key == QStringLiteral("acceleration_limit");
            QCOMPARE(reg.persistence, unknown ? Persistence::NotStated : Persistence::ByArea);
            QCOMPARE(reg.writeOffset, reg.offset);
        }
    }
}

void TestCatalogProtocols::lxFlags()
{
    QStringList identity;
    QStringList dangerous;
    QStringList motion;
    const ProfilePtr profile = m_catalog.resolve(Lx);
    for (const Register& reg : profile->registers) {
        if (reg.identity)
            identity << reg.key;
        if (reg.dangerous)
            dangerous << reg.key;
        if (reg.motion)
            motion << reg.key;
    }
    QCOMPARE(identity, QStringList{QStringLiteral("id")});
    QCOMPARE(dangerous, (QStringList{QStringLiteral("id"), QStringLiteral("angle_offset")}));
    const QStringList moving{QStringLiteral("move_angle"),   QStringLiteral("move_time"),
                             QStringLiteral("wait_angle"),   QStringLiteral("wait_time"),
                             QStringLiteral("angle_offset"), QStringLiteral("mode"),
                             QStringLiteral("motor_speed"),  QStringLiteral("load")};
    QCOMPARE(motion, moving);
}

void TestCatalogProtocols::modbusFlags()
{
    const ProfilePtr profile = m_catalog.resolve(Modbus);
    for (const Register& reg : profile->registers) {
        const bool factory = reg.area == Area::Factory;
        QVERIFY(!factory || (reg.writable() && reg.dangerous));
        QCOMPARE(factory, reg.address >= 384);
        QCOMPARE(reg.identity, reg.address == 10 || reg.address == 11);
    }
}

void TestCatalogProtocols::workedValues_data()
{
    QTest::addColumn<Identity>("identity");
    QTest::addColumn<QString>("key");
    QTest::addColumn<int>("raw");
    QTest::addColumn<QByteArray>("wire");
    QTest::addColumn<QString>("text");
    const auto row = [](Identity identity, const char* key, int raw, const char* wire,
                        const char* text) {
        QTest::addRow("%s %d", key, raw) << identity << QString::fromLatin1(key) << raw
                                         << QByteArray::fromHex(wire) << QString::fromUtf8(text);
    };
    // Bytes from the worked frames of the protocol descriptions.
    row(Lx, "angle_offset", -125, "83", "-30.0°");
    row(Lx, "angle_offset", -30, "E2", "-7.2°");
    row(Lx, "move_angle", 500, "F401", "120.0°");
    row(Lx, "move_time", 30000, "3075", "30000 ms");
    row(Lx, "vin_limit_min", 6500, "6419", "6.500 V");
    row(Lx, "vin", 7400, "E81C", "7.400 V");
    row(Lx, "position", -3, "FDFF", "-0.7°");
    row(Lx, "motor_speed", -500, "0CFE", "-500");
    row(Lx, "load", 1, "01", "loaded");
    row(Lx, "led", 1, "01", "off");
    row(Lx, "led", 0, "00", "on");
    row(Lx, "led_error", 7, "07", "temperature + voltage + stall");
    row(Modbus, "goal_position", 2048, "0800", "180.00°");
    row(Modbus, "goal_position", -1000, "FC18", "-87.89°");
    row(Modbus, "present_position", -1, "FFFF", "-0.09°");
    row(Modbus, "position_offset", -2047, "F801", "-179.91°");
    row(Modbus, "acceleration", 10, "000A", "88 °/s²");
    row(Modbus, "goal_speed", 50, "0032", "36.6 rpm");
    row(Modbus, "lock", 128, "0080", "factory block unlocked");
    row(Modbus, "fault_reset", 4, "0004", "set present position to 2048");
    row(Modbus, "servo_status", 0x21, "0021", "voltage + overload");
    row(Modbus, "servo_status", 0x10, "0010", "torque is on");
    const Identity hls{3, 46, 0, 10, 10};
    row(hls, "position_offset", -4095, "FF8F", "-359.91°");
    row(hls, "goal_current", -100, "6480", "-650 mA");
    row(hls, "goal_speed", 100, "6400", "73.2 rpm");
    row({1, 6, 0, 6, 16}, "position_offset", -1, "0108", "-0.09°");
    row({3, 20, 1, 9, 20}, "position_offset", -127, "FF", "-127 step");
    row({3, 20, 1, 9, 20}, "goal_pwm", -200, "04C8", "-20.0 %");
}

void TestCatalogProtocols::workedValues()
{
    QFETCH(Identity, identity);
    QFETCH(QString, key);
    QFETCH(int, raw);
    QFETCH(QByteArray, wire);
    QFETCH(QString, text);
    const ProfilePtr profile = m_catalog.resolve(identity);
    const Register* reg = profile->find(key);
    QVERIFY(reg);
    const ValueFormat meaning = valueFormat(*reg, *profile, noLookup);
    const base::Bytes bytes = encodeRaw(raw, *reg, meaning, profile->byteOrder);
    QCOMPARE(QByteArray(reinterpret_cast<const char*>(bytes.data()), qsizetype(bytes.size())),
             wire);
    QCOMPARE(decodeRaw(bytes, *reg, meaning, profile->byteOrder), raw);
    QCOMPARE(formatValue(raw, *reg, meaning, false), text);
    QCOMPARE(*parseValue(text, *reg, meaning), raw);
}

void TestCatalogProtocols::speedOfModbusFollowsItsMode()
{
    const ProfilePtr profile = m_catalog.resolve(Modbus);
    const Register* speed = profile->byRole(Role::GoalSpeed);
    const auto inMode = [&](int mode) {
        return valueFormat(*speed, *profile, [=](const QString&) { return std::optional(mode); });
    };
    const base::Bytes wire{0xFF, 0xCE};
    QCOMPARE(decodeRaw(wire, *speed, inMode(0), profile->byteOrder), 65486);
    QCOMPARE(decodeRaw(wire, *speed, inMode(1), profile->byteOrder), -50);
    QVERIFY(!checkNewValue(-50, *speed, inMode(0), {}));
    QVERIFY(checkNewValue(-50, *speed, inMode(1), {}));
    QVERIFY(!checkNewValue(1001, *speed, inMode(2), {}));
    QVERIFY(valueFormat(*speed, *profile, noLookup).assumed);
}

void TestCatalogProtocols::currentOfHlsFollowsItsMode()
{
    const ProfilePtr profile = m_catalog.resolve({3, 46, 0, 10, 10});
    const Register* current = profile->byRole(Role::GoalCurrent);
    QVERIFY(current);
    const auto inMode = [&](int mode) {
        return valueFormat(*current, *profile, [=](const QString&) { return std::optional(mode); });
    };
    QCOMPARE(inMode(2).unit, QStringLiteral("mA"));
    QCOMPARE(inMode(3).unit, QStringLiteral("%"));
    QCOMPARE(encodeRaw(-200, *current, inMode(2), profile->byteOrder), (base::Bytes{0xC8, 0x80}));
    QCOMPARE(encodeRaw(-200, *current, inMode(3), profile->byteOrder), (base::Bytes{0xC8, 0x04}));
    QVERIFY(checkNewValue(2047, *current, inMode(0), {}));
    QVERIFY(!checkNewValue(2047, *current, inMode(3), {}));
}

void TestCatalogProtocols::lxVoltageLimits()
{
    const ProfilePtr profile = m_catalog.resolve(Lx);
    const Register* most = profile->byRole(Role::MaxVoltage);
    const ValueFormat meaning = valueFormat(*most, *profile, noLookup);
    QCOMPARE(*parseValue(QStringLiteral("8.4V"), *most, meaning), 8400);
    QVERIFY(checkNewValue(4500, *most, meaning, {}));
    QVERIFY(checkNewValue(14000, *most, meaning, {}));
    QVERIFY(!checkNewValue(4499, *most, meaning, {}));
    QVERIFY(!checkNewValue(14001, *most, meaning, {}));
    QVERIFY(checkNewValue(15000, *most, meaning, 15000)); // what was read is always kept
    QCOMPARE(*most->warnAbove, 12000);
}

void TestCatalogProtocols::baudCodesOfModbus()
{
    const ProfilePtr profile = m_catalog.resolve(Modbus);
    const Register* baud = profile->byRole(Role::BaudRate);
    const ValueFormat meaning = valueFormat(*baud, *profile, noLookup);
    const QList<int> rates{256000, 128000, 115200, 57600, 56000, 38400, 19200, 14400, 9600, 4800};
    for (int code = 0; code < rates.size(); ++code)
        QCOMPARE(*parseValue(QString::number(rates[code]), *baud, meaning), code);
}

namespace {
QByteArray lxRow(const QByteArray& key, const QByteArray& members)
{
    return R"({"key": ")" + key +
           R"(", "area": "SRAM", "encoding": "unsigned", "name": {"en": "Name", "zh": "名称"},
              "help": {"en": "Help", "zh": "帮助"}, )" +
           members + "}";
}

/// A map of one sound row and those given, in a language nobody else of the family speaks.
Catalog::LoadResult loadMap(const QByteArray& protocol, const QByteArray& first,
                            const QByteArray& rows)
{
    QTemporaryDir dir;
    QFile file(dir.filePath(QStringLiteral("bench.json")));
    if (!file.open(QIODevice::WriteOnly))
        return {};
    file.write(R"({"maps": [{"key": "bench", "protocol": ")" + protocol + R"(", "registers": [)" +
               first + ", " + rows +
               R"(]}], "series": [{"key": "BENCH", "map": "bench", "byte_order": "little"}]})");
    file.close();
    return Catalog::load({dir.path()});
}
} // namespace

void TestCatalogProtocols::badRowSkipsOnlyThatRow_data()
{
    QTest::addColumn<QByteArray>("protocol");
    QTest::addColumn<QByteArray>("members");
    QTest::addColumn<QString>("about");
    const auto modbus = [](const char* title, const char* members, const char* about) {
        QTest::newRow(title) << QByteArray("modbus") << QByteArray(members)
                             << QString::fromLatin1(about);
    };
    const auto lx = [](const char* title, const char* members, const char* about) {
        QTest::newRow(title) << QByteArray("lx") << QByteArray(members)
                             << QString::fromLatin1(about);
    };
    modbus("register of one byte", R"("address": 8, "size": 1, "access": "ro")", "size");
    modbus("register of four bytes", R"("address": 8, "size": 4, "access": "ro")", "size");
    modbus("register beyond the table", R"("address": 512, "size": 2, "access": "ro")", "address");
    modbus("register 65535", R"("address": 65535, "size": 2, "access": "ro")", "address");
    modbus("place", R"("address": 8, "size": 2, "access": "ro", "place": 1)", "place");
    modbus("write", R"("address": 8, "size": 2, "access": "rw", "write": 7)", "write");
    modbus("persistence", R"("address": 8, "size": 2, "access": "rw", "persistence": "maybe")",
           "persistence");
    lx("no place", R"("address": 40, "size": 1, "access": "ro")", "place");
    lx("place 0", R"("address": 40, "place": 0, "size": 1, "access": "ro")", "place");
    lx("beyond the parameters", R"("address": 40, "place": 4, "size": 2, "access": "ro")",
       "beyond");
    lx("command 0", R"("address": 0, "place": 1, "size": 1, "access": "ro")", "address");
    lx("command 128", R"("address": 128, "place": 1, "size": 1, "access": "ro")", "address");
    lx("writable without a command", R"("address": 40, "place": 1, "size": 1, "access": "rw")",
       "write");
    lx("read only with a command",
       R"("address": 40, "write": 41, "place": 1, "size": 1, "access": "ro")", "write");
    lx("save without after_save",
       R"("address": 40, "write": 41, "save": 42, "place": 1, "size": 1, "access": "rw")", "save");
    lx("after_save without save", R"("address": 40, "write": 41, "place": 1, "size": 1,
        "access": "rw", "persistence": "after_save")",
       "save");
    lx("rule that changes the command", R"("address": 40, "write": 41, "place": 1, "size": 1,
        "access": "rw", "set": [{"when": {}, "write": 43}])",
       "write");
}

void TestCatalogProtocols::badRowSkipsOnlyThatRow()
{
    QFETCH(QByteArray, protocol);
    QFETCH(QByteArray, members);
    QFETCH(QString, about);
    const QByteArray sound = protocol == "lx"
                                 ? lxRow("sound", R"("address": 100, "place": 1, "size": 1,
                                          "access": "ro")")
                                 : lxRow("sound", R"("address": 100, "size": 2, "access": "ro")");
    const auto loaded = loadMap(protocol, sound, lxRow("bad", members));
    QCOMPARE(loaded.warnings.size(), std::size_t(1));
    QVERIFY2(loaded.warnings.front().detail.contains(about),
             qPrintable(loaded.warnings.front().detail));
    QVERIFY(loaded.warnings.front().where.contains(QStringLiteral("bad")));
    QVERIFY(loaded.catalog.mapKeys().contains(QStringLiteral("bench")));
}

void TestCatalogProtocols::conflictsOfLxRows_data()
{
    QTest::addColumn<QByteArray>("members");
    QTest::addColumn<QString>("about");
    const auto row = [](const char* title, const char* members, const char* about) {
        QTest::newRow(title) << QByteArray(members) << QString::fromLatin1(about);
    };
    row("same place", R"("address": 21, "write": 20, "place": 1, "size": 1, "access": "rw")",
        "belongs");
    row("runs into its neighbour",
        R"("address": 21, "write": 20, "place": 2, "size": 2, "access": "rw")", "belongs");
    row("another write command",
        R"("address": 21, "write": 25, "place": 3, "size": 2, "access": "rw")", "neighbour");
    row("writes what another writes",
        R"("address": 23, "write": 20, "place": 1, "size": 1, "access": "rw")", "belongs");
    row("reads what another writes", R"("address": 20, "place": 2, "size": 1, "access": "ro")",
        "belongs");
    row("fits", R"("address": 21, "write": 20, "place": 3, "size": 2, "access": "rw")", "");
}

void TestCatalogProtocols::conflictsOfLxRows()
{
    QFETCH(QByteArray, members);
    QFETCH(QString, about);
    const auto loaded = loadMap(
        "lx",
        lxRow("first", R"("address": 21, "write": 20, "place": 1, "size": 2, "access": "rw")"),
        lxRow("second", members));
    const ProfilePtr profile = loaded.catalog.resolve(Lx);
    QCOMPARE(profile->mapKey, QStringLiteral("bench"));
    QVERIFY(profile->find(QStringLiteral("first")));
    QCOMPARE(profile->find(QStringLiteral("second")) == nullptr, !about.isEmpty());
    QCOMPARE(loaded.warnings.size(), std::size_t(about.isEmpty() ? 0 : 1));
    if (!about.isEmpty())
        QVERIFY2(loaded.warnings.front().detail.contains(about),
                 qPrintable(loaded.warnings.front().detail));
    // The row that was dropped is not part of the block either.
    QCOMPARE(profile->find(QStringLiteral("first"))->block->size, about.isEmpty() ? 4 : 2);
}

void TestCatalogProtocols::seriesUsesItsMapsProtocol()
{
    // A user's own LX family comes before the built-in one and leaves the Feetech ones alone.
    const auto loaded =
        loadMap("lx", lxRow("a", R"("address": 14, "place": 1, "size": 1, "access": "ro")"),
                lxRow("b", R"("address": 28, "place": 1, "size": 2, "access": "ro")"));
    QVERIFY(loaded.warnings.empty());
    QCOMPARE(loaded.catalog.resolve(Lx)->series, QStringLiteral("BENCH"));
    QCOMPARE(loaded.catalog.resolve({3, 10, 0, 9, 3})->series, QStringLiteral("STS"));
    QCOMPARE(loaded.catalog.resolve(Modbus)->series, QStringLiteral("SMSMB"));

    const auto unknown = loadMap("morse", lxRow("a", R"("address": 1)"), "{}");
    QVERIFY(!unknown.catalog.mapKeys().contains(QStringLiteral("bench")));
    QVERIFY(unknown.warnings.front().detail.contains(QStringLiteral("morse")));
}

SERVODESK_GUILESS_TEST(TestCatalogProtocols)
#include "tst_catalog_protocols.moc"
