// SPDX-License-Identifier: GPL-3.0-or-later
// Which servo the window is about, and which others move with it. One for the window; main thread.
// Selecting reads nothing and writes nothing by itself; whoever shows the servo asks Desk for what
// it needs.
#pragma once

#include "session/servo_entry.h"

#include <QObject>

#include <algorithm>
#include <utility>
#include <vector>

namespace ui {
class Selection final : public QObject {
    Q_OBJECT

public:
    using QObject::QObject;

    session::ServoRef current() const { return m_current; } ///< 0: none
    void select(session::ServoRef ref)
    {
        choose(ref != 0 ? std::vector{ref} : std::vector<session::ServoRef>{});
    }

    /// All that are to move together, the current one first.
    const std::vector<session::ServoRef>& chosen() const { return m_chosen; }
    void choose(std::vector<session::ServoRef> chosen)
    {
        if (chosen == m_chosen)
            return;
        m_chosen = std::move(chosen);
        const session::ServoRef first = m_chosen.empty() ? 0 : m_chosen.front();
        if (std::exchange(m_current, first) != first)
            Q_EMIT changed(first);
        Q_EMIT chosenChanged();
    }
    /// It is gone. With the current one all are let go: nothing is to move in its place.
    void drop(session::ServoRef ref)
    {
        if (ref == m_current)
            return choose({});
        std::vector<session::ServoRef> left = m_chosen;
        left.erase(std::remove(left.begin(), left.end(), ref), left.end());
        choose(std::move(left));
    }

Q_SIGNALS:
    void changed(session::ServoRef ref); ///< the current one
    void chosenChanged();                ///< any of them

private:
    session::ServoRef m_current = 0;
    std::vector<session::ServoRef> m_chosen;
};
} // namespace ui
