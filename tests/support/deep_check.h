// SPDX-License-Identifier: GPL-3.0-or-later
// Whether packaging/deep-check.sh runs the tests: every case of a product of tasks and moments
// then, else its corners.
#pragma once

#include <QtGlobal>

namespace support {
inline bool isDeepCheck()
{
    return qEnvironmentVariableIsSet("SERVODESK_DEEP_CHECK");
}
} // namespace support
