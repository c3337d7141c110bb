// SPDX-License-Identifier: GPL-3.0-or-later
// The curves of the trend chart: a list of servo and register, and what it means now: the channels
// of the live data and the registers to read. "The selected servo" is a choice of its own, so that
// the curves follow the selection. Values and pure functions; main thread.
#pragma once

#include "session/recording/live_data.h"
#include "ui/charts/trend_channel.h"

namespace ui {
/// `servo` as presets have it: "*" the selected one, "3" the one with that ID.
struct TrendCurve {
    QString servo = QStringLiteral("*");
    QString key; ///< register key, session::errorKey, or built in ("@goal"): see trend_curves.cpp
    QColor color{}; ///< invalid: that of its quantity
    bool visible = true;
    double scale = 1.0;
    double offset = 0.0;
    QString id() const { return servo + QLatin1Char('/') + key; }
    static TrendCurve fromId(const QString& id);
    bool operator==(const TrendCurve&) const = default;
};

/// Words that mean a register of each family: "@goal", "@position", "@speed", "@load", "@current",
/// "@voltage", "@temperature", "@error".
QString registerOf(const catalog::Profile& profile, const QString& key);
QStringList builtInKeys();
QString builtInName(const QString& key);

/// Goal, position, speed, current of the selected servo; load where no current is measured.
std::vector<TrendCurve> defaultCurves();

/// Of a recording's column: the register's name as far as a servo here has it, else its key.
QString recordedChannelName(const session::ServoRegistry& registry,
                            const recording::RecordingChannel& column);

/// A mark as the chart shows it: "ID 1 · Over-temperature".
QString markText(const session::ServoRegistry& registry, const recording::Mark& mark);

class TrendResolver {
public:
    TrendResolver(const session::ServoRegistry& registry, const session::LiveData& scope,
                  session::ServoRef selected)
        : m_registry(registry)
        , m_liveData(scope)
        , m_selected(selected)
    {}
    session::ServoRef servoOf(const TrendCurve& curve) const; ///< 0: not in the list
    /// As the chart draws it; id −1 while nothing has been read.
    std::optional<TrendChannel> channel(const TrendCurve& curve, const QColor& color) const;
    /// What must be read for these.
    session::Subscription subscription(const std::vector<TrendCurve>& curves) const;

private:
    const session::ServoRegistry& m_registry;
    const session::LiveData& m_liveData;
    session::ServoRef m_selected;
};
} // namespace ui
