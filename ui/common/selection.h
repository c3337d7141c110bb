// SPDX-License-Identifier: GPL-3.0-or-later
// The servo that the window shows, and the others that move with it. One for the window; main
// thread. Selecting reads and writes nothing by itself; a page that shows the servo requests what
// it needs.
#pragma once

#include "session/servos/servo_entry.h"

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
        setSelected(ref != 0 ? std::vector{ref} : std::vector<session::ServoRef>{});
    }

    /// All that are to move together, the current one first.
    const std::vector<session::ServoRef>& selected() const { return m_selected; }
    void setSelected(std::vector<session::ServoRef> chosen)
    {
        if (chosen == m_selected)
            return;
        m_selected = std::move(chosen);
        const session::ServoRef first = m_selected.empty() ? 0 : m_selected.front();
        if (std::exchange(m_current, first) != first)
            Q_EMIT changed(first);
        Q_EMIT selectedServosChanged();
    }
    /// The selected rows of a list: the current one stays the first while it is among them, else
    /// it is the one that was clicked.
    void setSelectedRows(std::vector<session::ServoRef> rows, session::ServoRef clicked)
    {
        const bool isCurrentAmong = std::find(rows.begin(), rows.end(), m_current) != rows.end();
        const session::ServoRef first = isCurrentAmong ? m_current : clicked;
        std::stable_partition(rows.begin(), rows.end(),
                              [first](session::ServoRef ref) { return ref == first; });
        setSelected(std::move(rows));
    }
    /// It is gone. With the current one all are let go: nothing is to move in its place.
    void remove(session::ServoRef ref)
    {
        if (ref == m_current)
            return setSelected({});
        std::vector<session::ServoRef> remaining = m_selected;
        remaining.erase(std::remove(remaining.begin(), remaining.end(), ref), remaining.end());
        setSelected(std::move(remaining));
    }

Q_SIGNALS:
    void changed(session::ServoRef ref); ///< the current one
    void selectedServosChanged();        ///< any of them

private:
    session::ServoRef m_current = 0;
    std::vector<session::ServoRef> m_selected;
};
} // namespace ui
