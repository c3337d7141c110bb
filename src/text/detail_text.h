// SPDX-License-Identifier: GPL-3.0-or-later
// The short technical details of an Error in words: the tokens the layers below put there
// ("set-id", "time"), and the few cases that deserve a sentence of their own. Internal to text;
// pure.
#pragma once

#include "base/error.h"

namespace text {
/// A known token in words; anything else as it is.
QString detailText(const QString& detail);

/// A sentence that replaces the general one, or empty.
QString specialCase(const base::Error& error);

/// A cause that replaces the general one, or empty.
QString specialCause(const base::Error& error);

/// A remedy that replaces the general one, or empty.
QString specialRemedy(const base::Error& error);

/// The group that may open the port, as the error names it.
QString owningGroup(const QString& detail);
} // namespace text
