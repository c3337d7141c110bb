// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/encode_error.h"

#include "base/enum_names.h"

namespace protocol {
namespace {
constexpr base::EnumName<Op> operationNames[]{
    {Op::Ping, "ping"},
    {Op::Read, "read"},
    {Op::Write, "write"},
    {Op::RegWrite, "reg-write"},
    {Op::Action, "action"},
    {Op::Halt, "halt"},
    {Op::Restore, "restore"},
    {Op::Backup, "backup"},
    {Op::StateReset, "state-reset"},
    {Op::Calibrate, "calibrate"},
    {Op::Reboot, "reboot"},
    {Op::SyncRead, "sync-read"},
    {Op::SyncWrite, "sync-write"},
    {Op::Raw, "raw"},
};
} // namespace

QString operationName(Op op)
{
    return base::nameOf(operationNames, op);
}

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
