// SPDX-License-Identifier: GPL-3.0-or-later
// What restoring would do, before it does: reasons and ticks of every kind of row, other models by
// key, values that do not fit, and the order of the writes.
#include "integration/restore_support.h"
#include "jobs/restore/take_snapshot.h"
#include "snapshot/factory_snapshot.h"
#include "snapshot/snapshot_template.h"
#include "support/test_main.h"
#include "text/language.h"
#include "text/restore_text.h"

#include <QRegularExpression>
#include <QTest>

#include <array>
#include <cmath>

using jobs::RestoreReason;
using jobs::RestoreRow;
using jobs::RestoreStage;
using support::SimFixture;

namespace {
QString word(const char* latin1)
{
    return QString::fromLatin1(latin1);
}

device::Servo servoOf(const char* servos, int baud)
{
    SimFixture fixture(word(servos), support::atBaud(baud));
    return support::identifyWithTable(fixture);
}

const device::Servo& sts()
{
    static const device::Servo servo = servoOf("sts3215@1", 1'000'000);
    return servo;
}

/// A snapshot of `servo` in which every row has a value of its own choice.
snapshot::Snapshot randomSnapshot(const device::Servo& servo, unsigned seed)
{
    snapshot::Snapshot snapshot = jobs::snapshotOf(servo, word("test 1"));
    for (const auto& [key, raw] : support::RandomTable(seed).make(servo)) {
        for (snapshot::SnapshotRegister& reg : snapshot.registers) {
            if (reg.key != key)
                continue;
            reg.raw = raw;
            reg.value = catalog::toPhysical(raw, servo.meaning(*servo.profile->find(key)));
        }
    }
    return snapshot;
}

/// With the physical value, as a file has it.
void setValue(snapshot::Snapshot& snapshot, const device::Servo& servo, const char* key,
              std::int64_t raw)
{
    for (snapshot::SnapshotRegister& reg : snapshot.registers) {
        if (reg.key != word(key))
            continue;
        reg.raw = raw;
        reg.value = catalog::toPhysical(raw, servo.meaning(*servo.profile->find(reg.key)));
    }
}

void setRaw(snapshot::Snapshot& snapshot, const char* key, std::optional<std::int64_t> raw)
{
    for (snapshot::SnapshotRegister& reg : snapshot.registers) {
        if (reg.key == word(key))
            reg.raw = raw;
    }
}

bool has(const jobs::RestorePlan& plan, const char* key, RestoreReason reason)
{
    const RestoreRow* row = plan.find(word(key));
    return row != nullptr && row->reasons.testFlag(reason);
}

QStringList unmappedKeys(const jobs::RestorePlan& plan)
{
    QStringList keys;
    for (const RestoreRow* row : plan.unmappedRows())
        keys << row->key;
    return keys;
}
} // namespace

class TestRestorePlan : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { QTest::failOnWarning(QRegularExpression(word(".*"))); }

    void everyRowHasAReason();
    void unchangedRowsAreNotWritten();
    void valuesThatDoNotFitAreNotWritten_data();
    void valuesThatDoNotFitAreNotWritten();
    void betweenFamiliesOnlyEquivalentRegisters_data();
    void betweenFamiliesOnlyEquivalentRegisters();
    void limitsOfAnotherModelAreNotSelected_data();
    void limitsOfAnotherModelAreNotSelected();
    void aLimitThatWouldAlarmIsReported();
    void unmappedKeysAreListed();
    void theRateIsTranslatedBetweenFamilies();
    void namingARowSelectsIt();
    void aTemplateChangesOnlyItsRows();
    void theOrderIsSafe_data();
    void theOrderIsSafe();
    void readOnlyServosAreNotWritten();
    void everyReasonHasText_data();
    void everyReasonHasText();
};

