// SPDX-License-Identifier: GPL-3.0-or-later
// Worked wire examples of the sign codings, meanings chosen by other registers, and what may be
// written.
#include "catalog/catalog.h"
#include "catalog/value.h"
#include "support/test_main.h"
#include "unit/catalog/identities.h"

#include <QtTest>

#include <cmath>

using namespace catalog;

namespace {
Lookup lookupIn(QMap<QString, std::int64_t> values)
{
    return [values](const QString& key) {
        return values.contains(key) ? std::optional(values.value(key)) : std::nullopt;
    };
}

Register plain(int size, Encoding encoding, int signBit = 0)
{
    Register reg;
    reg.key = QStringLiteral("test");
    reg.size = size;
    reg.encoding = encoding;
    reg.signBit = signBit;
    reg.access = Access::ReadWrite;
    return reg;
}
} // namespace

class TestCatalogValue : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init();
    void wire_data();
    void wire();
    void negativeZeroIsZero_data();
    void negativeZeroIsZero();
    void encodingSaturates();
    void speedUnit_data();
    void speedUnit();
    void scsTimeOrPwm_data();
    void scsTimeOrPwm();
    void angleResolutionScalesTheGoalOnly();
    void scsDegreesWhereTheRangeIsKnown();
    void newValues_data();
    void newValues();
    void refusalsStateTheExpectedRange();

private:
    struct KnownRegister {
        ProfilePtr profile;
        const Register* reg;
        ValueFormat meaning;
    };
    KnownRegister known(const Identity& identity, const char* key,
                        const Lookup& lookup = noLookup) const
    {
        const ProfilePtr profile = m_catalog.resolve(identity);
        const Register* reg = profile->find(QLatin1String(key));
        return {profile, reg, valueFormat(*reg, *profile, lookup)};
    }
    const Catalog m_catalog = Catalog::load().catalog;
};

void TestCatalogValue::init()
{
    QTest::failOnWarning(QRegularExpression(QStringLiteral(".*")));
}

void TestCatalogValue::wire_data()
{
    QTest::addColumn<Register>("reg");
    QTest::addColumn<bool>("big");
    QTest::addColumn<base::Bytes>("bytes");
    QTest::addColumn<qint64>("raw");

    const Register sign15 = plain(2, Encoding::SignBit, 15);
    const Register sign10 = plain(2, Encoding::SignBit, 10);
    const Register offset = plain(2, Encoding::SignBit11Ext12);
    const Register u16 = plain(2, Encoding::Unsigned);
    const auto row = [](const char* title, const Register& reg, bool big, base::Bytes bytes,
                        qint64 raw) { QTest::newRow(title) << reg << big << bytes << raw; };
    row("position -1000, STS", sign15, false, {0xE8, 0x83}, -1000);
    row("position 1304, STS", u16, false, {0x18, 0x05}, 1304);
    row("position 2048, STS", sign15, false, {0x00, 0x08}, 2048);
    row("speed 2400, STS", sign15, false, {0x60, 0x09}, 2400);
    row("PWM -200, STS", sign10, false, {0xC8, 0x04}, -200);
    row("PWM -200, SCS", sign10, true, {0x04, 0xC8}, -200);
    row("position 512, SCS", u16, true, {0x02, 0x00}, 512);
    row("time 1000, SCS", u16, true, {0x03, 0xE8}, 1000);
    row("largest sign-bit-15", sign15, false, {0xFF, 0x7F}, 32767);
    row("smallest sign-bit-15", sign15, false, {0xFF, 0xFF}, -32767);
    row("offset 2047", offset, false, {0xFF, 0x07}, 2047);
    row("offset -1", offset, false, {0x01, 0x08}, -1);
    row("offset -2047", offset, false, {0xFF, 0x0F}, -2047);
    row("offset 2048, 13 bits", offset, false, {0x00, 0x10}, 2048);
    row("offset 4095, 13 bits", offset, false, {0xFF, 0x17}, 4095);
    row("offset -2048, 13 bits", offset, false, {0x00, 0x18}, -2048);
    row("offset -4095, 13 bits", offset, false, {0xFF, 0x1F}, -4095);
    row("offset -2047, 12 bits", plain(2, Encoding::SignBit, 11), false, {0xFF, 0x0F}, -2047);
    row("sign bit in one byte", plain(1, Encoding::SignBit, 7), false, {0x85}, -5);
    row("two's complement byte", plain(1, Encoding::TwosComplement), false, {0xFF}, -1);
    row("two's complement word", plain(2, Encoding::TwosComplement), true, {0x80, 0x00}, -32768);
    row("bits", plain(1, Encoding::Bits), false, {0xE1}, 0xE1);
    row("three bytes", plain(3, Encoding::Unsigned), false, {0x01, 0x02, 0x03}, 0x030201);
    row("three bytes, high first", plain(3, Encoding::Unsigned), true, {0x01, 0x02, 0x03},
        0x010203);
    row("four bytes", plain(4, Encoding::Unsigned), false, {0x01, 0x02, 0x03, 0x04}, 0x04030201);
    row("four bytes, low word first", plain(4, Encoding::Unsigned), true, {0x03, 0x04, 0x01, 0x02},
        0x01020304);
    row("four bytes, signed", plain(4, Encoding::TwosComplement), false, {0xFE, 0xFF, 0xFF, 0xFF},
        -2);
}

