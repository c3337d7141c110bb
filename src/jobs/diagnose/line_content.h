// SPDX-License-Identifier: GPL-3.0-or-later
// What bytes without a request tell about the other end: nothing, the text of a program, or bytes
// of a bus. Pure; any thread.
#pragma once

#include "base/bytes.h"

#include <QString>

namespace jobs {
/// A part of the text if that is what the bytes are; empty: they are not.
QString textIn(base::ByteView bytes);

/// The first bytes in hexadecimal.
QString sampleOf(base::ByteView bytes);
} // namespace jobs
