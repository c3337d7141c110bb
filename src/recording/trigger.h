// SPDX-License-Identifier: GPL-3.0-or-later
// Waits in a stream of samples for the moment a chart is to be frozen at: a level, an edge, a
// moving flag, a fault, a write. Fed with every sample and mark in time order; pure, one thread.
#pragma once

#include "recording/sample_store.h"

namespace recording {
enum class MarkKind : std::uint8_t {
    Write,
    Fault,
    FaultCleared,
    LinkError,
    LinkRestored,
    Move,
    Stop,
    Note
};
QString markName(MarkKind kind); ///< "write", "fault", "fault-over", "link-error" …
std::optional<MarkKind> markFromName(const QString& name);

/// Something that happened at an instant, shown in charts and kept in recordings.
struct Mark {
    base::Duration at{};
    MarkKind kind = MarkKind::Note;
    int servoId = -1; ///< -1: none or all
    QString text;     ///< "position_p 32 → 40", in technical words
    bool operator==(const Mark&) const = default;
};

struct TriggerSpec {
    enum class Kind : std::uint8_t {
        Above,   ///< the level itself, or more; counts also when it is there from the beginning
        Below,   ///< or less
        Rising,  ///< must have been below (level - hysteresis) before
        Falling, ///< must have been above (level + hysteresis) before
        Mark,    ///< any mark of `mark`
    };
    Kind kind = Kind::Rising;
    ChannelId channel = -1; ///< not for Mark; the moving flag is a channel like others
    double level = 0;
    double hysteresis = 0;
    MarkKind mark = MarkKind::Fault;
    int servoId = -1;      ///< Mark: of this servo, or one that concerns all; -1: of any
    base::Duration pre{};  ///< shown before the instant
    base::Duration post{}; ///< waited for after it
};

/// Arm → (fires) → complete when `post` has passed. After a gap an edge starts anew.
class Trigger {
public:
    enum class State : std::uint8_t { Idle, Armed, Fired, Complete };

    void arm(const TriggerSpec& spec);
    void disarm();
    void sample(ChannelId channel, base::Duration at, double value);
    void gap(ChannelId channel);
    void mark(const Mark& mark);
    /// Called as time passes without samples; completes a trigger that has fired.
    void advanceTo(base::Duration now);

    State state() const { return m_state; }
    const TriggerSpec& spec() const { return m_spec; }
    std::optional<base::Duration> firedAt() const { return m_firedAt; }
    /// From `pre` before to `post` after; none before it has fired.
    std::optional<TimeSpan> window() const;

private:
    void fire(base::Duration at);

    TriggerSpec m_spec;
    State m_state = State::Idle;
    std::optional<base::Duration> m_firedAt;
    bool m_isPrimed = false; ///< the other side of the level has been seen
};
} // namespace recording
