// SPDX-License-Identifier: GPL-3.0-or-later
// Every register of every family with every value that could be special, on every way a value takes
// to a servo: what can make the servo unreachable or dangerous, or its positions wrong, is refused
// without consent before a byte of it is sent. What must ask is listed here, from the data sheets.
#include "device/motion/motion.h"
#include "device/write_meaning.h"
#include "integration/restore_support.h"
#include "jobs/change/ordered_write.h"
#include "jobs/restore/restore_many.h"
#include "jobs/restore/take_snapshot.h"
#include "support/commission_fixture.h"
#include "support/consent_rules.h"
#include "support/test_main.h"

#include <QRegularExpression>

using base::ErrorCode;
using jobs::SpecialRegisters;
using support::consentFamilies;
using support::FamilyRules;
using support::mustAsk;
using support::SimFixture;
using support::specialValues;

namespace {
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
    void severalServosNeedConsent_data() { addFamilies(); }
    void severalServosNeedConsent();
    void commissioningNeedsConsent();
    void limitsAreNotRemovedWithoutConsent_data();
    void limitsAreNotRemovedWithoutConsent();
    void oneLimitNeedsNone();
    void limitsNeedConsentInEveryMode();

private:
    static void addFamilies()
    {
        QTest::addColumn<int>("family");
        for (std::size_t i = 0; i < consentFamilies().size(); ++i)
            QTest::newRow(consentFamilies()[i].servos) << int(i);
    }
};

