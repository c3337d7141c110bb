// SPDX-License-Identifier: GPL-3.0-or-later
// The range of a y axis that follows its curves without fidgeting: it grows at once when a curve
// would leave the chart, and shrinks only after the curves have needed much less for a while. A
// range that the user has set stays. A value; one thread.
#pragma once

#include "base/clock.h"
#include "ui/charts/axis_ticks.h"

#include <optional>

namespace ui {
class AutoRange {
public:
    static constexpr base::Duration shrinkDelay = std::chrono::seconds(2);

    explicit AutoRange(QString unit = {})
        : m_unit(std::move(unit))
    {}

    /// What is in view now; `now` only ever grows. Nothing is done while it is fixed.
    void update(double min, double max, base::Duration now);
    /// As update(), but without patience: another view was asked for.
    void setNow(double min, double max);

    void setFixed(const AxisRange& range);
    void setAutomatic();
    bool isFixed() const { return m_fixed; }

    const QString& unit() const { return m_unit; }
    const AxisRange& range() const { return m_range; }

private:
    QString m_unit;
    AxisRange m_range;
    bool m_known = false;
    bool m_fixed = false;
    std::optional<base::Duration> m_oversizedSince;
};
} // namespace ui