void TestCatalogValue::wire()
{
    QFETCH(Register, reg);
    QFETCH(bool, big);
    QFETCH(base::Bytes, bytes);
    QFETCH(qint64, raw);
    const auto order = big ? base::ByteOrder::Big : base::ByteOrder::Little;
    const ValueFormat meaning = valueFormat(reg, Profile{}, noLookup);
    QCOMPARE(decodeRaw(bytes, reg, meaning, order), raw);
    QCOMPARE(encodeRaw(raw, reg, meaning, order), bytes);
}

void TestCatalogValue::negativeZeroIsZero_data()
{
    QTest::addColumn<Register>("reg");
    QTest::addColumn<base::Bytes>("bytes");
    QTest::newRow("bit 15") << plain(2, Encoding::SignBit, 15) << base::Bytes{0x00, 0x80};
    QTest::newRow("bit 10") << plain(2, Encoding::SignBit, 10) << base::Bytes{0x00, 0x04};
    QTest::newRow("offset") << plain(2, Encoding::SignBit11Ext12) << base::Bytes{0x00, 0x08};
}

void TestCatalogValue::negativeZeroIsZero()
{
    QFETCH(Register, reg);
    QFETCH(base::Bytes, bytes);
    reg.unit = QStringLiteral("deg");
    reg.scale = 0.087890625;
    const ValueFormat meaning = valueFormat(reg, Profile{}, noLookup);
    const auto raw = decodeRaw(bytes, reg, meaning, base::ByteOrder::Little);
    QCOMPARE(raw, 0);
    QCOMPARE(formatValue(raw, reg, meaning, false), QStringLiteral("0.00°"));
    QCOMPARE(encodeRaw(raw, reg, meaning, base::ByteOrder::Little), (base::Bytes{0, 0}));
}

void TestCatalogValue::encodingSaturates()
{
    // A number that does not fit must not turn into another one.
    const Register reg = plain(2, Encoding::SignBit, 10);
    const ValueFormat meaning = valueFormat(reg, Profile{}, noLookup);
    QCOMPARE(encodeRaw(5000, reg, meaning, base::ByteOrder::Little), (base::Bytes{0xFF, 0x03}));
    QCOMPARE(encodeRaw(-5000, reg, meaning, base::ByteOrder::Little), (base::Bytes{0xFF, 0x07}));
    const Register byte = plain(1, Encoding::Unsigned);
    const ValueFormat unsignedMeaning = valueFormat(byte, Profile{}, noLookup);
    QCOMPARE(encodeRaw(300, byte, unsignedMeaning, base::ByteOrder::Little), (base::Bytes{0xFF}));
    QCOMPARE(encodeRaw(-1, byte, unsignedMeaning, base::ByteOrder::Little), (base::Bytes{0x00}));
    QCOMPARE(toRaw(std::nan(""), meaning), 0);
    QVERIFY(toRaw(1e300, meaning) > 1000000);
}

void TestCatalogValue::speedUnit_data()
{
    QTest::addColumn<Identity>("identity");
    QTest::addColumn<int>("phase"); // -1: could not be read
    QTest::addColumn<double>("scale");
    const double coarse = 50.0 * 60.0 / 4096.0;
    const double fine = 60.0 / 4096.0;
    QTest::newRow("STS, phase 0") << Sts << 0 << coarse;
    QTest::newRow("STS, phase 12") << Sts << 12 << fine;
    QTest::newRow("STS, phase 44") << Sts << 44 << fine;
    QTest::newRow("STS, phase 0xFB") << Sts << 0xFB << coarse;
    QTest::newRow("STS, not read") << Sts << -1 << fine;
    QTest::newRow("SMS, phase 0") << Sms << 0 << coarse;
    QTest::newRow("SMS, phase 4") << Sms << 4 << fine;
    QTest::newRow("SMS, not read") << Sms << -1 << coarse;
}

