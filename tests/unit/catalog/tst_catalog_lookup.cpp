// SPDX-License-Identifier: GPL-3.0-or-later
// Which map, name and limits a servo gets for what its first five bytes say.
#include "catalog/catalog.h"
#include "catalog/value.h"
#include "support/test_main.h"

#include <QtTest>

using namespace catalog;

namespace {
QStringList keysOf(const Register* reg)
{
    QStringList keys;
    for (const NamedValue& value : reg->values)
        keys << value.key;
    return keys;
}

const QStringList FastBauds{QStringLiteral("1000000"), QStringLiteral("500000"),
                            QStringLiteral("250000"),  QStringLiteral("128000"),
                            QStringLiteral("115200"),  QStringLiteral("76800"),
                            QStringLiteral("57600"),   QStringLiteral("38400")};
const QStringList SlowBauds{QStringLiteral("19200"), QStringLiteral("14400"),
                            QStringLiteral("9600"), QStringLiteral("4800")};
} // namespace

class TestCatalogLookup : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init();
    void builtInFilesAreClean();
    void mapByFirmware_data();
    void mapByFirmware();
    void unknownMapIsReadOnly();
    void byteOrderWithoutFlag_data();
    void byteOrderWithoutFlag();
    void modelsByName();
    void everyModelResolvesToItsName();
    void emptyCatalogStillWorks();
    void baudCodes_data();
    void baudCodes();
    void startupForceAndIntegralLimit_data();
    void startupForceAndIntegralLimit();
    void returnDelayOnlyOnSms();
    void torqueSwitchValues_data();
    void torqueSwitchValues();
    void phaseBit5BySeries();
    void hlsByFirmware_data();
    void hlsByFirmware();
    void locksAndFeaturesOfTheOtherMaps();
    void scsReservedRowsAreReadOnly();
    void features();
    void flags();

private:
    const Catalog m_catalog = Catalog::load().catalog;
};

void TestCatalogLookup::init()
{
    QTest::failOnWarning(QRegularExpression(QStringLiteral(".*")));
}

void TestCatalogLookup::builtInFilesAreClean()
{
    const auto loaded = Catalog::load();
    for (const LoadWarning& warning : loaded.warnings)
        qInfo() << warning.file << warning.where << warning.detail;
    QVERIFY(loaded.warnings.empty());
    const QStringList maps{QStringLiteral("hls"),     QStringLiteral("lx"),
                           QStringLiteral("scs"),     QStringLiteral("scs2"),
                           QStringLiteral("smcl"),    QStringLiteral("sms-modbus"),
                           QStringLiteral("sts-sms"), QStringLiteral("unknown")};
    QCOMPARE(loaded.catalog.mapKeys(), maps);
    QVERIFY(loaded.catalog.models().size() > 100);
}