void TestConsent::theMeaningIsThatOfTheSheets()
{
    QFETCH(const int, family);
    const FamilyRules& rules = consentFamilies()[std::size_t(family)];
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
    const FamilyRules& rules = consentFamilies()[std::size_t(family)];
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
    const FamilyRules& rules = consentFamilies()[std::size_t(family)];
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

/// The way of "several servos" and of bundles, with every risky row named.
void TestConsent::severalServosNeedConsent()
{
    QFETCH(const int, family);
    const FamilyRules& rules = consentFamilies()[std::size_t(family)];
    SimFixture fixture(QString::fromLatin1(rules.servos), support::atBaud(rules.baud));
    const device::Servo servo = support::identifyWithTable(fixture);
    snapshot::Bundle bundle;
    bundle.servos = {jobs::snapshotOf(servo, {})};
    snapshot::Snapshot& wanted = bundle.servos.front();
    jobs::ApplyOptions options;
    std::map<QString, std::int64_t> before;
    for (const catalog::Register* reg : writable(servo)) {
        const auto present = servo.raw(*reg);
        const std::int64_t risky = present.value_or(0) == 0 ? 1 : *present - 1;
        if (reg->identity || !present || !mustAsk(rules, *reg, risky) || !reg->min ||
            !support::isRestorable(*reg))
            continue;
        const auto row = std::find_if(wanted.registers.begin(), wanted.registers.end(),
                                      [&](const auto& one) { return one.key == reg->key; });
        row->raw = risky;
        options.choice.only << reg->key;
        before[reg->key] = *present;
    }
    const auto changed = [&] {
        return std::count_if(before.begin(), before.end(), [&](const auto& one) {
            return fixture.raw(1, one.first) != one.second;
        });
    };
    (void)jobs::applyToServos(fixture.context(), {1}, wanted, options);
    (void)jobs::restoreBundle(fixture.context(), bundle, options);
    QCOMPARE(changed(), 0);
    QVERIFY(fixture.journal().entries()->empty());
    // These are the values that a consent lets through.
    options.choice.consent = device::Consent::confirmed();
    options.restore.consent = options.choice.consent;
    (void)jobs::applyToServos(fixture.context(), {1}, wanted, options);
    QVERIFY2(before.empty() || changed() > 0, rules.servos);
}

void TestConsent::commissioningNeedsConsent()
{
    const QString condition = QStringLiteral("unload_condition");
    const QString max = QStringLiteral("max_angle_limit");
    for (const bool given : {false, true}) {
        support::CommissionFixture line(QStringLiteral("sts3215@1"));
        line.spec.settings =
            support::templateOf("sts3215", {{"unload_condition", 32}, {"max_angle_limit", 0}});
        line.spec.consent = device::Consent::byOption(given);
        line.spec.count = 1;
        QVERIFY(line.run());
        const sim::VirtualServo& servo = line.servoAt(0);
        QCOMPARE(servo.id(), 11);
        QCOMPARE(servo.raw(condition), given ? 32 : 44);
        QCOMPARE(servo.raw(max), given ? 0 : 4095);
    }
}

/// Both angle limits at 0: motor mode (SCS), or position mode without limits (STS, HLS, Modbus).
void TestConsent::limitsAreNotRemovedWithoutConsent_data()
{
    QTest::addColumn<QString>("servos");
    QTest::addColumn<int>("baud");
    for (const char* servos : {"sts3215@1", "scs15@1", "hls3606@1", "scs15-2@1"})
        QTest::newRow(servos) << QString::fromLatin1(servos) << 1'000'000;
    for (const char* servos : {"sm40blhv@1", "sm60-360m@1", "smsmb@1"})
        QTest::newRow(servos) << QString::fromLatin1(servos) << 115'200;
}

void TestConsent::limitsAreNotRemovedWithoutConsent()
{
    QFETCH(const QString, servos);
    QFETCH(const int, baud);
    SimFixture fixture(servos, support::atBaud(baud));
    device::Servo servo = support::identifyWithTable(fixture);
    fixture.clearFrames();
    const QString min = servo.profile->byRole(catalog::Role::MinAngle)->key;
    const QString max = servo.profile->byRole(catalog::Role::MaxAngle)->key;
    for (const auto special : {SpecialRegisters::Write, SpecialRegisters::Refuse}) {
        std::optional<device::WriteReport> report;
        const auto done =
            jobs::writeInOrder(fixture.context(), servo, {{min, 0}, {max, 0}}, {}, special, report);
        QVERIFY(!done && !report);
        QCOMPARE(done.error().code, ErrorCode::NeedsConsent);
        QCOMPARE(done.error().detail, QStringLiteral("free-turning"));
    }
    snapshot::Snapshot wanted = jobs::snapshotOf(servo, {});
    for (snapshot::SnapshotRegister& row : wanted.registers) {
        if (row.key == min || row.key == max)
            row.raw = 0;
    }
    jobs::RestorePlan plan = jobs::planRestore(servo, wanted);
    QVERIFY(jobs::plannedWrites(plan).empty());
    QVERIFY(plan.setSelected(min, true) || plan.setSelected(max, true));
    plan.setSelected(max, true);
    const auto restored = jobs::restore(fixture.context(), servo, plan, {});
    QVERIFY(!restored && restored.error().code == ErrorCode::NeedsConsent);
    QVERIFY(fixture.onlyReadsSent());

    // The user may want it.
    device::WriteOptions options;
    options.consent = device::Consent::byOption(true);
    std::optional<device::WriteReport> report;
    QVERIFY(jobs::writeInOrder(fixture.context(), servo, {{min, 0}, {max, 0}}, options,
                               SpecialRegisters::Refuse, report));
    QVERIFY(report && report->isSuccessful());
    // Limits again need none.
    QVERIFY(jobs::writeInOrder(fixture.context(), servo, {{min, 10}, {max, 900}}, {},
                               SpecialRegisters::Refuse, report));
    QVERIFY(report->isSuccessful());
}

void TestConsent::oneLimitNeedsNone()
{
    SimFixture fixture(QStringLiteral("sts3215@1"));
    device::Servo servo = support::identifyWithTable(fixture);
    const QString min = servo.profile->byRole(catalog::Role::MinAngle)->key;
    const QString max = servo.profile->byRole(catalog::Role::MaxAngle)->key;
    std::optional<device::WriteReport> report;
    QVERIFY(jobs::writeInOrder(fixture.context(), servo, {{min, 100}}, {}, SpecialRegisters::Write,
                               report));
    snapshot::Snapshot wanted = jobs::snapshotOf(servo, {});
    for (snapshot::SnapshotRegister& row : wanted.registers) {
        if (row.key == min || row.key == max)
            row.raw = 0;
    }
    jobs::RestoreChoice onlyMin;
    onlyMin.only = {min};
    const auto writes = jobs::plannedWrites(jobs::planRestore(servo, wanted, onlyMin));
    QCOMPARE(writes.size(), std::size_t(1));
    QCOMPARE(writes.front().key, min);
}

/// The mode in which there is no limit then may come later, and step mode is one already. The way
/// back to a position mode finds the limits again, whichever mode they were removed in.
void TestConsent::limitsNeedConsentInEveryMode()
{
    for (const char* mode : {"speed", "pwm", "step"}) {
        SimFixture fixture(QStringLiteral("sts3215@1"));
        device::Servo servo = support::identifyWithTable(fixture);
        const QString min = servo.profile->byRole(catalog::Role::MinAngle)->key;
        const QString max = servo.profile->byRole(catalog::Role::MaxAngle)->key;
        const std::int64_t number = servo.profile->mode(QLatin1String(mode))->operatingMode.value();
        const auto write = [&](const std::vector<device::WriteItem>& items,
                               device::Consent consent) {
            std::optional<device::WriteReport> report;
            device::WriteOptions options;
            options.consent = consent;
            const auto done = jobs::writeInOrder(fixture.context(), servo, items, options,
                                                 SpecialRegisters::Write, report);
            return done && report && report->isSuccessful();
        };
        QVERIFY(write({{min, 300}, {max, 3000}}, {}));
        QVERIFY(
            write({{QStringLiteral("operating_mode"), number}}, device::Consent::byOption(true)));
        // A snapshot with mode and limits together asks for the limits as well.
        snapshot::Snapshot wanted = jobs::snapshotOf(servo, {});
        for (snapshot::SnapshotRegister& row : wanted.registers) {
            if (row.key == min || row.key == max || row.key == QLatin1String("operating_mode"))
                row.raw = 0;
        }
        const auto plan = jobs::planRestore(servo, wanted);
        QVERIFY2(jobs::plannedWrites(plan).empty(), mode);
        QVERIFY2(!write({{min, 0}, {max, 0}}, {}), mode);
        QVERIFY2(write({{min, 0}, {max, 0}}, device::Consent::byOption(true)), mode);
        QVERIFY(device::switchMode(fixture.context(), servo, QStringLiteral("position")));
        QCOMPARE(fixture.raw(1, min), 300);
        QCOMPARE(fixture.raw(1, max), 3000);
    }
}

SERVODESK_GUILESS_TEST(TestConsent)
#include "tst_consent.moc"
