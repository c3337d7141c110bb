// SPDX-License-Identifier: GPL-3.0-or-later
// What to check before a servo is energized for the first time in a session. Keeps the action that
// waits for the answer. Owned by the control panel; main thread.
#pragma once

#include "session/settings.h"

#include <QFrame>

#include <functional>

class QCheckBox;
class QLabel;
class QPushButton;

namespace ui {
class TorqueHint final : public QFrame {
    Q_OBJECT

public:
    TorqueHint(session::Settings& settings, QWidget* parent);

    /// True: it has been answered, or is never to be shown. False: it is shown now, and `action`
    /// (which may be empty) is done when the user goes on.
    bool isConfirmed(std::function<void()> action);
    /// The question has lost its point: another servo, the port closed.
    void dismiss();
    void retranslate();

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    void proceed();

    session::Settings& m_settings;
    QLabel* m_title;
    QLabel* m_text;
    QCheckBox* m_neverAsk;
    QPushButton* m_cancel;
    QPushButton* m_yes;
    std::function<void()> m_action;
    bool m_answered = false;
};
} // namespace ui