void TestCatalogLookup::mapByFirmware_data()
{
    QTest::addColumn<Identity>("identity");
    QTest::addColumn<QString>("map");
    QTest::addColumn<QString>("series");
    QTest::addColumn<QString>("name");
    QTest::addColumn<bool>("known");

    const auto row = [](const char* title, Identity identity, const char* map, const char* series,
                        const char* name, bool known) {
        QTest::newRow(title) << identity << QString::fromLatin1(map) << QString::fromLatin1(series)
                             << QString::fromLatin1(name) << known;
    };
    row("SCS first", {0, 0, 1, 5, 4}, "scs", "SCS", "SCS0009", true);
    row("SCS last", {0, 39, 1, 5, 15}, "scs", "SCS", "SCS15", true);
    row("SCS beyond", {0, 40, 1, 5, 15}, "unknown", "SCS", "SCS15", true);
    row("SCS firmware, low byte first", {0, 4, 0, 5, 15}, "unclear", "", "? (5.15)", false);
    row("SMCL", {1, 6, 0, 6, 16}, "smcl", "SMCL", "SM100-360M", true);
    row("SMCL older range", {1, 39, 0, 6, 200}, "smcl", "SMCL", "SMCL (6.200)", false);
    row("below SMS", {2, 39, 0, 8, 42}, "unknown", "SMS", "SM45BLHV", true);
    row("SMS first", {2, 40, 0, 8, 42}, "sts-sms", "SMS", "SM45BLHV", true);
    row("SMS last", {2, 69, 0, 8, 30}, "sts-sms", "SMS", "SM30BL", true);
    row("above SMS", {2, 70, 0, 8, 30}, "unknown", "SMS", "SM30BL", true);
    row("STS first", {3, 0, 0, 9, 3}, "sts-sms", "STS", "STS3215", true);
    row("STS last", {3, 39, 0, 9, 11}, "sts-sms", "STS", "STS3250", true);
    row("STS, high byte first", {3, 10, 1, 9, 3}, "unclear", "", "? (9.3)", false);
    row("SCS2 firmware, STS number", {3, 25, 1, 9, 3}, "unclear", "", "? (9.3)", false);
    row("SMCL firmware, SMS number", {1, 6, 0, 8, 42}, "unclear", "", "? (8.42)", false);
    row("SCS2 first", {3, 20, 1, 9, 15}, "scs2", "SCS2", "SCS15-2", true);
    row("SCS2 last", {3, 39, 1, 9, 20}, "scs2", "SCS2", "SCSXX-2", true);
    row("HLS firmware, SCS2 flag and number", {3, 40, 1, 9, 15}, "unclear", "", "? (9.15)", false);
    row("SCS2 number, low byte first", {3, 24, 0, 9, 15}, "unclear", "", "? (9.15)", false);
    row("HLS first", {3, 40, 0, 10, 10}, "hls", "HLS", "HLS3606", true);
    row("HLS without a known model", {3, 46, 0, 10, 200}, "hls", "HLS", "HLS (10.200)", false);
    row("HLS last", {3, 59, 0, 10, 10}, "hls", "HLS", "HLS3606", true);
    row("above HLS", {3, 60, 0, 9, 3}, "unknown", "STS", "STS3215", true);
    row("BL model with STS firmware", {3, 20, 0, 10, 5}, "sts-sms", "STS", "STS3045BL", true);
    row("BL model with HLS firmware", {3, 42, 0, 10, 5}, "hls", "HLS", "STS3045BL", true);
    row("HTS with STS firmware", {3, 24, 0, 10, 7}, "sts-sms", "STS", "HTS3032", true);
    row("no public map", {5, 1, 0, 9, 3}, "unknown", "STS", "STS3215", true);
    row("nothing known", {8, 8, 0, 77, 1}, "unknown", "", "? (77.1)", false);
    row("generic name", {3, 10, 0, 9, 77}, "sts-sms", "STS", "STS (9.77)", false);
    row("named, but unsupported", {3, 10, 0, 11, 1}, "unknown", "other", "SWS3225", true);

    // 1288, 1289 and 1290 as 16-bit numbers each name two models.
    row("1288 high byte first", {0, 4, 1, 5, 8}, "scs", "SCS", "SCS2332", true);
    row("1288 low byte first", {2, 53, 0, 8, 5}, "sts-sms", "SMS", "SM30BL", true);
    row("1289 high byte first", {0, 4, 1, 5, 9}, "scs", "SCS", "SCS0005", true);
    row("1289 low byte first", {3, 10, 0, 9, 5}, "sts-sms", "STS", "STS3020", true);
    row("1290 high byte first", {0, 4, 1, 5, 10}, "scs", "SCS", "SCS0043", true);
    row("1290 low byte first", {3, 20, 0, 10, 5}, "sts-sms", "STS", "STS3045BL", true);

    row("9.1", {3, 10, 0, 9, 1}, "sts-sms", "STS", "STS3015", true);
    row("9.10", {3, 10, 0, 9, 10}, "sts-sms", "STS", "STS3095", true);
}

void TestCatalogLookup::mapByFirmware()
{
    QFETCH(Identity, identity);
    const ProfilePtr profile = m_catalog.resolve(identity);
    QVERIFY(profile);
    QTEST(profile->mapKey, "map");
    QTEST(profile->series, "series");
    QTEST(profile->modelName, "name");
    QTEST(profile->modelKnown, "known");
    const bool unclear = profile->mapKey == QStringLiteral("unclear");
    QCOMPARE(profile->conflict.has_value(), unclear);
    QCOMPARE(profile->writable, !unclear && profile->mapKey != QStringLiteral("unknown"));
    QCOMPARE(profile->identity, identity);
    QCOMPARE(profile->byteOrder,
             identity.byteOrderFlag ? base::ByteOrder::Big : base::ByteOrder::Little);
}

