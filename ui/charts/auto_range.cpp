// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/charts/auto_range.h"

#include <algorithm>
#include <cmath>

namespace ui {
namespace {
constexpr double oversized = 0.7; ///< less than this part of an axis is needed
}

void AutoRange::update(double min, double max, base::Duration now)
{
    if (m_fixed || !std::isfinite(min) || !std::isfinite(max) || min > max)
        return;
    const AxisRange required = paddedRange(min, max, m_unit);
    if (!m_known) {
        setNow(min, max);
        return;
    }
    if (min < m_range.low || max > m_range.high) {
        m_range = {std::min(m_range.low, required.low), std::max(m_range.high, required.high)};
        m_oversizedSince.reset();
        return;
    }
    if (required.size() > m_range.size() * oversized) {
        m_oversizedSince.reset();
        return;
    }
    if (!m_oversizedSince)
        m_oversizedSince = now;
    if (now - *m_oversizedSince < shrinkDelay)
        return;
    m_range = required;
    m_oversizedSince.reset();
}

void AutoRange::setNow(double min, double max)
{
    if (m_fixed || !std::isfinite(min) || !std::isfinite(max) || min > max)
        return;
    m_range = paddedRange(min, max, m_unit);
    m_known = true;
    m_oversizedSince.reset();
}

void AutoRange::setFixed(const AxisRange& range)
{
    const double minSize = 1e-9 * std::max(1.0, std::abs(range.low));
    if (!std::isfinite(range.low) || !std::isfinite(range.high) || range.size() < minSize ||
        range.size() > 1e15)
        return;
    m_range = range;
    m_fixed = m_known = true;
    m_oversizedSince.reset();
}

void AutoRange::setAutomatic()
{
    m_known = m_known && !m_fixed;
    m_fixed = false;
}
} // namespace ui
