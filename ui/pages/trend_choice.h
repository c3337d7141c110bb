// SPDX-License-Identifier: GPL-3.0-or-later
// Which curves the trend chart shows: a list of servo and register, remembered, and what that means
// right now: the samples of the scope, the registers to be read. "The selected servo" is a choice
// of its own, so that the curves follow the selection. Values and pure functions; main thread.
#pragma once

#include "session/scope.h"
#include "ui/charts/trend_channel.h"

namespace ui {
/// `servo` as presets have it: "*" the selected one, "3" the one with that ID.
struct TrendChoice {
    QString servo = QStringLiteral("*");
    QString key;     ///< register key, session::errorKey, or a role's word: see standsFor
    QColor colour{}; ///< invalid: from the palette, by its place
    bool visible = true;
    double scale = 1.0;
    double offset = 0.0;
    QString id() const { return servo + QLatin1Char('/') + key; }
    static TrendChoice fromId(const QString& id);
    bool operator==(const TrendChoice&) const = default;
};

/// Words that mean a register of each family: "@goal", "@position", "@speed", "@load", "@current",
/// "@voltage", "@temperature", "@error".
QString registerOf(const catalog::Profile& profile, const QString& key);
QStringList readyMadeKeys();
QString readyMadeName(const QString& key);

/// Goal, position, speed, current of the selected servo; load where no current is measured.
std::vector<TrendChoice> defaultChoices();

/// Of a recording's column: the register's name as far as a servo here has it, else its key.
QString recordedName(const session::Desk& desk, const record::RecordingChannel& column);

/// A mark as the chart says it: "ID 1 · Over-temperature".
QString markWords(const session::Desk& desk, const record::Mark& mark);

class TrendResolver {
public:
    TrendResolver(const session::Desk& desk, const session::Scope& scope,
                  session::ServoRef selected)
        : m_desk(desk)
        , m_scope(scope)
        , m_selected(selected)
    {}
    session::ServoRef servoOf(const TrendChoice& choice) const; ///< 0: not in the list
    /// As the chart draws it; id −1 while nothing has been read.
    std::optional<TrendChannel> channel(const TrendChoice& choice, std::size_t place,
                                        const QColor& ground) const;
    /// What must be read for these.
    session::FeedWish wish(const std::vector<TrendChoice>& choices) const;

private:
    const session::Desk& m_desk;
    const session::Scope& m_scope;
    session::ServoRef m_selected;
};
} // namespace ui
