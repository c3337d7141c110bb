// SPDX-License-Identifier: GPL-3.0-or-later
// A line that never falls silent: frames or noise without end, far more than the rate could carry.
// On the manual clock. Nothing waits for ever, nothing that comes is taken for an answer, what
// makes a servo safe is said all the same, stops get through, and what is kept is bounded.
#include "bus/bus_core.h"
#include "support/test_main.h"

#include <QRegularExpression>
#include <QTest>

#include "scripted_link.h"

using namespace bus;
using base::ErrorCode;
using protocol::Repeat;
using protocol::Request;
using namespace std::chrono_literals;

namespace {
/// Every look at it takes a moment and brings a chunk, for as long as it flows.
class FloodLink final : public transport::Link {
public:
    struct Source {
        base::ManualClock clock;
        Bytes chunk;
        Duration every = 1ms;
        Duration stall{}; ///< of a computer that is busy with other things
        int baud = 1'000'000;
        bool flows = true;
        Duration next{};
        std::vector<SentFrame> sent{};
        std::function<void()> onWait{};
    };

    explicit FloodLink(Source& source)
        : m_source(source)
    {}

    base::Result<void> write(base::ByteView bytes) override
    {
        m_source.sent.push_back({m_source.clock.now(), Bytes(bytes.begin(), bytes.end())});
        return {};
    }

    base::Result<std::size_t> read(Bytes& buffer) override
    {
        if (!m_source.flows || m_source.clock.now() < m_source.next)
            return std::size_t(0);
        m_source.next = m_source.clock.now() + m_source.every;
        buffer.insert(buffer.end(), m_source.chunk.begin(), m_source.chunk.end());
        return m_source.chunk.size();
    }

    base::Result<bool> waitForReadyRead(Duration span) override
    {
        if (m_source.onWait)
            m_source.onWait();
        // A look is not free, or a flood would stop the clock.
        const Duration until = m_source.clock.now() + std::max(span, Duration(10us));
        const bool comes = m_source.flows && m_source.next <= until;
        m_source.clock.sleepUntil(comes ? std::max(m_source.next, m_source.clock.now() + 10us)
                                        : until);
        m_source.clock.sleepUntil(m_source.clock.now() + m_source.stall);
        return comes || (m_source.flows && m_source.next <= m_source.clock.now());
    }

    base::Result<void> setBaud(int baud) override
    {
        m_source.baud = baud;
        return {};
    }
    int baud() const override { return m_source.baud; }
    QString name() const override { return QStringLiteral("flood"); }

private:
    Source& m_source;
};

enum class Kind { Frames, Noise };

struct FloodFixture {
    explicit FloodFixture(Kind kind, int baud = 1'000'000, Duration every = 1ms)
    {
        source.baud = baud;
        source.every = every;
        for (int i = 0; i < 125; ++i) {
            // The very reply that a PING of servo 1, or a write to it, would bring.
            const Bytes unit = kind == Kind::Frames ? frameOf(1, 0, {}) : Bytes(8, 0x55);
            source.chunk.insert(source.chunk.end(), unit.begin(), unit.end());
        }
        core = std::make_unique<BusCore>(std::make_unique<FloodLink>(source),
                                         protocol::feetechCodec(), source.clock, CoreOptions{});
        source.sent.clear();
    }

    base::Result<Outcome> transact(Request request, const base::StopToken* stop = nullptr)
    {
        Transaction transaction;
        transaction.request = std::move(request);
        transaction.stop = stop;
        return core->transact(transaction);
    }

    FloodLink::Source source;
    std::unique_ptr<BusCore> core;
};
} // namespace

