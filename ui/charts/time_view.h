// SPDX-License-Identifier: GPL-3.0-or-later
// The time span that a chart shows: the last seconds up to now, or a fixed span. Instants of the
// bus clock. A value; one thread.
#pragma once

#include "recording/sample_store.h"

namespace ui {
class TimeView {
public:
    static constexpr base::Duration minWidth = std::chrono::milliseconds(1);
    static constexpr base::Duration maxWidth = std::chrono::hours(24 * 30);

    bool isFollowing() const { return m_following; }
    base::Duration now() const { return m_now; }
    base::Duration width() const { return m_span.to - m_span.from; }
    const recording::TimeSpan& span() const { return m_span; }

    /// True when what is shown has changed.
    bool advance(base::Duration now);
    /// Off: the picture stays as it is.
    void setFollowing(bool on);
    /// Stops following.
    void show(recording::TimeSpan span);
    /// The right edge stays while following, otherwise the middle.
    void setWidth(base::Duration width);
    /// factor < 1: closer. `place` 0 … 1 from the left stays where it is, while following the right
    /// edge.
    void zoom(double factor, double place);
    /// Stops following. The picture keeps at least a tenth of `kept` (what there is to be seen).
    void panBy(base::Duration by, const std::optional<recording::TimeSpan>& bounds);

    base::Duration timeAt(double place) const;
    double fractionOf(base::Duration at) const;

private:
    bool m_following = true;
    base::Duration m_now{};
    recording::TimeSpan m_span{-std::chrono::seconds(10), base::Duration{}};
};
} // namespace ui