void TestCatalogLookup::unknownMapIsReadOnly()
{
    const ProfilePtr profile = m_catalog.resolve({8, 8, 0, 77, 1});
    for (const Register& reg : profile->registers)
        QVERIFY2(!reg.writable(), qPrintable(reg.key));
    QVERIFY(profile->modes.empty());
    QCOMPARE(profile->centering, Centering::None);
    QVERIFY(!profile->syncRead && !profile->damping && !profile->multiTurn);
    for (const Role role :
         {Role::FirmwareMajor, Role::ModelMinor, Role::PresentPosition, Role::PresentSpeed,
          Role::PresentLoad, Role::PresentVoltage, Role::PresentTemperature, Role::Status,
          Role::Moving, Role::PresentCurrent})
        QVERIFY(profile->byRole(role));
    QVERIFY(!profile->byRole(Role::Lock));
    QVERIFY(!profile->byRole(Role::TorqueSwitch));
    QVERIFY(!profile->byRole(Role::None));
}

void TestCatalogLookup::byteOrderWithoutFlag_data()
{
    QTest::addColumn<Identity>("identity");
    QTest::addColumn<QString>("series");
    QTest::addColumn<bool>("big");
    QTest::newRow("model list, SCS") << Identity{0, 4, -1, 5, 15} << QStringLiteral("SCS") << true;
    QTest::newRow("model list, STS") << Identity{3, 30, -1, 9, 3} << QStringLiteral("STS") << false;
    QTest::newRow("model list, SCS2")
        << Identity{3, 30, -1, 9, 20} << QStringLiteral("SCS2") << true;
    QTest::newRow("firmware alone") << Identity{3, 10, -1, 9, 77} << QStringLiteral("STS") << false;
    QTest::newRow("firmware alone, SCS")
        << Identity{0, 4, -1, 5, 99} << QStringLiteral("SCS") << true;
    QTest::newRow("firmware names two families")
        << Identity{3, 30, -1, 9, 77} << QString() << false;
    QTest::newRow("a flag that is neither")
        << Identity{0, 4, 7, 5, 15} << QStringLiteral("SCS") << true;
    QTest::newRow("nothing read") << Identity{} << QString() << false;
}

void TestCatalogLookup::byteOrderWithoutFlag()
{
    QFETCH(Identity, identity);
    QFETCH(bool, big);
    const ProfilePtr profile = m_catalog.resolve(identity);
    QTEST(profile->series, "series");
    QCOMPARE(profile->byteOrder == base::ByteOrder::Big, big);
}

void TestCatalogLookup::modelsByName()
{
    const ModelEntry* entry = m_catalog.model(QStringLiteral("sts3215"));
    QVERIFY(entry);
    QCOMPARE(entry->name, QStringLiteral("STS3215"));
    QCOMPARE(entry->line, Line::Ttl);
    QCOMPARE(m_catalog.model(QStringLiteral("SM45BLHV"))->line, Line::Rs485);
    QVERIFY(!m_catalog.model(QStringLiteral("STS9999")));
    for (const auto& typed : {QStringLiteral("lx16a"), QStringLiteral("LX 16-A")})
        QCOMPARE(m_catalog.model(typed)->name, QStringLiteral("LX-16A"));
    for (const ModelEntry& model : m_catalog.models())
        QVERIFY2(model.line != Line::Unknown || !model.supported, qPrintable(model.name));

    const ProfilePtr profile = m_catalog.profileFor(*entry, 3, 10);
    QCOMPARE(profile->identity, (Identity{3, 10, 0, 9, 3}));
    QCOMPARE(profile->identity.firmware(), QStringLiteral("3.10"));
    QCOMPARE(profile->identity.modelId(), QStringLiteral("9.3"));
    QCOMPARE(Identity{}.firmware(), QStringLiteral("?"));

    // A model whose number nobody knows still has its name when it is asked for by name.
    const ModelEntry* modelWithoutNumber = m_catalog.model(QStringLiteral("SCS125"));
    QVERIFY(modelWithoutNumber && modelWithoutNumber->major == -1);
    const ProfilePtr scs = m_catalog.profileFor(*modelWithoutNumber, 0, 4);
    QCOMPARE(scs->modelName, QStringLiteral("SCS125"));
    QCOMPARE(scs->mapKey, QStringLiteral("scs"));
    QCOMPARE(*scs->angleRangeDeg, 220.0);
}

