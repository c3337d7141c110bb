// SPDX-License-Identifier: GPL-3.0-or-later
// A servo whose firmware, byte order flag and model number do not belong together, or with a
// strange byte at the lock's place: it is read, and no path writes to it.
#include "device/motion/motion.h"
#include "device/reader.h"
#include "device/write_access.h"
#include "jobs/change/blink.h"
#include "jobs/change/change.h"
#include "jobs/change/clear_alarm.h"
#include "jobs/restore/restore.h"
#include "jobs/restore/take_snapshot.h"
#include "jobs/step/step_response.h"
#include "jobs/stop_check.h"
#include "jobs/sweep/sweep.h"
#include "support/memory_journal.h"
#include "support/raw_servo_line.h"
#include "support/sim_fixture.h"
#include "support/test_main.h"
#include "text/error_text.h"

#include <QRegularExpression>
#include <QTest>

using base::ErrorCode;
using support::RawServoLine;
using support::rawSts3215;

namespace {
struct ConflictFixture {
    base::ManualClock clock;
    RawServoLine line;
    support::MemoryJournal journal;
    base::StopToken stop;
    device::Notices notices;
    std::unique_ptr<bus::BusCore> bus;

    explicit ConflictFixture(const support::RawServo& servo)
    {
        line.servos = {servo};
        bus = std::make_unique<bus::BusCore>(support::openRawServoLine(line, clock),
                                             protocol::feetechCodec(), clock);
        line.frames.clear();
    }
    device::Context context() { return {*bus, support::builtInCatalog(), journal, stop, notices}; }
};

/// Firmware 3.25, byte order flag 1, model 9.3: the list has it as an STS3215.
support::RawServo conflictingServo()
{
    support::RawServo servo = rawSts3215(1);
    servo.table[1] = 25;
    servo.table[2] = 1;
    return servo;
}

support::RawServo invalidLockServo()
{
    support::RawServo servo = rawSts3215(1);
    servo.table[55] = 77;
    return servo;
}

template <typename Answer>
void refused(const Answer& answer, ConflictFixture& fixture, const char* path)
{
    QVERIFY2(!answer, path);
    QVERIFY2(answer.error().code == ErrorCode::FamilyConflict,
             qPrintable(QLatin1String(path) + QLatin1String(": ") +
                        base::errorName(answer.error().code)));
    QVERIFY2(fixture.line.writeFrameCount() == 0, path);
}

base::Result<void> move(const device::Context& context, device::Servo& servo)
{
    auto plan = device::planMove(context, {&servo, QStringLiteral("2100")});
    if (!plan)
        return tl::unexpected(plan.error());
    std::vector<device::MovePlan> plans{*plan};
    return device::sendMoves(context, plans, device::MoveMethod::Write);
}
} // namespace

class TestFamilyConflict : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { QTest::failOnWarning(QRegularExpression(QStringLiteral(".*"))); }

    void nothingWrites_data();
    void nothingWrites();
    void everythingCanBeRead();
    void theFactsAreReported_data();
    void theFactsAreReported();
    void emergencyStopIsAllowed();
    void torqueGoesOff_data();
    void torqueGoesOff();
    void aValidLockAllowsWriting();
};

void TestFamilyConflict::nothingWrites_data()
{
    QTest::addColumn<bool>("lockOnly");
    QTest::newRow("firmware, flag and model") << false;
    QTest::newRow("byte at the lock") << true;
}

