// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/error.h"

namespace base {
QString errorName(ErrorCode code)
{
    switch (code) {
    case ErrorCode::PortMissing:
        return QStringLiteral("port-missing");
    case ErrorCode::PortBusy:
        return QStringLiteral("port-busy");
    case ErrorCode::PortPermission:
        return QStringLiteral("port-permission");
    case ErrorCode::PortFailed:
        return QStringLiteral("port-failed");
    case ErrorCode::RateUnsupported:
        return QStringLiteral("rate-unsupported");
    case ErrorCode::LinkLost:
        return QStringLiteral("link-lost");
    case ErrorCode::NoReply:
        return QStringLiteral("no-answer");
    case ErrorCode::Garbled:
        return QStringLiteral("garbled");
    case ErrorCode::UnexpectedReply:
        return QStringLiteral("wrong-answer");
    case ErrorCode::LineBusy:
        return QStringLiteral("line-busy");
    case ErrorCode::Uncertain:
        return QStringLiteral("uncertain");
    case ErrorCode::Stopped:
        return QStringLiteral("stopped");
    case ErrorCode::Preempted:
        return QStringLiteral("preempted");
    case ErrorCode::Held:
        return QStringLiteral("held");
    case ErrorCode::BadArgument:
        return QStringLiteral("bad-argument");
    case ErrorCode::UnknownRegister:
        return QStringLiteral("unknown-register");
    case ErrorCode::ReadOnly:
        return QStringLiteral("read-only");
    case ErrorCode::OutOfRange:
        return QStringLiteral("out-of-range");
    case ErrorCode::NeedsConsent:
        return QStringLiteral("needs-consent");
    case ErrorCode::NotSupported:
        return QStringLiteral("not-supported");
    case ErrorCode::IdInUse:
        return QStringLiteral("id-in-use");
    case ErrorCode::Refused:
        return QStringLiteral("refused");
    case ErrorCode::Mismatch:
        return QStringLiteral("mismatch");
    case ErrorCode::LockOpen:
        return QStringLiteral("lock-open");
    case ErrorCode::UnknownModel:
        return QStringLiteral("unknown-model");
    case ErrorCode::FamilyConflict:
        return QStringLiteral("family-unclear");
    case ErrorCode::DuplicateId:
        return QStringLiteral("several-servos");
    case ErrorCode::IdentityMismatch:
        return QStringLiteral("identity-differs");
    case ErrorCode::AmbiguousProtocol:
        return QStringLiteral("several-protocols");
    case ErrorCode::TurnsUnknown:
        return QStringLiteral("turns-unknown");
    case ErrorCode::FileMissing:
        return QStringLiteral("file-missing");
    case ErrorCode::FileUnreadable:
        return QStringLiteral("file-unreadable");
    case ErrorCode::FileFormat:
        return QStringLiteral("file-format");
    case ErrorCode::FileUnwritable:
        return QStringLiteral("file-unwritable");
    case ErrorCode::DiskFull:
        return QStringLiteral("disk-full");
    }
    return QStringLiteral("unknown");
}
} // namespace base
