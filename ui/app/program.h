// SPDX-License-Identifier: GPL-3.0-or-later
// The program servodesk from its command line to its end: options, session, theme, language,
// window. Main thread. Returns the exit code: 0, 2 for invalid options, 1 for a screenshot that
// could not be written.
#pragma once

namespace ui {
int runProgram(int argc, char* argv[]);

/// Icons and fonts as the program has them; for tests that make the window themselves. Needs
/// the QApplication.
void initProgram();
} // namespace ui
