// SPDX-License-Identifier: GPL-3.0-or-later
// Shorthand for the texts of this layer. The context is written out at each call, because that is
// what lupdate collects.
#pragma once

#include <QCoreApplication>

namespace text {
inline QString translate(const char* context, const char* source, const char* comment = nullptr,
                         int n = -1)
{
    return QCoreApplication::translate(context, source, comment, n);
}
} // namespace text
