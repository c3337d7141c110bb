// SPDX-License-Identifier: GPL-3.0-or-later
#include "jobs/firmware/firmware_update.h"

#include "device/bootloader.h"
#include "device/motion/motion.h"
#include "device/reader.h"
#include "device/write_access.h"
#include "jobs/change/change_steps.h"
#include "jobs/restore/take_snapshot.h"
#include "jobs/scan/scan.h"

#include <algorithm>

namespace jobs {
namespace {
using base::ErrorCode;
using base::FirmwareOutcome;
using device::BootloaderReply;
using namespace std::chrono_literals;

const QString firmwareOperation = QStringLiteral("firmware");
/// The servo needs this long from its restart into its bootloader, which then waits for 800 ms.
constexpr base::Duration restartPause = 15ms;
constexpr base::Duration ratePause = 100ms;
constexpr int announcements = 4;
constexpr base::Duration leastAnnounceWait = 60ms;
/// A servo whose supply comes on is caught in its first 800 ms.
constexpr base::Duration rescueInterval = 20ms;
constexpr int maxRepeats = 10; ///< of one block
constexpr base::Duration startTime = 2s;
constexpr base::Duration startInterval = 50ms;

/// The port is at the bootloader's rate while it lives. An emergency stop meanwhile reached none of
/// the other servos: it is sent once more at the old rate.
class BootloaderRate {
public:
    explicit BootloaderRate(const device::Context& context)
        : m_context(context)
        , m_oldBaud(context.bus.baud())
        , m_emergencyCount(context.bus.emergencyCount())
    {}
    ~BootloaderRate() { (void)restore(); }
    BootloaderRate(const BootloaderRate&) = delete;
    BootloaderRate& operator=(const BootloaderRate&) = delete;

    bool isOld() const { return m_oldBaud == device::bootloaderBaud; }
    base::Result<void> set() { return setBaud(device::bootloaderBaud); }
    base::Result<void> restore()
    {
        const auto restored = setBaud(m_oldBaud);
        if (m_context.bus.emergencyCount() != m_emergencyCount) {
            m_context.bus.emergency();
            m_emergencyCount = m_context.bus.emergencyCount();
        }
        return restored;
    }

private:
    base::Result<void> setBaud(int baud)
    {
        return m_context.bus.baud() == baud ? base::Result<void>{} : m_context.bus.setBaud(baud);
    }

    const device::Context& m_context;
    const int m_oldBaud;
    std::uint64_t m_emergencyCount;
};

base::Error errorOf(BootloaderReply reply)
{
    return {reply == BootloaderReply::Silence   ? ErrorCode::NoReply
            : reply == BootloaderReply::Refused ? ErrorCode::Refused
                                                : ErrorCode::Garbled,
            firmwareOperation};
}

base::Result<void> requireAccepted(const base::Result<BootloaderReply>& reply)
{
    if (!reply)
        return tl::unexpected(reply.error());
    return *reply == BootloaderReply::Accepted ? base::Result<void>{}
                                               : tl::unexpected(errorOf(*reply));
}

class FirmwareTransfer {
public:
    FirmwareTransfer(const device::Context& context, const FirmwareFile& file,
                     const ProgressFn& progress)
        : m_context(context)
        , m_file(file)
        , m_progress(progress)
    {
        m_report.blocks = protocol::firmwareBlocks(file.bytes.size());
    }

    /// Its bootloader has just begun.
    base::Result<void> announce()
    {
        const base::Duration wait = std::max(leastAnnounceWait, m_context.bus.maxReplyLateness());
        base::Result<BootloaderReply> reply;
        for (int i = 0; i < announcements; ++i) {
            if (m_context.stop.isRequested())
                return base::fail(ErrorCode::Stopped, firmwareOperation);
            reply = device::callBootloader(m_context, wait);
            if (reply && *reply == BootloaderReply::Accepted && i > 0)
                return awaitLateReplies();
            if (!reply || *reply == BootloaderReply::Accepted)
                break;
        }
        return requireAccepted(reply);
    }

    /// Until one answers.
    base::Result<void> call()
    {
        base::Clock& clock = m_context.bus.clock();
        const base::Duration start = clock.now();
        for (base::Duration passed{}; passed < rescueTime; passed = clock.now() - start) {
            if (m_context.stop.isRequested())
                return base::fail(ErrorCode::Stopped, firmwareOperation);
            const auto reply = device::callBootloader(m_context, rescueInterval);
            if (!reply)
                return tl::unexpected(reply.error());
            if (*reply == BootloaderReply::Accepted)
                return awaitLateReplies();
            report(0, rescueTime - passed);
        }
        return base::fail(ErrorCode::NoReply, firmwareOperation, QStringLiteral("no-bootloader"));
    }

