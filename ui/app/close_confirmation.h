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
class CloseConfirmation final : public QObject {
    Q_OBJECT

public:
    CloseConfirmation(session::Desk& desk, QWidget* window);

    void disconnectPort();
    void closeWindow();

private:
    enum class CloseTarget : std::uint8_t { Disconnect, Close };

    void requestClose(CloseTarget target);
    void confirmTest(bool holds);
    void proceed();
    void confirmOpenWrites(const session::OpenWrites& found);
    void confirmMotion();
    void handleMotion(const std::vector<session::MovingServo>& moving);
    void close(session::MotionOnClose how);

    session::Desk& m_desk;
    QWidget* m_window;
    std::optional<CloseTarget> m_target; ///< asked for, and not decided yet
    session::LockOnClose m_lock = session::LockOnClose::CloseOrKeepOpen;
};
} // namespace ui
