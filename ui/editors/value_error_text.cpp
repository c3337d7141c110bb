// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/editors/value_error_text.h"

#include "text/error_text.h"
#include "text/language.h"
#include "text/translate.h"
#include "ui/editors/register_text.h"

namespace ui {
using base::ErrorCode;
using text::translate;

namespace {
/// Pasted text may be a whole page.
QString elided(const QString& inputText)
{
    constexpr int longest = 24;
    const QString line = inputText.simplified();
    return line.size() <= longest ? line : line.left(longest) + QStringLiteral("…");
}

QString choices(const catalog::Register& reg)
{
    QStringList words;
    for (const catalog::NamedValue& value : reg.values)
        words << QStringLiteral("%1 — %2").arg(value.value).arg(text::localized(value.name));
    return text::joinItems(words);
}

bool isChoice(const catalog::Register& reg, const catalog::ValueFormat& meaning)
{
    return meaning.encoding == catalog::Encoding::Enum && !reg.values.empty();
}

QString expectedInputText(const catalog::Register& reg, const catalog::ValueFormat& meaning)
{
    if (isChoice(reg, meaning))
        return translate("ValueEditor", "Select one of: %1.").arg(choices(reg));
    const QString range = rangeText(reg, meaning, false);
    if (meaning.unit.isEmpty() || meaning.encoding == catalog::Encoding::Bits)
        return translate("ValueEditor", "Enter a whole number (%1).").arg(range);
    const std::int64_t sample = reg.defaultRaw.value_or(meaning.max.value_or(1));
    return translate("ValueEditor",
                     "Enter a whole number (%1) or a value with its unit, such as %2.")
        .arg(range, physicalText(sample, reg, meaning));
}

QString notUnderstoodText(const base::Error& error, const QString& inputText)
{
    if (inputText.trimmed().isEmpty())
        return translate("ValueEditor", "No value entered.");
    if (error.detail.startsWith(QLatin1String("less than one step")))
        return translate("ValueEditor",
                         "“%1” is below the resolution of this register and would become 0.")
            .arg(elided(inputText));
    return translate("ValueEditor", "“%1” is not a valid value for this register.")
        .arg(elided(inputText));
}

QString outOfRangeText(const QString& inputText, const catalog::Register& reg,
                       const catalog::ValueFormat& meaning)
{
    const QString number = elided(inputText);
    if (isChoice(reg, meaning))
        return translate("ValueEditor",
                         "%1 is not a documented value; the servo may react unpredictably.")
            .arg(number);
    const QString raw = rangeText(reg, meaning, false);
    const QString physical = rangeText(reg, meaning, true);
    return translate("ValueEditor", "%1 is outside the range of this register (%2).")
        .arg(number, raw == physical ? raw : QStringLiteral("%1; %2").arg(raw, physical));
}
} // namespace

QString inputErrorText(const base::Error& error, const QString& inputText,
                       const catalog::Register& reg, const catalog::ValueFormat& meaning)
{
    QStringList lines;
    switch (error.code) {
    case ErrorCode::BadArgument:
        lines << notUnderstoodText(error, inputText) << expectedInputText(reg, meaning);
        break;
    case ErrorCode::OutOfRange:
        lines << outOfRangeText(inputText, reg, meaning) << expectedInputText(reg, meaning);
        break;
    default: {
        const text::Description words = text::describe(error);
        lines << words.message << words.remedy;
    }
    }
    lines << translate("ValueEditor", "Nothing was written.");
    return text::joinSentences(lines);
}
} // namespace ui
