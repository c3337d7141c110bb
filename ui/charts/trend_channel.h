// SPDX-License-Identifier: GPL-3.0-or-later
// One curve of a trend chart: its samples and its style; and how lanes are arranged. Values; main
// thread.
#pragma once

#include "recording/trigger.h"

#include <QColor>
#include <QMap>
#include <QStringList>

#include <functional>

namespace ui {
struct TrendChannel {
    recording::ChannelId id = -1;
    QString key;  ///< stable, for presets: "1/present_position"; "error" rows: "1/error"
    QString name; ///< translated: "ID 1 · Present position"
    QString unit; ///< channels of one unit share an axis: "°", "rpm", "V" …; empty: plain number
    QColor color;
    bool visible = true;
    bool steps = false;  ///< holds its value until the next sample: goals, flags
    bool dashed = false; ///< a goal, beside what is measured
    /// Earlier values do not widen the value axis: goals of a time without torque.
    base::Duration axisFrom = base::Duration::min();
    double scale = 1.0; ///< drawn as value × scale + offset; cursors show the value itself
    double offset = 0.0;
};

/// How the user has arranged the lanes, by unit; those not in it have their usual place or height.
struct LaneLayout {
    QMap<QString, double> heights{}; ///< to each other
    QStringList order{};
    bool operator==(const LaneLayout&) const = default;
};

/// What a chart writes beside a mark, in the language of the moment.
using MarkTextFunction = std::function<QString(const recording::Mark&)>;
} // namespace ui
