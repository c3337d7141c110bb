// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalog/raw_range.h"
#include "catalog/units.h"
#include "catalog/value.h"

#include <QRegularExpression>
#include <QStringList>

#include <algorithm>
#include <cmath>

namespace catalog {
namespace {
/// Fewest decimals that still distinguish neighboring raw values.
int decimalsFor(double scale)
{
    int decimals = 0;
    double smallest = 1.0;
    while (decimals < 9 && smallest > std::abs(scale) * (1 + 1e-9)) {
        smallest /= 10;
        ++decimals;
    }
    return decimals;
}

/// A value's word: neither blanks nor the case matter.
QString normalized(const QString& word)
{
    QString plain = word.toLower();
    plain.remove(QLatin1Char(' '));
    return plain;
}

const NamedValue* findByName(const Register& reg, const QString& word)
{
    const QString normalizedWord = normalized(word);
    if (normalizedWord.isEmpty())
        return nullptr;
    for (const NamedValue& value : reg.values) {
        for (const QString& name : {value.key, value.name.en, value.name.zh}) {
            if (normalized(name) == normalizedWord)
                return &value;
        }
    }
    return nullptr;
}

const NamedValue* findByValue(const Register& reg, std::int64_t number)
{
    const auto it = std::find_if(reg.values.begin(), reg.values.end(),
                                 [&](const NamedValue& value) { return value.value == number; });
    return it == reg.values.end() ? nullptr : &*it;
}

QString formatBits(std::int64_t raw, const Register& reg, bool chinese)
{
    QStringList words;
    for (int bit = 0; bit < reg.size * 8; ++bit) {
        if (!((raw >> bit) & 1))
            continue;
        const NamedValue* value = findByValue(reg, bit);
        words << (value     ? value->name.in(chinese)
                  : chinese ? QStringLiteral("位 %1").arg(bit)
                            : QStringLiteral("bit %1").arg(bit));
    }
    if (words.isEmpty())
        return chinese ? QStringLiteral("无") : QStringLiteral("none");
    return words.join(QStringLiteral(" + "));
}

base::Error parseError(const Register& reg, const QString& detail)
{
    base::Error error{base::ErrorCode::BadArgument, QStringLiteral("value"), detail};
    error.registerKey = reg.key;
    return error;
}

std::optional<int> bitNumber(const QString& word, const Register& reg)
{
    if (const NamedValue* value = findByName(reg, word))
        return value->value;
    static const QRegularExpression numbered(QStringLiteral("^(?:bit|位)(\\d{1,2})$"));
    const auto match = numbered.match(normalized(word));
    const int bit = match.hasMatch() ? match.captured(1).toInt() : -1;
    return bit >= 0 && bit < reg.size * 8 ? std::optional(bit) : std::nullopt;
}

std::optional<std::int64_t> parseBits(const QString& text, const Register& reg)
{
    if (normalized(text) == QStringLiteral("none") || text == QStringLiteral("无"))
        return 0;
    std::int64_t raw = 0;
    for (const QString& word : text.split(QLatin1Char('+'))) {
        const auto bit = bitNumber(word, reg);
        if (!bit)
            return std::nullopt;
        raw |= std::int64_t{1} << *bit;
    }
    return raw;
}

/// A number and what follows it. Digits are checked by hand so that "nan", "inf" and "1e9" are
/// words.
struct NumberAndSuffix {
    QString number;
    QString suffix;
};

NumberAndSuffix splitNumber(const QString& text)
{
    QString plain = text;
    plain.replace(QChar(0x2212), QLatin1Char('-'));
    static const QRegularExpression hex(QStringLiteral("^[+-]?0[xX][0-9a-fA-F]+$"));
    if (hex.match(plain).hasMatch())
        return {plain, {}};
    static const QRegularExpression number(QStringLiteral("^([+-]?\\d+(?:\\.\\d+)?)\\s*(.*)$"));
    const auto match = number.match(plain);
    return match.hasMatch() ? NumberAndSuffix{match.captured(1), match.captured(2)}
                            : NumberAndSuffix{{}, plain};
}

QString expectedText(const Register& reg, const ValueFormat& meaning)
{
    QStringList kinds{QStringLiteral("a whole raw number")};
    if (!meaning.unit.isEmpty())
        kinds << QStringLiteral("a value in %1").arg(meaning.unit);
    if (!reg.values.empty())
        kinds << QStringLiteral("one of %1").arg(valueKeys(reg));
    return QStringLiteral("expected ") + kinds.join(QStringLiteral(", or "));
}

base::Result<std::int64_t> parsePhysical(double number, const QString& suffix, const Register& reg,
                                         const ValueFormat& meaning)
{
    const auto factor = unitFactor(suffix, meaning.unit);
    if (!factor)
        return tl::unexpected(parseError(reg, expectedText(reg, meaning)));
    const double physical = number * *factor;
    const std::int64_t raw = toRaw(physical, meaning);
    // Zero is a special value of many registers; a small value must not become it by rounding.
    if (raw == 0 && physical != 0.0)
        return tl::unexpected(parseError(
            reg,
            QStringLiteral("less than one step of %1 %2").arg(meaning.scale).arg(meaning.unit)));
    return raw;
}
} // namespace

QString valueKeys(const Register& reg)
{
    QStringList words;
    for (const NamedValue& value : reg.values)
        words << value.key;
    return words.join(QStringLiteral(", "));
}

QString formatValue(std::int64_t raw, const Register& reg, const ValueFormat& meaning, bool chinese)
{
    if (meaning.encoding == Encoding::Bits)
        return formatBits(raw, reg, chinese);
    if (meaning.encoding == Encoding::Enum) {
        const NamedValue* value = findByValue(reg, raw);
        return value ? value->name.in(chinese) : QString::number(raw);
    }
    if (meaning.unit.isEmpty())
        return QString::number(raw);
    return QString::number(toPhysical(raw, meaning), 'f', decimalsFor(meaning.scale)) +
           unitSuffix(meaning.unit);
}

base::Result<std::int64_t> parseValue(const QString& text, const Register& reg,
                                      const ValueFormat& meaning)
{
    const QString trimmed = text.trimmed();
    if (meaning.encoding == Encoding::Bits) {
        if (const auto bits = parseBits(trimmed, reg))
            return *bits;
    } else if (const NamedValue* value = findByName(reg, trimmed)) {
        return value->value;
    }
    const NumberAndSuffix split = splitNumber(trimmed);
    if (split.number.isEmpty())
        return tl::unexpected(parseError(reg, expectedText(reg, meaning)));
    bool whole = false;
    const qlonglong raw =
        split.number.toLongLong(&whole, split.number.contains(u'x', Qt::CaseInsensitive) ? 16 : 10);
    bool numeric = whole; // a hexadecimal number too long for 64 bits is none
    const double number = whole ? static_cast<double>(raw) : split.number.toDouble(&numeric);
    if (!numeric)
        return tl::unexpected(parseError(reg, expectedText(reg, meaning)));
    if (!split.suffix.isEmpty())
        return parsePhysical(number, split.suffix, reg, meaning);
    if (whole)
        return raw;
    if (std::abs(number) < 1e15 && number == std::floor(number))
        return static_cast<std::int64_t>(number);
    return tl::unexpected(parseError(reg, expectedText(reg, meaning)));
}
} // namespace catalog
