// SPDX-License-Identifier: GPL-3.0-or-later
#include "jobs/firmware/firmware_preflight.h"

#include "device/bootloader.h"
#include "device/motion/motion.h"
#include "device/reader.h"
#include "jobs/firmware/firmware_update.h"
#include "jobs/scan/scan.h"

#include <algorithm>

namespace jobs {
namespace {
using base::FirmwareCheck;
using base::FirmwareCheckResult;
using catalog::Role;
using namespace std::chrono_literals;

/// The application area of the one part that is known: 464 blocks.
constexpr std::size_t knownArea = 29'696;
constexpr int supplyReadings = 15; ///< at rest, and as many with torque
constexpr base::Duration readingInterval = 20ms;
constexpr double steadyVolts = 0.5;

base::Result<FirmwareCheckResult> checkOtherServos(const device::Context& context,
                                                   const device::Servo& servo,
                                                   const ProgressFn& progress)
{
    ScanSpec spec;
    spec.identify = false;
    // At the bootloader's rate the blocks could look like packets to a servo.
    spec.bauds = {context.bus.baud(), device::bootloaderBaud};
    const auto report = scan(context, spec, progress);
    if (!report)
        return tl::unexpected(report.error());
    if (report->stopped)
        return base::fail(base::ErrorCode::Stopped, QStringLiteral("firmware"), {}, servo.id);
    FirmwareCheckResult result{.check = FirmwareCheck::OtherServos};
    for (const FoundServo& one : report->found) {
        const bool isIt = one.servo.id == servo.id && one.servo.protocol == servo.protocol;
        if (!isIt || one.duplicateSuspected)
            result.ids.push_back(one.servo.id);
    }
    result.isPassed = result.ids.empty();
    return result;
}

FirmwareCheckResult checkFileName(const device::Context& context, const device::Servo& servo,
                                  const FirmwareFile& file)
{
    FirmwareCheckResult result{.check = FirmwareCheck::FileName};
    const auto known = context.catalog.firmwareOf(*servo.profile);
    result.text = known ? known->source : QString();
    result.isPassed = known && firmwareNameOf(file.path) == firmwareNameOf(known->source);
    return result;
}

FirmwareCheckResult checkFileSize(const FirmwareFile& file)
{
    return {.check = FirmwareCheck::FileSize,
            .isPassed = file.bytes.size() <= knownArea,
            .number = int(file.bytes.size())};
}

FirmwareCheckResult checkSavedTable(const base::Result<void>& savedTable)
{
    return {.check = FirmwareCheck::SavedTable,
            .isPassed = savedTable.has_value(),
            .text = savedTable ? QString() : savedTable.error().detail};
}

FirmwareCheckResult checkBattery(const std::optional<int>& percent)
{
    return {.check = FirmwareCheck::Battery,
            .isPassed = !percent.has_value(),
            .number = percent.value_or(0)};
}

/// The servo's own voltage readings.
class SupplyCheck {
public:
    SupplyCheck(const device::Context& context, device::Servo& servo)
        : m_context(context)
        , m_servo(servo)
    {}

    base::Result<FirmwareCheckResult> run()
    {
        if (m_servo.profile->byRole(Role::PresentVoltage) == nullptr)
            return FirmwareCheckResult{.check = FirmwareCheck::Supply, .isPassed = false};
        const auto measured =
            device::setTorque(m_context, m_servo, device::Torque::Off)
                .and_then([this] { return readVolts(); })
                .and_then(
                    [this] { return device::setTorque(m_context, m_servo, device::Torque::On); })
                .and_then([this] { return readVolts(); });
        const auto off = device::setTorque(m_context, m_servo, device::Torque::Off);
        if (!measured && base::endsJob(measured.error().code))
            return tl::unexpected(measured.error());
        if (!off)
            return tl::unexpected(off.error());
        return FirmwareCheckResult{.check = FirmwareCheck::Supply,
                                   .isPassed = measured && m_high - m_low <= steadyVolts &&
                                               isWithinLimits(),
                                   .low = measured ? m_low : 0,
                                   .high = measured ? m_high : 0};
    }

private:
    base::Result<void> readVolts()
    {
        for (int i = 0; i < supplyReadings; ++i) {
            if (m_context.stop.isRequested())
                return base::fail(base::ErrorCode::Stopped, QStringLiteral("firmware"));
            if (const auto read = device::readRoles(m_context, m_servo, {Role::PresentVoltage});
                !read)
                return read;
            const double volts = m_servo.physical(Role::PresentVoltage).value_or(0);
            m_low = m_high == 0 ? volts : std::min(m_low, volts);
            m_high = std::max(m_high, volts);
            m_context.bus.clock().sleepFor(readingInterval);
        }
        return {};
    }

    /// 0 in a limit of some families: none.
    bool isWithinLimits() const
    {
        const double least = m_servo.physical(Role::MinVoltage).value_or(0);
        const double most = m_servo.physical(Role::MaxVoltage).value_or(0);
        return m_low > 0 && m_low >= least && (most == 0 || m_high <= most);
    }

    const device::Context& m_context;
    device::Servo& m_servo;
    double m_low = 0;
    double m_high = 0;
};
} // namespace

base::Result<std::vector<FirmwareCheckResult>>
checkFirmwareUpdate(const device::Context& outer, device::Servo& servo,
                    const FirmwarePreflight& preflight, const ProgressFn& progress)
{
    if (const auto possible = requireBootloader(servo); !possible)
        return tl::unexpected(possible.error());
    const device::Owned owned = device::own(outer, {});
    const auto others = checkOtherServos(owned.context, servo, progress);
    if (!others)
        return tl::unexpected(others.error());
    std::vector<FirmwareCheckResult> results{*others,
                                             checkFileName(owned.context, servo, preflight.file),
                                             checkFileSize(preflight.file)};
    const auto supply = SupplyCheck(owned.context, servo).run();
    if (!supply)
        return tl::unexpected(supply.error());
    results.push_back(*supply);
    results.push_back(checkSavedTable(preflight.savedTable));
    results.push_back(checkBattery(preflight.batteryPercent));
    return results;
}
} // namespace jobs
