// SPDX-License-Identifier: GPL-3.0-or-later
// Polling inside the bus: what goes onto the wire, when, and what an absent servo costs the others.
#include <QRegularExpression>
#include <QTest>

#include "bench_bus.h"
#include <set>

using namespace bus;
using base::ErrorCode;
using protocol::Repeat;
using protocol::Request;
using namespace std::chrono_literals;

namespace {
PollPlan singles(std::initializer_list<int> ids, Duration period)
{
    PollPlan plan;
    plan.period = period;
    for (const int id : ids)
        plan.servos.push_back({id, {{56, 15}}, false, 0});
    return plan;
}

PollPlan together(std::initializer_list<int> ids, Duration period)
{
    PollPlan plan = singles(ids, period);
    for (PollServo& servo : plan.servos)
        servo.syncRead = true;
    return plan;
}

std::map<int, int> answersById(const std::vector<Sample>& samples)
{
    std::map<int, int> answers;
    for (const Sample& sample : samples)
        answers[sample.id] += sample.answered ? 1 : 0;
    return answers;
}

std::map<int, int> missesById(const std::vector<Sample>& samples)
{
    std::map<int, int> misses;
    for (const Sample& sample : samples)
        misses[sample.id] += sample.answered ? 0 : 1;
    return misses;
}

void pause(Bench& bench, Duration span)
{
    bench.core->pauseUntil(bench.script.clock.now() + span, nullptr);
}
} // namespace

