// SPDX-License-Identifier: GPL-3.0-or-later
// What the trend panel remembers between starts: its curves, the time it shows of live readings,
// and how often it reads. Values that cannot be read are replaced by the defaults. Owned by the
// panel; main thread.
#pragma once

#include "session/settings.h"
#include "ui/trends/trend_curves.h"

namespace ui {
class TrendSettings final {
public:
    explicit TrendSettings(session::Settings& settings)
        : m_settings(settings)
    {}

    session::Settings& all() const { return m_settings; }
    std::vector<TrendCurve> curves() const;
    void setCurves(const std::vector<TrendCurve>& curves);
    base::Duration width() const; ///< at least 1 s
    void setWidth(base::Duration width);
    int rate() const; ///< in Hz; 0: as fast as the bus allows
    void setRate(int hz);
    int memory() const; ///< for readings, in megabytes
    void setMemory(int megabytes);
    bool hasLanes() const;
    void setLanes(bool on);
    LaneLayout laneLayout() const;
    void setLaneLayout(const LaneLayout& layout);

private:
    session::Settings& m_settings;
};
} // namespace ui
