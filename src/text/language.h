// SPDX-License-Identifier: GPL-3.0-or-later
// The language of the interface, one for the whole program. Set on the main thread at the start and
// when the user switches. Never fails: an unknown language, or a text without a translation, is
// English.
#pragma once

#include <QStringList>

namespace catalog {
class Profile;
struct Text;
} // namespace catalog

namespace text {
/// "zh_CN" if the user's system prefers any Chinese to English, else "en".
QString systemLanguage();

/// Sets the language of everything translated from now on: as given by the user ("en", "zh_CN",
/// "zh-TW" …), or that of the system if empty. Needs the application object. Returns "en" or
/// "zh_CN".
QString installTranslator(const QString& language);

/// True while the interface is Chinese.
bool isUiChinese();

/// The Chinese text, whatever the language of the interface; empty: there is none. Any thread.
QString inChinese(const char* context, const char* source, const char* comment = nullptr);

/// The text of a register map or a report in the language of the interface.
QString localized(const catalog::Text& text);

/// With a capital first letter.
QString capitalized(QString sentence);

/// One after the other; empty ones are left out. Chinese puts no space between sentences.
QString joinSentences(QStringList sentences);
/// Names in a list, with the comma of the language between them.
QString joinItems(const QStringList& items);
/// Parts of one sentence, with the semicolon of the language between them.
QString joinClauses(const QStringList& clauses);

/// The name of the register `key` in the language of the interface; the key itself if `profile` is
/// null or does not have it.
QString registerName(const catalog::Profile* profile, const QString& key);
} // namespace text
