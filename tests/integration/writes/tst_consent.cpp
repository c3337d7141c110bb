// SPDX-License-Identifier: GPL-3.0-or-later
// Every register of every family with every value that could be special, on every way a value takes
// to a servo: what can make the servo unreachable or dangerous, or its positions wrong, is refused
// without consent before a byte of it is sent. What must ask is listed here, from the data sheets.
#include "device/write_meaning.h"
#include "integration/restore_support.h"
#include "jobs/change/ordered_write.h"
#include "jobs/restore/restore.h"
#include "jobs/restore/take_snapshot.h"
#include "support/test_main.h"

#include <QRegularExpression>

#include <set>

using base::ErrorCode;
using jobs::SpecialRegisters;
using support::SimFixture;

namespace {
/// By the names of the register maps, whose addresses are those of the sheets.
const std::set<QString> riskyKeys{QStringLiteral("id"),
                                  QStringLiteral("secondary_id"),
                                  QStringLiteral("baud_rate"),
                                  QStringLiteral("response_level"),
                                  QStringLiteral("phase"),
                                  QStringLiteral("unload_condition"),
                                  QStringLiteral("angle_offset"),
                                  QStringLiteral("angle_resolution"),
                                  QStringLiteral("return_delay"),
                                  QStringLiteral("position_offset"),
                                  QStringLiteral("operating_mode")};

struct FamilyRules {
    const char* servos;
    int baud;
    std::set<QString> harmless; ///< of riskyKeys: only delays a reply in this family
    const char* centerKey;      ///< takes a value that sets the midpoint
    std::int64_t centerValue;
};

/// Torque switch 40 = 128 (STS and SMS), bit 2 of the fault reset register (Modbus).
const std::vector<FamilyRules>& families()
{
    static const std::vector<FamilyRules> all{
        {"sts3215@1", 1'000'000, {QStringLiteral("return_delay")}, "torque_switch", 128},
        {"sm40blhv@1", 115'200, {}, "torque_switch", 128},
        {"scs15@1", 1'000'000, {QStringLiteral("return_delay")}, "", 0},
        {"hls3606@1", 1'000'000, {QStringLiteral("return_delay")}, "", 0},
        {"sm60-360m@1", 115'200, {}, "", 0},
        {"scs15-2@1", 1'000'000, {QStringLiteral("return_delay")}, "", 0},
        {"smsmb@1", 115'200, {}, "fault_reset", 4},
        {"lx16a@1", 115'200, {}, "", 0}};
    return all;
}

std::set<std::int64_t> specialValues(const catalog::Register& reg,
                                     std::optional<std::int64_t> present)
{
    std::set<std::int64_t> values{0, 1, 2, 4, 128, 254};
    for (const auto& bound : {reg.min, reg.max}) {
        if (bound)
            values.insert(*bound);
    }
    for (const catalog::NamedValue& named : reg.values)
        values.insert(named.value);
    if (present)
        values.insert({*present - 1, *present + 1});
    return values;
}

bool mustAsk(const FamilyRules& rules, const catalog::Register& reg, std::int64_t raw)
{
    if (reg.key == QLatin1String(rules.centerKey))
        return *rules.centerKey == 'f' ? (raw & rules.centerValue) != 0 : raw == rules.centerValue;
    return reg.area == catalog::Area::Factory ||
           (riskyKeys.count(reg.key) > 0 && rules.harmless.count(reg.key) == 0);
}

std::vector<const catalog::Register*> writable(const device::Servo& servo)
{
    std::vector<const catalog::Register*> found;
    for (const catalog::Register& reg : servo.profile->registers) {
        if (reg.writable())
            found.push_back(&reg);
    }
    return found;
}

QByteArray name(const catalog::Register& reg, std::int64_t raw)
{
    return reg.key.toLatin1() + '=' + QByteArray::number(qlonglong(raw));
}
} // namespace

class TestConsent : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { QTest::failOnWarning(QRegularExpression(QStringLiteral(".*"))); }

    void theMeaningIsThatOfTheSheets_data() { addFamilies(); }
    void theMeaningIsThatOfTheSheets();
    void noWriteWithoutConsent_data() { addFamilies(); }
    void noWriteWithoutConsent();
    void noRestoreWithoutConsent_data() { addFamilies(); }
    void noRestoreWithoutConsent();

private:
    static void addFamilies()
    {
        QTest::addColumn<int>("family");
        for (std::size_t i = 0; i < families().size(); ++i)
            QTest::newRow(families()[i].servos) << int(i);
    }
};

void TestConsent::theMeaningIsThatOfTheSheets()
{
    QFETCH(const int, family);
    const FamilyRules& rules = families()[std::size_t(family)];
    SimFixture fixture(QString::fromLatin1(rules.servos), support::atBaud(rules.baud));
    const device::Servo servo = support::identifyWithTable(fixture);
    int asked = 0;
    for (const catalog::Register* reg : writable(servo)) {
        for (const std::int64_t raw : specialValues(*reg, servo.raw(*reg))) {
            const bool asks = device::classify(*reg, raw).needsConsent;
            QVERIFY2(asks == mustAsk(rules, *reg, raw), name(*reg, raw).constData());
            asked += asks ? 1 : 0;
        }
    }
    QVERIFY(asked > 10);
}

/// The way of memory table, several servos, undo and redo; and that of the command line, where
/// registers with a command of their own are refused with its name.
void TestConsent::noWriteWithoutConsent()
{
    QFETCH(const int, family);
    const FamilyRules& rules = families()[std::size_t(family)];
    SimFixture fixture(QString::fromLatin1(rules.servos), support::atBaud(rules.baud));
    device::Servo servo = support::identifyWithTable(fixture);
    fixture.clearFrames();
    for (const catalog::Register* reg : writable(servo)) {
        for (const std::int64_t raw : specialValues(*reg, servo.raw(*reg))) {
            if (!mustAsk(rules, *reg, raw))
                continue;
            for (const auto special : {SpecialRegisters::Write, SpecialRegisters::Refuse}) {
                for (const bool temporary : {false, true}) {
                    std::optional<device::WriteReport> report;
                    const auto done =
                        jobs::writeInOrder(fixture.context(), servo, {{reg->key, raw}},
                                           {temporary, {}}, special, report);
                    QVERIFY2(!done && !report, name(*reg, raw).constData());
                    const ErrorCode code = done.error().code;
                    QVERIFY2(code == ErrorCode::NeedsConsent ||
                                 (special == SpecialRegisters::Refuse &&
                                  code == ErrorCode::NotSupported),
                             name(*reg, raw).constData());
                }
            }
        }
    }
    QVERIFY(fixture.onlyReadsSent());
}

/// The way of snapshots, templates and bundles.
void TestConsent::noRestoreWithoutConsent()
{
    QFETCH(const int, family);
    const FamilyRules& rules = families()[std::size_t(family)];
    SimFixture fixture(QString::fromLatin1(rules.servos), support::atBaud(rules.baud));
    device::Servo servo = support::identifyWithTable(fixture);
    fixture.clearFrames();
    int refused = 0;
    for (const catalog::Register* reg : writable(servo)) {
        for (const std::int64_t raw : specialValues(*reg, servo.raw(*reg))) {
            if (!mustAsk(rules, *reg, raw))
                continue;
            for (const bool isTemplate : {false, true}) {
                snapshot::Snapshot wanted = jobs::snapshotOf(servo, {});
                wanted.isTemplate = isTemplate;
                for (snapshot::SnapshotRegister& row : wanted.registers) {
                    if (row.key == reg->key) {
                        row.raw = raw;
                        row.value = catalog::toPhysical(raw, servo.meaning(*reg));
                    }
                }
                jobs::RestorePlan plan = jobs::planRestore(servo, wanted);
                const jobs::RestoreRow* row = plan.find(reg->key);
                QVERIFY2(row == nullptr || !row->selected, name(*reg, raw).constData());
                // Address and rate are ticked by name, and asked about by a checkbox of their own.
                if (reg->identity || !plan.setSelected(reg->key, true))
                    continue;
                const auto done = jobs::restore(fixture.context(), servo, plan, {});
                QVERIFY2(!done && done.error().code == ErrorCode::NeedsConsent,
                         name(*reg, raw).constData());
                ++refused;
            }
        }
    }
    QVERIFY(refused > 0);
    QVERIFY(fixture.onlyReadsSent());
}

SERVODESK_GUILESS_TEST(TestConsent)
#include "tst_consent.moc"
