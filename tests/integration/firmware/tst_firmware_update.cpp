// SPDX-License-Identifier: GPL-3.0-or-later
// A new firmware for a servo, and everything that may come between: whatever happens, the result is
// the servo's real state, the port is back at its rate, and a rescue completes the update.
#include "base/crc.h"
#include "device/motion/stop_frames.h"
#include "device/reader.h"
#include "jobs/firmware/firmware_preflight.h"
#include "jobs/firmware/firmware_update.h"
#include "jobs/restore/take_snapshot.h"
#include "snapshot/snapshot_compare.h"
#include "support/sim_fixture.h"
#include "support/test_main.h"

#include <QRegularExpression>
#include <QTemporaryDir>
#include <QtTest>

using base::Bytes;
using base::ErrorCode;
using base::FirmwareCheck;
using base::FirmwareOutcome;
using support::SimFixture;
using support::SimFixtureOptions;
using namespace std::chrono_literals;

namespace {
constexpr std::size_t blockSize = 70;
const QString program = QStringLiteral("test");
const Bytes preamble{0x31, 0x66, 0x42, 0x56, 0x41};

jobs::FirmwareFile image(std::size_t size = 1500)
{
    jobs::FirmwareFile file;
    file.path = QStringLiteral("/images/SCServo21-GD32-TTL-250306.bin");
    for (std::size_t i = 0; i < size; ++i)
        file.bytes.push_back(std::uint8_t(i * 7 + i / 256));
    return file;
}

int blocksOf(const jobs::FirmwareFile& file)
{
    return int((file.bytes.size() + 63) / 64);
}

/// What a servo that knows only the facts makes of the frames that were sent: the bytes of the
/// file, or nothing where one breaks a rule.
Bytes acceptedBytes(const std::vector<Bytes>& frames)
{
    Bytes file;
    int expected = 1;
    bool isReady = false;
    bool isEnded = false;
    for (const Bytes& frame : frames) {
        if (frame == Bytes{0x01})
            isReady = true;
        if (!isReady || frame.size() != blockSize)
            continue;
        const Bytes checked(frame.begin(), frame.begin() + 64);
        const int crc = frame[67] << 8 | frame[68];
        if (frame[0] != (expected & 0xFF) || frame[1] != (~expected & 0xFF) || frame[2] != 1 ||
            crc != base::crc16Xmodem(checked) || isEnded)
            return {};
        isEnded = frame[69] == 0x04;
        ++expected;
        file.insert(file.end(), frame.begin() + 3, frame.begin() + 67);
    }
    return isEnded ? file : Bytes();
}

bool startsWith(const Bytes& bytes, const Bytes& start)
{
    return bytes.size() >= start.size() && std::equal(start.begin(), start.end(), bytes.begin());
}

struct Bench {
    explicit Bench(const QString& servos = QStringLiteral("sts3215@1"),
                   const SimFixtureOptions& options = {})
        : fixture(servos, options)
        , servo(fixture.servo(1))
    {
        fixture.clearFrames();
    }

    base::Result<jobs::FirmwareReport> update(const jobs::FirmwareFile& file)
    {
        return jobs::updateFirmware(fixture.context(), servo, file, program);
    }
    base::Result<jobs::FirmwareReport> rescue(const jobs::FirmwareFile& file)
    {
        return jobs::rescueFirmware(fixture.context(), file, program);
    }
    /// Switched off and on while the rescue calls.
    void powerCycleSoon()
    {
        fixture.tap().onWrite = [this, done = false](const Bytes& frame) mutable {
            if (!done && startsWith(frame, preamble)) {
                done = true;
                fixture.powerCycle();
            }
        };
    }
    int version()
    {
        const auto found = device::identify(fixture.context(), 1);
        return found ? found->profile->identity.firmwareMinor : -1;
    }

    SimFixture fixture;
    device::Servo servo;
};
} // namespace

