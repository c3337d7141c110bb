// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/request.h"

namespace protocol {
namespace {
Request simple(Op op, int id, Repeat repeat)
{
    Request request;
    request.op = op;
    request.id = id;
    request.repeat = repeat;
    return request;
}

Request addressed(Op op, int id, int address, base::Bytes data, Repeat repeat)
{
    Request request = simple(op, id, repeat);
    request.address = address;
    request.data = std::move(data);
    return request;
}
} // namespace

Request Request::ping(int id)
{
    return simple(Op::Ping, id, Repeat::Safe);
}

Request Request::read(int id, int address, int count)
{
    Request request = simple(Op::Read, id, Repeat::Safe);
    request.address = address;
    request.count = count;
    return request;
}

Request Request::write(int id, int address, base::Bytes data, Repeat repeat)
{
    return addressed(Op::Write, id, address, std::move(data), repeat);
}

Request Request::regWrite(int id, int address, base::Bytes data, Repeat repeat)
{
    return addressed(Op::RegWrite, id, address, std::move(data), repeat);
}

Request Request::action(int id)
{
    return simple(Op::Action, id, Repeat::Never);
}

Request Request::halt(int id)
{
    Request request;
    request.op = Op::Halt;
    request.id = id;
    request.repeat = Repeat::Safe;
    return request;
}

Request Request::restore(int id)
{
    return simple(Op::Restore, id, Repeat::Never);
}

Request Request::backup(int id)
{
    return simple(Op::Backup, id, Repeat::Safe);
}

Request Request::stateReset(int id)
{
    return simple(Op::StateReset, id, Repeat::Never);
}

Request Request::calibrate(int id, std::optional<int> value, base::ByteOrder order)
{
    Request request = simple(Op::Calibrate, id, Repeat::Never);
    if (value)
        request.data = base::writeUnsigned(static_cast<std::uint64_t>(*value), 2, order);
    return request;
}

Request Request::reboot(int id)
{
    return simple(Op::Reboot, id, Repeat::Never);
}

Request Request::syncRead(int address, int count, const std::vector<int>& ids)
{
    Request request = simple(Op::SyncRead, broadcastId, Repeat::Safe);
    request.address = address;
    request.count = count;
    for (const int id : ids)
        request.targets.push_back({id, {}});
    return request;
}

Request Request::syncWrite(int address, std::vector<Target> targets)
{
    Request request = simple(Op::SyncWrite, broadcastId, Repeat::Never);
    request.address = address;
    request.targets = std::move(targets);
    return request;
}

Request Request::raw(base::Bytes bytes, int replyBytes)
{
    Request request = simple(Op::Raw, -1, Repeat::Never);
    request.data = std::move(bytes);
    request.count = replyBytes;
    return request;
}
} // namespace protocol
