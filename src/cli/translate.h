// SPDX-License-Identifier: GPL-3.0-or-later
// Shorthand for the texts of the command line. The context is written out at each call, because
// that is what lupdate collects.
#pragma once

#include "text/translate.h"

namespace cli {
using text::translate;
} // namespace cli
