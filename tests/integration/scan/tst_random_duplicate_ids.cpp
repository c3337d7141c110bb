// SPDX-License-Identifier: GPL-3.0-or-later
// Random pairs of servos on one ID, in each family, each servo with its own clock, reply time and
// shaft angle: the search suspects at least 99 % of them, and no write is reported as kept. Random
// single servos are never suspected.
#include "device/writer.h"
#include "integration/scan_support.h"
#include "support/test_main.h"

#include <QRegularExpression>
#include <QTest>

#include <map>
#include <random>

using scan_support::find;
using support::SimFixture;
using support::SimFixtureOptions;

namespace {
constexpr int id = 5;
constexpr std::size_t maxExchanges = 20;

class RandomSource {
public:
    explicit RandomSource(std::uint64_t seed)
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

using base::Protocol;

struct RandomBus {
    RandomBus(std::uint64_t seed, int servos, Protocol protocol = Protocol::Feetech)
    {
        RandomSource random(seed);
        const bool isFeetech = protocol == Protocol::Feetech;
        options.baud = isFeetech ? random.oneOf({1'000'000, 500'000, 115'200}) : 115'200;
        options.wire.seed = seed * 1000;
        options.wire.adapterLatency = random.oneOf<base::Duration>(
            {std::chrono::milliseconds(0), std::chrono::milliseconds(1),
             std::chrono::milliseconds(16), std::chrono::milliseconds(60)});
        const QString model = modelOf(protocol, random);
        for (int i = 0; i < servos; ++i) {
            specs.push_back({model, id, options.baud, {}, 100.0 + random.below(160), {}, nullptr});
            names << QStringLiteral("%1 at %2°").arg(model).arg(*specs.back().initialDegrees);
        }
        names << QString::number(options.baud);
    }
    static QString modelOf(Protocol protocol, RandomSource& random)
    {
        if (protocol == Protocol::Lx)
            return random.oneOf<QString>(
                {QStringLiteral("LX-16A"), QStringLiteral("LX-224"), QStringLiteral("HTS-35H")});
        if (protocol == Protocol::Modbus)
            return QStringLiteral("SMSMB");
        return random.oneOf<QString>({QStringLiteral("STS3215"), QStringLiteral("STS3250"),
                                      QStringLiteral("SCS15"), QStringLiteral("SM40BLHV")});
    }

    SimFixtureOptions options;
    std::vector<sim::ServoSpec> specs;
    QStringList names;
};

jobs::ScanSpec onlyThisId(Protocol protocol = Protocol::Feetech)
{
    jobs::ScanSpec spec;
    spec.firstId = id;
    spec.lastId = id;
    spec.protocols = {protocol};
    return spec;
}
} // namespace

class TestRandomDuplicateIds : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { QTest::failOnWarning(QRegularExpression(QStringLiteral(".*"))); }
    void searchSuspectsPairs_data() { addFamilies(1000); }
    void searchSuspectsPairs();
    void noWriteToAPairIsKept_data() { addFamilies(200); }
    void noWriteToAPairIsKept();
    void searchSuspectsNoSingleServo_data() { addFamilies(1000); }
    void searchSuspectsNoSingleServo();

private:
    static void addFamilies(int buses);
};

void TestRandomDuplicateIds::addFamilies(int buses)
{
    QTest::addColumn<Protocol>("protocol");
    QTest::addColumn<int>("buses");
    QTest::newRow("Feetech") << Protocol::Feetech << buses;
    QTest::newRow("LX") << Protocol::Lx << buses;
    QTest::newRow("Modbus") << Protocol::Modbus << buses;
}

void TestRandomDuplicateIds::searchSuspectsPairs()
{
    QFETCH(Protocol, protocol);
    QFETCH(int, buses);
    QStringList missed;
    for (int seed = 1; seed <= buses; ++seed) {
        const RandomBus random(std::uint64_t(seed), 2, protocol);
        SimFixture fixture(random.specs, random.options);
        const auto report = jobs::scan(fixture.context(), onlyThisId(protocol));
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
    QVERIFY2(missed.size() * 100 <= buses, qPrintable(missed.join(u'\n')));
}

void TestRandomDuplicateIds::noWriteToAPairIsKept()
{
    QFETCH(Protocol, protocol);
    QFETCH(int, buses);
    const std::map<Protocol, QString> keys{{Protocol::Feetech, QStringLiteral("max_temperature")},
                                           {Protocol::Lx, QStringLiteral("temp_limit")},
                                           {Protocol::Modbus, QStringLiteral("position_p")}};
    for (int seed = 1; seed <= buses; ++seed) {
        const RandomBus random(std::uint64_t(seed), 2, protocol);
        SimFixture fixture(random.specs, random.options);
        // As found before the second one was plugged in.
        fixture.withBus([](sim::VirtualBus& bus) { bus.unplug(1); });
        device::Servo servo = fixture.servo(id, protocol);
        fixture.withBus([](sim::VirtualBus& bus) { bus.plug(1); });
        fixture.runFor(std::chrono::seconds(2));
        const auto write = [&] {
            return device::write(fixture.context(), servo, {{keys.at(protocol), 61}}, {});
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
    QFETCH(Protocol, protocol);
    QFETCH(int, buses);
    for (int seed = 1; seed <= buses; ++seed) {
        const RandomBus random(std::uint64_t(seed), 1, protocol);
        SimFixture fixture(random.specs, random.options);
        const auto report = jobs::scan(fixture.context(), onlyThisId(protocol));
        QVERIFY(report);
        const jobs::FoundServo* found = find(*report, id);
        QVERIFY2(found != nullptr && found->servo.profile && !found->duplicateSuspected,
                 qPrintable(QString::number(seed) + random.names.join(QStringLiteral(", "))));
    }
}

SERVODESK_GUILESS_TEST(TestRandomDuplicateIds)
#include "tst_random_duplicate_ids.moc"
