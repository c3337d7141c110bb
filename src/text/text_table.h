// SPDX-License-Identifier: GPL-3.0-or-later
// The look-up in the tables of texts: the `key` of an entry is an enumerator or a stable name, its
// texts stand there untranslated (QT_TRANSLATE_NOOP). Pure; any thread.
#pragma once

#include "text/translate.h"

#include <algorithm>
#include <iterator>
#include <type_traits>

namespace text {
struct NamedText {
    const char* key;
    const char* text;
};

/// Null: `table` has no entry with this key.
template <typename Table, typename Key>
auto entryFor(const Table& table, const Key& key) -> decltype(std::data(table))
{
    const auto found = std::find_if(std::begin(table), std::end(table), [&](const auto& entry) {
        if constexpr (std::is_same_v<Key, QString>)
            return key == QLatin1String(entry.key);
        else
            return key == entry.key;
    });
    return found != std::end(table) ? &*found : nullptr;
}

/// In the language of the interface; a key without an entry comes back as it is.
template <typename Table>
QString textFor(const Table& table, const QString& key)
{
    const auto* entry = entryFor(table, key);
    return entry != nullptr ? translate("text", entry->text) : key;
}
} // namespace text
