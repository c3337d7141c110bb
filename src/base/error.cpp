// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/error.h"

#include "base/enum_names.h"

namespace base {
namespace {
constexpr EnumName<ErrorCode> errorNames[]{
    {ErrorCode::PortMissing, "port-missing"},
    {ErrorCode::PortBusy, "port-busy"},
    {ErrorCode::PortPermission, "port-permission"},
    {ErrorCode::PortFailed, "port-failed"},
    {ErrorCode::RateUnsupported, "rate-unsupported"},
    {ErrorCode::LinkLost, "link-lost"},
    {ErrorCode::NoReply, "no-answer"},
    {ErrorCode::Garbled, "garbled"},
    {ErrorCode::UnexpectedReply, "wrong-answer"},
    {ErrorCode::LineBusy, "line-busy"},
    {ErrorCode::Uncertain, "uncertain"},
    {ErrorCode::Stopped, "stopped"},
    {ErrorCode::Preempted, "preempted"},
    {ErrorCode::Held, "held"},
    {ErrorCode::BadArgument, "bad-argument"},
    {ErrorCode::UnknownRegister, "unknown-register"},
    {ErrorCode::ReadOnly, "read-only"},
    {ErrorCode::OutOfRange, "out-of-range"},
    {ErrorCode::NeedsConsent, "needs-consent"},
    {ErrorCode::NotSupported, "not-supported"},
    {ErrorCode::IdInUse, "id-in-use"},
    {ErrorCode::Refused, "refused"},
    {ErrorCode::Mismatch, "mismatch"},
    {ErrorCode::LockOpen, "lock-open"},
    {ErrorCode::UnknownModel, "unknown-model"},
    {ErrorCode::FamilyConflict, "family-unclear"},
    {ErrorCode::DuplicateId, "several-servos"},
    {ErrorCode::IdentityMismatch, "identity-differs"},
    {ErrorCode::AmbiguousProtocol, "several-protocols"},
    {ErrorCode::TurnsUnknown, "turns-unknown"},
    {ErrorCode::FileMissing, "file-missing"},
    {ErrorCode::FileUnreadable, "file-unreadable"},
    {ErrorCode::FileFormat, "file-format"},
    {ErrorCode::FileUnwritable, "file-unwritable"},
    {ErrorCode::DiskFull, "disk-full"},
};
} // namespace

QString errorName(ErrorCode code)
{
    return nameOf(errorNames, code);
}

bool endsJob(ErrorCode code)
{
    switch (code) {
    case ErrorCode::LinkLost:
    case ErrorCode::Stopped:
    case ErrorCode::Preempted:
    case ErrorCode::Held:
        return true;
    default:
        return false;
    }
}
} // namespace base
