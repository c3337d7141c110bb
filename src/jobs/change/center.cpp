// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/motion/motion.h"
#include "device/transactions.h"
#include "device/write_access.h"
#include "device/write_meaning.h"
#include "jobs/change/change_steps.h"

#include <cstdlib>

namespace jobs {
using base::ErrorCode;
using catalog::Centering;
using catalog::Role;
using device::NoticeCode;

namespace {
const QString centerOperation = QStringLiteral("center");
/// Register 40, SMS and STS: "make the present position 2048".
constexpr std::int64_t centerCommand = 128;
/// The free shaft may still settle by this much while it is centered.
constexpr std::int64_t tolerance = 12;

struct CalibrationState {
    std::int64_t offset = 0;
    std::int64_t position = 0;
};

base::Result<CalibrationState> readCalibrationState(const device::Context& context,
                                                    device::Servo& servo)
{
    const auto done =
        device::readRoles(context, servo, {Role::PositionOffset, Role::PresentPosition});
    if (!done)
        return tl::unexpected(done.error());
    return CalibrationState{servo.raw(Role::PositionOffset).value_or(0),
                            servo.raw(Role::PresentPosition).value_or(0)};
}

bool isCentered(const device::Servo& servo, const CalibrationState& place)
{
    const std::int64_t turn = servo.profile->stepsPerTurn;
    const std::int64_t inTurn = ((place.position % turn) + turn) % turn;
    return std::abs(inTurn - turn / 2) <= tolerance;
}

protocol::Request writeRequest(const device::Servo& servo, Role role, std::int64_t raw)
{
    const catalog::Register& reg = *servo.profile->byRole(role);
    return protocol::Request::write(servo.id, reg.writeOffset, device::wireBytes(servo, reg, raw),
                                    protocol::Repeat::Never);
}

protocol::Request calibrationRequest(const device::Servo& servo)
{
    const Centering method = servo.profile->centering;
    auto request =
        method == Centering::Instruction0B
            ? protocol::Request::calibrate(servo.id, std::nullopt, servo.profile->byteOrder)
        : method == Centering::FaultReset4
            ? writeRequest(servo, Role::FaultReset, device::centerBit)
            : writeRequest(servo, Role::TorqueSwitch, centerCommand);
    request.acknowledged = servo.repliesToWrites();
    return request.in(servo.protocol);
}

/// A servo without the command may still have the register that the command would fill.
base::Result<void> checkSupported(const device::Servo& servo)
{
    const catalog::Register* offset = servo.profile->byRole(Role::PositionOffset);
    if (servo.profile->centering != Centering::None && offset != nullptr)
        return {};
    const QString detail = offset != nullptr && offset->writable()
                               ? QStringLiteral("write ") + offset->key
                               : servo.profile->series;
    return base::fail(ErrorCode::NotSupported, centerOperation, detail, servo.id);
}

/// Sends the calibration; after a lost reply offset and position are read to find out whether it
/// happened.
base::Result<CalibrationState> calibrate(const device::Context& context, device::Servo& servo,
                                         const CalibrationState& before)
{
    constexpr int sends = 2;
    CalibrationState now = before;
    for (int attempt = 0; attempt < sends; ++attempt) {
        const auto sent = sendOnce(context, calibrationRequest(servo));
        if (!sent)
            return tl::unexpected(sent.error());
        context.bus.clock().sleepFor(device::epromWriteTime);
        const auto place = readCalibrationState(context, servo);
        if (!place)
            return tl::unexpected(place.error());
        now = *place;
        if (isCentered(servo, now)) {
            if (sent->lost)
                context.note(NoticeCode::ReplyLostButWritten, servo.id);
            return now;
        }
        const bool mayResend = sent->lost || !servo.repliesToWrites();
        if (!mayResend || now.offset != before.offset)
            break;
        if (attempt + 1 < sends)
            device::noteResent(context, servo, sent->lost);
    }
    return base::fail(ErrorCode::Refused, centerOperation, QString::number(now.position), servo.id);
}

/// The end of the journal's entry. Certain: nothing is unknown any more.
struct CenterOutcome {
    bool certain = false;
    device::WriteOutcome outcome = device::WriteOutcome::NotSent;
    std::optional<std::int64_t> readBack{};
};

base::Result<CenterReport> centerUnlocked(const device::Context& context, device::Servo& servo,
                                          const CalibrationState& before, CenterOutcome& end)
{
    CenterReport report;
    report.offsetBefore = before.offset;
    report.positionBefore = before.position;
    auto eprom =
        device::UnlockedEprom::open(context, servo, *servo.profile->byRole(Role::PositionOffset));
    if (!eprom) {
        end.certain = device::closeLock(context, servo) == device::LockState::Closed;
        return tl::unexpected(eprom.error());
    }
    const auto after = calibrate(context, servo, before);
    report.lock = eprom->close();
    end.certain = report.lock == device::LockState::Closed &&
                  (after || after.error().code == ErrorCode::Refused);
    end.outcome = after ? device::WriteOutcome::Kept : device::WriteOutcome::Refused;
    end.readBack = servo.raw(Role::PositionOffset);
    if (end.certain && !eprom->stayedOpen()) {
        end.certain = false; // it stays open: it is not known what is kept
        return base::fail(ErrorCode::Uncertain, QStringLiteral("keep"), QStringLiteral("restarted"),
                          servo.id);
    }
    if (!after)
        return tl::unexpected(after.error());
    report.offsetAfter = after->offset;
    report.positionAfter = after->position;
    return report;
}
} // namespace

base::Result<CenterReport> center(const device::Context& outer, device::Servo& servo)
{
    if (const auto writable = device::requireWritable(servo, centerOperation); !writable)
        return tl::unexpected(writable.error());
    if (const auto possible = checkSupported(servo); !possible)
        return tl::unexpected(possible.error());
    const catalog::Register& offset = *servo.profile->byRole(Role::PositionOffset);
    const device::Owned owned = device::own(outer, {servo.id});
    const device::Context& context = owned.context;
    if (const auto may = device::beginWriting(context, servo, centerOperation); !may)
        return tl::unexpected(may.error());
    if (const auto fresh = device::readSettings(context, servo); !fresh)
        return tl::unexpected(fresh.error());
    const auto before = readCalibrationState(context, servo);
    if (!before)
        return tl::unexpected(before.error());
    if (context.stop.isRequested())
        return base::fail(ErrorCode::Stopped, centerOperation, {}, servo.id);
    // With torque on, the moved origin would send the servo to its old goal at full speed.
    if (const auto off = device::setTorque(context, servo, device::Torque::Off); !off)
        return tl::unexpected(off.error());
    const auto uuid = beginIntent(context, servo, base::IntentKind::Calibrate,
                                  {{offset.key, offset.address, before->offset, before->offset}});
    if (!uuid)
        return tl::unexpected(uuid.error());
    CenterOutcome end;
    auto report = centerUnlocked(context, servo, *before, end);
    if (end.certain) {
        context.record(*uuid, servo.id,
                       {report ? QStringLiteral("done") : QStringLiteral("failed"),
                        {},
                        {{offset.key, end.readBack, device::outcomeName(end.outcome)}}});
    }
    if (report)
        context.note(NoticeCode::TorqueStaysOff, servo.id);
    return report;
}
} // namespace jobs