void TestCatalogValue::speedUnit()
{
    QFETCH(Identity, identity);
    QFETCH(int, phase);
    QFETCH(double, scale);
    const Lookup lookup =
        phase < 0 ? Lookup(noLookup) : lookupIn({{QStringLiteral("phase"), phase}});
    for (const char* key : {"goal_speed", "present_speed"}) {
        const KnownRegister speed = known(identity, key, lookup);
        QCOMPARE(speed.meaning.scale, scale);
        QCOMPARE(speed.meaning.unit, QStringLiteral("rpm"));
        QCOMPARE(speed.meaning.assumed, phase < 0);
    }
}

void TestCatalogValue::scsTimeOrPwm_data()
{
    QTest::addColumn<int>("min");
    QTest::addColumn<int>("max");
    QTest::addColumn<bool>("pwm");
    QTest::addColumn<bool>("assumed");
    QTest::newRow("position mode") << 20 << 1003 << false << false;
    QTest::newRow("minimum 0 only") << 0 << 1003 << false << false;
    QTest::newRow("motor mode") << 0 << 0 << true << false;
    QTest::newRow("nothing known") << -1 << -1 << false << true;
    QTest::newRow("minimum 0, maximum not known") << 0 << -1 << false << true;
    QTest::newRow("maximum known, not 0") << -1 << 1003 << false << false;
}

void TestCatalogValue::scsTimeOrPwm()
{
    QFETCH(int, min);
    QFETCH(int, max);
    QFETCH(bool, pwm);
    QMap<QString, std::int64_t> values;
    if (min >= 0)
        values.insert(QStringLiteral("min_angle_limit"), min);
    if (max >= 0)
        values.insert(QStringLiteral("max_angle_limit"), max);
    const KnownRegister time = known(Scs15, "goal_time", lookupIn(values));
    QTEST(time.meaning.assumed, "assumed");
    const base::Bytes wire{0x04, 0xC8};
    const auto raw = decodeRaw(wire, *time.reg, time.meaning, base::ByteOrder::Big);
    QCOMPARE(raw, pwm ? -200 : 1224);
    QCOMPARE(formatValue(raw, *time.reg, time.meaning, false),
             pwm ? QStringLiteral("-20.0 %") : QStringLiteral("1224 ms"));
    QCOMPARE(*time.meaning.max, pwm ? 1000 : 9999);
    QCOMPARE(*time.meaning.min, pwm ? -1000 : 0);
    QCOMPARE(time.meaning.name.en.contains(QStringLiteral("PWM")), pwm);
    QCOMPARE(checkNewValue(-200, *time.reg, time.meaning, std::nullopt).has_value(), pwm);
    QCOMPARE(checkNewValue(1224, *time.reg, time.meaning, std::nullopt).has_value(), !pwm);
}

void TestCatalogValue::angleResolutionScalesTheGoalOnly()
{
    const Lookup factor3 = lookupIn({{QStringLiteral("angle_resolution"), 3}});
    const KnownRegister goal = known(Sts, "goal_position", factor3);
    QCOMPARE(toPhysical(1024, goal.meaning), 270.0);
    QVERIFY(!goal.meaning.assumed);
    QCOMPARE(*parseValue(QStringLiteral("270deg"), *goal.reg, goal.meaning), 1024);
    for (const char* key : {"present_position", "active_goal_position", "min_angle_limit"})
        QCOMPARE(toPhysical(1024, known(Sts, key, factor3).meaning), 90.0);

    const KnownRegister unread = known(Sts, "goal_position");
    QVERIFY(unread.meaning.assumed);
    QCOMPARE(toPhysical(1024, unread.meaning), 90.0);
    const KnownRegister invalidRegister =
        known(Sts, "goal_position", lookupIn({{QStringLiteral("angle_resolution"), 0}}));
    QVERIFY(invalidRegister.meaning.assumed);
    QCOMPARE(toPhysical(1024, invalidRegister.meaning), 90.0);
}