void TestCatalogLookup::everyModelResolvesToItsName()
{
    for (const ModelEntry& model : m_catalog.models()) {
        if (model.major < 0)
            continue;
        const int flag = model.byteOrder == base::ByteOrder::Big ? 1 : 0;
        // With the firmware of another family the number would contradict it.
        const auto [major, minor] = model.series == QLatin1String("SCS")    ? std::pair(0, 4)
                                    : model.series == QLatin1String("SMCL") ? std::pair(1, 6)
                                    : model.series == QLatin1String("SMS")  ? std::pair(2, 50)
                                                                            : std::pair(3, 30);
        const ProfilePtr profile =
            m_catalog.resolve({major, minor, flag, model.major, model.minor});
        QCOMPARE(profile->modelName, model.name);
        QVERIFY(model.supported || !profile->writable);
    }
}

void TestCatalogLookup::emptyCatalogStillWorks()
{
    const Catalog empty;
    const ProfilePtr profile = empty.resolve({3, 10, 0, 9, 3});
    QVERIFY(profile);
    QVERIFY(!profile->writable);
    QVERIFY(profile->registers.empty());
    const ProfilePtr lx = empty.resolve({-1, -1, -1, -1, -1, base::Protocol::Lx});
    QVERIFY(lx->registers.empty() && !lx->writable);
    QCOMPARE(empty.protocolsAt(115200), std::vector{base::Protocol::Feetech});
}

void TestCatalogLookup::baudCodes_data()
{
    QTest::addColumn<Identity>("identity");
    QTest::addColumn<bool>("slow");
    QTest::addColumn<int>("factory");
    QTest::newRow("STS") << Identity{3, 10, 0, 9, 3} << false << 0;
    QTest::newRow("SMS 2.45") << Identity{2, 45, 0, 8, 42} << false << 4;
    QTest::newRow("SMS 2.46") << Identity{2, 46, 0, 8, 42} << true << 4;
    QTest::newRow("SCS") << Identity{0, 4, 1, 5, 15} << false << 0;
    QTest::newRow("HLS") << Identity{3, 43, 0, 10, 10} << false << 0;
    QTest::newRow("SMCL") << Identity{1, 6, 0, 6, 16} << false << 4;
}

void TestCatalogLookup::baudCodes()
{
    QFETCH(Identity, identity);
    QFETCH(bool, slow);
    QFETCH(int, factory);
    const ProfilePtr profile = m_catalog.resolve(identity);
    const Register* reg = profile->byRole(Role::BaudRate);
    QCOMPARE(keysOf(reg), slow ? FastBauds + SlowBauds : FastBauds);
    QCOMPARE(*reg->max, slow ? 11 : 7);
    QCOMPARE(*reg->defaultRaw, factory);
    const ValueFormat meaning = valueFormat(*reg, *profile, noLookup);
    QCOMPARE(checkNewValue(8, *reg, meaning, std::nullopt).has_value(), slow);
    QVERIFY(checkNewValue(7, *reg, meaning, std::nullopt).has_value());
    QVERIFY(!checkNewValue(12, *reg, meaning, std::nullopt).has_value());
    QCOMPARE(*profile->defaultBaud, factory == 4 ? 115200 : 1000000);
}

void TestCatalogLookup::startupForceAndIntegralLimit_data()
{
    QTest::addColumn<Identity>("identity");
    QTest::addColumn<int>("size");
    QTest::addColumn<int>("max");
    QTest::addColumn<bool>("integralLimit");
    QTest::newRow("STS") << Identity{3, 10, 0, 9, 3} << 1 << 254 << true;
    QTest::newRow("SMS 2.48") << Identity{2, 48, 0, 8, 42} << 2 << 1000 << false;
    QTest::newRow("SMS 2.49") << Identity{2, 49, 0, 8, 42} << 1 << 254 << true;
    QTest::newRow("SCS") << Identity{0, 4, 1, 5, 15} << 2 << 1000 << false;
}

