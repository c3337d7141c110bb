// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/exit_code.h"

#include <algorithm>

namespace cli {
Exit exitCode(base::ErrorCode code)
{
    using base::ErrorCode;
    switch (code) {
    case ErrorCode::PortMissing:
    case ErrorCode::PortBusy:
    case ErrorCode::PortPermission:
    case ErrorCode::PortFailed:
    case ErrorCode::RateUnsupported:
    case ErrorCode::LinkLost:
        return Exit::Port;
    case ErrorCode::NoReply:
    case ErrorCode::Garbled:
    case ErrorCode::UnexpectedReply:
    case ErrorCode::LineBusy:
    case ErrorCode::Uncertain:
        return Exit::NoReply;
    case ErrorCode::BadArgument:
    case ErrorCode::UnknownRegister:
    case ErrorCode::ReadOnly:
    case ErrorCode::OutOfRange:
    case ErrorCode::NeedsConsent:
    case ErrorCode::NotSupported:
        return Exit::Usage;
    case ErrorCode::Stopped:
    case ErrorCode::Preempted:
    case ErrorCode::Held:
    case ErrorCode::IdInUse:
    case ErrorCode::Refused:
    case ErrorCode::Mismatch:
    case ErrorCode::LockOpen:
    case ErrorCode::UnknownModel:
    case ErrorCode::FamilyConflict:
    case ErrorCode::DuplicateId:
    case ErrorCode::IdentityMismatch:
    case ErrorCode::TurnsUnknown:
    case ErrorCode::AmbiguousProtocol:
        return Exit::Failed;
    case ErrorCode::FileMissing:
    case ErrorCode::FileUnreadable:
    case ErrorCode::FileFormat:
    case ErrorCode::FileUnwritable:
    case ErrorCode::DiskFull:
        return Exit::File;
    }
    return Exit::Failed;
}

Exit exitCode(const device::WriteReport& report)
{
    if (report.isSuccessful())
        return Exit::Success;
    const auto& writes = report.writes;
    const bool lost = std::any_of(writes.begin(), writes.end(), [](const auto& result) {
        return result.error && exitCode(result.error->code) == Exit::Port;
    });
    const bool silent =
        !writes.empty() && std::all_of(writes.begin(), writes.end(), [](const auto& result) {
            return result.outcome == device::WriteOutcome::NoReply;
        });
    return lost ? Exit::Port : silent ? Exit::NoReply : Exit::Failed;
}

Exit exitCode(device::LockState lock)
{
    return lock == device::LockState::Closed || lock == device::LockState::None ? Exit::Success
                                                                                : Exit::Failed;
}
} // namespace cli
