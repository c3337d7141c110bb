// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/charts/auto_range.h"

#include <cmath>

namespace ui {
namespace {
constexpr double margin = 0.025; ///< of the height, above and below
}

void AutoRange::update(double min, double max, base::Duration now)
{
    if (m_fixed || !std::isfinite(min) || !std::isfinite(max) || min > max)
        return;
    const AxisRange required = roundRange(min, max, m_unit);
    const bool outside = min < m_range.low || max > m_range.high;
    if (!m_known || outside) {
        m_range = required;
        m_known = true;
        m_oversizedSince.reset();
        return;
    }
    if (required.size() > m_range.size() / 2) {
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
    m_range = roundRange(min, max, m_unit);
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

AxisRange AutoRange::paddedRange() const
{
    if (m_fixed)
        return m_range;
    const double more = m_range.size() * margin;
    return {m_range.low - more, m_range.high + more};
}

double AutoRange::step(bool tall) const
{
    const int parts = tall ? 2 * axisDivisions : axisDivisions;
    return m_fixed ? valueStep(m_range.size(), parts, m_unit) : m_range.size() / parts;
}
} // namespace ui
