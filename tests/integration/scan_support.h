// SPDX-License-Identifier: GPL-3.0-or-later
// What the tests of the search share. One thread.
#pragma once

#include "jobs/scan/scan.h"
#include "support/sim_fixture.h"

#include <QList>

#include <algorithm>

namespace scan_support {
constexpr int fast = 1'000'000;

inline QList<int> idsOf(const jobs::ScanReport& report)
{
    QList<int> ids;
    for (const jobs::FoundServo& found : report.found)
        ids.append(found.servo.id);
    return ids;
}

inline const jobs::FoundServo* find(const jobs::ScanReport& report, int id)
{
    const auto found = std::find_if(report.found.begin(), report.found.end(),
                                    [id](const jobs::FoundServo& f) { return f.servo.id == id; });
    return found == report.found.end() ? nullptr : &*found;
}

/// A USB adapter that hands bytes on 16 ms late.
inline support::SimFixtureOptions slowAdapterOptions()
{
    support::SimFixtureOptions options;
    options.wire.adapterLatency = std::chrono::milliseconds(16);
    return options;
}
} // namespace scan_support
