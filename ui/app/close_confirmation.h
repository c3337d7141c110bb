// SPDX-License-Identifier: GPL-3.0-or-later
// Asks before the window or the port is closed. Servos that turn on a command of this program: stop
// them, leave them turning, or cancel; they are read first, and what does not move needs no
// question. A running test that moves servos: the question says what happens to their torque.
// Unfinished writes in the journal are named; an EPROM that a write has left unlocked is locked or
// left, as the user decides. Owned by the window; main thread.
#pragma once

#include "session/workbench.h"
#include "ui/widgets/question_dialog.h"

#include <QPointer>

#include <functional>

class QWidget;

namespace ui {
class CloseConfirmation final : public QObject {
    Q_OBJECT

public:
    CloseConfirmation(session::Workbench& workbench, QWidget* window);

    void disconnectPort();
    void closeWindow();

private:
    enum class CloseTarget : std::uint8_t { Disconnect, Close };

    void requestClose(CloseTarget target);
    void confirmTest(bool holds);
    void proceed();
    void confirmOpenWrites(const session::OpenWrites& found);
    Question openWritesQuestion(const QStringList& ids, const QStringList& open,
                                const QStringList& openElsewhere) const;
    void confirmMotion();
    void handleMotion(const std::vector<session::MovingServo>& moving);
    void close(session::MotionOnClose how);

    session::Workbench& m_workbench;
    QWidget* m_window;
    std::optional<CloseTarget> m_target; ///< asked for, and not decided yet
    session::LockOnClose m_lock = session::LockOnClose::CloseOrKeepOpen;
};
} // namespace ui
