// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/input/arguments.h"

#include "cli/translate.h"
#include "history/server/server_address.h"
#include "protocol/request.h"
#include "text/language.h"
#include "transport/port_opener.h"

#include <QRegularExpression>

#include <algorithm>
#include <cmath>

namespace cli {
using base::ErrorCode;

namespace {
std::optional<int> intFrom(const QString& argument)
{
    static const QRegularExpression digits(QStringLiteral("^-?[0-9]{1,9}$"));
    return digits.match(argument).hasMatch() ? std::optional(argument.toInt()) : std::nullopt;
}

/// Edit distance (Levenshtein).
int distance(const QString& a, const QString& b)
{
    std::vector<int> row(static_cast<std::size_t>(b.size()) + 1);
    for (std::size_t j = 0; j < row.size(); ++j)
        row[j] = static_cast<int>(j);
    for (int i = 0; i < a.size(); ++i) {
        int diagonal = row[0];
        row[0] = i + 1;
        for (std::size_t j = 1; j < row.size(); ++j) {
            const int change = diagonal + (a[i] == b[static_cast<int>(j) - 1] ? 0 : 1);
            diagonal = row[j];
            row[j] = std::min({change, row[j] + 1, row[j - 1] + 1});
        }
    }
    return row.back();
}
} // namespace

/// For messages that repeat an invalid argument: it may be a connection string.
tl::unexpected<base::Error> badArgument(const QString& detail)
{
    return base::fail(ErrorCode::BadArgument, QStringLiteral("arguments"),
                      history::ServerAddress::masked(detail));
}

base::Result<int> parseId(const QString& argument)
{
    const auto id = intFrom(argument);
    if (!id || *id < 0 || *id > protocol::maxId)
        return badArgument(
            translate("cli", "\"%1\" is not a valid ID; IDs must be 0 to 253").arg(argument));
    return *id;
}

base::Result<IdRange> parseIdRange(const QString& argument)
{
    const qsizetype dash = argument.indexOf(QLatin1Char('-'));
    const auto first = parseId(dash < 0 ? argument : argument.left(dash));
    const auto last = parseId(dash < 0 ? argument : argument.mid(dash + 1));
    if (!first || !last || *first > *last)
        return badArgument(
            translate("cli", "\"%1\" is not an ID range; example: 1-20").arg(argument));
    return IdRange{*first, *last};
}

base::Result<std::vector<int>> parseIds(const QStringList& words)
{
    std::vector<int> ids;
    for (const QString& part : words.join(QLatin1Char(',')).split(QLatin1Char(','))) {
        const auto range = parseIdRange(part);
        if (!range)
            return tl::unexpected(range.error());
        for (int id = range->first; id <= range->last; ++id) {
            if (std::find(ids.begin(), ids.end(), id) == ids.end())
                ids.push_back(id);
        }
    }
    return ids;
}

base::Result<int> parseInt(const QString& argument, int min, int max)
{
    const auto number = intFrom(argument);
    if (!number || *number < min || *number > max)
        return badArgument(translate("cli", "\"%1\" is not a whole number from %2 to %3")
                               .arg(argument, QString::number(min), QString::number(max)));
    return *number;
}

base::Result<double> parsePositive(const QString& argument)
{
    bool good = false;
    const double number = argument.toDouble(&good);
    if (!good || !std::isfinite(number) || number <= 0 || number > 1e6)
        return badArgument(translate("cli", "\"%1\" is not a number above 0").arg(argument));
    return number;
}

base::Result<std::vector<int>> parseBauds(const QString& argument)
{
    const std::vector<int>& known = transport::standardBaudRates();
    if (argument == QLatin1String("all"))
        return known;
    std::vector<int> bauds;
    for (const QString& part : argument.split(QLatin1Char(','))) {
        const auto baud = intFrom(part);
        if (!baud || std::find(known.begin(), known.end(), *baud) == known.end()) {
            QStringList names;
            for (const int rate : known)
                names << QString::number(rate);
            return badArgument(translate("cli", "unsupported baud rate \"%1\" (%2)")
                                   .arg(part, text::joinItems(names)));
        }
        bauds.push_back(*baud);
    }
    return bauds;
}

base::Result<std::optional<base::Protocol>> parseProtocol(const QString& argument)
{
    if (argument == QLatin1String("auto"))
        return std::optional<base::Protocol>();
    if (const auto protocol = base::protocolFromName(argument))
        return protocol;
    return badArgument(
        translate("cli", "unknown protocol \"%1\" (auto, feetech, modbus, lx)").arg(argument));
}

base::Result<std::pair<QString, QString>> parseAssignment(const QString& argument)
{
    const qsizetype sign = argument.indexOf(QLatin1Char('='));
    if (sign < 1 || sign == argument.size() - 1)
        return badArgument(
            translate("cli", "\"%1\" must have the form KEY=VALUE, without spaces").arg(argument));
    return std::pair(argument.left(sign), argument.mid(sign + 1));
}

QStringList nearest(const QString& argument, const QStringList& known)
{
    std::vector<std::pair<int, QString>> ranked;
    for (const QString& candidate : known) {
        const bool contained = argument.size() >= 3 && candidate.contains(argument);
        const int steps = contained ? 1 : distance(argument.toLower(), candidate);
        if (steps <= std::max(2, static_cast<int>(argument.size()) / 3))
            ranked.emplace_back(steps, candidate);
    }
    std::stable_sort(ranked.begin(), ranked.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
    QStringList names;
    for (std::size_t i = 0; i < std::min<std::size_t>(3, ranked.size()); ++i)
        names << ranked[i].second;
    return names;
}

base::Result<const catalog::Register*> findRegister(const catalog::Profile& profile,
                                                    const QString& key, int id)
{
    if (const catalog::Register* reg = profile.find(key))
        return reg;
    QStringList known;
    for (const catalog::Register& reg : profile.registers)
        known << reg.key;
    const QStringList near = nearest(key, known);
    const QString hint = near.isEmpty()
                             ? QString()
                             : translate("cli", "did you mean %1?").arg(text::joinItems(near));
    return tl::unexpected(
        base::Error{ErrorCode::UnknownRegister, QStringLiteral("read"), hint, id, key});
}
} // namespace cli