    base::Result<void> sendBlocks()
    {
        if (m_context.stop.isRequested())
            return base::fail(ErrorCode::Stopped, firmwareOperation);
        m_isStarted = true;
        if (const auto started = requireAccepted(device::startTransfer(m_context)); !started)
            return started;
        for (int index = 0; index < m_report.blocks; ++index) {
            if (const auto sent = sendBlock(index); !sent)
                return sent;
            ++m_report.acceptedBlocks;
            report(double(m_report.acceptedBlocks) / m_report.blocks);
        }
        return {};
    }

    FirmwareReport& result() { return m_report; }
    /// What is known of the servo before it is asked. After the start byte the old firmware does
    /// not start on its own.
    void end(const base::Result<void>& done, const base::Result<void>& restored)
    {
        if (!done)
            m_report.error = done.error();
        else if (!restored)
            m_report.error = restored.error();
        if (m_report.sentBlocks > 0 && m_report.sentBlocks < m_report.blocks)
            m_report.outcome = FirmwareOutcome::Incomplete;
        else if (m_isStarted)
            m_report.outcome = FirmwareOutcome::Unknown;
    }

private:
    /// Through a slow adapter those to the calls before would be taken for those to the blocks.
    base::Result<void> awaitLateReplies()
    {
        return m_context.bus.listen(m_context.bus.maxReplyLateness());
    }

    base::Result<void> sendBlock(int index)
    {
        for (int repeats = 0;; ++repeats) {
            const auto reply = device::sendFirmwareBlock(m_context, m_file.bytes, index);
            const bool isRefused = reply && *reply == BootloaderReply::Refused;
            if (!isRefused && (reply || reply.error().attempts > 0))
                m_report.sentBlocks = index + 1;
            if (!isRefused || repeats == maxRepeats)
                return requireAccepted(reply);
            ++m_report.repeats;
        }
    }

    void report(double fraction, std::optional<base::Duration> remaining = {}) const
    {
        if (m_progress)
            m_progress(
                {.fraction = fraction, .remaining = remaining, .baud = device::bootloaderBaud});
    }

