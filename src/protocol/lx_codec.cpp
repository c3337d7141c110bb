// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/codec.h"

namespace protocol {
const Codec& lxCodec()
{
    return feetechCodec();
}
} // namespace protocol
