// SPDX-License-Identifier: GPL-3.0-or-later
// Broken replies in a search: two servos on one ID, a servo with unreadable replies, and noise
// without a servo.
#include "device/duplicate_id_check.h"
#include "integration/scan_support.h"
#include "support/test_main.h"

#include <QRegularExpression>
#include <QTest>

using scan_support::fast;
using scan_support::find;
using scan_support::idsOf;
using std::chrono::milliseconds;
using support::SimFixture;
using support::SimFixtureOptions;

namespace {
std::vector<sim::ServoSpec> twins(const QString& one, const QString& other)
{
    return {{one, 5, fast, 7.4, 180, {}, nullptr},
            {other, 5, fast, 7.4, 95, {}, nullptr},
            {QStringLiteral("STS3215"), 9, fast, 7.4, 180, {}, nullptr}};
}
} // namespace

class TestScanDuplicateId : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { QTest::failOnWarning(QRegularExpression(QStringLiteral(".*"))); }

    void suspectsDuplicateIds_data();
    void suspectsDuplicateIds();
    void suspectsDuplicateIdsThatReplyInTurn();
    void suspectsSixNewServos();
    void listsAServoWithOnlyGarbledReplies_data();
    void listsAServoWithOnlyGarbledReplies();
    void garbledBytesProveNoServo();
    void oneGarbledReplyIsNoDuplicate();
    void noiseIsReportedAndProvesNoServo();
    void oneServoCouldReplyLikeThis_data();
    void oneServoCouldReplyLikeThis();
    void blindSpotOfATurnIsNoJump();
};

void TestScanDuplicateId::suspectsDuplicateIds_data()
{
    QTest::addColumn<QString>("one");
    QTest::addColumn<QString>("other");
    QTest::addColumn<int>("latencyMs");
    const QString sts = QStringLiteral("STS3215");
    for (const int latency : {0, 16}) {
        QTest::addRow("same model, latency %d", latency) << sts << sts << latency;
        QTest::addRow("same series, latency %d", latency)
            << sts << QStringLiteral("STS3250") << latency;
        QTest::addRow("other series, latency %d", latency)
            << sts << QStringLiteral("SCS15") << latency;
    }
}

void TestScanDuplicateId::suspectsDuplicateIds()
{
    QFETCH(QString, one);
    QFETCH(QString, other);
    QFETCH(int, latencyMs);
    SimFixtureOptions options;
    options.wire.adapterLatency = milliseconds(latencyMs);
    SimFixture fixture(twins(one, other), options);
    const auto report = jobs::scan(fixture.context(), {});
    QVERIFY(report);
    QCOMPARE(idsOf(*report), QList<int>({5, 9}));
    QVERIFY(find(*report, 5)->duplicateSuspected);
    QVERIFY(!find(*report, 9)->duplicateSuspected);
    QVERIFY(fixture.onlyReadsSent());
}

// Two SMS servos with different reply delays: each answer comes whole, and there are two of them.
void TestScanDuplicateId::suspectsDuplicateIdsThatReplyInTurn()
{
    const QString sms = QStringLiteral("SM40BLHV");
    const auto slow = [](sim::VirtualServo& servo) {
        servo.poke(QStringLiteral("return_delay"), 250);
    };
    SimFixture fixture(
        {{sms, 5, fast, 12.0, 180, {}, nullptr}, {sms, 5, fast, 12.0, 180, {}, slow}});
    const auto report = jobs::scan(fixture.context(), {});
    QVERIFY(report);
    QCOMPARE(idsOf(*report), QList<int>({5}));
    QVERIFY(report->found.front().duplicateSuspected);
}

void TestScanDuplicateId::suspectsSixNewServos()
{
    for (const int latencyMs : {0, 16, 60}) {
        SimFixtureOptions options;
        options.wire.adapterLatency = milliseconds(latencyMs);
        SimFixture fixture(QStringLiteral("new-arm"), options);
        const auto report = jobs::scan(fixture.context(), {});
        QVERIFY(report);
        QCOMPARE(idsOf(*report), QList<int>({1}));
        QVERIFY(report->found.front().duplicateSuspected);
    }
}

void TestScanDuplicateId::listsAServoWithOnlyGarbledReplies_data()
{
    QTest::addColumn<int>("latencyMs");
    QTest::newRow("at once") << 0;
    QTest::newRow("while later IDs are asked") << 16;
}

void TestScanDuplicateId::listsAServoWithOnlyGarbledReplies()
{
    QFETCH(int, latencyMs);
    SimFixtureOptions options;
    options.wire.faults.corrupt = 1.0;
    options.wire.adapterLatency = milliseconds(latencyMs);
    SimFixture fixture(QStringLiteral("sts3215@17"), options);
    const auto report = jobs::scan(fixture.context(), {});
    QVERIFY(report);
    QCOMPARE(idsOf(*report), QList<int>({17}));
    QVERIFY(report->found.front().duplicateSuspected);
    QVERIFY(!report->found.front().servo.profile);
    QVERIFY(!report->hasGarbledReplies); // explained by the servo listed
}

