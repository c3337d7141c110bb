// SPDX-License-Identifier: GPL-3.0-or-later
// Which servo the window is about. One for the window; main thread. Selecting reads nothing and
// writes nothing by itself; whoever shows the servo asks Desk for what it needs.
#pragma once

#include "session/servo_entry.h"

#include <QObject>

namespace ui {
class Selection final : public QObject {
    Q_OBJECT

public:
    using QObject::QObject;

    session::ServoRef current() const { return m_current; } ///< 0: none
    void select(session::ServoRef ref)
    {
        if (ref == m_current)
            return;
        m_current = ref;
        Q_EMIT changed(ref);
    }

Q_SIGNALS:
    void changed(session::ServoRef ref);

private:
    session::ServoRef m_current = 0;
};
} // namespace ui