class TestFirmwareUpdate : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { QTest::failOnWarning(QRegularExpression(QStringLiteral(".*"))); }

    void theServoRunsTheNewFirmware()
    {
        Bench bench;
        const jobs::FirmwareFile file = image();
        const int before = bench.version();
        bench.fixture.clearFrames();
        const auto report = bench.update(file);
        QVERIFY(report);
        QCOMPARE(report->outcome, FirmwareOutcome::Updated);
        QVERIFY(!report->error);
        QCOMPARE(report->acceptedBlocks, blocksOf(file));
        QCOMPARE(report->blocks, blocksOf(file));
        QCOMPARE(report->repeats, 0);
        QCOMPARE(report->servo->profile->identity.firmwareMinor, before + 1);
        QCOMPARE(bench.fixture.bus().baud(), 1'000'000);
        QCOMPARE(bench.version(), before + 1);

        Bytes expected = file.bytes;
        expected.resize(std::size_t(blocksOf(file)) * 64, 0xFF);
        QCOMPARE(acceptedBytes(bench.fixture.tap().written), expected);
    }

    void changedDefaultsAreInTheTableAfterwards()
    {
        Bench bench;
        QVERIFY(device::readAll(bench.fixture.context(), bench.servo));
        const auto before = jobs::takeSnapshot(bench.fixture.context(), bench.servo, program);
        QVERIFY(before);
        const auto report = bench.update(image());
        QVERIFY(report && report->table);
        const auto comparison = snapshot::compareSnapshots({&*before, &*report->table});
        QStringList different;
        for (const snapshot::CompareRow& row : comparison.rows) {
            if (row.verdict == snapshot::RowVerdict::Different)
                different << row.key;
        }
        QCOMPARE(different, QStringList({QStringLiteral("protection_time"),
                                         QStringLiteral("overload_torque")}));
    }

    void torqueIsOffBeforeTheRestart()
    {
        Bench bench;
        bench.fixture.poke(1, QStringLiteral("torque_switch"), 1);
        std::optional<std::int64_t> atRestart;
        bench.fixture.tap().onWrite = [&](const Bytes& frame) {
            if (frame == Bytes{0xFF, 0xFF, 0x01, 0x02, 0x08, 0xF4})
                atRestart = bench.fixture.raw(1, QStringLiteral("torque_switch"));
        };
        QVERIFY(bench.update(image(64)));
        QCOMPARE(atRestart, std::optional<std::int64_t>(0));
    }

    void adaptersAndRates_data()
    {
        QTest::addColumn<int>("latencyMs");
        QTest::addColumn<bool>("echo");
        QTest::addColumn<int>("baud");
        QTest::newRow("16 ms") << 16 << false << 1'000'000;
        QTest::newRow("60 ms") << 60 << false << 1'000'000;
        QTest::newRow("echo") << 0 << true << 1'000'000;
        QTest::newRow("at the bootloader's rate") << 0 << false << 500'000;
        QTest::newRow("slow rate") << 16 << false << 38'400;
    }
    void adaptersAndRates()
    {
        QFETCH(int, latencyMs);
        QFETCH(bool, echo);
        QFETCH(int, baud);
        SimFixtureOptions options;
        options.baud = baud;
        options.servoBaud = baud;
        options.wire.adapterLatency = std::chrono::milliseconds(latencyMs);
        options.wire.echo = echo;
        Bench bench(QStringLiteral("sts3215@1"), options);
        const auto report = bench.update(image());
        QVERIFY(report);
        QCOMPARE(report->outcome, FirmwareOutcome::Updated);
        QCOMPARE(bench.fixture.bus().baud(), baud);
    }

    /// At every block.
    void aCutIsNeverASuccess_data()
    {
        QTest::addColumn<int>("cause");
        QTest::newRow("power") << 0;
        QTest::newRow("link") << 1;
        QTest::newRow("silence") << 2;
        QTest::newRow("emergency stop") << 3;
    }
    void aCutIsNeverASuccess()
    {
        QFETCH(int, cause);
        const jobs::FirmwareFile file = image(64 * 36);
        for (int at = 0; at <= blocksOf(file); ++at) {
            Bench bench;
            const int before = bench.version();
            int blocks = 0;
            bench.fixture.tap().onWrite = [&](const Bytes& frame) {
                if (frame.size() != blockSize || blocks++ != at)
                    return;
                switch (cause) {
                case 0:
                    bench.fixture.powerCycle();
                    break;
                case 1:
                    bench.fixture.cutLink();
                    break;
                case 2:
                    bench.fixture.wireConfig().faults.muteIds = {1};
                    break;
                default:
                    bench.fixture.bus().emergency();
                }
            };
            const auto report = bench.update(file);
            const QByteArray where = "block " + QByteArray::number(at);
            QVERIFY2(report, where);
            bench.fixture.tap().onWrite = {};
            bench.fixture.wireConfig().faults.muteIds.clear();
            if (at == blocksOf(file)) { // it never came to that
                QCOMPARE(report->outcome, FirmwareOutcome::Updated);
                continue;
            }
            QVERIFY2(report->outcome != FirmwareOutcome::Updated, where);
            QVERIFY2(report->error, where);
            // Whether the last block arrived cannot be known.
            const bool isLast = at + 1 == blocksOf(file);
            QCOMPARE(report->outcome,
                     isLast ? FirmwareOutcome::Unknown : FirmwareOutcome::Incomplete);
            if (cause == 1)
                bench.fixture.reconnect(1'000'000);
            QCOMPARE(bench.fixture.bus().baud(), 1'000'000);

            // Nothing to rescue: the last block arrived, or the first one did not.
            if (isLast || bench.version() == before)
                continue;
            bench.powerCycleSoon();
            const auto rescued = bench.rescue(file);
            QVERIFY2(rescued, where + (rescued ? ""
                                               : qPrintable(base::errorName(rescued.error().code) +
                                                            rescued.error().detail)));
            QCOMPARE(rescued->outcome, FirmwareOutcome::Updated);
            QCOMPARE(bench.version(), before + 1);
            QCOMPARE(bench.fixture.bus().baud(), 1'000'000);
        }
    }

    void refusedBlocksAreSentAgain()
    {
        Bench bench;
        int refusals = 0;
        bench.fixture.tap().replyOverride = [&](const Bytes& frame) -> std::optional<Bytes> {
            if (frame.size() == blockSize && frame[0] == 5 && refusals < 10) {
                ++refusals;
                return Bytes{0x15};
            }
            return std::nullopt;
        };
        const auto report = bench.update(image());
        QVERIFY(report);
        QCOMPARE(report->outcome, FirmwareOutcome::Updated);
        QCOMPARE(report->repeats, 10);
    }

    void blocksThatAreRefusedForEverEndIt()
    {
        Bench bench;
        bench.fixture.tap().replyOverride = [&](const Bytes& frame) -> std::optional<Bytes> {
            return frame.size() == blockSize && frame[0] == 5 ? std::optional(Bytes{0x15})
                                                              : std::nullopt;
        };
        const auto report = bench.update(image());
        QVERIFY(report);
        QCOMPARE(report->outcome, FirmwareOutcome::Incomplete);
        QCOMPARE(report->error->code, ErrorCode::Refused);
        QCOMPARE(report->acceptedBlocks, 4);
        QCOMPARE(report->repeats, 10);
        QCOMPARE(bench.fixture.bus().baud(), 1'000'000);
    }

    /// Not even its only block was accepted: what replies afterwards is the old firmware.
    void aRefusedFileIsNoUpdate()
    {
        Bench bench;
        int refusals = 0;
        bench.fixture.tap().replyOverride = [&](const Bytes& frame) -> std::optional<Bytes> {
            if (frame.size() != blockSize)
                return std::nullopt;
            if (++refusals == 11)
                bench.fixture.powerCycle();
            return Bytes{0x15};
        };
        const auto report = bench.update(image(64));
        QVERIFY(report);
        QCOMPARE(refusals, 11);
        QCOMPARE(report->outcome, FirmwareOutcome::Unchanged);
        QCOMPARE(report->acceptedBlocks, 0);
    }

    /// It restarts with the firmware it has.
    void withoutABootloaderNothingChanges()
    {
        Bench bench;
        bench.fixture.tap().replyOverride = [&](const Bytes& frame) -> std::optional<Bytes> {
            return startsWith(frame, preamble) ? std::optional(Bytes()) : std::nullopt;
        };
        const int before = bench.version();
        const auto report = bench.update(image());
        QVERIFY(report);
        QCOMPARE(report->outcome, FirmwareOutcome::Unchanged);
        QCOMPARE(report->error->code, ErrorCode::NoReply);
        QCOMPARE(report->servo->profile->identity.firmwareMinor, before);
        QCOMPARE(bench.fixture.bus().baud(), 1'000'000);
    }

    void aStopIsObeyedOnlyBeforeTheFirstBlock()
    {
        Bench early;
        early.fixture.tap().onWrite = [&](const Bytes& frame) {
            if (startsWith(frame, preamble))
                early.fixture.stop().request();
        };
        const auto stopped = early.update(image());
        QVERIFY(stopped);
        QCOMPARE(stopped->outcome, FirmwareOutcome::Unchanged);
        QCOMPARE(stopped->error->code, ErrorCode::Stopped);

        Bench late;
        late.fixture.tap().onWrite = [&](const Bytes& frame) {
            if (frame.size() == blockSize)
                late.fixture.stop().request();
        };
        const auto finished = late.update(image());
        QVERIFY(finished);
        QCOMPARE(finished->acceptedBlocks, finished->blocks);
        QCOMPARE(late.version(), 11);
    }

    void aLineThatLosesRepliesNeverLies()
    {
        int updated = 0;
        for (int seed = 1; seed <= 40; ++seed) {
            SimFixtureOptions options;
            options.wire.seed = std::uint64_t(seed);
            Bench bench(QStringLiteral("sts3215@1"), options);
            const int before = bench.version();
            bench.fixture.wireConfig().faults.drop = 0.05;
            const auto report = bench.update(image());
            bench.fixture.wireConfig().faults.drop = 0;
            if (!report)
                continue; // not begun
            const bool isNew = bench.version() == before + 1;
            if (report->outcome == FirmwareOutcome::Updated)
                QVERIFY(isNew);
            if (report->outcome == FirmwareOutcome::Unchanged)
                QVERIFY(!isNew);
            updated += isNew ? 1 : 0;
            if (isNew)
                continue;
            bench.powerCycleSoon();
            const auto rescued = bench.rescue(image());
            QVERIFY(rescued);
            QCOMPARE(rescued->outcome, FirmwareOutcome::Updated);
        }
        QVERIFY(updated > 0 && updated < 40);
    }

    void aRescueNeedsNoServoToBeKnown()
    {
        SimFixtureOptions options;
        options.servoBaud = 115'200;
        SimFixture fixture(QStringLiteral("sts3215@9+firmware-lost=1"), options);
        const auto report = jobs::rescueFirmware(fixture.context(), image(), program);
        QVERIFY(report);
        QCOMPARE(report->outcome, FirmwareOutcome::Updated);
        QCOMPARE(report->servo->id, 9);
        QCOMPARE(report->servo->baud, 115'200);
    }

    void aRescueWorksThroughSlowAdapters()
    {
        for (const int latency : {0, 16, 60}) {
            SimFixtureOptions options;
            options.wire.adapterLatency = std::chrono::milliseconds(latency);
            SimFixture fixture(QStringLiteral("sts3215@1+firmware-lost=1"), options);
            const auto report = jobs::rescueFirmware(fixture.context(), image(), program);
            QVERIFY2(report, qPrintable(QStringLiteral("%1 ms: %2")
                                            .arg(latency)
                                            .arg(report ? QString()
                                                        : base::errorName(report.error().code))));
            QCOMPARE(report->outcome, FirmwareOutcome::Updated);
            QCOMPARE(report->servo->id, 1);
        }
    }

    /// Another one would take the firmware as well, or be taken for the rescued one.
    void aRescueBesideOtherServosIsRefused()
    {
        SimFixture fixture(QStringLiteral("sts3215@9+firmware-lost=1,sts3215@2"));
        const auto report = jobs::rescueFirmware(fixture.context(), image(), program);
        QVERIFY(!report);
        QCOMPARE(report.error().detail, QStringLiteral("rescue-not-alone"));
        QVERIFY(fixture.onlyReadsSent());
        QCOMPARE(fixture.bus().baud(), 1'000'000);
    }

    /// Their supply came on together: all of them have taken it.
    void severalRescuedServosAreNotToldApart()
    {
        SimFixture fixture(QStringLiteral("sts3215@9+firmware-lost=1,sts3215@2+firmware-lost=1"));
        const auto report = jobs::rescueFirmware(fixture.context(), image(), program);
        if (report) { // their replies did not collide
            QCOMPARE(report->outcome, FirmwareOutcome::Unknown);
            QCOMPARE(report->error->detail, QStringLiteral("several-rescued"));
        }
        QCOMPARE(fixture.bus().baud(), 1'000'000);
    }

    /// The other servos hear it at their own rate.
    void anEmergencyStopReachesTheOtherServos_data()
    {
        QTest::addColumn<int>("moment");
        QTest::newRow("while announcing") << 0;
        QTest::newRow("at a block") << 1;
        QTest::newRow("stopped as well, as the window does") << 2;
    }
    void anEmergencyStopReachesTheOtherServos()
    {
        QFETCH(int, moment);
        Bench bench(QStringLiteral("sts3215@1,sts3215@2"));
        bench.fixture.bus().setStopFrames(device::stopFrames({base::Protocol::Feetech}));
        bench.fixture.poke(2, QStringLiteral("torque_switch"), 1);
        bool done = false;
        bench.fixture.tap().onWrite = [&](const Bytes& frame) {
            const bool isIt = moment == 1 ? frame.size() == blockSize && frame[0] == 9
                                          : startsWith(frame, preamble);
            if (!isIt || std::exchange(done, true))
                return;
            bench.fixture.bus().emergency();
            if (moment == 2)
                bench.fixture.stop().request();
        };
        const auto report = bench.update(image());
        QVERIFY(report);
        QVERIFY(report->outcome != FirmwareOutcome::Updated);
        QCOMPARE(bench.fixture.bus().baud(), 1'000'000);
        (void)bench.fixture.bus().listen(100ms);
        QCOMPARE(bench.fixture.raw(2, QStringLiteral("torque_switch")), std::int64_t(0));
    }

    void anEmergencyStopEndsARescueAtTheOldRate()
    {
        SimFixture fixture(QStringLiteral("sts3215@1+firmware-lost=1"));
        bool done = false;
        fixture.tap().onWrite = [&](const Bytes& frame) {
            if (startsWith(frame, preamble) && !std::exchange(done, true))
                fixture.bus().emergency();
        };
        const auto report = jobs::rescueFirmware(fixture.context(), image(), program);
        QCOMPARE(report ? report->error->code : report.error().code, ErrorCode::Preempted);
        QCOMPARE(fixture.bus().baud(), 1'000'000);
        QCOMPARE(fixture.bus().emergencyCount(), std::uint64_t(2)); // once more at this rate
    }

    void aRescueWithoutBootloaderEndsInTime()
    {
        Bench bench;
        bench.fixture.withBus([](sim::VirtualBus& bus) { bus.unplugAll(); });
        const base::Duration began = bench.fixture.clock().now();
        const auto report = bench.rescue(image());
        QVERIFY(!report);
        QCOMPARE(report.error().detail, QStringLiteral("no-bootloader"));
        const base::Duration took = bench.fixture.clock().now() - began;
        QVERIFY(took >= 30s && took < 35s);
        QCOMPARE(bench.fixture.bus().baud(), 1'000'000);
    }

    void otherFamiliesAreRefused()
    {
        SimFixtureOptions options;
        options.baud = 115'200;
        SimFixture fixture(QStringLiteral("lx16a@1"), options);
        device::Servo servo = fixture.servo(1, base::Protocol::Lx);
        fixture.clearFrames();
        const auto report = jobs::updateFirmware(fixture.context(), servo, image(), program);
        QVERIFY(!report);
        QCOMPARE(report.error().code, ErrorCode::NotSupported);
        QCOMPARE(fixture.frameCount(), std::size_t(0));
    }

    void anAdapterWithoutTheRateLeavesTheServoAlone()
    {
        Bench bench;
        bench.fixture.tap().refusedRates = {500'000};
        const auto report = bench.update(image());
        QVERIFY(!report);
        QCOMPARE(report.error().code, ErrorCode::RateUnsupported);
        QCOMPARE(bench.fixture.frames(support::Reboot), 0);
    }

    void thePreflightOfAGoodBenchIsGreen()
    {
        Bench bench;
        const auto checks = preflight(bench, image());
        for (const base::FirmwareCheckResult& one : checks)
            QVERIFY2(one.isPassed, qPrintable(base::firmwareCheckName(one.check)));
        QCOMPARE(checks.size(), std::size_t(6));
        QCOMPARE(bench.fixture.raw(1, QStringLiteral("torque_switch")), std::int64_t(0));
    }

    void thePreflightNamesEachRisk_data()
    {
        QTest::addColumn<QString>("servos");
        QTest::addColumn<double>("volts");
        QTest::addColumn<QString>("path");
        QTest::addColumn<int>("size");
        QTest::addColumn<FirmwareCheck>("risk");
        const QString one = QStringLiteral("sts3215@1");
        const QString good = image().path;
        QTest::newRow("second servo") << QStringLiteral("sts3215@1,scs15@7") << 7.4 << good << 1500
                                      << FirmwareCheck::OtherServos;
        QTest::newRow("another line") << one << 7.4 << QStringLiteral("FT-HLS-GD32-TTL-250326.bin")
                                      << 1500 << FirmwareCheck::FileName;
        QTest::newRow("another bus")
            << one << 7.4 << QStringLiteral("SCServo21-GD32-485-250306.bin") << 1500
            << FirmwareCheck::FileName;
        QTest::newRow("another family with the same letters")
            << one << 7.4 << QStringLiteral("SCServo2.20-GD32-TTL(200824).bin") << 1500
            << FirmwareCheck::FileName;
        QTest::newRow("a servo at the bootloader's rate")
            << QStringLiteral("sts3215@1,sts3215@7:500000") << 7.4 << good << 1500
            << FirmwareCheck::OtherServos;
        QTest::newRow("renamed") << one << 7.4 << QStringLiteral("new.bin") << 1500
                                 << FirmwareCheck::FileName;
        QTest::newRow("large") << one << 7.4 << good << 29'697 << FirmwareCheck::FileSize;
        QTest::newRow("supply too low") << one << 3.5 << good << 1500 << FirmwareCheck::Supply;
        QTest::newRow("supply too high") << one << 9.0 << good << 1500 << FirmwareCheck::Supply;
    }
    void thePreflightNamesEachRisk()
    {
        QFETCH(QString, servos);
        QFETCH(double, volts);
        QFETCH(QString, path);
        QFETCH(int, size);
        QFETCH(FirmwareCheck, risk);
        Bench bench(servos);
        bench.fixture.withBus(
            [&](sim::VirtualBus& bus) { bus.servo(1)->environment().supplyVolts = volts; });
        bench.fixture.runFor(1s);
        jobs::FirmwareFile file = image(std::size_t(size));
        file.path = path;
        const auto checks = preflight(bench, file);
        QCOMPARE(checks.size(), std::size_t(6));
        for (const base::FirmwareCheckResult& one : checks)
            QVERIFY2(one.isPassed == (one.check != risk),
                     qPrintable(base::firmwareCheckName(one.check)));
    }

    void onlyImagesForBusServosAreLoaded_data()
    {
        QTest::addColumn<QString>("name");
        QTest::addColumn<int>("size");
        QTest::addColumn<QString>("refusal");
        QTest::newRow("good") << "a.bin" << 64 << "";
        QTest::newRow("capital letters") << "A.BIN" << 65'535 << "";
        QTest::newRow("too small") << "a.bin" << 63 << "firmware-size";
        QTest::newRow("too large") << "a.bin" << 65'536 << "firmware-size";
        QTest::newRow("empty") << "a.bin" << 0 << "firmware-size";
        for (const char* kind : {"a.hex", "a.fbin", "a.mbin", "a.xbin", "a.txt", "bin"})
            QTest::newRow(kind) << kind << 1000 << "firmware-kind";
    }
    void onlyImagesForBusServosAreLoaded()
    {
        QFETCH(QString, name);
        QFETCH(int, size);
        QFETCH(QString, refusal);
        const QTemporaryDir folder;
        QFile out(folder.filePath(name));
        QVERIFY(out.open(QIODevice::WriteOnly));
        out.write(QByteArray(size, 'x'));
        out.close();
        const auto loaded = jobs::loadFirmwareFile(out.fileName());
        QCOMPARE(loaded.has_value(), refusal.isEmpty());
        if (!loaded)
            QCOMPARE(loaded.error().detail, refusal);
        else
            QCOMPARE(loaded->bytes.size(), std::size_t(size));
    }

private:
    static std::vector<base::FirmwareCheckResult> preflight(Bench& bench,
                                                            const jobs::FirmwareFile& file)
    {
        const auto checks =
            jobs::checkFirmwareUpdate(bench.fixture.context(), bench.servo, {file, {}, {}});
        return checks ? *checks : std::vector<base::FirmwareCheckResult>();
    }
};

SERVODESK_GUILESS_TEST(TestFirmwareUpdate)
#include "tst_firmware_update.moc"
