// SPDX-License-Identifier: GPL-3.0-or-later
// Shared by the protocols' explanations of frames for the bus monitor. Pure; any thread.
#pragma once

#include "base/bytes.h"

#include <QString>

namespace protocol {
/// "WRITE 3: 01 02"; the head alone without data.
inline QString withData(const QString& head, base::ByteView data)
{
    return data.empty() ? head : head + QStringLiteral(": ") + base::toHex(data);
}
} // namespace protocol