void TestRestorePlan::everyRowHasAReason()
{
    snapshot::Snapshot snapshot = randomSnapshot(sts(), 3);
    setRaw(snapshot, "position_p", std::nullopt);
    setRaw(snapshot, "id", 9);
    setRaw(snapshot, "acceleration", 33);
    setRaw(snapshot, "goal_position", 99);
    const auto plan = jobs::planRestore(sts(), snapshot);
    QVERIFY(!plan.otherModel && !plan.otherFirmware && !plan.otherMap);
    QVERIFY(has(plan, "firmware_major", RestoreReason::ReadOnly));
    QVERIFY(has(plan, "max_speed_limit", RestoreReason::Factory));
    QVERIFY(has(plan, "id", RestoreReason::Identity));
    QVERIFY(has(plan, "goal_position", RestoreReason::Live));
    QVERIFY(has(plan, "lock", RestoreReason::Live));
    QVERIFY(has(plan, "acceleration", RestoreReason::OptIn));
    QVERIFY(has(plan, "position_offset", RestoreReason::MovesShaft));
    QVERIFY(has(plan, "operating_mode", RestoreReason::NeedsConsent));
    QVERIFY(has(plan, "position_p", RestoreReason::NoValue));
    QVERIFY(plan.find(word("acceleration"))->isSelectable);
    QVERIFY(!plan.find(word("acceleration"))->selected);
    QVERIFY(!plan.find(word("goal_position"))->isSelectable);
    QVERIFY(!plan.find(word("position_p"))->isSelectable);
    QCOMPARE(unmappedKeys(plan), QStringList{word("position_p")});
    // What may be written stands first.
    bool possible = true;
    for (const RestoreRow& row : plan.rows) {
        QVERIFY(possible || !row.isSelectable);
        possible = possible && row.isSelectable;
    }
}

void TestRestorePlan::unchangedRowsAreNotWritten()
{
    const auto plan = jobs::planRestore(sts(), jobs::snapshotOf(sts(), {}));
    QVERIFY(jobs::plannedWrites(plan).empty());
    QVERIFY(jobs::plannedSteps(plan).empty());
    QVERIFY(plan.unmappedRows().empty());
    QVERIFY(has(plan, "position_p", RestoreReason::Same));
}

