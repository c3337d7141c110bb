// SPDX-License-Identifier: GPL-3.0-or-later
// Distinguishes a servo that went silent from a lost reading: four lost in a row, or lost ones
// over more than a quarter of a second. Part of a ServoEntry; main thread; bus-clock instants.
#pragma once

#include "base/clock.h"

#include <cstdint>
#include <optional>

namespace session {
class LinkMonitor {
public:
    enum class Transition : std::uint8_t { None, Lost, Back };

    /// `garbled`: not answered, but something unreadable came.
    Transition addReading(bool answered, base::Duration at, bool garbled = false)
    {
        if (garbled)
            m_garbledAt = at;
        m_latest = at;
        if (answered) {
            const bool back = m_lost;
            *this = {};
            return back ? Transition::Back : Transition::None;
        }
        if (m_missed++ == 0)
            m_since = at;
        const bool silent = m_missed >= minMissed || (m_missed > 1 && at - m_since > maxSilence);
        if (m_lost || !silent)
            return Transition::None;
        m_lost = true;
        return Transition::Lost;
    }
    bool isLost() const { return m_lost; }
    /// The latest of the lost readings were garbage, not silence.
    bool isGarbled() const { return m_garbledAt && m_latest - *m_garbledAt < garbledTimeout; }
    /// Of the first lost reading; nullopt while it answers.
    std::optional<base::Duration> silentSince() const
    {
        return m_lost ? std::optional(m_since) : std::nullopt;
    }

private:
    static constexpr int minMissed = 4;
    static constexpr base::Duration maxSilence = std::chrono::milliseconds(250);
    static constexpr base::Duration garbledTimeout = std::chrono::seconds(1);
    int m_missed = 0;
    bool m_lost = false;
    base::Duration m_since{};
    base::Duration m_latest{};
    std::optional<base::Duration> m_garbledAt{};
};
} // namespace session
