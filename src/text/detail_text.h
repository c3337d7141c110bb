// SPDX-License-Identifier: GPL-3.0-or-later
// The texts of the technical details of an error: the tokens that the layers below put there
// ("set-id", "time"), and the cases that have a sentence of their own. Internal to text; pure.
#pragma once

#include "base/error.h"

namespace text {
/// The text of a known token; anything else as it is.
QString detailText(const QString& detail);

/// A sentence that replaces the general one, or empty.
QString specialCase(const base::Error& error);

/// A cause that replaces the general one, or empty.
QString specialCause(const base::Error& error);

/// A remedy that replaces the general one, or empty.
QString specialRemedy(const base::Error& error);

/// The group that may open the port, as named by the error.
QString owningGroup(const QString& detail);
} // namespace text
