// SPDX-License-Identifier: GPL-3.0-or-later
// Worked wire examples of the sign codings, meanings chosen by other registers, texts in and out,
// and what may be written.
#include "catalog/catalog.h"
#include "catalog/value.h"

#include <QtTest>

#include <cmath>

using namespace catalog;

Q_DECLARE_METATYPE(base::Bytes)

namespace {
const Identity Sts{3, 10, 0, 9, 3};
const Identity Sms{2, 53, 0, 8, 42};
const Identity Scs15{0, 4, 1, 5, 15};
const Identity Scs45{0, 4, 1, 5, 12}; // range not known

Lookup knows(QMap<QString, std::int64_t> values)
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
    void format_data();
    void format();
    void parse_data();
    void parse();
    void parseRefuses_data();
    void parseRefuses();
    void halfStepIsTheLargestRounding();
    void newValues_data();
    void newValues();
    void refusalsSayWhatIsExpected();

private:
    struct Known {
        ProfilePtr profile;
        const Register* reg;
        Meaning meaning;
    };
    Known known(const Identity& identity, const char* key, const Lookup& lookup = knowNothing) const
    {
        const ProfilePtr profile = m_catalog.resolve(identity);
        const Register* reg = profile->find(QLatin1String(key));
        return {profile, reg, meaningOf(*reg, *profile, lookup)};
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
    const Meaning meaning = meaningOf(reg, Profile{}, knowNothing);
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
    const Meaning meaning = meaningOf(reg, Profile{}, knowNothing);
    const auto raw = decodeRaw(bytes, reg, meaning, base::ByteOrder::Little);
    QCOMPARE(raw, 0);
    QCOMPARE(formatValue(raw, reg, meaning, false), QStringLiteral("0.00°"));
    QCOMPARE(encodeRaw(raw, reg, meaning, base::ByteOrder::Little), (base::Bytes{0, 0}));
}

void TestCatalogValue::encodingSaturates()
{
    // A number that does not fit must not turn into another one.
    const Register reg = plain(2, Encoding::SignBit, 10);
    const Meaning meaning = meaningOf(reg, Profile{}, knowNothing);
    QCOMPARE(encodeRaw(5000, reg, meaning, base::ByteOrder::Little), (base::Bytes{0xFF, 0x03}));
    QCOMPARE(encodeRaw(-5000, reg, meaning, base::ByteOrder::Little), (base::Bytes{0xFF, 0x07}));
    const Register byte = plain(1, Encoding::Unsigned);
    const Meaning unsignedMeaning = meaningOf(byte, Profile{}, knowNothing);
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
        phase < 0 ? Lookup(knowNothing) : knows({{QStringLiteral("phase"), phase}});
    for (const char* key : {"goal_speed", "present_speed"}) {
        const Known speed = known(identity, key, lookup);
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
    const Known time = known(Scs15, "goal_time", knows(values));
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
    const Lookup factor3 = knows({{QStringLiteral("angle_resolution"), 3}});
    const Known goal = known(Sts, "goal_position", factor3);
    QCOMPARE(toPhysical(1024, goal.meaning), 270.0);
    QVERIFY(!goal.meaning.assumed);
    QCOMPARE(*parseValue(QStringLiteral("270deg"), *goal.reg, goal.meaning), 1024);
    for (const char* key : {"present_position", "active_goal_position", "min_angle_limit"})
        QCOMPARE(toPhysical(1024, known(Sts, key, factor3).meaning), 90.0);

    const Known unread = known(Sts, "goal_position");
    QVERIFY(unread.meaning.assumed);
    QCOMPARE(toPhysical(1024, unread.meaning), 90.0);
    const Known senseless =
        known(Sts, "goal_position", knows({{QStringLiteral("angle_resolution"), 0}}));
    QVERIFY(senseless.meaning.assumed);
    QCOMPARE(toPhysical(1024, senseless.meaning), 90.0);
}

void TestCatalogValue::scsDegreesWhereTheRangeIsKnown()
{
    for (const char* key : {"goal_position", "present_position", "min_angle_limit",
                            "max_angle_limit", "cw_dead_zone", "ccw_dead_zone"}) {
        const Known with = known(Scs15, key);
        QCOMPARE(with.meaning.unit, QStringLiteral("deg"));
        QCOMPARE(toPhysical(1024, with.meaning), 220.0);
        const Known without = known(Scs45, key);
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

void TestCatalogValue::format_data()
{
    QTest::addColumn<Identity>("identity");
    QTest::addColumn<QString>("key");
    QTest::addColumn<qint64>("raw");
    QTest::addColumn<QString>("en");
    QTest::addColumn<QString>("zh");
    const auto row = [](const Identity& identity, const char* key, qint64 raw, const char* en,
                        const char* zh = nullptr) {
        QTest::addRow("%s %lld", key, raw)
            << identity << QString::fromLatin1(key) << raw << QString::fromUtf8(en)
            << QString::fromUtf8(zh ? zh : en);
    };
    row(Sts, "max_voltage", 85, "8.5 V");
    row(Sts, "goal_position", 1024, "90.00°");
    row(Sts, "goal_position", -1, "-0.09°");
    row(Sts, "present_temperature", 55, "55 °C");
    row(Sts, "protection_time", 20, "200 ms");
    row(Sts, "max_torque", 500, "50.0 %");
    row(Sts, "present_current", 50, "325 mA");
    row(Sts, "present_current", -50, "-325 mA");
    row(Sts, "present_speed", 840, "12.30 rpm");
    row(Sms, "present_speed", 17, "12.5 rpm");
    row(Sms, "return_delay", 250, "500 µs");
    row(Sts, "acceleration", 100, "879 °/s²");
    row(Sts, "integral_limit", 25, "25");
    row(Sts, "id", 7, "7");
    row(Scs45, "goal_position", 512, "512 step");
    row(Sts, "operating_mode", 1, "speed", "恒速");
    row(Sts, "operating_mode", 9, "9");
    row(Sts, "torque_switch", 2, "damping", "阻尼");
    row(Sts, "baud_rate", 4, "115200 baud", "115200 波特");
    row(Sts, "servo_status", 0, "none", "无");
    row(Sts, "servo_status", 33, "voltage + overload", "电压 + 过载");
    row(Sts, "servo_status", 0x60, "overload + bit 6", "过载 + 位 6");
    row(Scs15, "servo_status", 2, "bit 1", "位 1");
}

void TestCatalogValue::format()
{
    QFETCH(Identity, identity);
    QFETCH(QString, key);
    QFETCH(qint64, raw);
    const Known value = known(identity, key.toLatin1().constData());
    QTEST(formatValue(raw, *value.reg, value.meaning, false), "en");
    QTEST(formatValue(raw, *value.reg, value.meaning, true), "zh");
}

void TestCatalogValue::parse_data()
{
    QTest::addColumn<Identity>("identity");
    QTest::addColumn<QString>("key");
    QTest::addColumn<QString>("text");
    QTest::addColumn<qint64>("raw");
    const auto row = [](const Identity& identity, const char* key, const char* text, qint64 raw) {
        QTest::addRow("%s %s", key, text)
            << identity << QString::fromLatin1(key) << QString::fromUtf8(text) << raw;
    };
    row(Sts, "max_voltage", "85", 85);
    row(Sts, "max_voltage", " 8.5V ", 85);
    row(Sts, "max_voltage", "8.5 v", 85);
    row(Sts, "max_voltage", "8500mV", 85);
    row(Sts, "max_voltage", "8.0", 8);
    row(Sts, "max_voltage", "0x55", 85);
    row(Sts, "goal_position", "90deg", 1024);
    row(Sts, "goal_position", "90°", 1024);
    row(Sts, "goal_position", "90 度", 1024);
    row(Sts, "goal_position", "-90.0 deg", -1024);
    row(Sts, "goal_position", "−90°", -1024);
    row(Sts, "goal_position", "+1000", 1000);
    row(Sts, "goal_position", "-1000", -1000);
    row(Sts, "goal_position", "0deg", 0);
    row(Sms, "goal_speed", "12rpm", 16);
    row(Sms, "goal_speed", "360deg/s", 82);
    row(Sts, "torque_limit", "50%", 500);
    row(Sts, "protection_time", "1s", 100);
    row(Sts, "protection_time", "200ms", 20);
    row(Sts, "protection_current", "0.5A", 77);
    row(Sts, "protection_current", "500mA", 77);
    row(Sts, "max_temperature", "60°C", 60);
    row(Sts, "max_temperature", "60 ℃", 60);
    row(Sms, "return_delay", "0.1 ms", 50);
    row(Scs45, "goal_position", "512step", 512);
    row(Scs45, "goal_position", "512 steps", 512);
    row(Sts, "operating_mode", "speed", 1);
    row(Sts, "operating_mode", "Speed", 1);
    row(Sts, "operating_mode", "恒速", 1);
    row(Sts, "operating_mode", "3", 3);
    row(Sts, "torque_switch", "center", 128);
    row(Sts, "baud_rate", "1000000", 0);
    row(Sts, "baud_rate", "115200 baud", 4);
    row(Sts, "baud_rate", "4", 4);
    row(Sts, "unload_condition", "overload+voltage", 33);
    row(Sts, "unload_condition", "overload + temperature + current", 44);
    row(Sts, "unload_condition", "44", 44);
    row(Sts, "unload_condition", "bit6+过载", 96);
    row(Sts, "unload_condition", "none", 0);
}

void TestCatalogValue::parse()
{
    QFETCH(Identity, identity);
    QFETCH(QString, key);
    QFETCH(QString, text);
    QFETCH(qint64, raw);
    const Known value = known(identity, key.toLatin1().constData());
    const auto parsed = parseValue(text, *value.reg, value.meaning);
    QVERIFY2(parsed.has_value(), parsed ? "" : qPrintable(parsed.error().detail));
    QCOMPARE(*parsed, raw);
}

void TestCatalogValue::parseRefuses_data()
{
    QTest::addColumn<QString>("key");
    QTest::addColumn<QString>("text");
    const auto row = [](const char* key, const char* text) {
        QTest::addRow("%s \"%s\"", key, text)
            << QString::fromLatin1(key) << QString::fromUtf8(text);
    };
    row("max_voltage", "");
    row("max_voltage", "8.5");
    row("max_voltage", "8.5deg");
    row("max_voltage", "8,5V");
    row("max_voltage", "8.5.1V");
    row("max_voltage", "V");
    row("max_voltage", "1e3");
    row("max_voltage", "nan");
    row("max_voltage", "inf V");
    row("max_voltage", "--5");
    row("max_voltage", "0xZZ");
    row("max_voltage", "0x10V");
    row("max_voltage", "99999999999999999999999");
    row("protection_time", "4ms");
    row("id", "7deg");
    row("id", "seven");
    row("operating_mode", "fly");
    row("operating_mode", "1.5");
    row("operating_mode", "1 V");
    row("unload_condition", "overload+");
    row("unload_condition", "overload+smoke");
    row("unload_condition", "bit8");
}

void TestCatalogValue::parseRefuses()
{
    QFETCH(QString, key);
    QFETCH(QString, text);
    const Known value = known(Sts, key.toLatin1().constData());
    const auto parsed = parseValue(text, *value.reg, value.meaning);
    QVERIFY2(!parsed.has_value(), parsed ? qPrintable(QString::number(*parsed)) : "");
    QCOMPARE(parsed.error().code, base::ErrorCode::BadArgument);
    QCOMPARE(parsed.error().registerKey, key);
    QVERIFY(!parsed.error().detail.isEmpty());
}

void TestCatalogValue::halfStepIsTheLargestRounding()
{
    const Known volts = known(Sts, "max_voltage");
    for (const char* text : {"8.55V", "8.54V", "8.56V", "8.449V"}) {
        const QString typed = QString::fromLatin1(text);
        const auto raw = parseValue(typed, *volts.reg, volts.meaning);
        QVERIFY(raw.has_value());
        const double wanted = typed.chopped(1).toDouble();
        QVERIFY(std::abs(toPhysical(*raw, volts.meaning) - wanted) <= 0.05 + 1e-9);
    }
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
    row("return_delay", 1, none, "read-only");
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
    const Known value = known(Sts, key.toLatin1().constData());
    const auto result =
        checkNewValue(raw, *value.reg, value.meaning,
                      present == -99999 ? std::nullopt : std::optional<std::int64_t>(present));
    QCOMPARE(result ? QString() : base::errorName(result.error().code), error);
    if (!result)
        QCOMPARE(result.error().registerKey, key);
}

void TestCatalogValue::refusalsSayWhatIsExpected()
{
    const Known angle = known(Sts, "goal_position");
    QCOMPARE(checkNewValue(40000, *angle.reg, angle.meaning, std::nullopt).error().detail,
             QStringLiteral("-30719…30719"));
    const Known mode = known(Sts, "operating_mode");
    QCOMPARE(checkNewValue(4, *mode.reg, mode.meaning, std::nullopt).error().detail,
             QStringLiteral("position, speed, pwm, step"));
    QVERIFY(parseValue(QStringLiteral("8.5"), *angle.reg, angle.meaning)
                .error()
                .detail.contains(QStringLiteral("deg")));
}

QTEST_GUILESS_MAIN(TestCatalogValue)
#include "tst_catalog_value.moc"
