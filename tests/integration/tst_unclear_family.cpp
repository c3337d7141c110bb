// SPDX-License-Identifier: GPL-3.0-or-later
// A servo whose firmware, byte order flag and model number do not belong together, or with a
// strange byte at the lock's place: it is read, and no path writes to it.
#include "device/motion.h"
#include "device/reader.h"
#include "device/write_access.h"
#include "jobs/blink.h"
#include "jobs/change.h"
#include "jobs/clear_alarm.h"
#include "jobs/restore.h"
#include "jobs/snapshot.h"
#include "jobs/step_response.h"
#include "jobs/stop_check.h"
#include "jobs/sweep.h"
#include "support/byte_line.h"
#include "support/memory_journal.h"
#include "support/sim_bench.h"
#include "text/error_words.h"

#include <QRegularExpression>
#include <QTest>

using base::ErrorCode;
using support::ByteLine;
using support::byteSts;

namespace {
struct Bench {
    base::ManualClock clock;
    ByteLine line;
    support::MemoryJournal journal;
    base::Stop stop;
    device::Notices notices;
    std::unique_ptr<bus::BusCore> bus;

    explicit Bench(const support::ByteServo& servo)
    {
        line.servos = {servo};
        bus = std::make_unique<bus::BusCore>(support::openByteLine(line, clock),
                                             protocol::feetechCodec(), clock);
        line.frames.clear();
    }
    device::Context context() { return {*bus, support::builtInCatalog(), journal, stop, notices}; }
};

/// Firmware 3.25, byte order flag 1, model 9.3: the list has it as an STS3215.
support::ByteServo contradicting()
{
    support::ByteServo servo = byteSts(1);
    servo.table[1] = 25;
    servo.table[2] = 1;
    return servo;
}

support::ByteServo strangeLock()
{
    support::ByteServo servo = byteSts(1);
    servo.table[55] = 77;
    return servo;
}

template <typename Answer>
void refused(const Answer& answer, Bench& bench, const char* path)
{
    QVERIFY2(!answer, path);
    QVERIFY2(answer.error().code == ErrorCode::FamilyUnclear,
             qPrintable(QLatin1String(path) + QLatin1String(": ") +
                        base::errorName(answer.error().code)));
    QVERIFY2(bench.line.changingFrames() == 0, path);
}

base::Result<void> move(const device::Context& context, device::Servo& servo)
{
    auto plan = device::planMove(context, {&servo, QStringLiteral("2100")});
    if (!plan)
        return tl::unexpected(plan.error());
    std::vector<device::MovePlan> plans{*plan};
    return device::sendMoves(context, plans, device::MoveHow::Write);
}
} // namespace

class TestUnclearFamily : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { QTest::failOnWarning(QRegularExpression(QStringLiteral(".*"))); }

    void noPathWrites_data();
    void noPathWrites();
    void everythingCanBeRead();
    void theFactsAreNamed_data();
    void theFactsAreNamed();
    void emergencyStopIsAllowed();
    void torqueGoesOff_data();
    void torqueGoesOff();
    void onceTheLockIsWellItIsWrittenTo();
};

void TestUnclearFamily::noPathWrites_data()
{
    QTest::addColumn<bool>("lockOnly");
    QTest::newRow("firmware, flag and model") << false;
    QTest::newRow("byte at the lock") << true;
}

void TestUnclearFamily::noPathWrites()
{
    QFETCH(bool, lockOnly);
    Bench bench(lockOnly ? strangeLock() : contradicting());
    const auto context = bench.context();
    auto found = device::identify(context, 1);
    QVERIFY(found);
    device::Servo& servo = *found;
    const device::WriteItem item{
        lockOnly ? QStringLiteral("max_temperature") : QStringLiteral("byte_13"), 61};
    refused(device::write(context, servo, {item}, {}), bench, "write");
    for (const auto torque : {device::Torque::On, device::Torque::Damp})
        refused(device::setTorque(context, servo, torque), bench, "torque");
    refused(move(context, servo), bench, "move");
    refused(jobs::changeId(context, servo, 9), bench, "set-id");
    refused(jobs::changeBaud(context, servo, 500'000), bench, "set-baud");
    refused(jobs::center(context, servo), bench, "center");
    refused(jobs::reboot(context, servo), bench, "reboot");
    refused(jobs::restoreDefaults(context, servo), bench, "restore-defaults");
    refused(jobs::blink(context, servo, std::chrono::seconds(1)), bench, "blink");
    std::vector<device::Servo> servos{servo};
    jobs::SweepOrder sweep;
    sweep.limits.resize(1);
    refused(jobs::sweep(context, servos, sweep, {}), bench, "sweep");
    refused(jobs::stepResponse(context, servo, {}, {}), bench, "step-response");
    QVERIFY(bench.journal.entries()->empty());
}

void TestUnclearFamily::everythingCanBeRead()
{
    Bench bench(contradicting());
    auto servo = device::identify(bench.context(), 1);
    QVERIFY(servo);
    QVERIFY(servo->profile->conflict);
    QVERIFY(device::readAll(bench.context(), *servo));
    const base::Bytes& table = bench.line.servos[0].table;
    for (int place = 0; place <= 70; ++place) {
        const catalog::Register* reg = servo->profile->at(place);
        QVERIFY(reg != nullptr);
        QCOMPARE(reg->size, 1); // no number that a wrong byte order could turn into a lie
        QVERIFY(!reg->writable());
        QCOMPARE(servo->raw(*reg), std::int64_t{table[std::size_t(place)]});
    }
    QCOMPARE(bench.line.changingFrames(), 0);
}

void TestUnclearFamily::theFactsAreNamed_data()
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
                                           "address 55", "77 stands there"});
}

