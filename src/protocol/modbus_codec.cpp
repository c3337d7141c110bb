// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/codec.h"

namespace protocol {
const Codec& modbusCodec()
{
    return feetechCodec();
}
} // namespace protocol
