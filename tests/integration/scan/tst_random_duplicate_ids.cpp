// SPDX-License-Identifier: GPL-3.0-or-later
// Random pairs of servos on one ID, each servo with its own clock, reply time and shaft angle: the
// search suspects at least 99 % of them, and no write is reported as kept. Random single servos are
// never suspected.
#include "device/writer.h"
#include "integration/scan_support.h"
#include "support/test_main.h"

#include <QRegularExpression>
#include <QTest>

#include <random>

using scan_support::find;
using support::SimFixture;
using support::SimFixtureOptions;

namespace {
constexpr int id = 5;
constexpr std::size_t maxExchanges = 20;

class Random {
public:
    explicit Random(std::uint64_t seed)
        : m_generator(seed)
    {}
    int below(int limit) { return int(m_generator() % std::uint64_t(limit)); }
    template <typename T>
    T oneOf(std::initializer_list<T> choices)
    {
        return *(choices.begin() + below(int(choices.size())));
    }

private:
    std::mt19937_64 m_generator;
};

struct RandomBus {
    RandomBus(std::uint64_t seed, int servos)
    {
        Random random(seed);
        options.baud = random.oneOf({1'000'000, 500'000, 115'200});
        options.wire.seed = seed * 1000;
        options.wire.adapterLatency = random.oneOf<base::Duration>(
            {std::chrono::milliseconds(0), std::chrono::milliseconds(1),
             std::chrono::milliseconds(16), std::chrono::milliseconds(60)});
        const QString model =
            random.oneOf<QString>({QStringLiteral("STS3215"), QStringLiteral("STS3250"),
                                   QStringLiteral("SCS15"), QStringLiteral("SM40BLHV")});
        for (int i = 0; i < servos; ++i) {
            specs.push_back({model, id, options.baud, {}, 100.0 + random.below(160), {}, nullptr});
            names << QStringLiteral("%1 at %2°").arg(model).arg(specs.back().initialDegrees);
        }
        names << QString::number(options.baud);
    }
    SimFixtureOptions options;
    std::vector<sim::ServoSpec> specs;
    QStringList names;
};

jobs::ScanSpec onlyThisId()
{
    jobs::ScanSpec spec;
    spec.firstId = id;
    spec.lastId = id;
    spec.protocols = {base::Protocol::Feetech};
    return spec;
}
} // namespace

class TestRandomDuplicateIds : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { QTest::failOnWarning(QRegularExpression(QStringLiteral(".*"))); }
    void searchSuspectsPairs();
    void noWriteToAPairIsKept();
    void searchSuspectsNoSingleServo();
};

void TestRandomDuplicateIds::searchSuspectsPairs()
{
    const int pairs = 1000;
    QStringList missed;
    for (int seed = 1; seed <= pairs; ++seed) {
        const RandomBus random(std::uint64_t(seed), 2);
        SimFixture fixture(random.specs, random.options);
        const auto report = jobs::scan(fixture.context(), onlyThisId());
        QVERIFY(report);
        const jobs::FoundServo* found = find(*report, id);
        const bool suspected = found != nullptr && found->duplicateSuspected;
        if (!suspected || fixture.frameCount() > maxExchanges) {
            missed << QStringLiteral("%1: %2, %3 exchanges")
                          .arg(seed)
                          .arg(random.names.join(QStringLiteral(", ")))
                          .arg(fixture.frameCount());
        }
    }
    QVERIFY2(missed.size() * 100 <= pairs, qPrintable(missed.join(u'\n')));
}

void TestRandomDuplicateIds::noWriteToAPairIsKept()
{
    const int pairs = 200;
    for (int seed = 1; seed <= pairs; ++seed) {
        const RandomBus random(std::uint64_t(seed), 2);
        SimFixture fixture(random.specs, random.options);
        // As found before the second one was plugged in.
        fixture.withBus([](sim::VirtualBus& bus) { bus.unplug(1); });
        device::Servo servo = fixture.servo(id);
        fixture.withBus([](sim::VirtualBus& bus) { bus.plug(1); });
        fixture.runFor(std::chrono::seconds(2));
        const auto write = [&] {
            return device::write(fixture.context(), servo,
                                 {{QStringLiteral("max_temperature"), 61}}, {});
        };
        const auto report = write();
        const QString name = QString::number(seed) + random.names.join(QStringLiteral(", "));
        QVERIFY2(!report && report.error().code == base::ErrorCode::DuplicateId,
                 qPrintable(name + (report ? QString() : base::errorName(report.error().code))));
        QVERIFY(fixture.onlyReadsSent());

        fixture.withBus([](sim::VirtualBus& bus) { bus.unplug(1); });
        const auto alone = write();
        QVERIFY2(alone && alone->isSuccessful(), qPrintable(name));
    }
}

void TestRandomDuplicateIds::searchSuspectsNoSingleServo()
{
    const int servos = 1000;
    for (int seed = 1; seed <= servos; ++seed) {
        const RandomBus random(std::uint64_t(seed), 1);
        SimFixture fixture(random.specs, random.options);
        const auto report = jobs::scan(fixture.context(), onlyThisId());
        QVERIFY(report);
        const jobs::FoundServo* found = find(*report, id);
        QVERIFY2(found != nullptr && found->servo.profile && !found->duplicateSuspected,
                 qPrintable(QString::number(seed) + random.names.join(QStringLiteral(", "))));
    }
}

SERVODESK_GUILESS_TEST(TestRandomDuplicateIds)
#include "tst_random_duplicate_ids.moc"
