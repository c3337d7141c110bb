// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/editors/value_words.h"

#include "text/error_words.h"
#include "text/language.h"
#include "text/translate.h"
#include "ui/models/memory_words.h"

namespace ui {
using base::ErrorCode;
using text::translate;

namespace {
/// Pasted text may be a whole page.
QString shortened(const QString& typed)
{
    constexpr int longest = 24;
    const QString line = typed.simplified();
    return line.size() <= longest ? line : line.left(longest) + QStringLiteral("…");
}

QString choices(const catalog::Register& reg)
{
    QStringList words;
    for (const catalog::NamedValue& value : reg.values)
        words << QStringLiteral("%1 — %2").arg(value.value).arg(value.name.in(text::inChinese()));
    return words.join(translate("ValueEditor", ", ", "between items of a list"));
}

bool isChoice(const catalog::Register& reg, const catalog::Meaning& meaning)
{
    return meaning.encoding == catalog::Encoding::Enum && !reg.values.empty();
}

QString whatToType(const catalog::Register& reg, const catalog::Meaning& meaning)
{
    if (isChoice(reg, meaning))
        return translate("ValueEditor", "Choose one of: %1.").arg(choices(reg));
    const QString range = rangeWord(reg, meaning, false);
    if (meaning.unit.isEmpty() || meaning.encoding == catalog::Encoding::Bits)
        return translate("ValueEditor", "Type a whole number, %1.").arg(range);
    const std::int64_t sample = reg.defaultRaw.value_or(meaning.max.value_or(1));
    return translate("ValueEditor",
                     "Type a whole number, %1, or a value with its unit, such as %2.")
        .arg(range, physicalWord(sample, reg, meaning));
}

QString notUnderstood(const base::Error& error, const QString& typed)
{
    if (typed.trimmed().isEmpty())
        return translate("ValueEditor", "There is no value.");
    if (error.detail.startsWith(QLatin1String("less than one step")))
        return translate("ValueEditor",
                         "“%1” is less than one step of this register and would become 0.")
            .arg(shortened(typed));
    return translate("ValueEditor", "“%1” is not a value this register understands.")
        .arg(shortened(typed));
}

QString outside(const QString& typed, const catalog::Register& reg, const catalog::Meaning& meaning)
{
    const QString number = shortened(typed);
    if (isChoice(reg, meaning))
        return translate("ValueEditor", "%1 is not one of the documented values, and the servo may "
                                        "do anything with it.")
            .arg(number);
    const QString raw = rangeWord(reg, meaning, false);
    const QString physical = rangeWord(reg, meaning, true);
    return translate("ValueEditor", "%1 is outside what this register accepts (%2).")
        .arg(number, raw == physical ? raw : QStringLiteral("%1; %2").arg(raw, physical));
}
} // namespace

QString complaintWords(const base::Error& error, const QString& typed, const catalog::Register& reg,
                       const catalog::Meaning& meaning)
{
    QStringList lines;
    switch (error.code) {
    case ErrorCode::BadArgument:
        lines << notUnderstood(error, typed) << whatToType(reg, meaning);
        break;
    case ErrorCode::OutOfRange:
        lines << outside(typed, reg, meaning) << whatToType(reg, meaning);
        break;
    default: {
        const text::Description words = text::describe(error);
        lines << words.what << words.remedy;
    }
    }
    lines << translate("ValueEditor", "Nothing was written.");
    return lines.join(translate("ValueEditor", " ", "between sentences"));
}
} // namespace ui
