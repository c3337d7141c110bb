// SPDX-License-Identifier: GPL-3.0-or-later
// Shorthand for the texts of the command line. The context is written out at each call, because
// that is what lupdate collects.
#pragma once

#include <QCoreApplication>

namespace cli {
inline QString translate(const char* context, const char* source, const char* comment = nullptr)
{
    return QCoreApplication::translate(context, source, comment);
}
} // namespace cli
