// SPDX-License-Identifier: GPL-3.0-or-later
// Makes the process' character set UTF-8 where the user's locale has another or none: Qt would
// switch over with a complaint of its own. The language the user asked for stays. Before the
// application object and before any thread.
#pragma once

namespace cli {
void useUtf8();
} // namespace cli
