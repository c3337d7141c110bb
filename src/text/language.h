// SPDX-License-Identifier: GPL-3.0-or-later
// The language of the interface, one for the whole program. Set on the main thread at the start
// and when the user switches; words are only made on that thread. Never fails: what is not known
// is English.
#pragma once

#include <QString>

namespace text {
/// "zh_CN" when the user's system prefers Chinese (any kind of) over English, else "en".
QString systemLanguage();

/// `language` as given by the user ("en", "zh_CN", "zh-TW" …; empty: the system's) becomes the
/// language of everything translated from now on. Needs the application object. Answers "en" or
/// "zh_CN".
QString installTranslator(const QString& language);

/// True while the interface is Chinese: for catalog::Text::in.
bool isUiChinese();
} // namespace text
