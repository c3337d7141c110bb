// SPDX-License-Identifier: GPL-3.0-or-later
// Keeps what comes from files, devices and the command line from being taken for commands by the
// terminal it is shown on. All human output of the programs goes through terminalSafe(); see
// Console. Pure; any thread.
#pragma once

#include <QString>

namespace cli {
/// Control characters (C0, DEL, C1) and those that change the direction of text.
bool isTerminalControl(QChar c);
/// With a replacement character for each of them, but for line ends and tabs.
QString terminalSafe(const QString& text);
} // namespace cli
