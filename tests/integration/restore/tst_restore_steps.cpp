// SPDX-License-Identifier: GPL-3.0-or-later
// The dry run of a restore against the wire, on every family: each frame that changes the servo is
// taken apart by the bytes of its language, and what it changes in the simulated servo is a step of
// the list, in its order and with its value; nothing else is sent that could change anything.
#include "device/motion/motion.h"
#include "integration/restore_support.h"
#include "jobs/restore/restore.h"
#include "jobs/restore/take_snapshot.h"
#include "protocol/codec.h"
#include "support/test_main.h"
#include "support/text.h"

#include <QRegularExpression>
#include <QTest>

using catalog::Role;
using jobs::RestoreStepKind;
using support::SimFixture;
using support::TableValues;
using support::utf8;

namespace {
/// Bytes of the servo's table that a request writes.
struct ByteRange {
    int offset = 0;
    int bytes = 0;
};

int word(const base::Bytes& bytes, std::size_t at)
{
    return bytes[at] * 256 + bytes[at + 1];
}

/// Nullopt: it only asks.
std::optional<ByteRange> written(const base::Bytes& frame, base::Protocol protocol)
{
    if (protocol == base::Protocol::Feetech) {
        const auto request = protocol::scanFeetechRequest(frame);
        if (request.instruction != support::Write)
            return std::nullopt;
        return ByteRange{request.params[0], int(request.params.size()) - 1};
    }
    if (protocol == base::Protocol::Lx) {
        const auto request = protocol::scanLxRequest(frame);
        constexpr int saveOffset = 18;
        if (request.params.empty() && request.instruction != saveOffset)
            return std::nullopt;
        return ByteRange{request.instruction * 8, int(request.params.size())};
    }
    const auto request = protocol::scanModbusRequest(frame);
    constexpr int one = 0x06;
    constexpr int several = 0x10;
    if (request.instruction == one)
        return ByteRange{word(request.params, 0) * 2, 2};
    if (request.instruction == several)
        return ByteRange{word(request.params, 0) * 2, word(request.params, 2) * 2};
    return std::nullopt;
}

/// One change of a register: "operating_mode = 0". The lock's values are its own business.
QString change(const QString& key, std::int64_t raw)
{
    return key.startsWith(utf8("lock")) ? key : QStringLiteral("%1 = %2").arg(key).arg(raw);
}

/// What every frame changes, looked at when the next one goes out.
class WriteObserver {
public:
    WriteObserver(SimFixture& fixture, const device::Servo& servo)
        : m_fixture(fixture)
        , m_profile(servo.profile)
    {
        fixture.tap().onWrite = [this](const base::Bytes& frame) {
            observe();
            m_span = written(frame, m_profile->protocol);
            m_before = m_span ? covered(*m_span) : TableValues();
        };
    }
    ~WriteObserver() { m_fixture.tap().onWrite = nullptr; }
    WriteObserver(const WriteObserver&) = delete;
    WriteObserver& operator=(const WriteObserver&) = delete;

    QStringList changes()
    {
        observe();
        return m_changes;
    }
    int idle() const { return m_idle; } ///< writes that changed nothing
    int snapshotCount() const { return m_snapshotCount; }

private:
    TableValues covered(const ByteRange& span) const
    {
        TableValues values;
        for (const catalog::Register& reg : m_profile->registers) {
            if (reg.writable() && reg.writeOffset >= span.offset &&
                reg.writeOffset + reg.size <= span.offset + span.bytes)
                values[reg.key] = m_fixture.raw(1, reg.key);
        }
        return values;
    }

    void observe()
    {
        if (!m_span)
            return;
        const ByteRange span = *std::exchange(m_span, std::nullopt);
        m_snapshotCount += span.bytes == 0 ? 1 : 0;
        bool changed = span.bytes == 0;
        // In the order of the table, as the list has those that go out in one frame. What travels
        // in a block goes out with what is written.
        std::map<int, QString> now;
        for (const auto& [key, raw] : covered(span)) {
            if (m_before.at(key) != raw || !m_profile->find(key)->block)
                now[m_profile->find(key)->writeOffset] = change(key, raw);
        }
        for (const auto& [offset, what] : now)
            m_changes << what;
        m_idle += changed || !now.empty() ? 0 : 1;
    }

    SimFixture& m_fixture;
    catalog::ProfilePtr m_profile;
    std::optional<ByteRange> m_span;
    TableValues m_before;
    QStringList m_changes;
    int m_idle = 0;
    int m_snapshotCount = 0;
};

/// What the dry run promises. Torque that a command may switch on is switched off where it did.
QStringList plannedSteps(const jobs::RestorePlan& plan, const QStringList& happened)
{
    QStringList list;
    for (const jobs::RestoreStep& step : jobs::plannedSteps(plan)) {
        if (step.kind == RestoreStepKind::TorqueOff && step.from == 0)
            continue;
        const QString what = change(step.key, step.to.value_or(0));
        const bool perhaps = step.kind == RestoreStepKind::TorqueOff && !step.from;
        if (!perhaps || happened.value(list.size()) == what)
            list << what;
    }
    return list;
}

/// Where the two lists part; empty: nowhere.
QString firstDifference(const QStringList& happened, const QStringList& listed)
{
    for (qsizetype i = 0; i < std::max(happened.size(), listed.size()); ++i) {
        if (happened.value(i) != listed.value(i))
            return QStringLiteral("step %1: \"%2\" happened, \"%3\" is listed")
                .arg(i + 1)
                .arg(happened.value(i), listed.value(i));
    }
    return {};
}

/// Commands of all kinds stand in it, and it may be under torque.
void randomizeState(SimFixture& fixture, const device::Servo& servo, unsigned seed)
{
    for (const Role role : {Role::GoalSpeed, Role::GoalTime, Role::GoalCurrent}) {
        const catalog::Register* reg = servo.profile->byRole(role);
        if (reg != nullptr && reg->writable() && (seed % 3) != 0)
            fixture.poke(1, reg->key, 40 + int(seed));
    }
    const catalog::Register* torque = servo.profile->byRole(Role::TorqueSwitch);
    if (torque != nullptr && (seed % 2) == 0)
        fixture.poke(1, torque->key, 1);
}

jobs::RestoreChoice everythingLive()
{
    jobs::RestoreChoice choice;
    choice.consent = device::Consent::confirmed();
    choice.live = true;
    return choice;
}
} // namespace