void TestScanDuplicateId::garbledBytesProveNoServo()
{
    QStringList servos;
    for (int id = 1; id <= 40; ++id)
        servos.append(QStringLiteral("sts3215@%1").arg(id));
    SimFixtureOptions options;
    options.wire.faults.corrupt = 1.0;
    SimFixture fixture(servos.join(QLatin1Char(',')), options);
    const auto report = jobs::scan(fixture.context(), {});
    QVERIFY(report);
    QVERIFY(report->found.empty());
    QVERIFY(report->hasGarbledReplies);
}

void TestScanDuplicateId::oneGarbledReplyIsNoDuplicate()
{
    SimFixture fixture(QStringLiteral("sts3215@17"));
    fixture.tap().onWrite = [&](const base::Bytes&) {
        fixture.wireConfig().faults.corrupt = fixture.framesSentTo(17) == 1 ? 1.0 : 0.0;
    };
    const auto report = jobs::scan(fixture.context(), {});
    QVERIFY(report);
    QCOMPARE(idsOf(*report), QList<int>({17}));
    QVERIFY(!report->found.front().duplicateSuspected);
    QVERIFY(report->found.front().servo.profile);
    QVERIFY(!report->hasGarbledReplies); // it was explained
}

void TestScanDuplicateId::noiseIsReportedAndProvesNoServo()
{
    SimFixture fixture(QStringLiteral("sts3215@40"));
    fixture.tap().onWrite = [&](const base::Bytes& frame) {
        // A frame cut short by noise: bytes come, once, and never again.
        sim::FaultPlan& faults = fixture.wireConfig().faults;
        faults.muteIds = fixture.framesSentTo(40) > 1 ? std::vector<int>{40} : std::vector<int>{};
        faults.truncate = frame[2] == 40 ? 1.0 : 0.0;
    };
    const auto report = jobs::scan(fixture.context(), {});
    QVERIFY(report);
    QVERIFY(report->found.empty());
    QVERIFY(report->hasGarbledReplies);
}

void TestScanDuplicateId::oneServoCouldReplyLikeThis_data()
{
    QTest::addColumn<int>("before");
    QTest::addColumn<int>("after");
    QTest::addColumn<int>("speed");
    QTest::addColumn<int>("temperature");
    QTest::addColumn<bool>("possible");
    QTest::newRow("at rest, same") << 2048 << 2048 << 0 << 30 << true;
    QTest::newRow("at rest, jitter") << 2048 << 2051 << 0 << 30 << true;
    QTest::newRow("at rest, elsewhere") << 2048 << 2148 << 0 << 30 << false;
    QTest::newRow("moving on") << 2048 << 2068 << 3000 << 30 << true;
    QTest::newRow("moving, too far") << 2048 << 3000 << 3000 << 30 << false;
    QTest::newRow("over the seam") << 4094 << 3 << 0 << 30 << true;
    QTest::newRow("sudden heat") << 2048 << 2048 << 0 << 45 << false;
}

void TestScanDuplicateId::oneServoCouldReplyLikeThis()
{
    QFETCH(int, before);
    QFETCH(int, after);
    QFETCH(int, speed);
    QFETCH(int, temperature);
    QFETCH(bool, possible);
    device::Servo a;
    a.profile = support::builtInCatalog().resolve({3, 10, 0, 9, 3});
    const auto low = [](int value) { return std::uint8_t(value & 0xFF); };
    const auto high = [](int value) { return std::uint8_t(value >> 8); };
    const std::uint8_t moving = speed != 0 ? 1 : 0;
    const auto feedback = [&](int position, int degrees) {
        return base::Bytes{low(position),
                           high(position),
                           low(speed),
                           high(speed),
                           0,
                           0,
                           74,
                           std::uint8_t(degrees),
                           0,
                           0,
                           moving,
                           0,
                           0,
                           0,
                           0};
    };
    device::Servo b = a;
    a.image.store(56, feedback(before, 30), {});
    b.image.store(56, feedback(after, temperature), {});
    QCOMPARE(device::canBeOneServo(a, b, milliseconds(4)), possible);
}

/// An SCS servo at rest where it cannot measure reports either end of its range.
void TestScanDuplicateId::blindSpotOfATurnIsNoJump()
{
    const auto at = [](int position) {
        device::Servo servo;
        servo.profile = support::builtInCatalog().resolve({0, 15, 1, 5, 15});
        base::Bytes feedback(15, 0);
        feedback[0] = std::uint8_t(position >> 8);
        feedback[1] = std::uint8_t(position & 0xFF);
        servo.image.store(56, feedback, {});
        return servo;
    };
    QCOMPARE(at(1023).raw(catalog::Role::PresentPosition), std::optional<std::int64_t>(1023));
    QVERIFY(device::canBeOneServo(at(1023), at(0), milliseconds(4)));
    QVERIFY(device::canBeOneServo(at(0), at(1023), milliseconds(4)));
    QVERIFY(!device::canBeOneServo(at(900), at(100), milliseconds(4)));
    QVERIFY(!device::canBeOneServo(at(512), at(540), milliseconds(4)));
}

SERVODESK_GUILESS_TEST(TestScanDuplicateId)
#include "tst_scan_duplicate_id.moc"
