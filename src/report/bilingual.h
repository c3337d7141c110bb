// SPDX-License-Identifier: GPL-3.0-or-later
// A text of a report in both languages: a page contains both, and paper need not have the language
// of the interface. The context is written out at each call, because that is what lupdate collects.
// Pure; any thread.
#pragma once

#include "catalog/register.h"
#include "text/language.h"

namespace report {
inline catalog::Text translate(const char* context, const char* source,
                               const char* comment = nullptr)
{
    return {QString::fromUtf8(source), text::inChinese(context, source, comment)};
}

/// What needs no translation: a number, a name, a dash.
inline catalog::Text inBoth(const QString& text)
{
    return {text, text};
}

/// Between the items of a list.
inline catalog::Text listComma()
{
    return {QStringLiteral(", "), QStringLiteral("、")};
}

/// `form` with its placeholders replaced.
template <typename... Texts>
catalog::Text filled(const catalog::Text& form, const Texts&... values)
{
    return {form.en.arg(values.en...), form.zh.arg(values.zh...)};
}
} // namespace report
