// SPDX-License-Identifier: GPL-3.0-or-later
// Sets the character set of the process to UTF-8 if the locale has another or none; Qt would do the
// same with a warning. The language of the user stays. To be called before the application object
// and before any thread.
#pragma once

namespace cli {
void useUtf8();
} // namespace cli
