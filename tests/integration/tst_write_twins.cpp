// SPDX-License-Identifier: GPL-3.0-or-later
// Two servos on one ID are not written to, whichever way the write is asked for; one servo on a
// poor line is. Against responders that know only bytes, and against the simulator for the
// languages of the trade.
#include "device/motion.h"
#include "device/reader.h"
#include "device/twin_check.h"
#include "device/write_access.h"
#include "jobs/blink.h"
#include "jobs/change.h"
#include "jobs/restore.h"
#include "jobs/scan.h"
#include "jobs/snapshot.h"
#include "jobs/stop_check.h"
#include "jobs/sweep.h"
#include "support/byte_line.h"
#include "support/memory_journal.h"
#include "support/sim_bench.h"
#include "text/error_words.h"

#include <QRegularExpression>
#include <QTest>

using base::ErrorCode;
using base::Protocol;
using std::chrono::milliseconds;
using support::ByteLine;
using support::byteSts;
using support::SimBench;

namespace {
/// A bus on responders that know only bytes.
struct Bytes {
    base::ManualClock clock;
    ByteLine line;
    support::MemoryJournal journal;
    base::Stop stop;
    device::Notices notices;
    std::unique_ptr<bus::BusCore> bus;

    void open()
    {
        bus = std::make_unique<bus::BusCore>(support::openByteLine(line, clock),
                                             protocol::feetechCodec(), clock);
        line.frames.clear();
    }
    device::Context context() { return {*bus, support::builtInCatalog(), journal, stop, notices}; }
    /// As it was identified before the second one was plugged in.
    device::Servo servo() const
    {
        device::Servo known;
        known.id = 1;
        known.baud = 1'000'000;
        known.profile = support::builtInCatalog().resolve({3, 10, 0, 9, 3});
        known.image.store(0, line.servos.front().table, {});
        return known;
    }
};

/// Every way to change a servo.
using Deed = std::function<base::Result<void>(const device::Context&, device::Servo&)>;

template <typename Answer>
base::Result<void> plain(const Answer& answer)
{
    return answer ? base::Result<void>() : tl::unexpected(answer.error());
}

base::Result<void> writeOne(const device::Context& context, device::Servo& servo, const char* key,
                            std::int64_t raw)
{
    device::WriteOptions options;
    options.dangerous = true;
    return plain(device::write(context, servo, {{QString::fromLatin1(key), raw}}, options));
}

base::Result<void> restoreOther(const device::Context& context, device::Servo& servo)
{
    if (const auto read = device::readAll(context, servo); !read)
        return read;
    auto snapshot = jobs::takeSnapshot(context, servo, QStringLiteral("test"));
    if (!snapshot)
        return tl::unexpected(snapshot.error());
    for (record::SnapshotRegister& row : snapshot->registers) {
        if (row.key == QLatin1String("max_temperature"))
            row.raw = 61;
    }
    return plain(jobs::restore(context, servo, jobs::planRestore(servo, *snapshot), {}));
}

base::Result<void> move(const device::Context& context, device::Servo& servo)
{
    auto plan = device::planMove(context, {&servo, QStringLiteral("2100")});
    if (!plan)
        return tl::unexpected(plan.error());
    std::vector<device::MovePlan> plans{*plan};
    return device::sendMoves(context, plans, device::MoveHow::Write);
}

base::Result<void> sweepOnce(const device::Context& context, device::Servo& servo)
{
    std::vector<device::Servo> servos{servo};
    jobs::SweepOrder order;
    order.limits.resize(1);
    return plain(jobs::sweep(context, servos, order, {}));
}

const std::vector<std::pair<const char*, Deed>>& deeds()
{
    using device::Context;
    using device::Servo;
    static const std::vector<std::pair<const char*, Deed>> all{
        {"write", [](const Context& context,
                     Servo& servo) { return writeOne(context, servo, "max_temperature", 61); }},
        {"temporary write",
         [](const Context& context, Servo& servo) {
             device::WriteOptions options;
             options.temporary = true;
             return plain(
                 device::write(context, servo, {{QStringLiteral("max_temperature"), 61}}, options));
         }},
        {"set-id", [](const Context& context,
                      Servo& servo) { return plain(jobs::changeId(context, servo, 9)); }},
        {"set-baud", [](const Context& context,
                        Servo& servo) { return plain(jobs::changeBaud(context, servo, 500'000)); }},
        {"torque on",
         [](const Context& context, Servo& servo) {
             return device::setTorque(context, servo, device::Torque::On);
         }},
        {"move", move},
        {"center",
         [](const Context& context, Servo& servo) { return plain(jobs::center(context, servo)); }},
        {"reboot",
         [](const Context& context, Servo& servo) { return plain(jobs::reboot(context, servo)); }},
        {"restore-defaults",
         [](const Context& context, Servo& servo) {
             return plain(jobs::restoreDefaults(context, servo));
         }},
        {"restore", restoreOther},
        {"blink",
         [](const Context& context, Servo& servo) {
             return plain(jobs::blink(context, servo, milliseconds(500)));
         }},
        {"sweep", sweepOnce},
    };
    return all;
}

enum class Second { OneAfterAnother, Collides, Late };
} // namespace
Q_DECLARE_METATYPE(Second)

class TestWriteTwins : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { QTest::failOnWarning(QRegularExpression(QStringLiteral(".*"))); }

    void nothingIsWrittenToTwoResponders_data();
    void nothingIsWrittenToTwoResponders();
    void nothingIsWrittenToSimulatedTwins_data();
    void nothingIsWrittenToSimulatedTwins();
    void identicalInStepCannotBeTold();
    void oneServoIsWrittenTo_data();
    void oneServoIsWrittenTo();
    void theLookCostsOnce();
    void aSearchIsFollowedByANewLook();
    void aNewIdNeedsNoSecondLook();
    void noiseIsAskedAgainAndNotRemembered();
    void aLostReplyIsNoSecondServo();
    void silenceIsNoSecondServo();
    void anEmergencyStopIsNotKeptWaiting();
    void torqueOffReachesBoth_data();
    void torqueOffReachesBoth();
};

void TestWriteTwins::nothingIsWrittenToTwoResponders_data()
{
    QTest::addColumn<int>("deed");
    QTest::addColumn<Second>("second");
    for (std::size_t i = 0; i < deeds().size(); ++i) {
        const char* name = deeds()[i].first;
        QTest::addRow("%s, one after the other", name) << int(i) << Second::OneAfterAnother;
        QTest::addRow("%s, colliding", name) << int(i) << Second::Collides;
        QTest::addRow("%s, second reply 60 ms late", name) << int(i) << Second::Late;
    }
}

void TestWriteTwins::nothingIsWrittenToTwoResponders()
{
    QFETCH(int, deed);
    QFETCH(Second, second);
    Bytes bench;
    bench.line.servos = {byteSts(1, 2048), byteSts(1, 900)};
    bench.line.servos[0].table[14] = 80;
    bench.line.servos[1].table[14] = 90;
    if (second != Second::Collides)
        bench.line.replies = ByteLine::Replies::OneAfterAnother;
    if (second == Second::Late) {
        bench.line.adapterLate = milliseconds(60);
        bench.line.secondLate = milliseconds(60);
    }
    bench.open();
    device::Servo servo = bench.servo();
    const auto done = deeds()[std::size_t(deed)].second(bench.context(), servo);
    QVERIFY(!done);
    // Colliding replies may not even be readable beforehand.
    const bool heard = done.error().code == ErrorCode::SeveralServos ||
                       (second == Second::Collides && done.error().code == ErrorCode::Garbled);
    QVERIFY2(heard, qPrintable(base::errorName(done.error().code)));
    QCOMPARE(bench.line.changingFrames(), 0);
    QCOMPARE(bench.line.writesTo(0) + bench.line.writesTo(1), 0);
    QCOMPARE(bench.journal.entries()->size(), std::size_t{0});
    if (done.error().code != ErrorCode::SeveralServos)
        return;
    const auto words = text::describe(done.error());
    QVERIFY2(words.remedy.contains(QLatin1String("one servo at a time")), qPrintable(words.remedy));
}

void TestWriteTwins::nothingIsWrittenToSimulatedTwins_data()
{
    QTest::addColumn<QString>("model");
    QTest::addColumn<int>("baud");
    QTest::addColumn<Protocol>("protocol");
    QTest::addColumn<QString>("key");
    QTest::addColumn<int>("latencyMs");
    for (const int latency : {0, 60}) {
        QTest::addRow("STS, %d ms", latency)
            << "STS3215" << 1'000'000 << Protocol::Feetech << "max_temperature" << latency;
        QTest::addRow("SCS, %d ms", latency)
            << "SCS15" << 1'000'000 << Protocol::Feetech << "max_temperature" << latency;
        QTest::addRow("Modbus, %d ms", latency)
            << "SMSMB" << 115'200 << Protocol::Modbus << "position_p" << latency;
        QTest::addRow("LX, %d ms", latency)
            << "LX-16A" << 115'200 << Protocol::Lx << "temp_limit" << latency;
    }
}

void TestWriteTwins::nothingIsWrittenToSimulatedTwins()
{
    QFETCH(QString, model);
    QFETCH(int, baud);
    QFETCH(Protocol, protocol);
    QFETCH(QString, key);
    QFETCH(int, latencyMs);
    support::BenchOptions options;
    options.baud = baud;
    options.wire.adapterLatency = milliseconds(latencyMs);
    const std::optional<int> rate = baud;
    SimBench alone({{model, 1, rate, {}, 180, {}, nullptr}}, options);
    const device::Servo known = alone.servo(1, protocol);
    for (const bool energise : {false, true}) {
        SimBench bench(
            {{model, 1, rate, {}, 180, {}, nullptr}, {model, 1, rate, {}, 95, {}, nullptr}},
            options);
        device::Servo servo = known;
        const auto before = servo.raw(key).value_or(0);
        const auto done = energise ? device::setTorque(bench.context(), servo, device::Torque::On)
                                   : writeOne(bench.context(), servo, qPrintable(key), before - 1);
        QVERIFY(!done);
        QCOMPARE(done.error().code, ErrorCode::SeveralServos);
        QVERIFY(bench.journal().entries()->empty());
        bench.withWire([&](sim::VirtualBus& wire) {
            for (sim::VirtualServo* each : wire.servos())
                QCOMPARE(each->raw(key), before);
        });
    }
}

// Said to be so in the help: content that is equal bit by bit, in step, looks like one servo.
void TestWriteTwins::identicalInStepCannotBeTold()
{
    Bytes bench;
    bench.line.servos = {byteSts(1), byteSts(1)};
    bench.open();
    device::Servo servo = bench.servo();
    QVERIFY(writeOne(bench.context(), servo, "max_temperature", 61));
    QCOMPARE(bench.line.servos[1].table[13], std::uint8_t(61));
}

void TestWriteTwins::oneServoIsWrittenTo_data()
{
    QTest::addColumn<int>("lateMs");
    QTest::addColumn<int>("spoilEvery"); ///< 0: none
    for (const int late : {0, 20, 60, 100}) {
        QTest::addRow("%d ms late", late) << late << 0;
        QTest::addRow("%d ms late, every 4th reply broken", late) << late << 4;
    }
    QTest::newRow("every 3rd reply broken") << 0 << 3;
}

void TestWriteTwins::oneServoIsWrittenTo()
{
    QFETCH(int, lateMs);
    QFETCH(int, spoilEvery);
    Bytes bench;
    bench.line.servos = {byteSts(1)};
    bench.line.adapterLate = milliseconds(lateMs);
    if (spoilEvery > 0) {
        bench.line.spoil = [spoilEvery](int n, base::Bytes& reply) {
            if (n % spoilEvery == spoilEvery - 1)
                reply[reply.size() / 2] ^= 0x10;
        };
    }
    bench.open();
    device::Servo servo = bench.servo();
    const auto done = writeOne(bench.context(), servo, "max_temperature", 61);
    QVERIFY2(done, done ? "" : qPrintable(text::describe(done.error()).what));
    QCOMPARE(bench.line.servos[0].table[13], std::uint8_t(61));
    QCOMPARE(bench.line.servos[0].table[55], std::uint8_t(1)); // locked again
}

void TestWriteTwins::theLookCostsOnce()
{
    Bytes bench;
    bench.line.servos = {byteSts(1)};
    bench.open();
    device::Servo servo = bench.servo();
    QVERIFY(device::beginWriting(bench.context(), servo, {}));
    QVERIFY(!bench.line.frames.empty());
    QCOMPARE(bench.line.changingFrames(), 0);
    bench.line.frames.clear();
    const base::Duration before = bench.clock.now();
    QVERIFY(device::requireVerified(bench.context(), servo, {}));
    QCOMPARE(bench.line.frames.size(), std::size_t{0});
    QCOMPARE(bench.clock.now(), before);
    QVERIFY(device::beginWriting(bench.context(), servo, {}));
    QCOMPARE(bench.line.frames.size(), std::size_t{1}); // who it is
    bench.open();                                       // another connection
    QVERIFY(device::beginWriting(bench.context(), servo, {}));
    QVERIFY(!bench.line.frames.empty());
}

void TestWriteTwins::aSearchIsFollowedByANewLook()
{
    SimBench bench(QStringLiteral("sts3215@1"));
    device::Servo servo = bench.servo(1);
    QVERIFY(writeOne(bench.context(), servo, "max_temperature", 61));
    QVERIFY(jobs::scan(bench.context(), {}));
    bench.forgetFrames();
    QVERIFY(device::beginWriting(bench.context(), servo, {}));
    QVERIFY(bench.frames(support::Read) > 0);
}

void TestWriteTwins::aNewIdNeedsNoSecondLook()
{
    SimBench bench(QStringLiteral("sts3215@1"));
    device::Servo servo = bench.servo(1);
    QVERIFY(jobs::changeId(bench.context(), servo, 9));
    QCOMPARE(servo.id, 9);
    bench.forgetFrames();
    QVERIFY(device::beginWriting(bench.context(), servo, {}));
    QCOMPARE(bench.frameCount(), std::size_t{1}); // who it is
}

// On a line that breaks everything nothing is written; the next attempt looks afresh.
void TestWriteTwins::noiseIsAskedAgainAndNotRemembered()
{
    Bytes bench;
    bench.line.servos = {byteSts(1)};
    bench.line.spoil = [](int, base::Bytes& reply) { reply[reply.size() / 2] ^= 0x10; };
    bench.open();
    device::Servo servo = bench.servo();
    const auto refused = writeOne(bench.context(), servo, "max_temperature", 61);
    QVERIFY(!refused);
    QCOMPARE(refused.error().code, ErrorCode::SeveralServos);
    const auto words = text::describe(refused.error());
    QVERIFY2(words.what.contains(QRegularExpression(QStringLiteral("\\d+ of \\d+"))),
             qPrintable(words.what));
    QCOMPARE(bench.line.changingFrames(), 0);
    bench.line.spoil = nullptr;
    QVERIFY(writeOne(bench.context(), servo, "max_temperature", 61));
}

// The firmware's span is never answered: that is no sign of a second servo.
void TestWriteTwins::aLostReplyIsNoSecondServo()
{
    Bytes bench;
    bench.line.servos = {byteSts(1)};
    bench.line.spoil = [](int, base::Bytes& reply) {
        if (reply.size() > 7 && reply[5] == 3 && reply[6] == 10)
            reply.clear();
    };
    bench.open();
    device::Servo servo = bench.servo();
    const auto refused = device::beginWriting(bench.context(), servo, QStringLiteral("write"));
    QVERIFY(!refused);
    QCOMPARE(refused.error().code, ErrorCode::NoAnswer);
    QCOMPARE(refused.error().id, 1);
}

/// One unreadable reply, and then the cable is out.
void TestWriteTwins::silenceIsNoSecondServo()
{
    Bytes bench;
    bench.line.servos = {byteSts(1)};
    bench.line.spoil = [told = false](int, base::Bytes& reply) mutable {
        if (std::exchange(told, true))
            reply.clear();
        else
            reply.back() ^= 0xFF;
    };
    bench.open();
    device::Servo servo = bench.servo();
    const auto refused = device::beginWriting(bench.context(), servo, QStringLiteral("write"));
    QVERIFY(!refused);
    QCOMPARE(refused.error().code, ErrorCode::NoAnswer);
}

void TestWriteTwins::torqueOffReachesBoth_data()
{
    QTest::addColumn<bool>("halt");
    QTest::addColumn<bool>("collide");
    QTest::addColumn<int>("mode");
    for (const bool collide : {false, true}) {
        const char* how = collide ? "colliding" : "in turn";
        QTest::addRow("off, %s", how) << false << collide << 0;
        QTest::addRow("stop, %s", how) << true << collide << 0;
        QTest::addRow("stop of wheels, %s", how) << true << collide << 1;
    }
}

void TestWriteTwins::torqueOffReachesBoth()
{
    QFETCH(bool, halt);
    QFETCH(bool, collide);
    QFETCH(int, mode);
    constexpr std::uint8_t goal = 4; // its high byte: 1024
    Bytes bench;
    bench.line.servos = {byteSts(1, 2048), byteSts(1, 900)};
    bench.line.servos[1].table[14] = 90;
    if (!collide)
        bench.line.replies = ByteLine::Replies::OneAfterAnother;
    for (support::ByteServo& one : bench.line.servos) {
        one.table[33] = std::uint8_t(mode);
        one.table[40] = 1;
        one.table[43] = goal;
    }
    bench.open();
    device::Servo servo = bench.servo();
    const auto done = halt ? device::halt(bench.context(), servo)
                           : device::setTorque(bench.context(), servo, device::Torque::Off);
    for (const support::ByteServo& one : bench.line.servos) {
        QCOMPARE(one.table[40], std::uint8_t(0));
        QCOMPARE(one.table[43], goal); // the place of one is not the other's
    }
    QVERIFY(!done);
    const auto words = text::describe(done.error());
    QVERIFY2(words.what.contains(QLatin1String("Torque off was sent")), qPrintable(words.what));
}

void TestWriteTwins::anEmergencyStopIsNotKeptWaiting()
{
    Bytes bench;
    bench.line.servos = {byteSts(1, 2048), byteSts(1, 900)};
    bench.line.replies = ByteLine::Replies::OneAfterAnother;
    for (support::ByteServo& one : bench.line.servos)
        one.table[40] = 1;
    bench.open();
    device::Servo servo = bench.servo();
    const auto verdicts = jobs::checkStopped(bench.context(), {&servo});
    QVERIFY(verdicts);
    QCOMPARE(bench.line.servos[0].table[40], std::uint8_t(0));
    QCOMPARE(bench.line.servos[1].table[40], std::uint8_t(0));
}

QTEST_GUILESS_MAIN(TestWriteTwins)
#include "tst_write_twins.moc"