void TestFamilyConflict::nothingWrites()
{
    QFETCH(bool, lockOnly);
    ConflictFixture fixture(lockOnly ? invalidLockServo() : conflictingServo());
    const auto context = fixture.context();
    auto found = device::identify(context, 1);
    QVERIFY(found);
    device::Servo& servo = *found;
    const device::WriteItem item{
        lockOnly ? QStringLiteral("max_temperature") : QStringLiteral("byte_13"), 61};
    refused(device::write(context, servo, {item}, {}), fixture, "write");
    for (const auto torque : {device::Torque::On, device::Torque::Damp})
        refused(device::setTorque(context, servo, torque), fixture, "torque");
    refused(move(context, servo), fixture, "move");
    refused(jobs::changeId(context, servo, 9), fixture, "set-id");
    refused(jobs::changeBaud(context, servo, 500'000), fixture, "set-baud");
    refused(jobs::center(context, servo), fixture, "center");
    refused(jobs::reboot(context, servo), fixture, "reboot");
    refused(jobs::restoreDefaults(context, servo), fixture, "restore-defaults");
    refused(jobs::blink(context, servo, std::chrono::seconds(1)), fixture, "blink");
    std::vector<device::Servo> servos{servo};
    jobs::SweepRequest sweep;
    sweep.limits.resize(1);
    refused(jobs::sweep(context, servos, sweep, {}), fixture, "sweep");
    refused(jobs::stepResponse(context, servo, {}, {}), fixture, "step-response");
    QVERIFY(fixture.journal.entries()->empty());
}

void TestFamilyConflict::everythingCanBeRead()
{
    ConflictFixture fixture(conflictingServo());
    auto servo = device::identify(fixture.context(), 1);
    QVERIFY(servo);
    QVERIFY(servo->profile->conflict);
    QVERIFY(device::readAll(fixture.context(), *servo));
    const base::Bytes& table = fixture.line.servos[0].table;
    for (int place = 0; place <= 70; ++place) {
        const catalog::Register* reg = servo->profile->at(place);
        QVERIFY(reg != nullptr);
        QCOMPARE(reg->size, 1); // no number that a wrong byte order could turn into a lie
        QVERIFY(!reg->writable());
        QCOMPARE(servo->raw(*reg), std::int64_t{table[std::size_t(place)]});
    }
    QCOMPARE(fixture.line.writeFrameCount(), 0);
}

void TestFamilyConflict::theFactsAreReported_data()
{
    QTest::addColumn<bool>("lockOnly");
    QTest::addColumn<QStringList>("facts");
    const auto list = [](std::initializer_list<const char*> words) {
        QStringList all;
        for (const char* word : words)
            all << QString::fromLatin1(word);
        return all;
    };
    QTest::newRow("three") << false
                           << list({"firmware 3.25 (SCS2/STS)", "byte order flag 1",
                                    "9.3 (STS3215, byte order flag 0)"});
    QTest::newRow("and the lock") << true
                                  << list({"firmware 3.10", "byte order flag 0", "9.3 (STS3215",
                                           "address 55", "the byte at that address is 77"});
}

void TestFamilyConflict::theFactsAreReported()
{
    QFETCH(bool, lockOnly);
    QFETCH(QStringList, facts);
    ConflictFixture fixture(lockOnly ? invalidLockServo() : conflictingServo());
    auto servo = device::identify(fixture.context(), 1);
    QVERIFY(servo);
    const auto refusal = device::setTorque(fixture.context(), *servo, device::Torque::On);
    QVERIFY(!refusal);
    const auto words = text::describe(refusal.error());
    for (const QString& fact : facts)
        QVERIFY2(words.message.contains(fact), qPrintable(words.message));
    QVERIFY(!words.remedy.isEmpty());
    // Every view of the servo shows the same, once the byte has been read.
    QVERIFY(device::readAll(fixture.context(), *servo));
    const auto bar = device::writeObstacle(*servo);
    QVERIFY(bar);
    QCOMPARE(bar->detail, refusal.error().detail);
}

void TestFamilyConflict::emergencyStopIsAllowed()
{
    support::RawServo servo = conflictingServo();
    servo.table[40] = 1;
    ConflictFixture fixture(servo);
    auto found = device::identify(fixture.context(), 1);
    QVERIFY(found);
    const auto verdicts = jobs::verifyEmergencyStop(fixture.context(), {&*found});
    QVERIFY(verdicts);
    QVERIFY(verdicts->front().torque == jobs::StopCheckResult::Torque::Off);
    QCOMPARE(fixture.line.servos[0].table[40], std::uint8_t(0));
}

void TestFamilyConflict::torqueGoesOff_data()
{
    QTest::addColumn<bool>("lockOnly");
    QTest::addColumn<bool>("halt");
    for (const bool lockOnly : {false, true}) {
        QTest::addRow("off, %s", lockOnly ? "lock" : "facts") << lockOnly << false;
        QTest::addRow("stop, %s", lockOnly ? "lock" : "facts") << lockOnly << true;
    }
}

/// Its switch has the same place in every table.
void TestFamilyConflict::torqueGoesOff()
{
    QFETCH(bool, lockOnly);
    QFETCH(bool, halt);
    support::RawServo servo = lockOnly ? invalidLockServo() : conflictingServo();
    servo.table[40] = 1;
    ConflictFixture fixture(servo);
    auto found = device::identify(fixture.context(), 1);
    QVERIFY(found);
    const auto done = halt ? device::halt(fixture.context(), *found)
                           : device::setTorque(fixture.context(), *found, device::Torque::Off);
    QVERIFY(done); // reading has shown it
    support::RawServo off = servo;
    off.table[40] = 0;
    QCOMPARE(fixture.line.servos[0].table, off.table);
    QCOMPARE(fixture.notices.back().code, device::NoticeCode::TorqueSwitchedOff);
}

void TestFamilyConflict::aValidLockAllowsWriting()
{
    ConflictFixture fixture(invalidLockServo());
    auto servo = device::identify(fixture.context(), 1);
    QVERIFY(servo);
    const device::WriteItem item{QStringLiteral("max_temperature"), 61};
    QVERIFY(!device::write(fixture.context(), *servo, {item}, {}));
    fixture.line.servos[0].table[55] = 1; // switched off and on
    const auto report = device::write(fixture.context(), *servo, {item}, {});
    QVERIFY(report);
    QVERIFY(report->isSuccessful());
    QCOMPARE(fixture.line.servos[0].table[13], std::uint8_t(61));
}

SERVODESK_GUILESS_TEST(TestFamilyConflict)
#include "tst_family_conflict.moc"
