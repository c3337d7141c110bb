// SPDX-License-Identifier: GPL-3.0-or-later
// The padlock: whether the EPROM of the servo is locked, and if not, whether ServoDesk or another
// program has unlocked it, with the button that locks it. Owned by the toolbar; main thread.
#pragma once

#include "session/servos/servo_entry.h"

#include <QWidget>

class QAction;
class QLabel;
class QToolButton;

namespace ui {
class LockBadge final : public QWidget {
    Q_OBJECT

public:
    LockBadge(QAction* closeLock, QWidget* parent);

    /// Null: no servo; hidden.
    void setEntry(const session::ServoEntry* entry);

    enum class Lock : std::uint8_t { NoServo, None, NotRead, Closed, OpenByUs, OpenByOthers };
    Lock lock() const { return m_lock; }

protected:
    void changeEvent(QEvent* event) override;

private:
    static QString lockText(Lock lock);
    void retranslate();
    void showSign();

    QLabel* m_sign;
    QLabel* m_word;
    QToolButton* m_close;
    Lock m_lock = Lock::NoServo;
};
} // namespace ui