void TestUnclearFamily::theFactsAreNamed()
{
    QFETCH(bool, lockOnly);
    QFETCH(QStringList, facts);
    Bench bench(lockOnly ? strangeLock() : contradicting());
    auto servo = device::identify(bench.context(), 1);
    QVERIFY(servo);
    const auto refusal = device::setTorque(bench.context(), *servo, device::Torque::On);
    QVERIFY(!refusal);
    const auto words = text::describe(refusal.error());
    for (const QString& fact : facts)
        QVERIFY2(words.what.contains(fact), qPrintable(words.what));
    QVERIFY(!words.remedy.isEmpty());
    // Whoever shows the servo says the same, once the byte has been read.
    QVERIFY(device::readAll(bench.context(), *servo));
    const auto bar = device::writeBar(*servo);
    QVERIFY(bar);
    QCOMPARE(bar->detail, refusal.error().detail);
}

void TestUnclearFamily::emergencyStopIsAllowed()
{
    support::ByteServo servo = contradicting();
    servo.table[40] = 1;
    Bench bench(servo);
    auto found = device::identify(bench.context(), 1);
    QVERIFY(found);
    const auto verdicts = jobs::checkStopped(bench.context(), {&*found});
    QVERIFY(verdicts);
    QVERIFY(verdicts->front().torque == jobs::StopVerdict::Torque::Off);
    QCOMPARE(bench.line.servos[0].table[40], std::uint8_t(0));
}

void TestUnclearFamily::torqueGoesOff_data()
{
    QTest::addColumn<bool>("lockOnly");
    QTest::addColumn<bool>("halt");
    for (const bool lockOnly : {false, true}) {
        QTest::addRow("off, %s", lockOnly ? "lock" : "facts") << lockOnly << false;
        QTest::addRow("stop, %s", lockOnly ? "lock" : "facts") << lockOnly << true;
    }
}

/// Its switch has the same place in every table.
void TestUnclearFamily::torqueGoesOff()
{
    QFETCH(bool, lockOnly);
    QFETCH(bool, halt);
    support::ByteServo servo = lockOnly ? strangeLock() : contradicting();
    servo.table[40] = 1;
    Bench bench(servo);
    auto found = device::identify(bench.context(), 1);
    QVERIFY(found);
    const auto done = halt ? device::halt(bench.context(), *found)
                           : device::setTorque(bench.context(), *found, device::Torque::Off);
    QVERIFY(done); // reading has shown it
    support::ByteServo off = servo;
    off.table[40] = 0;
    QCOMPARE(bench.line.servos[0].table, off.table);
    QCOMPARE(bench.notices.back().code, device::NoticeCode::TorqueSwitchedOff);
}

void TestUnclearFamily::onceTheLockIsWellItIsWrittenTo()
{
    Bench bench(strangeLock());
    auto servo = device::identify(bench.context(), 1);
    QVERIFY(servo);
    const device::WriteItem item{QStringLiteral("max_temperature"), 61};
    QVERIFY(!device::write(bench.context(), *servo, {item}, {}));
    bench.line.servos[0].table[55] = 1; // switched off and on
    const auto report = device::write(bench.context(), *servo, {item}, {});
    QVERIFY(report);
    QVERIFY(report->allGood());
    QCOMPARE(bench.line.servos[0].table[13], std::uint8_t(61));
}

QTEST_GUILESS_MAIN(TestUnclearFamily)
#include "tst_unclear_family.moc"
