// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/editors/register_text.h"

#include "catalog/raw_range.h"
#include "text/language.h"

namespace ui {
using catalog::Encoding;

bool hasNamedValues(const catalog::ValueFormat& meaning)
{
    return meaning.encoding == Encoding::Enum || meaning.encoding == Encoding::Bits;
}

base::Error withName(base::Error error, const catalog::Register* reg)
{
    if (reg != nullptr && error.registerKey == reg->key)
        error.registerKey = text::localized(reg->name);
    return error;
}

QString rangeText(const catalog::Register& reg, const catalog::ValueFormat& meaning, bool physical)
{
    const auto fits = catalog::representableRange(reg.size, meaning.encoding, meaning.signBit);
    const std::int64_t min = std::max(fits.min, meaning.min.value_or(fits.min));
    const std::int64_t max = std::min(fits.max, meaning.max.value_or(fits.max));
    const bool inUnit = physical && !hasNamedValues(meaning) && !meaning.unit.isEmpty();
    const auto word = [&](std::int64_t raw) {
        return inUnit ? physicalText(raw, reg, meaning) : QString::number(raw);
    };
    if (min == -max)
        return QStringLiteral("±%1").arg(word(max));
    return QStringLiteral("%1–%2").arg(word(min), word(max));
}

QString physicalText(std::int64_t raw, const catalog::Register& reg,
                     const catalog::ValueFormat& meaning)
{
    // A plain number would only repeat the raw one.
    if (!hasNamedValues(meaning) && meaning.unit.isEmpty())
        return {};
    return catalog::formatValue(raw, reg, meaning, text::isUiChinese());
}

QString rawWord(std::int64_t raw, const catalog::Register& reg, const catalog::ValueFormat& meaning)
{
    const QString physical = physicalText(raw, reg, meaning);
    const QString number = QString::number(raw);
    return physical.isEmpty() || physical == number
               ? number
               : QStringLiteral("%1 — %2").arg(number, physical);
}
} // namespace ui
