// SPDX-License-Identifier: GPL-3.0-or-later
// The fonts that come with the program, so that its texts fit their places and look the same on
// every machine. The first call for families registers them and needs a QGuiApplication; any
// thread.
#pragma once

#include <QStringList>

namespace report {
/// Noto Sans, its signs, then what this machine has for Simplified Chinese. Digits are of one
/// width. Only families that are there; empty if there are none.
QStringList textFamilies();

/// The same for code and hexadecimal numbers: all characters are of one width.
QStringList codeFamilies();

/// @font-face rules with the letters in them, for a page that needs no other file: the families
/// "ServoDesk Text" and "ServoDesk Signs".
QString embeddedFonts();
} // namespace report