class TestBusFlood : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { QTest::failOnWarning(QRegularExpression(QStringLiteral(".*"))); }

    void noRequestsAmongForeignFrames_data()
    {
        QTest::addColumn<int>("baud");
        QTest::addColumn<Duration>("every");
        for (const int baud : {1'000'000, 115'200, 9'600}) {
            for (const Duration every : {Duration(100us), Duration(1ms)})
                QTest::addRow("%d, each %d us", baud, int(every.count())) << baud << every;
        }
    }

    void noRequestsAmongForeignFrames()
    {
        QFETCH(const int, baud);
        QFETCH(const Duration, every);
        FloodFixture fixture(Kind::Frames, baud, every);
        for (const Request& request : {Request::ping(1), Request::read(1, 56, 2), Request::action(),
                                       Request::write(1, 5, {9}, Repeat::Never)}) {
            const Duration start = fixture.source.clock.now();
            const auto outcome = fixture.transact(request);
            QVERIFY(!outcome);
            QCOMPARE(outcome.error().code, ErrorCode::LineBusy);
            QVERIFY(fixture.source.clock.now() - start < 200ms);
        }
        QVERIFY(fixture.source.sent.empty());
    }

    /// A busy computer hands a flood over in bursts with pauses, in which requests go out.
    void burstsOfAFloodAreReportedAsOne()
    {
        for (int phase = 0; phase < 60; ++phase) {
            FloodFixture fixture(Kind::Frames, 1'000'000, 60ms);
            for (int i = 0; i < 2; ++i) {
                const Bytes half = fixture.source.chunk;
                fixture.source.chunk.insert(fixture.source.chunk.end(), half.begin(), half.end());
            }
            fixture.source.next = fixture.source.clock.now() + std::chrono::milliseconds(phase);
            const auto outcome = fixture.transact(Request::read(1, 56, 2));
            QVERIFY(!outcome);
            QCOMPARE(outcome.error().code, ErrorCode::LineBusy);
        }
    }

    void safetyWritesAreSentButNotTrusted()
    {
        FloodFixture fixture(Kind::Frames);
        const auto outcome = fixture.transact(Request::write(1, 55, {1}, Repeat::Safe));
        QVERIFY(!outcome);
        QCOMPARE(outcome.error().code, ErrorCode::LineBusy);
        QCOMPARE(fixture.source.sent.size(), std::size_t(3));
        QCOMPARE(fixture.source.sent.front().bytes, frameOf(1, 3, {55, 1}));
    }

    void noRequestsOnANoisyLine()
    {
        FloodFixture fixture(Kind::Noise);
        const auto outcome = fixture.transact(Request::ping(1));
        QVERIFY(!outcome);
        QCOMPARE(outcome.error().code, ErrorCode::LineBusy);
        QCOMPARE(outcome.error().attempts, 0);
    }

    void requestsAreSentThroughLightNoiseAndTheCauseReported()
    {
        FloodFixture fixture(Kind::Noise);
        fixture.source.flows = false;
        QVERIFY(fixture.core->listen(3s));
        fixture.source.flows = true;
        fixture.source.chunk = Bytes(8, 0x55);
        fixture.source.every = 400us;
        fixture.source.sent.clear();
        const auto outcome = fixture.transact(Request::ping(1));
        QVERIFY(!outcome);
        QCOMPARE(outcome.error().code, ErrorCode::LineBusy);
        QCOMPARE(fixture.source.sent.size(), std::size_t(3));
    }

    void aByteEachMillisecondIsNoise()
    {
        FloodFixture fixture(Kind::Noise);
        fixture.source.chunk = {0x55};
        QVERIFY(fixture.core->listen(400ms));
        const Duration start = fixture.source.clock.now();
        const auto outcome = fixture.transact(Request::ping(1));
        QVERIFY(!outcome);
        QCOMPARE(outcome.error().code, ErrorCode::Garbled);
        QVERIFY(fixture.source.clock.now() - start < 400ms);
    }

    /// A busy computer does not see the pauses between them.
    void aByteEachMillisecondIsNoiseToABusyComputer()
    {
        FloodFixture fixture(Kind::Noise);
        fixture.source.chunk = {0x55};
        QVERIFY(fixture.core->listen(400ms));
        fixture.source.stall = 3ms;
        const auto outcome = fixture.transact(Request::ping(1));
        QVERIFY(!outcome);
        QCOMPARE(outcome.error().code, ErrorCode::Garbled);
    }

    void recoversWhenItEnds()
    {
        FloodFixture fixture(Kind::Frames);
        QVERIFY(!fixture.transact(Request::ping(1)));
        fixture.source.flows = false;
        QVERIFY(fixture.core->listen(50ms));
        const auto outcome = fixture.transact(Request::ping(1));
        QVERIFY(!outcome);
        QCOMPARE(outcome.error().code, ErrorCode::NoReply);
        QCOMPARE(fixture.source.sent.size(), std::size_t(3));
    }

    void stopEndsEveryWait_data()
    {
        QTest::addColumn<Kind>("kind");
        QTest::addColumn<int>("baud");
        for (const int baud : {1'000'000, 9'600}) {
            QTest::addRow("frames, %d", baud) << Kind::Frames << baud;
            QTest::addRow("noise, %d", baud) << Kind::Noise << baud;
        }
    }

    void stopEndsEveryWait()
    {
        QFETCH(const Kind, kind);
        QFETCH(const int, baud);
        FloodFixture fixture(kind, baud);
        base::StopToken stop;
        std::optional<Duration> asked;
        const Duration from = fixture.source.clock.now() + 3ms;
        fixture.source.onWait = [&] {
            if (!asked && fixture.source.clock.now() >= from) {
                asked = fixture.source.clock.now();
                stop.request();
            }
        };
        const auto outcome = fixture.transact(Request::read(1, 0, 100), &stop);
        QVERIFY(!outcome);
        QCOMPARE(outcome.error().code, ErrorCode::Stopped);
        QVERIFY(asked && fixture.source.clock.now() - *asked < 50ms);
    }

    void stopFramesGetThrough_data() { stopEndsEveryWait_data(); }
    void stopFramesGetThrough()
    {
        QFETCH(const Kind, kind);
        QFETCH(const int, baud);
        FloodFixture fixture(kind, baud);
        const Bytes off = frameOf(254, 3, {40, 0});
        fixture.core->setStopFrames({{base::Protocol::Feetech, off}});
        const Duration start = fixture.source.clock.now();
        fixture.core->emergency();
        QVERIFY(!fixture.source.sent.empty());
        QCOMPARE(fixture.source.sent.front().bytes, off);
        // The longest frames that may be running at this rate, and a moment.
        const Duration longest = Duration(std::int64_t(512) * 10'000'000 / baud);
        QVERIFY(fixture.source.sent.front().at - start < 60ms + longest);
    }

    void theRateCanBeChanged()
    {
        FloodFixture fixture(Kind::Frames);
        QVERIFY(fixture.core->setBaud(500'000));
        QCOMPARE(fixture.core->baud(), 500'000);
    }

    void buffersAreBounded()
    {
        FloodFixture fixture(Kind::Frames, 1'000'000, 100us);
        fixture.source.chunk.resize(0);
        for (int i = 0; i < 2000; ++i) {
            const Bytes frame = frameOf(7, 0, {1, 2, 3});
            fixture.source.chunk.insert(fixture.source.chunk.end(), frame.begin(), frame.end());
        }
        QVERIFY(fixture.core->listen(500ms));
        QVERIFY(fixture.core->takeUnexpectedFrames().size() <= 1024);
        QVERIFY(fixture.core->takeTrace().size() <= 4096);
        // What answers a raw request ends at a size, and at its deadline.
        const Duration start = fixture.source.clock.now();
        const auto raw = fixture.transact(Request::raw(frameOf(1, 1, {})));
        QVERIFY(raw);
        QVERIFY(raw->data().size() <= 65'536 + fixture.source.chunk.size());
        QVERIFY(fixture.source.clock.now() - start < 200ms);
    }

    void aMissingEchoBuffersNothing()
    {
        FloodFixture fixture(Kind::Noise);
        fixture.source.flows = false;
        QVERIFY(fixture.core->listen(3s));
        // Looks like an echoing adapter while the probe is sent, and never again.
        FloodLink::Source source;
        source.flows = false;
        source.onWait = [&source, done = std::size_t(0)]() mutable {
            if (source.sent.size() > done) {
                done = source.sent.size();
                source.chunk = source.sent.back().bytes;
                source.flows = true;
                source.next = source.clock.now();
                source.every = 1h;
            }
        };
        BusCore core(std::make_unique<FloodLink>(source), protocol::feetechCodec(), source.clock,
                     CoreOptions{});
        QVERIFY(core.hasEcho());
        source.onWait = {};
        source.chunk = Bytes(1000, 0x55);
        source.every = 100us;
        source.next = source.clock.now();
        Transaction transaction;
        transaction.request = Request::ping(1);
        const Duration start = source.clock.now();
        const auto outcome = core.transact(transaction);
        QVERIFY(!outcome);
        QCOMPARE(outcome.error().code, ErrorCode::LineBusy);
        QVERIFY(source.clock.now() - start < 300ms);
    }
};

SERVODESK_GUILESS_TEST(TestBusFlood)
#include "tst_bus_flood.moc"