void TestRestorePlan::valuesThatDoNotFitAreNotWritten_data()
{
    QTest::addColumn<QString>("key");
    QTest::addColumn<qlonglong>("raw");
    QTest::newRow("more than a byte") << word("position_p") << qlonglong(256);
    QTest::newRow("far more") << word("max_torque") << qlonglong(4'294'967'296);
    QTest::newRow("negative") << word("max_temperature") << qlonglong(-1);
    QTest::newRow("beyond the sheet") << word("max_torque") << qlonglong(1001);
    QTest::newRow("no such mode") << word("operating_mode") << qlonglong(77);
    QTest::newRow("offset") << word("position_offset") << qlonglong(5000);
}

void TestRestorePlan::valuesThatDoNotFitAreNotWritten()
{
    QFETCH(const QString, key);
    QFETCH(const qlonglong, raw);
    snapshot::Snapshot snapshot = jobs::snapshotOf(sts(), {});
    setRaw(snapshot, qPrintable(key), raw);
    jobs::RestoreChoice choice;
    choice.consent = device::Consent::confirmed();
    const auto plan = jobs::planRestore(sts(), snapshot, choice);
    QVERIFY(has(plan, qPrintable(key), RestoreReason::OutsideRange));
    QVERIFY(jobs::plannedWrites(plan).empty());
    QCOMPARE(unmappedKeys(plan), QStringList{key});
}

void TestRestorePlan::betweenFamiliesOnlyEquivalentRegisters_data()
{
    QTest::addColumn<int>("from");
    QTest::addColumn<int>("to");
    for (std::size_t from = 0; from < support::restoreFamilies.size(); ++from) {
        for (std::size_t to = 0; to < support::restoreFamilies.size(); ++to)
            QTest::addRow("%s to %s", support::restoreFamilies[from].name,
                          support::restoreFamilies[to].name)
                << int(from) << int(to);
    }
}

void TestRestorePlan::betweenFamiliesOnlyEquivalentRegisters()
{
    QFETCH(const int, from);
    QFETCH(const int, to);
    const support::Family& source = support::restoreFamilies[std::size_t(from)];
    const support::Family& target = support::restoreFamilies[std::size_t(to)];
    const device::Servo donor = servoOf(source.servos, source.baud);
    const device::Servo servo = servoOf(target.servos, target.baud);
    jobs::RestoreChoice choice;
    choice.consent = device::Consent::confirmed();
    choice.live = true;
    for (unsigned seed = 1; seed <= 5; ++seed) {
        const snapshot::Snapshot snapshot = randomSnapshot(donor, seed);
        const auto plan = jobs::planRestore(servo, snapshot, choice);
        QCOMPARE(plan.otherMap, donor.profile->mapKey != servo.profile->mapKey);
        for (const jobs::RestoreWrite& write : jobs::plannedWrites(plan)) {
            const catalog::Register& reg = *servo.profile->find(write.key);
            const catalog::ValueFormat meaning = servo.meaning(reg);
            const snapshot::SnapshotRegister* file = snapshot.find(write.key);
            QVERIFY2(!reg.identity && reg.writable(), qPrintable(write.key));
            QVERIFY2(!plan.otherMap || !meaning.unit.isEmpty(), qPrintable(write.key));
            QVERIFY2(file->unit == meaning.unit, qPrintable(write.key));
            const double off = std::abs(catalog::toPhysical(write.to, meaning) - *file->value);
            QVERIFY2(off <= 0.5001 * std::abs(meaning.scale), qPrintable(write.key));
        }
        // Nothing is lost from sight: what the file has is the same, possible, or has its reason.
        for (const snapshot::SnapshotRegister& file : snapshot.registers) {
            const RestoreRow* row = plan.find(file.key);
            QVERIFY2(row != nullptr &&
                         (row->isSelectable || row->reasons != jobs::RestoreReasons()),
                     qPrintable(file.key));
        }
    }
}

void TestRestorePlan::limitsOfAnotherModelAreNotSelected_data()
{
    QTest::addColumn<bool>("template_");
    QTest::newRow("snapshot") << false;
    QTest::newRow("template") << true;
}

/// An STS3215 for 8 V, an STS3250 at 12 V.
void TestRestorePlan::limitsOfAnotherModelAreNotSelected()
{
    QFETCH(bool, template_);
    const device::Servo strong = servoOf("sts3250@1", 1'000'000);
    snapshot::Snapshot snapshot = jobs::snapshotOf(sts(), word("test 1"));
    const std::array limits{"max_temperature", "max_voltage",        "min_voltage",
                            "max_torque",      "protection_current", "protection_torque",
                            "overload_torque", "torque_limit"};
    for (const char* key : limits)
        setValue(snapshot, strong, key, *strong.raw(word(key)) - 1);
    setValue(snapshot, strong, "position_p", 50);
    snapshot.isTemplate = template_;
    const auto plan = jobs::planRestore(strong, snapshot);
    QVERIFY(plan.otherModel);
    QCOMPARE(plan.sourceModel, word("STS3215"));
    QVERIFY(plan.find(word("position_p"))->selected);
    jobs::RestoreChoice withConsent;
    withConsent.consent = device::Consent::confirmed();
    withConsent.live = true;
    const auto dangerous = jobs::planRestore(strong, snapshot, withConsent);
    for (const char* key : limits) {
        QVERIFY2(has(plan, key, RestoreReason::OtherModelLimit), key);
        QVERIFY2(has(plan, key, RestoreReason::NeedsConsent), key);
        QVERIFY2(plan.find(word(key))->isSelectable && !plan.find(word(key))->selected, key);
        QVERIFY2(!dangerous.find(word(key))->selected, key); // consent is given to a name
        jobs::RestorePlan byHand = plan;
        QVERIFY(byHand.setSelected(word(key), true) && byHand.needsConsent());
    }
    withConsent.otherModelLimits = {word("max_temperature")};
    const auto named = jobs::planRestore(strong, snapshot, withConsent);
    QVERIFY(named.find(word("max_temperature"))->selected);
    QVERIFY(!named.find(word("max_voltage"))->selected);

    // To the same model they are rows like others.
    const auto same = jobs::planRestore(sts(), randomSnapshot(sts(), 5));
    for (const char* key : limits)
        QVERIFY2(!has(same, key, RestoreReason::OtherModelLimit), key);
}

void TestRestorePlan::aLimitThatWouldAlarmIsReported()
{
    device::Servo strong = servoOf("sts3250@1", 1'000'000); // at 12.0 V
    snapshot::Snapshot snapshot = jobs::snapshotOf(sts(), word("test 1"));
    const auto set = [&](const char* key, std::int64_t raw) {
        setValue(snapshot, strong, key, raw);
    };
    const auto alarms = [&] {
        QStringList found;
        const auto plan = jobs::planRestore(strong, snapshot);
        for (const RestoreRow* row : jobs::predictedAlarms(plan))
            found << row->key + QLatin1Char(' ') + row->alarm;
        return found;
    };
    set("max_temperature", *strong.raw(word("max_temperature")));
    set("min_voltage", *strong.raw(word("min_voltage")));
    const std::int64_t volts = *strong.raw(word("present_voltage"));
    set("max_voltage", 80);
    QCOMPARE(alarms(), QStringList{word("max_voltage voltage")});
    const auto plan = jobs::planRestore(strong, snapshot);
    QCOMPARE(plan.find(word("max_voltage"))->reading, double(volts) / 10);
    QCOMPARE(plan.find(word("max_voltage"))->readingUnit, word("V"));
    set("max_voltage", volts); // on its limit is not outside
    QCOMPARE(alarms(), QStringList());
    set("max_voltage", volts - 1);
    QCOMPARE(alarms(), QStringList{word("max_voltage voltage")});
    set("max_voltage", *strong.raw(word("max_voltage")));
    set("min_voltage", volts + 1);
    set("max_temperature", *strong.raw(word("present_temperature")) - 1);
    QStringList both = alarms();
    both.sort();
    QCOMPARE(both, (QStringList{word("max_temperature temperature"), word("min_voltage voltage")}));
}

void TestRestorePlan::unmappedKeysAreListed()
{
    const device::Servo scs = servoOf("scs15@1", 1'000'000);
    snapshot::Snapshot snapshot = randomSnapshot(sts(), 1);
    for (snapshot::SnapshotRegister& reg : snapshot.registers) {
        if (reg.key == word("max_torque"))
            reg.unit = word("mNm"); // an older file, or one of another program
    }
    const auto plan = jobs::planRestore(scs, snapshot);
    QVERIFY(plan.otherModel && plan.otherMap);
    const QStringList keys = unmappedKeys(plan);
    QVERIFY(keys.contains(word("operating_mode"))); // by its limits there
    QVERIFY(keys.contains(word("max_torque")));
    QVERIFY(has(plan, "operating_mode", RestoreReason::NoSuchRegister));
    QVERIFY(has(plan, "max_torque", RestoreReason::OtherMeaning));
    QVERIFY(has(plan, "position_p", RestoreReason::PlainNumber));
    QVERIFY(plan.find(word("position_p"))->isSelectable &&
            !plan.find(word("position_p"))->selected);
    QVERIFY(has(plan, "max_temperature", RestoreReason::OtherModelLimit));
    QVERIFY(!plan.find(word("max_temperature"))->selected);
    // The same angle, in this servo's steps.
    QVERIFY(has(plan, "max_angle_limit", RestoreReason::Converted));
    // The other way round: what only this servo has stays as it is.
    const auto back = jobs::planRestore(sts(), jobs::snapshotOf(scs, {}));
    QVERIFY(has(back, "operating_mode", RestoreReason::NotInFile));
}

void TestRestorePlan::theRateIsTranslatedBetweenFamilies()
{
    const device::Servo modbus = servoOf("smsmb@1", 115'200);
    snapshot::Snapshot snapshot = jobs::snapshotOf(sts(), {}); // 1 Mbaud: code 0
    snapshot.baud = 38'400;
    jobs::RestoreChoice choice;
    choice.identity = true;
    const auto plan = jobs::planRestore(modbus, snapshot, choice);
    const RestoreRow* rate = plan.find(word("baud_rate"));
    const catalog::Register* reg = modbus.profile->byRole(catalog::Role::BaudRate);
    const auto named = std::find_if(reg->values.begin(), reg->values.end(),
                                    [](const auto& value) { return value.key == word("38400"); });
    QVERIFY(named != reg->values.end());
    QCOMPARE(rate->newRaw.value(), named->value);
    snapshot.baud = 12'345;
    QVERIFY(
        has(jobs::planRestore(modbus, snapshot, choice), "baud_rate", RestoreReason::OtherMeaning));
}

void TestRestorePlan::namingARowSelectsIt()
{
    snapshot::Snapshot snapshot = randomSnapshot(sts(), 2);
    setRaw(snapshot, "acceleration", 33);
    jobs::RestoreChoice choice;
    choice.only = QStringList{word("acceleration"), word("position_d"), word("position_offset")};
    const auto plan = jobs::planRestore(sts(), snapshot, choice);
    QStringList keys;
    for (const jobs::RestoreWrite& write : jobs::plannedWrites(plan))
        keys << write.key;
    QCOMPARE(keys, (QStringList{word("position_d"), word("acceleration")}));
    QVERIFY(has(plan, "position_p", RestoreReason::NotChosen));
    QVERIFY(!plan.find(word("position_offset"))->selected); // dangerous all the same
}

void TestRestorePlan::aTemplateChangesOnlyItsRows()
{
    const auto chosen = snapshot::makeTemplate(randomSnapshot(sts(), 4),
                                               {word("position_p"), word("max_temperature")});
    const auto plan = jobs::planRestore(sts(), *chosen);
    QCOMPARE(plan.rows.size(), std::size_t(2));
    QCOMPARE(jobs::plannedWrites(plan).size(), std::size_t(2));
    QCOMPARE(plan.count(RestoreReason::NotInFile), 0);
}

void TestRestorePlan::theOrderIsSafe_data()
{
    QTest::addColumn<int>("family");
    for (std::size_t i = 0; i < support::restoreFamilies.size(); ++i)
        QTest::newRow(support::restoreFamilies[i].name) << int(i);
}

void TestRestorePlan::theOrderIsSafe()
{
    QFETCH(const int, family);
    const support::Family& kind = support::restoreFamilies[std::size_t(family)];
    const device::Servo servo = servoOf(kind.servos, kind.baud);
    snapshot::Snapshot snapshot = randomSnapshot(servo, 7);
    setRaw(snapshot, "id", 9);
    if (const catalog::Register* rate = servo.profile->byRole(catalog::Role::BaudRate))
        setRaw(snapshot, qPrintable(rate->key), servo.raw(*rate) == 1 ? 2 : 1);
    jobs::RestoreChoice choice;
    choice.consent = device::Consent::confirmed();
    choice.identity = choice.live = true;
    const auto plan = jobs::planRestore(servo, snapshot, choice);
    const auto writes = jobs::plannedWrites(plan);
    QVERIFY(writes.size() > 5);
    int unlocks = 0;
    int identity = 0;
    std::optional<catalog::Area> area;
    RestoreStage stage = RestoreStage::Limits;
    for (const jobs::RestoreWrite& write : writes) {
        const catalog::Register& reg = *servo.profile->find(write.key);
        QVERIFY2(identity == 0 || reg.identity, "a register behind the ID");
        identity += reg.identity ? 1 : 0;
        if (reg.identity)
            continue;
        if (area != reg.area)
            stage = RestoreStage::Limits;
        unlocks += area != reg.area ? 1 : 0;
        QVERIFY2(stage <= write.stage, qPrintable(write.key));
        stage = write.stage;
        area = reg.area;
    }
    QVERIFY(identity >= 1);
    QVERIFY(unlocks <= 3); // one run an area
    QCOMPARE(writes[writes.size() - std::size_t(identity)].stage, RestoreStage::Id);
    // Every step of opening has its closing, and torque comes first.
    const auto steps = jobs::plannedSteps(plan);
    QCOMPARE(steps.front().kind, jobs::RestoreStepKind::TorqueOff);
    int open = 0;
    for (const jobs::RestoreStep& step : steps) {
        open += step.kind == jobs::RestoreStepKind::Unlock ? 1 : 0;
        open -= step.kind == jobs::RestoreStepKind::Lock ? 1 : 0;
        QVERIFY(open == 0 || open == 1);
    }
    QCOMPARE(open, 0);
}

void TestRestorePlan::readOnlyServosAreNotWritten()
{
    device::Servo unknown = sts();
    catalog::Identity identity = sts().profile->identity;
    identity.firmwareMajor = 99;
    unknown.profile = support::builtInCatalog().resolve(identity);
    QVERIFY(!unknown.profile->writable);
    jobs::RestoreChoice choice;
    choice.consent = device::Consent::confirmed();
    choice.identity = choice.live = true;
    const auto plan = jobs::planRestore(unknown, randomSnapshot(sts(), 5), choice);
    QVERIFY(jobs::plannedWrites(plan).empty());
}

void TestRestorePlan::everyReasonHasText_data()
{
    QTest::addColumn<QString>("name");
    for (std::uint32_t bit = 0; bit < 32; ++bit) {
        const QString name = jobs::restoreReasonName(RestoreReason(1U << bit));
        if (!name.isEmpty())
            QTest::newRow(qPrintable(name)) << name;
    }
}

void TestRestorePlan::everyReasonHasText()
{
    QFETCH(const QString, name);
    text::installTranslator(QStringLiteral("en"));
    QVERIFY(!text::restoreReasonText(name).isEmpty());
    const bool isWord = !name.contains(QLatin1Char('-')) || name == QLatin1String("read-only");
    QVERIFY(isWord || text::restoreReasonText(name) != name);
    QVERIFY2(text::restoreReasonHelp(name).endsWith(QLatin1Char('.')), qPrintable(name));
}

SERVODESK_GUILESS_TEST(TestRestorePlan)
#include "tst_restore_plan.moc"
