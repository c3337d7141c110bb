// SPDX-License-Identifier: GPL-3.0-or-later
// Several languages on one line: each request is spoken in its own, with the silence it needs, and
// nothing that came for one is taken for the answer to another.
#include "support/test_main.h"

#include <QRegularExpression>
#include <QTest>

#include "multi_protocol_fixture.h"

using namespace bus;
using base::ErrorCode;
using base::Protocol;
using protocol::Repeat;
using protocol::Request;
using namespace std::chrono_literals;

namespace {
const Bytes modbusOffAll = modbusFrame({0, 6, 0, 129, 0, 0});
const Bytes modbusOff1 = modbusFrame({1, 6, 0, 129, 0, 0});
const Bytes feetechOffAll = frameOf(254, 3, {40, 0});
const Bytes lxOffAll = lxFrame(254, 31, {0});

int samplesAt(const std::vector<Sample>& samples, int address)
{
    return int(std::count_if(samples.begin(), samples.end(), [address](const Sample& sample) {
        return sample.address == address && sample.answered;
    }));
}
} // namespace

class TestBusProtocols : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { QTest::failOnWarning(QRegularExpression(QStringLiteral(".*"))); }

    void eachRequestInItsProtocol()
    {
        MultiProtocolFixture drawer;
        drawer.openMultiProtocol();
        for (int round = 0; round < 3; ++round) {
            const auto feetech = drawer.transact(Request::read(1, 56, 4));
            QVERIFY(feetech);
            QCOMPARE(feetech->data(), tableBytes(1, 56, 4));
            const auto modbus = drawer.transact(modbusRead(256, 2));
            QVERIFY(modbus);
            QCOMPARE(modbus->data(), (Bytes{1, 0, 1, 1}));
            QVERIFY(drawer.transact(modbusWrite(129, {0, 1})));
            QVERIFY(drawer.transact(modbusWrite(128, {8, 0, 0, 1})));
            const auto lx = drawer.transact(lxRead(28, 2));
            QVERIFY(lx);
            QCOMPARE(lx->data(), (Bytes{0xFD, 0xFF}));
            QVERIFY(drawer.transact(inLx(Request::halt(1))));
        }
        const Counters counters = drawer.counters(1);
        QCOMPARE(counters.ok, std::uint64_t(15));
        QCOMPARE(counters.retried, std::uint64_t(0));
        QCOMPARE(counters.noiseBytes, std::uint64_t(0));
    }

    void theTraceHasTheProtocol()
    {
        MultiProtocolFixture drawer;
        drawer.openMultiProtocol();
        QVERIFY(drawer.transact(modbusRead(256, 1)));
        QVERIFY(drawer.transact(lxRead(26, 1)));
        QVERIFY(drawer.transact(Request::ping(2)));
        QStringList said;
        for (const TraceEntry& entry : drawer.core->takeTrace())
            said += protocol::codecFor(entry.protocol)
                        .explain(entry.bytes, entry.kind == TraceKind::Sent);
        QCOMPARE(
            said,
            (QStringList{QString::fromUtf8("READ 1 @256 ×1"), QStringLiteral("REPLY READ 1: 01 00"),
                         QStringLiteral("TEMP READ 1"), QStringLiteral("REPLY TEMP READ 1: 2D"),
                         QStringLiteral("PING 2"), QStringLiteral("STATUS 2")}));
    }

    void unsupportedRequestsAreNotSent()
    {
        MultiProtocolFixture drawer;
        drawer.openMultiProtocol();
        for (const Request& request :
             {inModbus(Request::action()), inLx(Request::reboot(1)), Request::halt(1)}) {
            const auto outcome = drawer.transact(request);
            QVERIFY(!outcome);
            QCOMPARE(outcome.error().code, ErrorCode::NotSupported);
            QVERIFY(!outcome.error().detail.isEmpty());
        }
        QVERIFY(drawer.script.sent.empty());
    }

    void modbusIsPrecededBySilence_data()
    {
        QTest::addColumn<Request>("before");
        QTest::addColumn<int>("baud");
        QTest::addColumn<Duration>("chosen");
        QTest::addColumn<Duration>("silence");
        const Duration defaultSilence = -1us;
        const Request feetech = Request::read(1, 56, 4);
        const Request modbus = modbusRead(256, 2);
        const auto row = [](const char* name, const Request& before, int baud, Duration chosen,
                            Duration silence) {
            QTest::newRow(name) << before << baud << chosen << silence;
        };
        row("after Modbus", modbus, 115'200, defaultSilence, 1750us);
        row("after Feetech", feetech, 115'200, defaultSilence, 1750us);
        row("after a request nobody answers", inLx(Request::halt(1)), 115'200, defaultSilence,
            1750us);
        row("after a Modbus broadcast", modbusWrite(129, {0, 0}, 254), 115'200, defaultSilence,
            1750us);
        row("9600", modbus, 9'600, defaultSilence, 3646us);
        row("chosen", modbus, 115'200, 300us, 300us);
        row("none chosen", modbus, 115'200, 0us, 0us);
    }

    void modbusIsPrecededBySilence()
    {
        QFETCH(const Request, before);
        QFETCH(const int, baud);
        QFETCH(const Duration, chosen);
        QFETCH(const Duration, silence);
        MultiProtocolFixture drawer;
        drawer.script.baud = baud;
        drawer.modbusSilence = 0us;
        drawer.openMultiProtocol();
        if (chosen >= 0us)
            drawer.core->setSilence(chosen);
        QVERIFY(drawer.transact(before));
        const Duration lineFree = drawer.script.wireFreeAt;
        QVERIFY(drawer.transact(modbusRead(256, 2)));
        const Duration silent = drawer.script.sent.at(1).at - lineFree;
        // The wire of the script rounds down, the line up.
        QVERIFY2(silent >= silence && silent <= silence + 2us,
                 QByteArray::number(qint64(silent.count())).constData());
    }

    void bytesDuringSilenceAreNoReply_data()
    {
        QTest::addColumn<int>("baud");
        QTest::addColumn<Duration>("after");
        QTest::addColumn<int>("broken");
        QTest::addColumn<Duration>("silence");
        const auto row = [](const char* name, int baud, Duration after, int broken,
                            Duration silence) {
            QTest::newRow(name) << baud << after << broken << silence;
        };
        row("at once", 115'200, 100us, 0, 1750us);
        row("in the middle", 115'200, 1000us, 0, 1750us);
        row("at the end", 115'200, 1700us, 0, 1750us);
        row("in two parts", 115'200, 1000us, 4, 1750us);
        // Here the pause that ends an unexpected reply is longer: four bytes and half a
        // millisecond.
        row("9600", 9'600, 3000us, 0, 4667us);
    }

    void bytesDuringSilenceAreNoReply()
    {
        QFETCH(const int, baud);
        QFETCH(const Duration, after);
        QFETCH(const int, broken);
        QFETCH(const Duration, silence);
        MultiProtocolFixture drawer;
        drawer.script.baud = baud;
        drawer.openMultiProtocol();
        QVERIFY(drawer.transact(modbusRead(256, 2)));
        const Bytes stale = modbusFrame({1, 3, 4, 0xAA, 0xAA, 0xAA, 0xAA});
        const auto cut = stale.begin() + broken;
        const Duration end = drawer.script.clock.now() + after;
        drawer.script.deliver(end, Bytes(cut, stale.end()));
        if (broken > 0)
            drawer.script.deliver(end - 300us, Bytes(stale.begin(), cut));
        const auto outcome = drawer.transact(modbusRead(260, 2), 0);
        QVERIFY(outcome);
        QCOMPARE(outcome->data(), (Bytes{1, 4, 1, 5}));
        const Duration silent = drawer.script.sent.at(1).at - end;
        QVERIFY2(silent >= silence && silent <= silence + 2us,
                 QByteArray::number(qint64(silent.count())).constData());
        QCOMPARE(drawer.counters(1).foreign, std::uint64_t(1));
        QCOMPARE(drawer.counters(1).noiseBytes, std::uint64_t(0));
    }

    void listensDuringSilenceAfterAnotherProtocol()
    {
        MultiProtocolFixture drawer;
        drawer.openMultiProtocol();
        QVERIFY(drawer.transact(modbusWrite(129, {0, 0}, 254)));
        // Its second part comes 0.1 ms after the silence would have ended.
        const Bytes running = frameOf(2, 0, {1, 2});
        const Duration end = drawer.script.clock.now() + 1850us;
        drawer.script.deliver(end - 300us, Bytes(running.begin(), running.begin() + 4));
        drawer.script.deliver(end, Bytes(running.begin() + 4, running.end()));
        QVERIFY(drawer.transact(Request::ping(1)));
        QVERIFY2(drawer.script.sent.back().at >= end, "it spoke into a running reply");
    }

    void aNeverSilentLineIsStillUsed()
    {
        MultiProtocolFixture drawer;
        drawer.openMultiProtocol();
        QVERIFY(drawer.transact(modbusRead(256, 2)));
        const Duration start = drawer.script.clock.now();
        for (Duration at = 1ms; at < 1s; at += 1ms)
            drawer.script.deliver(start + at, {0});
        static_cast<void>(drawer.transact(modbusRead(256, 2), 0));
        QCOMPARE(drawer.script.sent.size(), std::size_t(2));
        QVERIFY(drawer.script.sent.back().at - start < 200ms);
    }

    void theSilenceEndsEarly_data()
    {
        QTest::addColumn<bool>("emergency");
        QTest::addColumn<ErrorCode>("code");
        QTest::newRow("stop") << false << ErrorCode::Stopped;
        QTest::newRow("emergency") << true << ErrorCode::Preempted;
    }

    void theSilenceEndsEarly()
    {
        QFETCH(const bool, emergency);
        QFETCH(const ErrorCode, code);
        MultiProtocolFixture drawer;
        drawer.openMultiProtocol();
        drawer.core->setSilence(1s);
        QVERIFY(drawer.transact(Request::ping(1)));
        const Duration start = drawer.script.clock.now();
        base::StopToken stop;
        drawer.script.onWait = [&, done = false]() mutable {
            if (drawer.script.clock.now() < start + 100ms || std::exchange(done, true))
                return;
            if (emergency)
                std::thread([&] { drawer.core->emergency(); }).join();
            else
                stop.request();
        };
        Transaction transaction;
        transaction.request = modbusWrite(129, {0, 1});
        transaction.request.repeat = Repeat::Never;
        transaction.stop = &stop;
        const auto outcome = drawer.core->transact(transaction);
        QVERIFY(!outcome);
        QCOMPARE(outcome.error().code, code);
        QVERIFY(drawer.script.clock.now() - start <= 120ms);
        QVERIFY2(drawer.script.sent.size() == 1, "it was not sent");
    }

    void otherProtocolsNeedNoSilence_data()
    {
        QTest::addColumn<Request>("request");
        QTest::newRow("Feetech") << Request::read(1, 56, 4);
        QTest::newRow("LX") << lxRead(28, 2);
    }

    void otherProtocolsNeedNoSilence()
    {
        QFETCH(const Request, request);
        MultiProtocolFixture drawer;
        drawer.openMultiProtocol();
        drawer.core->setSilence(5ms);
        QVERIFY(drawer.transact(Request::ping(2)));
        const Duration lineFree = drawer.script.wireFreeAt;
        QVERIFY(drawer.transact(request));
        QCOMPARE(drawer.script.sent.back().at, lineFree);
    }

    void aModbusBroadcastIsFollowedBySilence()
    {
        MultiProtocolFixture drawer;
        drawer.openMultiProtocol();
        QVERIFY(drawer.transact(modbusWrite(129, {0, 0}, 254)));
        QVERIFY(drawer.transact(Request::ping(1)));
        QCOMPARE(drawer.executedFrames, (std::vector<Bytes>{modbusOffAll}));
    }

    void exceptionsAreRefusals_data()
    {
        QTest::addColumn<int>("exception");
        QTest::addColumn<QString>("detail");
        QTest::newRow("function") << 1 << QStringLiteral("illegal-function");
        QTest::newRow("address") << 2 << QStringLiteral("illegal-address");
        QTest::newRow("value") << 3 << QStringLiteral("illegal-value");
        QTest::newRow("another") << 4 << QStringLiteral("exception 4");
    }

    void exceptionsAreRefusals()
    {
        QFETCH(const int, exception);
        QFETCH(const QString, detail);
        MultiProtocolFixture drawer;
        drawer.openMultiProtocol();
        drawer.exception = exception;
        Request never = modbusWrite(10, {0, 5});
        never.repeat = Repeat::Never;
        for (const Request& request : {modbusRead(1000, 1), modbusWrite(129, {0, 1}),
                                       modbusWrite(128, {8, 0, 0, 1}), never}) {
            drawer.script.sent.clear();
            const Duration start = drawer.script.clock.now();
            const auto outcome = drawer.transact(request, 3);
            QVERIFY(!outcome);
            QCOMPARE(outcome.error().code, ErrorCode::Refused);
            QCOMPARE(outcome.error().detail, detail);
            QCOMPARE(outcome.error().id, 1);
            QCOMPARE(drawer.script.sent.size(), std::size_t(1));
            QVERIFY2(drawer.script.clock.now() - start < 5ms, "no waiting for what will not come");
        }
    }

    void aRefusedPollIsASample()
    {
        MultiProtocolFixture drawer;
        drawer.openMultiProtocol();
        drawer.exception = 2;
        PollPlan plan;
        plan.period = 10ms;
        plan.servos.push_back({1, {{512, 4, 1}}, false, 0, Protocol::Modbus, 0, 58});
        const PollId id = drawer.core->startPoll(plan);
        drawer.pause(95ms);
        const auto samples = drawer.core->takeSamples(id);
        QCOMPARE(samples.size(), std::size_t(10));
        QVERIFY(!samples.front().answered);
        QVERIFY(samples.front().data.empty());
        QCOMPARE(samples.front().error, ErrorCode::Refused);
    }

    void brokenModbusRepliesAreGarbled()
    {
        MultiProtocolFixture drawer;
        drawer.openMultiProtocol();
        drawer.script.intercept = [&](const Bytes&) {
            Bytes broken = modbusFrame({1, 3, 2, 0, 1});
            broken.back() ^= 1;
            drawer.script.reply(broken);
            return true;
        };
        const auto outcome = drawer.transact(modbusRead(256, 1));
        QVERIFY(!outcome);
        QCOMPARE(outcome.error().code, ErrorCode::Garbled);
        QCOMPARE(drawer.counters(1).badChecksums, std::uint64_t(3));
    }

    void anotherProtocolIsNoReply_data()
    {
        QTest::addColumn<Request>("request");
        QTest::addColumn<Bytes>("answer");
        QTest::newRow("Feetech to Modbus") << modbusRead(256, 1) << frameOf(1, 0, {});
        QTest::newRow("Modbus to LX") << lxRead(28, 2) << modbusFrame({1, 3, 2, 0, 1});
        QTest::newRow("LX to Feetech") << Request::read(1, 56, 2) << lxFrame(1, 28, {1, 2});
    }

    void anotherProtocolIsNoReply()
    {
        QFETCH(const Request, request);
        QFETCH(const Bytes, answer);
        MultiProtocolFixture drawer;
        drawer.openMultiProtocol();
        drawer.script.intercept = [&](const Bytes&) {
            drawer.script.reply(answer);
            return true;
        };
        const auto outcome = drawer.transact(request);
        QVERIFY(!outcome);
        QCOMPARE(outcome.error().code, ErrorCode::Garbled);
    }

    void slowRowsAreReadEveryNthRound()
    {
        MultiProtocolFixture drawer;
        drawer.openMultiProtocol();
        PollPlan plan;
        plan.period = 10ms;
        plan.servos.push_back(
            {1, {{224, 2, 1}, {216, 2, 5}, {208, 1, 10}}, false, 0, Protocol::Lx, -1, 128});
        const PollId id = drawer.core->startPoll(plan);
        drawer.pause(195ms);
        const auto samples = drawer.core->takeSamples(id);
        QCOMPARE(samplesAt(samples, 224), 20);
        QCOMPARE(samplesAt(samples, 216), 4);
        QCOMPARE(samplesAt(samples, 208), 2);
        QCOMPARE(samples.front().data, (Bytes{0xFD, 0xFF}));
    }

    void slowRowsNeedNoFastOnes_data()
    {
        QTest::addColumn<Duration>("period");
        QTest::addColumn<int>("fives");
        QTest::addColumn<int>("tens");
        QTest::newRow("at the period") << Duration(10ms) << 4 << 2;
        QTest::newRow("at another") << Duration(5ms) << 8 << 4;
    }

    void slowRowsNeedNoFastOnes()
    {
        QFETCH(const Duration, period);
        MultiProtocolFixture drawer;
        drawer.openMultiProtocol();
        PollPlan plan;
        plan.period = period;
        plan.servos.push_back({1, {{216, 2, 5}, {208, 1, 10}}, false, 0, Protocol::Lx, -1, 128});
        const PollId id = drawer.core->startPoll(plan);
        drawer.pause(195ms);
        const auto samples = drawer.core->takeSamples(id);
        QTEST(samplesAt(samples, 216), "fives");
        QTEST(samplesAt(samples, 208), "tens");
    }

    void slowRowsAloneAreReadAsFastAsTheWireAllows()
    {
        MultiProtocolFixture drawer;
        drawer.openMultiProtocol();
        PollPlan plan;
        plan.servos.push_back({1, {{216, 2, 5}}, false, 0, Protocol::Lx, -1, 128});
        const PollId id = drawer.core->startPoll(plan);
        drawer.pause(100ms);
        // 14 bytes at 115200 take 1.22 ms.
        QVERIFY(samplesAt(drawer.core->takeSamples(id), 216) >= 80);
    }

    /// LX blocks stand eight places apart whether they are read together or not.
    void lxBlocksAreReadUnchanged()
    {
        MultiProtocolFixture drawer;
        drawer.openMultiProtocol();
        PollPlan plan;
        plan.period = 10ms;
        plan.servos.push_back(
            {1, {{208, 1}, {216, 2}, {224, 2}, {216, 2}}, false, 0, Protocol::Lx, -1, 128});
        const PollId id = drawer.core->startPoll(plan);
        drawer.pause(8ms);
        std::vector<int> commands;
        for (const SentFrame& frame : drawer.script.sent)
            commands.push_back(frame.instruction());
        QCOMPARE(commands, (std::vector<int>{26, 27, 28}));
        QCOMPARE(drawer.core->takeSamples(id).size(), std::size_t(3));
    }

    void oneIdInTwoProtocols()
    {
        MultiProtocolFixture drawer;
        drawer.openMultiProtocol();
        PollPlan plan;
        plan.period = 20ms;
        plan.servos.push_back({1, {{56, 4}}, true, 0});
        plan.servos.push_back({2, {{56, 4}}, true, 0});
        plan.servos.push_back({1, {{512, 4}, {516, 12}}, true, 0, Protocol::Modbus, 0, 58});
        const PollId id = drawer.core->startPoll(plan);
        drawer.pause(15ms);
        const auto samples = drawer.core->takeSamples(id);
        QCOMPARE(samples.size(), std::size_t(3));
        for (const Sample& sample : samples) {
            QVERIFY(sample.answered);
            QCOMPARE(sample.data.size(), std::size_t(sample.address == 512 ? 16 : 4));
        }
        QCOMPARE(samplesAt(samples, 56), 2);
    }

    void aLateReplyToAnotherCommandIsNotTheReply_data()
    {
        QTest::addColumn<Duration>("latency");
        QTest::newRow("within the pause") << Duration(16ms);
        QTest::newRow("after the pause") << Duration(45ms);
    }

    void aLateReplyToAnotherCommandIsNotTheReply()
    {
        QFETCH(const Duration, latency);
        MultiProtocolFixture drawer;
        drawer.openMultiProtocol();
        drawer.script.latency = latency;
        QVERIFY(!drawer.transact(lxRead(27, 2), 0, 5ms));
        const auto position = drawer.transact(lxRead(28, 2), 0, 80ms);
        QVERIFY(position);
        QCOMPARE(position->data(), (Bytes{0xFD, 0xFF}));
        QCOMPARE(drawer.counters(1).late, std::uint64_t(1));
    }

    void anAcknowledgmentOfAnotherWriteIsNotTheReply()
    {
        MultiProtocolFixture drawer;
        drawer.openMultiProtocol();
        drawer.script.latency = 45ms;
        QVERIFY(!drawer.transact(modbusWrite(133, {0, 0}), 0, 5ms));
        drawer.script.intercept = [](const Bytes&) { return true; };
        const auto lost = drawer.transact(modbusWrite(129, {0, 1}), 0, 80ms);
        QVERIFY(!lost);
        QCOMPARE(lost.error().code, ErrorCode::NoReply);
    }

    void echoesAreDetected_data()
    {
        QTest::addColumn<Protocol>("protocol");
        QTest::addColumn<bool>("echo");
        for (const Protocol protocol : base::allProtocols) {
            for (const bool echo : {true, false})
                QTest::addRow("%s %s", qPrintable(base::protocolName(protocol)),
                              echo ? "with" : "without")
                    << protocol << echo;
        }
    }

    void echoesAreDetected()
    {
        QFETCH(const Protocol, protocol);
        QFETCH(const bool, echo);
        MultiProtocolFixture drawer;
        drawer.script.echo = echo;
        drawer.openMultiProtocol(protocol::codecFor(protocol));
        QCOMPARE(drawer.core->hasEcho(), echo);
        QVERIFY(drawer.transact(Request::read(1, 56, 4)));
        QVERIFY(drawer.transact(lxRead(28, 2)));
        QVERIFY(drawer.transact(modbusRead(256, 2)));
        QVERIFY2(drawer.transact(modbusWrite(129, {0, 1})), "the reply equals the echo");
        QCOMPARE(drawer.counters(1).foreign, std::uint64_t(0));
    }

    void anEchoIsNoAcknowledgment()
    {
        MultiProtocolFixture drawer;
        drawer.script.echo = true;
        drawer.openMultiProtocol(protocol::modbusCodec());
        drawer.script.intercept = [](const Bytes&) { return true; };
        const auto outcome = drawer.transact(modbusWrite(129, {0, 1}));
        QVERIFY(!outcome);
        QCOMPARE(outcome.error().code, ErrorCode::NoReply);
    }

    void stopFramesLeaveModbusItsSilence_data()
    {
        QTest::addColumn<Request>("before");
        QTest::newRow("after Modbus") << modbusRead(256, 8);
        QTest::newRow("after LX") << lxRead(28, 2);
        QTest::newRow("after a broadcast") << inLx(Request::halt(254));
        QTest::newRow("after a Modbus broadcast") << modbusWrite(131, {0, 50}, 254);
    }

    void stopFramesLeaveModbusItsSilence()
    {
        QFETCH(const Request, before);
        MultiProtocolFixture drawer;
        drawer.openMultiProtocol();
        drawer.core->setStopFrames({{Protocol::Modbus, modbusOffAll},
                                    {Protocol::Feetech, feetechOffAll},
                                    {Protocol::Lx, lxOffAll},
                                    {Protocol::Modbus, modbusOff1},
                                    {Protocol::Modbus, modbusOff1},
                                    {Protocol::Lx, lxOffAll}});
        QVERIFY(drawer.transact(before));
        drawer.finishBroadcast();
        drawer.executedFrames.clear();
        const Duration start = drawer.script.clock.now();
        drawer.core->emergency();
        QCOMPARE(drawer.executedFrames, (std::vector<Bytes>{modbusOffAll, modbusOff1, modbusOff1}));
        QVERIFY2(drawer.script.clock.now() - start < 30ms, "stopping does not wait for long");
    }

    void aLongSilenceDoesNotDelayStopping()
    {
        MultiProtocolFixture drawer;
        drawer.openMultiProtocol();
        drawer.core->setSilence(100ms);
        drawer.core->setStopFrames(std::vector<StopFrame>(20, {Protocol::Modbus, modbusOff1}));
        QVERIFY(drawer.transact(modbusRead(256, 2)));
        drawer.executedFrames.clear();
        const Duration start = drawer.script.clock.now();
        drawer.core->emergency();
        QCOMPARE(drawer.executedFrames, std::vector<Bytes>(20, modbusOff1));
        // 16 bytes at 115200, the silence and the margin: less than 5 ms each.
        QVERIFY(drawer.script.clock.now() - start <= 100ms);
    }

    void aShorterSilenceMakesStoppingFaster()
    {
        const auto span = [](Duration chosen) {
            MultiProtocolFixture drawer;
            drawer.modbusSilence = 0us;
            drawer.openMultiProtocol();
            if (chosen >= 0us)
                drawer.core->setSilence(chosen);
            drawer.core->setStopFrames(std::vector<StopFrame>(4, {Protocol::Modbus, modbusOff1}));
            const Duration start = drawer.script.clock.now();
            drawer.core->emergency();
            return drawer.script.clock.now() - start;
        };
        QVERIFY(span(300us) < span(-1us));
        QCOMPARE(span(1s), span(-1us));
    }

    void stopFramesAreTracedInTheirProtocol()
    {
        MultiProtocolFixture drawer;
        drawer.openMultiProtocol();
        drawer.core->setStopFrames({{Protocol::Feetech, frameOf(1, 3, {40, 0})},
                                    {Protocol::Modbus, modbusOff1},
                                    {Protocol::Lx, lxOffAll}});
        QVERIFY(drawer.transact(Request::ping(2)));
        drawer.core->takeTrace();
        drawer.core->emergency();
        std::vector<std::pair<TraceKind, Protocol>> traced;
        for (const TraceEntry& entry : drawer.core->takeTrace()) {
            if (entry.kind != TraceKind::Note)
                traced.emplace_back(entry.kind, entry.protocol);
        }
        const std::vector<std::pair<TraceKind, Protocol>> wanted{
            {TraceKind::Sent, Protocol::Feetech},
            {TraceKind::Foreign, Protocol::Feetech},
            {TraceKind::Sent, Protocol::Modbus},
            {TraceKind::Foreign, Protocol::Modbus},
            {TraceKind::Sent, Protocol::Lx}};
        QCOMPARE(traced, wanted);
        QCOMPARE(drawer.counters(1).noiseBytes, std::uint64_t(0));
    }
};

SERVODESK_GUILESS_TEST(TestBusProtocols)
#include "tst_bus_protocols.moc"