class TestRestoreSteps : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { QTest::failOnWarning(QRegularExpression(utf8(".*"))); }

    void theListMatchesTheWire_data();
    void theListMatchesTheWire();
    void aRememberedSpeedIsInTheList_data();
    void aRememberedSpeedIsInTheList();
};

void TestRestoreSteps::theListMatchesTheWire_data()
{
    QTest::addColumn<int>("family");
    QTest::addColumn<int>("seed");
    for (int family = 0; family < int(support::restoreFamilies.size()); ++family) {
        for (int seed = 1; seed <= 24; ++seed)
            QTest::addRow("%s %d", support::restoreFamilies[std::size_t(family)].name, seed)
                << family << seed;
    }
}

void TestRestoreSteps::theListMatchesTheWire()
{
    QFETCH(const int, family);
    QFETCH(const int, seed);
    const support::Family& kind = support::restoreFamilies[std::size_t(family)];
    SimFixture fixture(utf8(kind.servos), support::atBaud(kind.baud));
    const TableValues factory = support::held(fixture);
    support::RandomTable random{unsigned(seed)};
    support::pokeAllPersistent(fixture, random.make(support::identifyWithTable(fixture)));
    const snapshot::Snapshot snapshot =
        jobs::snapshotOf(support::identifyWithTable(fixture), utf8("test 1"));
    // Now and then from one random table to another, else from the factory's.
    support::pokeAllPersistent(
        fixture, seed % 4 == 0 ? random.make(support::identifyWithTable(fixture)) : factory);
    randomizeState(fixture, support::identifyWithTable(fixture), unsigned(seed));
    fixture.runFor(std::chrono::seconds(1));

    device::Servo servo = support::identifyWithTable(fixture);
    const auto plan = jobs::planRestore(fixture.context(), servo, snapshot, everythingLive());
    WriteObserver observer(fixture, servo);
    const auto outcome =
        jobs::restore(fixture.context(), servo, plan, {device::Consent::confirmed(), {}, {}});
    QVERIFY2(outcome, outcome ? "" : qPrintable(outcome.error().detail));
    QCOMPARE(outcome->verdict, jobs::RestoreVerdict::Done);
    const QStringList happened = observer.changes();
    QCOMPARE(firstDifference(happened, plannedSteps(plan, happened)), QString());
    QCOMPARE(observer.idle(), 0);
    // The save command of LX belongs to the write of the one register that has one.
    const catalog::Register* offset = servo.profile->byRole(Role::PositionOffset);
    const bool writesOffset =
        offset != nullptr && offset->saveOffset >= 0 && !happened.filter(offset->key).isEmpty();
    QCOMPARE(observer.snapshotCount() > 0, writesOffset);
}

void TestRestoreSteps::aRememberedSpeedIsInTheList_data()
{
    QTest::addColumn<QString>("servos");
    QTest::addColumn<int>("baud");
    QTest::newRow("STS") << utf8("sts3215@1") << 1'000'000;
    QTest::newRow("SMS") << utf8("sm40blhv@1") << 115'200;
    QTest::newRow("HLS") << utf8("hls3606@1") << 1'000'000;
}

void TestRestoreSteps::aRememberedSpeedIsInTheList()
{
    QFETCH(const QString, servos);
    QFETCH(const int, baud);
    SimFixture fixture(servos, support::atBaud(baud));
    device::Servo servo = support::identifyWithTable(fixture);
    const snapshot::Snapshot snapshot = jobs::snapshotOf(servo, utf8("test 1"));
    const QString speed = servo.profile->byRole(Role::GoalSpeed)->key;
    fixture.poke(1, speed, 120);
    servo = support::identifyWithTable(fixture);
    QVERIFY(device::switchMode(fixture.context(), servo, utf8("speed"))->isSuccessful());
    QCOMPARE(fixture.raw(1, speed), 0);

    servo = support::identifyWithTable(fixture);
    const auto plan = jobs::planRestore(fixture.context(), servo, snapshot, everythingLive());
    WriteObserver observer(fixture, servo);
    QCOMPARE(jobs::restore(fixture.context(), servo, plan, {device::Consent::confirmed(), {}, {}})
                 ->verdict,
             jobs::RestoreVerdict::Done);
    const QStringList happened = observer.changes();
    QVERIFY(happened.contains(change(speed, 120)));
    QCOMPARE(firstDifference(happened, plannedSteps(plan, happened)), QString());
    QCOMPARE(observer.idle(), 0);
}

SERVODESK_GUILESS_TEST(TestRestoreSteps)
#include "tst_restore_steps.moc"
