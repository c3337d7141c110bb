// SPDX-License-Identifier: GPL-3.0-or-later
// The names that the values of an enum have in files, in JSON and on the command line: one table
// per enum, looked up in both directions. Names are part of formats and must not change. Any
// thread.
#pragma once

#include <QLatin1String>
#include <QStringView>

#include <cstddef>
#include <optional>

namespace base {
/// A row of `constexpr EnumName<Grade> gradeNames[]{{Grade::Pass, "pass"}, …}`.
template <typename Enum>
struct EnumName {
    Enum value;
    const char* name;
};

/// Every value needs a row; a value without one has no name.
template <typename Enum, std::size_t Count>
QLatin1StringView nameOf(const EnumName<Enum> (&names)[Count], Enum value)
{
    for (const EnumName<Enum>& row : names) {
        if (row.value == value)
            return QLatin1StringView(row.name);
    }
    return {};
}

template <typename Enum, std::size_t Count>
std::optional<Enum> valueOf(const EnumName<Enum> (&names)[Count], QStringView name)
{
    for (const EnumName<Enum>& row : names) {
        if (name == QLatin1StringView(row.name))
            return row.value;
    }
    return std::nullopt;
}
} // namespace base
