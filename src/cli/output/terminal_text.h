// SPDX-License-Identifier: GPL-3.0-or-later
// Prevents text from files, devices and the command line from controlling the terminal. All text
// output of the programs goes through terminalSafe(); see Console. Pure; any thread.
#pragma once

#include <QString>

namespace cli {
/// Control characters (C0, DEL, C1) and those that change the direction of text.
bool isTerminalControl(QChar c);
/// Replaces each of them except line feeds and tabs.
QString terminalSafe(const QString& text);
} // namespace cli