void TestCatalogLookup::startupForceAndIntegralLimit()
{
    QFETCH(Identity, identity);
    QFETCH(int, max);
    QFETCH(bool, integralLimit);
    const ProfilePtr profile = m_catalog.resolve(identity);
    const Register* force = profile->find(QStringLiteral("min_startup_force"));
    QVERIFY(force);
    QTEST(force->size, "size");
    QCOMPARE(*force->max, max);
    QCOMPARE(profile->find(QStringLiteral("integral_limit")) != nullptr, integralLimit);
    const Register* at25 = profile->at(25);
    QVERIFY(at25);
    QCOMPARE(at25->key, integralLimit ? QStringLiteral("integral_limit")
                                      : QStringLiteral("min_startup_force"));
}

void TestCatalogLookup::returnDelayOnlyOnSms()
{
    const ProfilePtr smsProfile = m_catalog.resolve({2, 53, 0, 8, 42});
    const Register* sms = smsProfile->find(QStringLiteral("return_delay"));
    QVERIFY(sms->writable());
    QCOMPARE(sms->role, Role::ReturnDelay);
    QCOMPARE(sms->unit, QStringLiteral("us"));
    QCOMPARE(sms->scale, 2.0);

    const ProfilePtr profile = m_catalog.resolve({3, 10, 0, 9, 3});
    const Register* sts = profile->find(QStringLiteral("return_delay"));
    QVERIFY(sts->writable()); // stored, without a function
    QVERIFY(!profile->byRole(Role::ReturnDelay));
    QVERIFY(sts->help.en.contains(QStringLiteral("no known function")));
    QVERIFY(sts->help.zh.contains(QStringLiteral("预留")));
}

void TestCatalogLookup::torqueSwitchValues_data()
{
    QTest::addColumn<Identity>("identity");
    QTest::addColumn<QStringList>("keys");
    const QString off = QStringLiteral("off");
    const QString on = QStringLiteral("on");
    const QString damp = QStringLiteral("damp");
    const QString center = QStringLiteral("center");
    QTest::newRow("STS") << Identity{3, 10, 0, 9, 3} << QStringList{off, on, damp, center};
    QTest::newRow("SMS") << Identity{2, 53, 0, 8, 42} << QStringList{off, on, center};
    QTest::newRow("SCS") << Identity{0, 4, 1, 5, 15} << QStringList{off, on, damp};
    QTest::newRow("HLS") << Identity{3, 43, 0, 10, 10} << QStringList{off, on, damp};
    QTest::newRow("SMCL") << Identity{1, 6, 0, 6, 16} << QStringList{off, on};
    QTest::newRow("SCS2") << Identity{3, 20, 1, 9, 15} << QStringList{off, on, damp};
    QTest::newRow("Modbus") << Identity{20, 8, -1, -1, -1, base::Protocol::Modbus}
                            << QStringList{off, on};
    QTest::newRow("LX") << Identity{-1, -1, -1, -1, -1, base::Protocol::Lx} << QStringList{off, on};
}

void TestCatalogLookup::torqueSwitchValues()
{
    QFETCH(Identity, identity);
    const ProfilePtr profile = m_catalog.resolve(identity);
    QTEST(keysOf(profile->byRole(Role::TorqueSwitch)), "keys");
    QCOMPARE(profile->damping,
             keysOf(profile->byRole(Role::TorqueSwitch)).contains(QStringLiteral("damp")));
}

void TestCatalogLookup::phaseBit5BySeries()
{
    const auto hasKey = [this](Identity identity, const char* key) {
        return keysOf(m_catalog.resolve(identity)->byRole(Role::Phase))
            .contains(QLatin1String(key));
    };
    QVERIFY(hasKey({3, 10, 0, 9, 3}, "integrated_bridge"));
    QVERIFY(hasKey({2, 53, 0, 8, 42}, "voltage_divider"));
    QVERIFY(!hasKey({2, 53, 0, 8, 42}, "integrated_bridge"));
}

void TestCatalogLookup::hlsByFirmware_data()
{
    QTest::addColumn<int>("minor");
    QTest::addColumn<QString>("bit0");
    QTest::addColumn<bool>("speedDirection");
    QTest::addColumn<bool>("calibrates");
    const QString encoder = QStringLiteral("encoder_mt6701");
    QTest::newRow("3.40") << 40 << QStringLiteral("servo_phase") << true << false;
    QTest::newRow("3.41") << 41 << QStringLiteral("servo_phase") << true << false;
    QTest::newRow("3.42") << 42 << QString() << false << false;
    QTest::newRow("3.43") << 43 << QString() << false << true;
    QTest::newRow("3.44") << 44 << encoder << false << true;
    QTest::newRow("3.59") << 59 << encoder << false << true;
}

