// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/protocol.h"

#include "base/enum_names.h"

namespace base {
namespace {
constexpr EnumName<Protocol> protocolNames[]{
    {Protocol::Feetech, "feetech"},
    {Protocol::Modbus, "modbus"},
    {Protocol::Lx, "lx"},
};
} // namespace

QString protocolName(Protocol protocol)
{
    return nameOf(protocolNames, protocol);
}

std::optional<Protocol> protocolFromName(const QString& name)
{
    return valueOf(protocolNames, name);
}
} // namespace base
