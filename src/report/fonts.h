// SPDX-License-Identifier: GPL-3.0-or-later
// The fonts that come with the program, so that its texts fit their places and look the same on
// every machine. The first call for families registers them and needs a QGuiApplication; any
// thread.
#pragma once

#include <QStringList>

namespace report {
/// Noto Sans, its signs, then the Simplified Chinese fonts of this machine. All digits have one
/// width. Only installed families; empty if there are none.
QStringList textFamilies();

/// The same for code and hexadecimal numbers: all characters have one width.
QStringList codeFamilies();

/// @font-face rules that contain the fonts, for a self-contained page: the families
/// "ServoDesk Text" and "ServoDesk Signs".
QString embeddedFonts();
} // namespace report