void TestCatalogLookup::hlsByFirmware()
{
    QFETCH(int, minor);
    QFETCH(QString, bit0);
    QFETCH(bool, speedDirection);
    QFETCH(bool, calibrates);
    const ProfilePtr profile = m_catalog.resolve({3, minor, 0, 10, 10});
    QCOMPARE(profile->mapKey, QStringLiteral("hls"));
    const QStringList bits = keysOf(profile->byRole(Role::Phase));
    QCOMPARE(bits.contains(QStringLiteral("servo_phase")) ||
                 bits.contains(QStringLiteral("encoder_mt6701")),
             !bit0.isEmpty());
    QVERIFY(bit0.isEmpty() || bits.contains(bit0));
    QCOMPARE(bits.contains(QStringLiteral("speed_direction")), speedDirection);
    QVERIFY(!bits.contains(QStringLiteral("fine_speed")));
    QCOMPARE(profile->centering, calibrates ? Centering::Instruction0B : Centering::None);
}

void TestCatalogLookup::locksAndFeaturesOfTheOtherMaps()
{
    const ProfilePtr hls = m_catalog.resolve({3, 43, 0, 10, 10});
    QCOMPARE(hls->byRole(Role::Lock)->address, 55);
    QVERIFY(hls->syncRead && hls->damping && hls->multiTurn);
    QCOMPARE(hls->line, Line::Ttl);
    QCOMPARE(hls->byRole(hls->mode(QStringLiteral("current"))->command)->address, 44);
    QCOMPARE(hls->byRole(hls->mode(QStringLiteral("pwm"))->command)->address, 44);
    QCOMPARE(*hls->mode(QStringLiteral("position-pd"))->operatingMode, 4);
    // Without an overload bit there is nothing an overload could clear.
    QVERIFY(!keysOf(hls->byRole(Role::Status)).contains(QStringLiteral("overload")));

    const ProfilePtr smcl = m_catalog.resolve({1, 6, 0, 6, 16});
    const ProfilePtr scs2 = m_catalog.resolve({3, 20, 1, 9, 15});
    for (const ProfilePtr& profile : {smcl, scs2}) {
        QCOMPARE(profile->byRole(Role::Lock)->address, 48);
        QVERIFY(!profile->syncRead);
        QVERIFY(!profile->byRole(Role::TorqueLimit));
        QCOMPARE(profile->centering, Centering::None);
        QVERIFY(!profile->find(QStringLiteral("phase"))->writable());
    }
    QCOMPARE(smcl->line, Line::Rs485);
    QCOMPARE(smcl->byRole(Role::PositionOffset)->address, 33);
    QCOMPARE(smcl->byRole(Role::OperatingMode)->address, 35);
    QVERIFY(!smcl->mode(QStringLiteral("step")));
    QCOMPARE(scs2->line, Line::Ttl);
    QCOMPARE(scs2->byteOrder, base::ByteOrder::Big);
    QCOMPARE(scs2->byRole(scs2->mode(QStringLiteral("motor"))->command)->address, 44);
}

void TestCatalogLookup::scsReservedRowsAreReadOnly()
{
    const ProfilePtr profile = m_catalog.resolve({0, 4, 1, 5, 15});
    for (const int address : {7, 23}) {
        const Register* reg = profile->at(address);
        QVERIFY(reg);
        QVERIFY2(!reg->writable(), qPrintable(reg->key));
        QVERIFY(reg->help.en.contains(QStringLiteral("cannot be edited")));
    }
    QVERIFY(!profile->byRole(Role::PositionI));
    QVERIFY(!profile->byRole(Role::TorqueLimit));
    QCOMPARE(profile->byRole(Role::Lock)->address, 48);
}

