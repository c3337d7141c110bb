// SPDX-License-Identifier: GPL-3.0-or-later
// Closing the window or the port while servos turn on the program's command asks first: stop them,
// leave them turning, or stay. Reads before it asks; what does not move closes without a question.
// A test that moves servos is asked about first: what becomes of their torque is said. Then what
// the journal still holds is named; an EPROM lock that a write has left open is closed or left on
// request.
// Owned by the window; main thread.
#pragma once

#include "session/desk.h"

#include <QPointer>

#include <functional>

class QWidget;

namespace ui {
class LeaveQuestion final : public QObject {
    Q_OBJECT

public:
    LeaveQuestion(session::Desk& desk, QWidget* window);

    void disconnectPort();
    void closeWindow();

private:
    enum class Way : std::uint8_t { Disconnect, Close };

    void begin(Way way);
    void askAboutTest(bool holds);
    void proceed();
    void askAboutWrites(const session::UnfinishedWrites& found);
    void askAboutMotion();
    void found(const std::vector<session::MovingServo>& moving);
    void go(session::AtClose how);

    session::Desk& m_desk;
    QWidget* m_window;
    std::optional<Way> m_way; ///< asked for, and not decided yet
    session::LockAtClose m_lock = session::LockAtClose::CloseOrStay;
};
} // namespace ui
