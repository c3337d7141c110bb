// SPDX-License-Identifier: GPL-3.0-or-later
// Two servos on one ID are not written to, by any kind of write; one servo on a
// poor line is. Against responders that know only bytes, and against the simulator for the
// protocols of the trade.
#include "device/duplicate_id_check.h"
#include "device/motion/motion.h"
#include "device/reader.h"
#include "device/write_access.h"
#include "jobs/change/blink.h"
#include "jobs/change/change.h"
#include "jobs/restore/restore.h"
#include "jobs/restore/take_snapshot.h"
#include "jobs/scan/scan.h"
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
using base::Protocol;
using std::chrono::milliseconds;
using support::RawServoLine;
using support::rawSts3215;
using support::SimFixture;

namespace {
/// A bus on responders that know only bytes.
struct DuplicateIdFixture {
    base::ManualClock clock;
    RawServoLine line;
    support::MemoryJournal journal;
    base::StopToken stop;
    device::Notices notices;
    std::unique_ptr<bus::BusCore> bus;

    void open()
    {
        bus = std::make_unique<bus::BusCore>(support::openRawServoLine(line, clock),
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
using Action = std::function<base::Result<void>(const device::Context&, device::Servo&)>;

template <typename Answer>
base::Result<void> plain(const Answer& answer)
{
    return answer ? base::Result<void>() : tl::unexpected(answer.error());
}

base::Result<void> writeRegister(const device::Context& context, device::Servo& servo,
                                 const char* key, std::int64_t raw)
{
    device::WriteOptions options;
    options.consent = device::Consent::confirmed();
    return plain(device::write(context, servo, {{QString::fromLatin1(key), raw}}, options));
}

base::Result<void> restoreOtherSnapshot(const device::Context& context, device::Servo& servo)
{
    if (const auto read = device::readAll(context, servo); !read)
        return read;
    auto snapshot = jobs::takeSnapshot(context, servo, QStringLiteral("test"));
    if (!snapshot)
        return tl::unexpected(snapshot.error());
    for (snapshot::SnapshotRegister& row : snapshot->registers) {
        if (row.key == QLatin1String("max_temperature"))
            row.raw = 61;
    }
    return plain(jobs::restore(context, servo, jobs::planRestore(servo, *snapshot), {}));
}

base::Result<void> moveOnce(const device::Context& context, device::Servo& servo)
{
    auto plan = device::planMove(context, {&servo, QStringLiteral("2100")});
    if (!plan)
        return tl::unexpected(plan.error());
    std::vector<device::MovePlan> plans{*plan};
    return device::sendMoves(context, plans, device::MoveMethod::Write);
}

base::Result<void> sweepOnce(const device::Context& context, device::Servo& servo)
{
    std::vector<device::Servo> servos{servo};
    jobs::SweepRequest order;
    order.limits.resize(1);
    return plain(jobs::sweep(context, servos, order, {}));
}

const std::vector<std::pair<const char*, Action>>& actions()
{
    using device::Context;
    using device::Servo;
    static const std::vector<std::pair<const char*, Action>> all{
        {"write",
         [](const Context& context, Servo& servo) {
             return writeRegister(context, servo, "max_temperature", 61);
         }},
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
        {"move", moveOnce},
        {"center",
         [](const Context& context, Servo& servo) { return plain(jobs::center(context, servo)); }},
        {"reboot",
         [](const Context& context, Servo& servo) { return plain(jobs::reboot(context, servo)); }},
        {"restore-defaults",
         [](const Context& context, Servo& servo) {
             return plain(jobs::restoreDefaults(context, servo));
         }},
        {"restore", restoreOtherSnapshot},
        {"blink",
         [](const Context& context, Servo& servo) {
             return plain(jobs::blink(context, servo, milliseconds(500)));
         }},
        {"sweep", sweepOnce},
    };
    return all;
}

enum class SecondReply { Sequential, Collides, Delayed };
} // namespace

class TestWriteDuplicateId : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { QTest::failOnWarning(QRegularExpression(QStringLiteral(".*"))); }

    void nothingIsWrittenToTwoResponders_data();
    void nothingIsWrittenToTwoResponders();
    void nothingIsWrittenToSimulatedDuplicates_data();
    void nothingIsWrittenToSimulatedDuplicates();
    void identicalSynchronousServosAreIndistinguishable();
    void aSingleServoIsWritten_data();
    void aSingleServoIsWritten();
    void theCheckIsDoneOnce();
    void aSearchIsFollowedByANewCheck();
    void aNewIdNeedsNoSecondCheck();
    void noiseIsRetriedAndNotRemembered();
    void aLostReplyIsNoSecondServo();
    void silenceIsNoSecondServo();
    void anEmergencyStopDoesNotWait();
    void torqueOffReachesBoth_data();
    void torqueOffReachesBoth();
};

void TestWriteDuplicateId::nothingIsWrittenToTwoResponders_data()
{
    QTest::addColumn<int>("action");
    QTest::addColumn<SecondReply>("second");
    for (std::size_t i = 0; i < actions().size(); ++i) {
        const char* name = actions()[i].first;
        QTest::addRow("%s, one after the other", name) << int(i) << SecondReply::Sequential;
        QTest::addRow("%s, colliding", name) << int(i) << SecondReply::Collides;
        QTest::addRow("%s, second reply 60 ms late", name) << int(i) << SecondReply::Delayed;
    }
}

void TestWriteDuplicateId::nothingIsWrittenToTwoResponders()
{
    QFETCH(int, action);
    QFETCH(SecondReply, second);
    DuplicateIdFixture fixture;
    fixture.line.servos = {rawSts3215(1, 2048), rawSts3215(1, 900)};
    fixture.line.servos[0].table[14] = 80;
    fixture.line.servos[1].table[14] = 90;
    if (second != SecondReply::Collides)
        fixture.line.replies = RawServoLine::ReplyTiming::Sequential;
    if (second == SecondReply::Delayed) {
        fixture.line.adapterLatency = milliseconds(60);
        fixture.line.secondReplyDelay = milliseconds(60);
    }
    fixture.open();
    device::Servo servo = fixture.servo();
    const auto done = actions()[std::size_t(action)].second(fixture.context(), servo);
    QVERIFY(!done);
    // Colliding replies may not even be readable beforehand.
    const bool repliesSeen =
        done.error().code == ErrorCode::DuplicateId ||
        (second == SecondReply::Collides && done.error().code == ErrorCode::Garbled);
    QVERIFY2(repliesSeen, qPrintable(base::errorName(done.error().code)));
    QCOMPARE(fixture.line.writeFrameCount(), 0);
    QCOMPARE(fixture.line.writeCount(0) + fixture.line.writeCount(1), 0);
    QCOMPARE(fixture.journal.entries()->size(), std::size_t{0});
    if (done.error().code != ErrorCode::DuplicateId)
        return;
    const auto words = text::describe(done.error());
    QVERIFY2(words.remedy.contains(QLatin1String("one servo at a time")), qPrintable(words.remedy));
}

void TestWriteDuplicateId::nothingIsWrittenToSimulatedDuplicates_data()
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

void TestWriteDuplicateId::nothingIsWrittenToSimulatedDuplicates()
{
    QFETCH(QString, model);
    QFETCH(int, baud);
    QFETCH(Protocol, protocol);
    QFETCH(QString, key);
    QFETCH(int, latencyMs);
    support::SimFixtureOptions options;
    options.baud = baud;
    options.wire.adapterLatency = milliseconds(latencyMs);
    const std::optional<int> rate = baud;
    SimFixture alone({{model, 1, rate, {}, 180, {}, nullptr}}, options);
    const device::Servo known = alone.servo(1, protocol);
    for (const bool energize : {false, true}) {
        SimFixture fixture(
            {{model, 1, rate, {}, 180, {}, nullptr}, {model, 1, rate, {}, 95, {}, nullptr}},
            options);
        device::Servo servo = known;
        const auto before = servo.raw(key).value_or(0);
        const auto done =
            energize ? device::setTorque(fixture.context(), servo, device::Torque::On)
                     : writeRegister(fixture.context(), servo, qPrintable(key), before - 1);
        QVERIFY(!done);
        QCOMPARE(done.error().code, ErrorCode::DuplicateId);
        QVERIFY(fixture.journal().entries()->empty());
        fixture.withBus([&](sim::VirtualBus& wire) {
            for (sim::VirtualServo* each : wire.servos())
                QCOMPARE(each->raw(key), before);
        });
    }
}

// Said to be so in the help: content that is equal bit by bit, in step, looks like one servo.
void TestWriteDuplicateId::identicalSynchronousServosAreIndistinguishable()
{
    DuplicateIdFixture fixture;
    fixture.line.servos = {rawSts3215(1), rawSts3215(1)};
    fixture.open();
    device::Servo servo = fixture.servo();
    QVERIFY(writeRegister(fixture.context(), servo, "max_temperature", 61));
    QCOMPARE(fixture.line.servos[1].table[13], std::uint8_t(61));
}

void TestWriteDuplicateId::aSingleServoIsWritten_data()
{
    QTest::addColumn<int>("lateMs");
    QTest::addColumn<int>("spoilEvery"); ///< 0: none
    for (const int late : {0, 20, 60, 100}) {
        QTest::addRow("%d ms late", late) << late << 0;
        QTest::addRow("%d ms late, every 4th reply broken", late) << late << 4;
    }
    QTest::newRow("every 3rd reply broken") << 0 << 3;
}

void TestWriteDuplicateId::aSingleServoIsWritten()
{
    QFETCH(int, lateMs);
    QFETCH(int, spoilEvery);
    DuplicateIdFixture fixture;
    fixture.line.servos = {rawSts3215(1)};
    fixture.line.adapterLatency = milliseconds(lateMs);
    if (spoilEvery > 0) {
        fixture.line.spoil = [spoilEvery](int n, base::Bytes& reply) {
            if (n % spoilEvery == spoilEvery - 1)
                reply[reply.size() / 2] ^= 0x10;
        };
    }
    fixture.open();
    device::Servo servo = fixture.servo();
    const auto done = writeRegister(fixture.context(), servo, "max_temperature", 61);
    QVERIFY2(done, done ? "" : qPrintable(text::describe(done.error()).message));
    QCOMPARE(fixture.line.servos[0].table[13], std::uint8_t(61));
    QCOMPARE(fixture.line.servos[0].table[55], std::uint8_t(1)); // locked again
}

void TestWriteDuplicateId::theCheckIsDoneOnce()
{
    DuplicateIdFixture fixture;
    fixture.line.servos = {rawSts3215(1)};
    fixture.open();
    device::Servo servo = fixture.servo();
    QVERIFY(device::beginWriting(fixture.context(), servo, {}));
    QVERIFY(!fixture.line.frames.empty());
    QCOMPARE(fixture.line.writeFrameCount(), 0);
    fixture.line.frames.clear();
    const base::Duration before = fixture.clock.now();
    QVERIFY(device::requireVerified(fixture.context(), servo, {}));
    QCOMPARE(fixture.line.frames.size(), std::size_t{0});
    QCOMPARE(fixture.clock.now(), before);
    QVERIFY(device::beginWriting(fixture.context(), servo, {}));
    QCOMPARE(fixture.line.frames.size(), std::size_t{1}); // who it is
    fixture.open();                                       // another connection
    QVERIFY(device::beginWriting(fixture.context(), servo, {}));
    QVERIFY(!fixture.line.frames.empty());
}

void TestWriteDuplicateId::aSearchIsFollowedByANewCheck()
{
    SimFixture fixture(QStringLiteral("sts3215@1"));
    device::Servo servo = fixture.servo(1);
    QVERIFY(writeRegister(fixture.context(), servo, "max_temperature", 61));
    QVERIFY(jobs::scan(fixture.context(), {}));
    fixture.clearFrames();
    QVERIFY(device::beginWriting(fixture.context(), servo, {}));
    QVERIFY(fixture.frames(support::Read) > 0);
}

void TestWriteDuplicateId::aNewIdNeedsNoSecondCheck()
{
    SimFixture fixture(QStringLiteral("sts3215@1"));
    device::Servo servo = fixture.servo(1);
    QVERIFY(jobs::changeId(fixture.context(), servo, 9));
    QCOMPARE(servo.id, 9);
    fixture.clearFrames();
    QVERIFY(device::beginWriting(fixture.context(), servo, {}));
    QCOMPARE(fixture.frameCount(), std::size_t{1}); // who it is
}

// On a line that breaks everything nothing is written; the next attempt looks afresh.
void TestWriteDuplicateId::noiseIsRetriedAndNotRemembered()
{
    DuplicateIdFixture fixture;
    fixture.line.servos = {rawSts3215(1)};
    fixture.line.spoil = [](int, base::Bytes& reply) { reply[reply.size() / 2] ^= 0x10; };
    fixture.open();
    device::Servo servo = fixture.servo();
    const auto refused = writeRegister(fixture.context(), servo, "max_temperature", 61);
    QVERIFY(!refused);
    QCOMPARE(refused.error().code, ErrorCode::DuplicateId);
    const auto words = text::describe(refused.error());
    QVERIFY2(words.message.contains(QRegularExpression(QStringLiteral("\\d+ of \\d+"))),
             qPrintable(words.message));
    QCOMPARE(fixture.line.writeFrameCount(), 0);
    fixture.line.spoil = nullptr;
    QVERIFY(writeRegister(fixture.context(), servo, "max_temperature", 61));
}

// The firmware's span is never answered: that is no sign of a second servo.
void TestWriteDuplicateId::aLostReplyIsNoSecondServo()
{
    DuplicateIdFixture fixture;
    fixture.line.servos = {rawSts3215(1)};
    fixture.line.spoil = [](int, base::Bytes& reply) {
        if (reply.size() > 7 && reply[5] == 3 && reply[6] == 10)
            reply.clear();
    };
    fixture.open();
    device::Servo servo = fixture.servo();
    const auto refused = device::beginWriting(fixture.context(), servo, QStringLiteral("write"));
    QVERIFY(!refused);
    QCOMPARE(refused.error().code, ErrorCode::NoReply);
    QCOMPARE(refused.error().id, 1);
}

/// One unreadable reply, and then the cable is out.
void TestWriteDuplicateId::silenceIsNoSecondServo()
{
    DuplicateIdFixture fixture;
    fixture.line.servos = {rawSts3215(1)};
    fixture.line.spoil = [duplicateReported = false](int, base::Bytes& reply) mutable {
        if (std::exchange(duplicateReported, true))
            reply.clear();
        else
            reply.back() ^= 0xFF;
    };
    fixture.open();
    device::Servo servo = fixture.servo();
    const auto refused = device::beginWriting(fixture.context(), servo, QStringLiteral("write"));
    QVERIFY(!refused);
    QCOMPARE(refused.error().code, ErrorCode::NoReply);
}

void TestWriteDuplicateId::torqueOffReachesBoth_data()
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

void TestWriteDuplicateId::torqueOffReachesBoth()
{
    QFETCH(bool, halt);
    QFETCH(bool, collide);
    QFETCH(int, mode);
    constexpr std::uint8_t goal = 4; // its high byte: 1024
    DuplicateIdFixture fixture;
    fixture.line.servos = {rawSts3215(1, 2048), rawSts3215(1, 900)};
    fixture.line.servos[1].table[14] = 90;
    if (!collide)
        fixture.line.replies = RawServoLine::ReplyTiming::Sequential;
    for (support::RawServo& one : fixture.line.servos) {
        one.table[33] = std::uint8_t(mode);
        one.table[40] = 1;
        one.table[43] = goal;
    }
    fixture.open();
    device::Servo servo = fixture.servo();
    const auto done = halt ? device::halt(fixture.context(), servo)
                           : device::setTorque(fixture.context(), servo, device::Torque::Off);
    for (const support::RawServo& one : fixture.line.servos) {
        QCOMPARE(one.table[40], std::uint8_t(0));
        QCOMPARE(one.table[43], goal); // the place of one is not the other's
    }
    QVERIFY(!done);
    const auto words = text::describe(done.error());
    QVERIFY2(words.message.contains(QLatin1String("torque-off command was sent")),
             qPrintable(words.message));
}

void TestWriteDuplicateId::anEmergencyStopDoesNotWait()
{
    DuplicateIdFixture fixture;
    fixture.line.servos = {rawSts3215(1, 2048), rawSts3215(1, 900)};
    fixture.line.replies = RawServoLine::ReplyTiming::Sequential;
    for (support::RawServo& one : fixture.line.servos)
        one.table[40] = 1;
    fixture.open();
    device::Servo servo = fixture.servo();
    const auto verdicts = jobs::verifyEmergencyStop(fixture.context(), {&servo});
    QVERIFY(verdicts);
    QCOMPARE(fixture.line.servos[0].table[40], std::uint8_t(0));
    QCOMPARE(fixture.line.servos[1].table[40], std::uint8_t(0));
}

SERVODESK_GUILESS_TEST(TestWriteDuplicateId)
#include "tst_write_duplicate_id.moc"