void TestCatalogValue::scsDegreesWhereTheRangeIsKnown()
{
    for (const char* key : {"goal_position", "present_position", "min_angle_limit",
                            "max_angle_limit", "cw_dead_zone", "ccw_dead_zone"}) {
        const KnownRegister with = known(Scs15, key);
        QCOMPARE(with.meaning.unit, QStringLiteral("deg"));
        QCOMPARE(toPhysical(1024, with.meaning), 220.0);
        const KnownRegister without = known(Scs45, key);
        QCOMPARE(without.meaning.unit, QStringLiteral("step"));
        QCOMPARE(toPhysical(1024, without.meaning), 1024.0);
    }
    for (const char* key : {"goal_speed", "present_speed"}) {
        QCOMPARE(known(Scs15, key).meaning.unit, QStringLiteral("rpm"));
        // 1024 step/s are 220 °/s.
        QCOMPARE(toPhysical(1024, known(Scs15, key).meaning), 220.0 / 6.0);
        QCOMPARE(known(Scs45, key).meaning.unit, QStringLiteral("step/s"));
    }
    QCOMPARE(toPhysical(1, known(Scs45, "max_speed_limit").meaning), 50.0);
}

void TestCatalogValue::newValues_data()
{
    QTest::addColumn<QString>("key");
    QTest::addColumn<qint64>("raw");
    QTest::addColumn<int>("present"); // -99999: not known
    QTest::addColumn<QString>("error");
    const int none = -99999;
    const auto row = [](const char* key, qint64 raw, int present, const char* error) {
        QTest::addRow("%s %lld of %d", key, raw, present)
            << QString::fromLatin1(key) << raw << present << QString::fromLatin1(error);
    };
    row("max_temperature", 100, none, "");
    row("max_temperature", 101, none, "out-of-range");
    row("max_temperature", 120, 120, "");
    row("max_temperature", 119, 120, "out-of-range");
    row("max_temperature", -1, none, "out-of-range");
    row("present_position", 5, 5, "read-only");
    row("moving_threshold", 1, none, "read-only");
    row("return_delay", 254, none, "");
    row("return_delay", 255, none, "out-of-range");
    row("id", 253, none, "");
    row("id", 254, none, "out-of-range");
    row("max_angle_limit", 0, none, "");
    row("max_angle_limit", 4096, none, "out-of-range");
    row("operating_mode", 3, none, "");
    row("operating_mode", 4, none, "out-of-range");
    row("operating_mode", 4, 4, "");
    row("torque_switch", 3, none, "out-of-range");
    row("torque_switch", 128, none, "");
    row("goal_position", -30719, none, "");
    row("goal_position", 30720, none, "out-of-range");
    row("unload_condition", 0x60, none, "");
    row("unload_condition", 255, none, "out-of-range");
    row("unload_condition", 255, 255, "");
    row("position_offset", 2047, none, "");
    row("position_offset", -2048, none, "out-of-range");
    row("position_offset", -2048, -2048, "");
    row("position_offset", 4095, 100, "out-of-range");
    row("position_offset", 4095, -3000, "");
    row("position_offset", 4096, -3000, "out-of-range");
}

void TestCatalogValue::newValues()
{
    QFETCH(QString, key);
    QFETCH(qint64, raw);
    QFETCH(int, present);
    QFETCH(QString, error);
    const KnownRegister value = known(Sts, key.toLatin1().constData());
    const auto result =
        checkNewValue(raw, *value.reg, value.meaning,
                      present == -99999 ? std::nullopt : std::optional<std::int64_t>(present));
    QCOMPARE(result ? QString() : base::errorName(result.error().code), error);
    if (!result)
        QCOMPARE(result.error().registerKey, key);
}

void TestCatalogValue::refusalsStateTheExpectedRange()
{
    const KnownRegister angle = known(Sts, "goal_position");
    QCOMPARE(checkNewValue(40000, *angle.reg, angle.meaning, std::nullopt).error().detail,
             QStringLiteral("-30719…30719, -2699.91° … 2699.91°"));
    const KnownRegister mode = known(Sts, "operating_mode");
    QCOMPARE(checkNewValue(4, *mode.reg, mode.meaning, std::nullopt).error().detail,
             QStringLiteral("position, speed, pwm, step"));
    QVERIFY(parseValue(QStringLiteral("8.5"), *angle.reg, angle.meaning)
                .error()
                .detail.contains(QStringLiteral("deg")));
}

SERVODESK_GUILESS_TEST(TestCatalogValue)
#include "tst_catalog_value.moc"
