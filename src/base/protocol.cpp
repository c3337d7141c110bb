// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/protocol.h"

namespace base {
QString protocolName(Protocol protocol)
{
    switch (protocol) {
    case Protocol::Feetech:
        return QStringLiteral("feetech");
    case Protocol::Modbus:
        return QStringLiteral("modbus");
    case Protocol::Lx:
        return QStringLiteral("lx");
    }
    return {};
}

std::optional<Protocol> protocolFromName(const QString& name)
{
    for (const Protocol protocol : allProtocols) {
        if (protocolName(protocol) == name)
            return protocol;
    }
    return std::nullopt;
}
} // namespace base
