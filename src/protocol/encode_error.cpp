// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/encode_error.h"

namespace protocol {
namespace {
QString operationName(Op op)
{
    switch (op) {
    case Op::Ping:
        return QStringLiteral("ping");
    case Op::Read:
        return QStringLiteral("read");
    case Op::Write:
        return QStringLiteral("write");
    case Op::RegWrite:
        return QStringLiteral("reg-write");
    case Op::Action:
        return QStringLiteral("action");
    case Op::Halt:
        return QStringLiteral("halt");
    case Op::Restore:
        return QStringLiteral("restore");
    case Op::Backup:
        return QStringLiteral("backup");
    case Op::StateReset:
        return QStringLiteral("state-reset");
    case Op::Calibrate:
        return QStringLiteral("calibrate");
    case Op::Reboot:
        return QStringLiteral("reboot");
    case Op::SyncRead:
        return QStringLiteral("sync-read");
    case Op::SyncWrite:
        return QStringLiteral("sync-write");
    case Op::Raw:
        return QStringLiteral("raw");
    }
    return {};
}
} // namespace

tl::unexpected<base::Error> refuse(const Request& request, const QString& detail)
{
    return base::fail(base::ErrorCode::BadArgument, operationName(request.op), detail, request.id);
}

tl::unexpected<base::Error> refuseUnsupported(const Request& request)
{
    return base::fail(base::ErrorCode::NotSupported, operationName(request.op),
                      QStringLiteral("no such instruction"), request.id);
}

base::Result<base::Bytes> encodeRaw(const Request& request, std::size_t maxSize)
{
    if (request.data.empty())
        return refuse(request, QStringLiteral("no bytes"));
    if (request.data.size() > maxSize)
        return refuse(request, QStringLiteral("packet longer than %1 bytes").arg(maxSize));
    return request.data;
}
} // namespace protocol
