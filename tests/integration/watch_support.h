// SPDX-License-Identifier: GPL-3.0-or-later
// What the tests of watching share. One thread.
#pragma once

#include "jobs/watch/watch.h"
#include "support/sim_fixture.h"

#include <QStringList>

#include <algorithm>

namespace watch_support {
constexpr int fast = 1'000'000;

using Rows = std::vector<jobs::WatchRow>;

struct WatchResult {
    base::Result<jobs::WatchReport> report;
    Rows rows;
};

inline WatchResult watch(support::SimFixture& fixture, const jobs::WatchSpec& spec)
{
    Rows rows;
    auto report = jobs::watch(fixture.context(), spec, [&](const jobs::WatchRow& row) {
        rows.push_back(row);
        return base::Result<void>{};
    });
    return {std::move(report), std::move(rows)};
}

inline jobs::WatchSpec specFor(support::SimFixture& fixture, const std::vector<int>& ids,
                               base::Duration period, base::Duration length)
{
    jobs::WatchSpec spec;
    for (const int id : ids)
        spec.servos.push_back(fixture.servo(id));
    spec.period = period;
    spec.length = length;
    return spec;
}

inline std::size_t column(const std::vector<jobs::WatchColumn>& columns, const QString& key,
                          const QString& unit = {})
{
    const auto found = std::find_if(columns.begin(), columns.end(), [&](const auto& c) {
        return c.key == key && (unit.isEmpty() || c.unit == unit);
    });
    return std::size_t(found - columns.begin());
}

inline QStringList headers(const std::vector<jobs::WatchColumn>& columns)
{
    QStringList texts;
    for (const jobs::WatchColumn& c : columns)
        texts.append(QStringLiteral("%1[%2]").arg(c.key, c.unit));
    return texts;
}

inline Rows rowsOf(const Rows& rows, int id)
{
    Rows result;
    std::copy_if(rows.begin(), rows.end(), std::back_inserter(result),
                 [id](const jobs::WatchRow& row) { return row.id == id; });
    return result;
}
} // namespace watch_support
