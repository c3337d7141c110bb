// SPDX-License-Identifier: GPL-3.0-or-later
// Values as text: what a technician sees, and what may be typed.
#include "catalog/catalog.h"
#include "catalog/value.h"
#include "support/test_main.h"
#include "unit/catalog/identities.h"

#include <QtTest>

#include <cmath>

using namespace catalog;

class TestCatalogText : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init();
    void format_data();
    void format();
    void parse_data();
    void parse();
    void parseRefuses_data();
    void parseRefuses();
    void halfStepIsTheLargestRounding();

private:
    struct KnownRegister {
        ProfilePtr profile;
        const Register* reg;
        ValueFormat meaning;
    };
    KnownRegister known(const Identity& identity, const QString& key) const
    {
        const ProfilePtr profile = m_catalog.resolve(identity);
        const Register* reg = profile->find(key);
        return {profile, reg, valueFormat(*reg, *profile, noLookup)};
    }
    const Catalog m_catalog = Catalog::load().catalog;
};

void TestCatalogText::init()
{
    QTest::failOnWarning(QRegularExpression(QStringLiteral(".*")));
}

void TestCatalogText::format_data()
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

void TestCatalogText::format()
{
    QFETCH(Identity, identity);
    QFETCH(QString, key);
    QFETCH(qint64, raw);
    const KnownRegister value = known(identity, key);
    QTEST(formatValue(raw, *value.reg, value.meaning, false), "en");
    QTEST(formatValue(raw, *value.reg, value.meaning, true), "zh");
}

void TestCatalogText::parse_data()
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

void TestCatalogText::parse()
{
    QFETCH(Identity, identity);
    QFETCH(QString, key);
    QFETCH(QString, text);
    QFETCH(qint64, raw);
    const KnownRegister value = known(identity, key);
    const auto parsed = parseValue(text, *value.reg, value.meaning);
    QVERIFY2(parsed.has_value(), parsed ? "" : qPrintable(parsed.error().detail));
    QCOMPARE(*parsed, raw);
}

void TestCatalogText::parseRefuses_data()
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
    row("max_voltage", "0x7fffffffffffffffff");
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

void TestCatalogText::parseRefuses()
{
    QFETCH(QString, key);
    QFETCH(QString, text);
    const KnownRegister value = known(Sts, key);
    const auto parsed = parseValue(text, *value.reg, value.meaning);
    QVERIFY2(!parsed.has_value(), parsed ? qPrintable(QString::number(*parsed)) : "");
    QCOMPARE(parsed.error().code, base::ErrorCode::BadArgument);
    QCOMPARE(parsed.error().registerKey, key);
    QVERIFY(!parsed.error().detail.isEmpty());
}

void TestCatalogText::halfStepIsTheLargestRounding()
{
    const KnownRegister volts = known(Sts, QStringLiteral("max_voltage"));
    for (const char* text : {"8.55V", "8.54V", "8.56V", "8.449V"}) {
        const QString typed = QString::fromLatin1(text);
        const auto raw = parseValue(typed, *volts.reg, volts.meaning);
        QVERIFY(raw.has_value());
        const double wanted = typed.chopped(1).toDouble();
        QVERIFY(std::abs(toPhysical(*raw, volts.meaning) - wanted) <= 0.05 + 1e-9);
    }
}

SERVODESK_GUILESS_TEST(TestCatalogText)
#include "tst_catalog_text.moc"