    const device::Context& m_context;
    const FirmwareFile& m_file;
    const ProgressFn& m_progress;
    FirmwareReport m_report;
    bool m_isStarted = false;
};

/// What answers has the new firmware if every block was sent, else its old one.
template <typename Find>
void lookAfterwards(const device::Context& context, FirmwareReport& report, Find&& find,
                    const QString& program)
{
    if (report.outcome == FirmwareOutcome::Incomplete ||
        (report.error && base::endsJob(report.error->code)))
        return;
    auto found = find();
    if (!found) {
        report.error = report.error.value_or(found.error());
        report.outcome = FirmwareOutcome::Unknown;
        return;
    }
    report.servo = std::move(*found);
    report.outcome =
        report.sentBlocks == report.blocks ? FirmwareOutcome::Updated : FirmwareOutcome::Unchanged;
    if (auto table = takeSnapshot(context, *report.servo, program))
        report.table = std::move(*table);
}

/// The application begins as soon as the last block is in.
base::Result<device::Servo> awaitServo(const device::Context& context, const device::Servo& servo)
{
    base::Clock& clock = context.bus.clock();
    const base::Duration end = clock.now() + startTime + context.bus.maxReplyLateness();
    for (;;) {
        auto found = device::identify(context, servo.id, servo.protocol);
        if (found || base::endsJob(found.error().code) || clock.now() > end)
            return found;
        clock.sleepFor(startInterval);
    }
}

/// The rescued servo could not be told from others, and they would take the firmware too.
base::Result<void> requireSilence(const device::Context& context)
{
    ScanSpec spec;
    spec.protocols = {base::Protocol::Feetech};
    const auto report = scan(context, spec);
    if (!report)
        return tl::unexpected(report.error());
    if (report->stopped)
        return base::fail(ErrorCode::Stopped, firmwareOperation);
    // Broken replies may be those of a bootloader to bytes it takes for a block.
    const bool isSilent =
        std::all_of(report->found.begin(), report->found.end(),
                    [](const FoundServo& one) { return one.servo.profile == nullptr; });
    return isSilent ? base::Result<void>{}
                    : base::fail(ErrorCode::NotSupported, firmwareOperation,
                                 QStringLiteral("rescue-not-alone"));
}

/// With a second one on the bus it is not clear which of them has taken the firmware.
base::Result<device::Servo> searchServo(const device::Context& context)
{
    ScanSpec spec;
    spec.protocols = {base::Protocol::Feetech};
    spec.bauds = {context.bus.baud()};
    for (const int baud : {1'000'000, 115'200, 500'000, 250'000, 57'600, 38'400})
        spec.bauds.push_back(baud);
    spec.untilFound = true;
    context.bus.clock().sleepFor(startTime);
    const auto report = scan(context, spec);
    if (!report)
        return tl::unexpected(report.error());
    const device::Servo* found = nullptr;
    for (const FoundServo& one : report->found) {
        if (one.servo.profile == nullptr)
            continue;
        if (found != nullptr)
            return base::fail(ErrorCode::NotSupported, firmwareOperation,
                              QStringLiteral("several-rescued"));
        found = &one.servo;
    }
    if (found == nullptr)
        return base::fail(ErrorCode::NoReply, firmwareOperation);
    return *found;
}

} // namespace

base::Result<void> requireBootloader(const device::Servo& servo)
{
    if (servo.protocol != base::Protocol::Feetech)
        return base::fail(ErrorCode::NotSupported, firmwareOperation,
                          QStringLiteral("no-firmware-update"), servo.id);
    return {};
}

std::vector<snapshot::CompareRow> changedSettings(const snapshot::Snapshot& before,
                                                  const snapshot::Snapshot& after)
{
    auto rows = snapshot::compareSnapshots({&before, &after}).rows;
    std::erase_if(rows, [](const snapshot::CompareRow& row) {
        return row.verdict != snapshot::RowVerdict::Different ||
               row.area == catalog::Area::Feedback || row.area == catalog::Area::Sram;
    });
    return rows;
}

base::Result<FirmwareReport> updateFirmware(const device::Context& outer, device::Servo& servo,
                                            const FirmwareFile& file, const QString& program,
                                            const ProgressFn& progress)
{
    if (const auto possible = requireBootloader(servo); !possible)
        return tl::unexpected(possible.error());
    const device::Owned owned = device::own(outer, {});
    const device::Context& context = owned.context;
    if (const auto may = device::beginWriting(context, servo, firmwareOperation); !may)
        return tl::unexpected(may.error());
    if (const auto off = device::setTorque(context, servo, device::Torque::Off); !off)
        return tl::unexpected(off.error());
    if (context.stop.isRequested())
        return base::fail(ErrorCode::Stopped, firmwareOperation, {}, servo.id);

    FirmwareTransfer transfer(context, file, progress);
    FirmwareReport& report = transfer.result();
    BootloaderRate rate(context);
    // An adapter that cannot run it says so while the servo is still as it was.
    if (const auto possible = rate.set().and_then([&] { return rate.restore(); }); !possible)
        return tl::unexpected(possible.error());
    const auto done = sendOnce(context, protocol::Request::reboot(servo.id))
                          .and_then([&](const SendResult&) {
                              context.bus.clock().sleepFor(restartPause);
                              return rate.set();
                          })
                          .and_then([&] { return context.bus.listen(ratePause); })
                          .and_then([&] { return transfer.announce(); })
                          .and_then([&] { return transfer.sendBlocks(); });
    transfer.end(done, rate.restore());
    // A PING could be taken for the start byte by a bootloader that is still waiting.
    if (rate.isOld() && report.sentBlocks == 0)
        (void)context.bus.listen(startTime);
    lookAfterwards(
        context, report, [&] { return awaitServo(context, servo); }, program);
    return std::move(report);
}

base::Result<FirmwareReport> rescueFirmware(const device::Context& outer, const FirmwareFile& file,
                                            const QString& program, const ProgressFn& progress)
{
    const device::Owned owned = device::own(outer, {});
    const device::Context& context = owned.context;
    if (const auto silent = requireSilence(context); !silent)
        return tl::unexpected(silent.error());
    FirmwareTransfer transfer(context, file, progress);
    FirmwareReport& report = transfer.result();
    BootloaderRate rate(context);
    const auto called = rate.set().and_then([&] { return transfer.call(); });
    if (!called)
        return tl::unexpected(called.error());
    const auto done = transfer.sendBlocks();
    transfer.end(done, rate.restore());
    if (report.sentBlocks < report.blocks) // it had none before
        report.outcome = FirmwareOutcome::Incomplete;
    lookAfterwards(
        context, report, [&] { return searchServo(context); }, program);
    return std::move(report);
}
} // namespace jobs