class TestBusPolls : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { QTest::failOnWarning(QRegularExpression(QStringLiteral(".*"))); }

    void samplesComeAtThePeriodWithTheirTime()
    {
        Bench bench;
        bench.open();
        const Duration start = bench.script.clock.now();
        const PollId id = bench.core->startPoll(singles({1}, 10ms));
        pause(bench, 100ms - 1us);
        const auto samples = bench.core->takeSamples(id);
        QCOMPARE(samples.size(), std::size_t(10));
        for (std::size_t i = 0; i < samples.size(); ++i) {
            const Sample& sample = samples[i];
            QVERIFY(sample.answered);
            QCOMPARE(sample.id, 1);
            QCOMPARE(sample.address, 56);
            QCOMPARE(sample.data, tableBytes(1, 56, 15));
            QCOMPARE(sample.at, start + i * Duration(10ms) + 290us);
        }
        QVERIFY(bench.core->takeSamples(id).empty());
    }

    /// The program is suspended while the servo answers: its value is of then, not of now.
    void aReplyTakenUpMuchLaterIsOfWhenItWasDue()
    {
        Bench bench;
        bench.open();
        const Duration start = bench.script.clock.now();
        bench.script.onWait = [&bench, stood = false]() mutable {
            if (!std::exchange(stood, !bench.script.sent.empty()) && stood)
                bench.script.clock.advance(2s);
        };
        const PollId id = bench.core->startPoll(singles({1}, 10ms));
        pause(bench, 2s + 5ms);
        const auto samples = bench.core->takeSamples(id);
        QVERIFY(samples.size() >= 2);
        QVERIFY(samples[0].answered && samples[1].answered);
        QVERIFY(samples[0].at < start + 2ms);
        QVERIFY(samples[1].at >= start + 2s);
    }

    void periodZeroFillsTheWire()
    {
        Bench bench;
        bench.open();
        const PollId id = bench.core->startPoll(singles({1}, 0us));
        pause(bench, 29ms);
        QCOMPARE(bench.core->takeSamples(id).size(), std::size_t(100));
    }

    void nearbySpansAreOneRead()
    {
        Bench bench;
        bench.open();
        PollPlan plan;
        plan.period = 10ms;
        plan.servos.push_back({1, {{60, 2}, {56, 2}, {100, 3}}, false, 0});
        const PollId id = bench.core->startPoll(plan);
        pause(bench, 5ms);
        QCOMPARE(bench.script.sent.size(), std::size_t(2));
        const auto samples = bench.core->takeSamples(id);
        QCOMPARE(samples.size(), std::size_t(2));
        QCOMPARE(samples[0].address, 56);
        QCOMPARE(samples[0].data, tableBytes(1, 56, 6));
        QCOMPARE(samples[1].address, 100);
    }

    void servosShareSyncReads()
    {
        Bench bench;
        bench.open();
        const PollId id = bench.core->startPoll(together({1, 2, 3}, 10ms));
        pause(bench, 25ms);
        QCOMPARE(bench.script.sent.size(), std::size_t(3));
        for (const SentFrame& frame : bench.script.sent)
            QCOMPARE(frame.instruction(), 0x82);
        QCOMPARE(answersById(bench.core->takeSamples(id)),
                 (std::map<int, int>{{1, 3}, {2, 3}, {3, 3}}));
    }

    void oneServoNeedsNoSyncRead()
    {
        Bench bench;
        bench.open();
        bench.core->startPoll(together({2}, 10ms));
        pause(bench, 5ms);
        QCOMPARE(bench.script.sent.front().instruction(), 0x02);
    }

    void severalPlansRunSideBySide()
    {
        Bench bench;
        bench.open();
        const PollId fast = bench.core->startPoll(singles({1}, 0us));
        const PollId slow = bench.core->startPoll(singles({2}, 50ms));
        const PollId greedy = bench.core->startPoll(singles({3}, 0us));
        pause(bench, 500ms);
        QVERIFY(bench.core->takeSamples(fast).size() > 800);
        QVERIFY(bench.core->takeSamples(greedy).size() > 800);
        QCOMPARE(bench.core->takeSamples(slow).size(), std::size_t(10));
    }

    void stoppedPollsStop()
    {
        Bench bench;
        bench.open();
        const PollId id = bench.core->startPoll(singles({1}, 10ms));
        pause(bench, 15ms);
        bench.core->stopPoll(id);
        QCOMPARE(bench.core->takeSamples(id).size(), std::size_t(2));
        bench.script.sent.clear();
        pause(bench, 100ms);
        QVERIFY(bench.script.sent.empty());
        QVERIFY(bench.core->takeSamples(id).empty());
    }

    void anUnansweredPollIsASampleAndNotRepeated()
    {
        Bench bench;
        bench.open();
        const PollId id = bench.core->startPoll(singles({9}, 200ms));
        pause(bench, 150ms);
        QCOMPARE(bench.script.sent.size(), std::size_t(1));
        const auto samples = bench.core->takeSamples(id);
        QCOMPARE(samples.size(), std::size_t(1));
        QVERIFY(!samples.front().answered);
        QVERIFY(samples.front().data.empty());
        QCOMPARE(samples.front().error, ErrorCode::NoAnswer);
        QCOMPARE(bench.counters(9).retried, std::uint64_t(0));
    }

    void aBrokenPollSaysSo()
    {
        Bench bench;
        bench.open();
        bench.script.intercept = [&](const Bytes&) {
            Bytes broken = frameOf(1, 0, Bytes(15));
            broken.back() ^= 1;
            bench.script.reply(broken);
            return true;
        };
        const PollId id = bench.core->startPoll(singles({1}, 1s));
        pause(bench, 100ms);
        QCOMPARE(bench.core->takeSamples(id).front().error, ErrorCode::Garbled);
    }

    void anImpossiblePlanIsAnswered()
    {
        Bench bench;
        bench.open();
        PollPlan plan;
        plan.servos.push_back({1, {{250, 20}}, false, 0});
        plan.period = 10ms;
        const PollId id = bench.core->startPoll(plan);
        pause(bench, 15ms);
        const auto samples = bench.core->takeSamples(id);
        QVERIFY(!samples.empty());
        QCOMPARE(samples.front().error, ErrorCode::BadArgument);
        QVERIFY(bench.script.sent.empty());
    }

    void anAbsentServoDoesNotSlowTheOthersDown_data()
    {
        QTest::addColumn<bool>("sync");
        QTest::newRow("single reads") << false;
        QTest::newRow("sync reads") << true;
    }

    void anAbsentServoDoesNotSlowTheOthersDown()
    {
        QFETCH(const bool, sync);
        Bench bench;
        bench.open();
        const PollId id =
            bench.core->startPoll(sync ? together({1, 9, 2}, 0us) : singles({1, 9, 2}, 0us));
        pause(bench, 10s);
        const auto samples = bench.core->takeSamples(id);
        const auto answers = answersById(samples);
        // Undisturbed, each of the two would be read about 17000 (20000 by sync read) times.
        QVERIFY2(answers.at(1) > 13000, QByteArray::number(answers.at(1)).constData());
        QVERIFY(answers.at(2) > 13000);
        QCOMPARE(missesById(samples).at(1), 0);
        const int misses = missesById(samples).at(9);
        QVERIFY2(misses >= 10 && misses <= 25, "asked about once a second after a few turns");
    }

    void aServoThatComesBackIsPolledAgain()
    {
        Bench bench;
        bench.open();
        const PollId id = bench.core->startPoll(together({1, 2, 3}, 10ms));
        const Bytes table = bench.script.tables.at(2);
        pause(bench, 100ms);
        bench.script.tables.erase(2);
        pause(bench, 5s);
        bench.script.tables[2] = table;
        pause(bench, 2s);
        bench.core->takeSamples(id);
        bench.script.sent.clear();
        pause(bench, 100ms);
        QCOMPARE(answersById(bench.core->takeSamples(id)).at(2), 10);
        for (const SentFrame& frame : bench.script.sent)
            QCOMPARE(frame.instruction(), 0x82);
    }

    void aServoWithoutSyncReadIsReadSingly()
    {
        Bench bench;
        bench.open();
        bench.script.intercept = [&](const Bytes& frame) {
            if (frame[4] != 0x82)
                return false;
            Bytes others = frame; // servo 3 does not know SYNC READ
            others.erase(std::remove(others.begin() + 7, others.end() - 1, 3), others.end() - 1);
            bench.script.answer(others);
            return true;
        };
        const PollId id = bench.core->startPoll(together({1, 2, 3}, 10ms));
        pause(bench, 1s);
        bench.core->takeSamples(id);
        bench.script.sent.clear();
        pause(bench, 100ms);
        const auto samples = bench.core->takeSamples(id);
        QCOMPARE(answersById(samples), (std::map<int, int>{{1, 10}, {2, 10}, {3, 10}}));
        QCOMPARE(missesById(samples).at(3), 0);
        std::set<int> instructions;
        for (const SentFrame& frame : bench.script.sent)
            instructions.insert(frame.instruction());
        QCOMPARE(instructions, (std::set<int>{0x02, 0x82}));
    }

    void heldServosAreSkippedWithoutError()
    {
        Bench bench;
        bench.open();
        const PollId id = bench.core->startPoll(together({1, 2, 3}, 10ms));
        {
            const Hold hold = bench.core->hold({2});
            pause(bench, 100ms);
            const auto samples = bench.core->takeSamples(id);
            QCOMPARE(answersById(samples), (std::map<int, int>{{1, 10}, {3, 10}}));
            QCOMPARE(bench.counters(2).sent, std::uint64_t(0));
        }
        pause(bench, 50ms);
        QVERIFY(answersById(bench.core->takeSamples(id)).at(2) >= 4);
    }

    void holdingAllStopsPolling()
    {
        Bench bench;
        bench.open();
        bench.core->startPoll(singles({1}, 0us));
        const Hold hold = bench.core->hold({});
        pause(bench, 100ms);
        QVERIFY(bench.script.sent.empty());
    }

    void pollsKeepAShareWhileAJobIsBusy()
    {
        Bench bench;
        bench.open();
        const PollId id = bench.core->startPoll(singles({2}, 0us));
        const Duration end = bench.script.clock.now() + 1s;
        int transactions = 0;
        while (bench.script.clock.now() < end) {
            QVERIFY(bench.transact(Request::read(1, 56, 15)));
            ++transactions;
        }
        const auto polled = bench.core->takeSamples(id).size();
        QVERIFY2(polled >= 40 && polled <= 55, QByteArray::number(int(polled)).constData());
        QVERIFY2(transactions > 3000, "the job keeps almost all of the wire");
    }

    void pollsRunWhileAJobWaitsForALateReply()
    {
        Bench bench;
        bench.open();
        QVERIFY(!bench.transact(Request::ping(9), 0));
        const PollId id = bench.core->startPoll(singles({1}, 5ms));
        QVERIFY(!bench.transact(Request::ping(9), 0));
        QVERIFY(bench.core->takeSamples(id).size() >= 4);
    }

    void polledTimeOutsObeyTheLateRule()
    {
        Bench bench;
        bench.open();
        bench.core->setPatience(5ms);
        bench.script.latency = 16ms;
        PollPlan plan;
        plan.servos.push_back({1, {{56, 2}, {100, 2}}, false, 0});
        const PollId id = bench.core->startPoll(plan);
        pause(bench, 5s);
        int answered = 0;
        for (const Sample& sample : bench.core->takeSamples(id)) {
            if (!sample.answered)
                continue;
            ++answered;
            QCOMPARE(sample.data, tableBytes(1, sample.address, 2));
        }
        QVERIFY(answered > 100);
    }

    void aLostLinkEndsPollingButNotThePause()
    {
        Bench bench;
        bench.open();
        const PollId id = bench.core->startPoll(singles({1}, 10ms));
        bench.script.cut = true;
        const Duration end = bench.script.clock.now() + 1s;
        QVERIFY(bench.core->pauseUntil(end, nullptr));
        QCOMPARE(bench.script.clock.now(), end);
        QVERIFY(bench.core->lost());
        QVERIFY(bench.core->takeSamples(id).empty());
    }
};

QTEST_GUILESS_MAIN(TestBusPolls)
#include "tst_bus_polls.moc"