void TestCatalogLookup::features()
{
    const ProfilePtr sts = m_catalog.resolve({3, 10, 0, 9, 11});
    QCOMPARE(sts->line, Line::Ttl);
    QVERIFY(sts->syncRead && sts->damping && sts->multiTurn);
    QCOMPARE(sts->centering, Centering::Write128);
    QCOMPARE(*sts->minVoltage, 9.0);
    QCOMPARE(*sts->maxVoltage, 12.6);
    QCOMPARE(sts->currentSensing, CurrentSensing::UnlessPhaseBit5);
    QCOMPARE(sts->byRole(Role::Lock)->address, 55);

    const ProfilePtr sms = m_catalog.resolve({2, 53, 0, 8, 42});
    QCOMPARE(sms->line, Line::Rs485);
    QVERIFY(sms->syncRead && !sms->damping && sms->multiTurn);
    for (const ProfilePtr& profile : {sts, sms}) {
        QCOMPARE(profile->modes.size(), std::size_t(5));
        QCOMPARE(*profile->mode(QStringLiteral("position"))->operatingMode, 0);
        QVERIFY(!profile->mode(QStringLiteral("position"))->limitsZero);
        QCOMPARE(*profile->mode(QStringLiteral("multiturn"))->operatingMode, 0);
        QVERIFY(profile->mode(QStringLiteral("multiturn"))->limitsZero);
        QCOMPARE(profile->mode(QStringLiteral("speed"))->command, Role::GoalSpeed);
        QCOMPARE(profile->mode(QStringLiteral("pwm"))->command, Role::GoalPwm);
        QCOMPARE(*profile->mode(QStringLiteral("step"))->operatingMode, 3);
        QVERIFY(profile->mode(QStringLiteral("step"))->limitsZero);
        QVERIFY(!profile->mode(QStringLiteral("motor")));
    }

    const ProfilePtr scs = m_catalog.resolve({0, 4, 1, 5, 15});
    QCOMPARE(scs->line, Line::Ttl);
    QVERIFY(!scs->syncRead && scs->damping && !scs->multiTurn);
    QCOMPARE(scs->centering, Centering::None);
    QCOMPARE(scs->currentSensing, CurrentSensing::No);
    QCOMPARE(scs->modes.size(), std::size_t(2));
    QVERIFY(!scs->mode(QStringLiteral("motor"))->operatingMode);
    QVERIFY(scs->mode(QStringLiteral("motor"))->limitsZero);
    QVERIFY(scs->byRole(scs->mode(QStringLiteral("motor"))->command));
    QCOMPARE(scs->byRole(scs->mode(QStringLiteral("motor"))->command)->address, 44);
}

void TestCatalogLookup::flags()
{
    const auto addresses = [](const ProfilePtr& profile, auto&& predicate) {
        QList<int> found;
        for (const Register& reg : profile->registers) {
            if (predicate(reg))
                found << reg.address;
        }
        return found;
    };
    const auto dangerous = [](const Register& reg) { return reg.dangerous; };
    const auto motion = [](const Register& reg) { return reg.motion; };
    const auto torqueOff = [](const Register& reg) { return reg.torqueOff == TorqueOff::Needed; };
    const auto bothZero = [](const Register& reg) {
        return reg.torqueOff == TorqueOff::WhenBothZero;
    };
    const auto identity = [](const Register& reg) { return reg.identity; };

    const ProfilePtr sms = m_catalog.resolve({2, 53, 0, 8, 42});
    QCOMPARE(addresses(sms, identity), (QList<int>{5, 6}));
    QCOMPARE(addresses(sms, dangerous), (QList<int>{5, 6, 7, 8, 18, 19, 30, 31, 33, 85}));
    QCOMPARE(addresses(sms, motion), (QList<int>{40, 42, 44, 46}));
    QCOMPARE(addresses(sms, torqueOff), (QList<int>{18, 30, 31, 33}));
    QCOMPARE(addresses(sms, bothZero), (QList<int>{9, 11}));

    const ProfilePtr scs = m_catalog.resolve({0, 4, 1, 5, 15});
    QCOMPARE(addresses(scs, identity), (QList<int>{5, 6}));
    QCOMPARE(addresses(scs, dangerous), (QList<int>{5, 6, 8, 18, 19}));
    QCOMPARE(addresses(scs, motion), (QList<int>{40, 42, 44, 46}));
    QCOMPARE(addresses(scs, torqueOff), (QList<int>{18}));
    QCOMPARE(addresses(scs, bothZero), (QList<int>{9, 11}));
}

SERVODESK_GUILESS_TEST(TestCatalogLookup)
#include "tst_catalog_lookup.moc"
