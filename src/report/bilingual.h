// SPDX-License-Identifier: GPL-3.0-or-later
// A text of a report in both languages: a report can be written in another language than the
// window's. Pure; any thread.
#pragma once

#include "catalog/register.h"

namespace report {
inline catalog::Text both(const char* english, const char* chinese)
{
    return {QString::fromUtf8(english), QString::fromUtf8(chinese)};
}
} // namespace report
