// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/codec.h"

namespace protocol {
base::Duration Codec::silence(int /*baud*/) const
{
    return {};
}

const Codec& codecFor(base::Protocol protocol)
{
    switch (protocol) {
    case base::Protocol::Modbus:
        return modbusCodec();
    case base::Protocol::Lx:
        return lxCodec();
    case base::Protocol::Feetech:
        break;
    }
    return feetechCodec();
}
} // namespace protocol
