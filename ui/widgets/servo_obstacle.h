// SPDX-License-Identifier: GPL-3.0-or-later
// What a page shows in place of a servo's controls or table: why there are none, and where several
// servos share an ID the way out, which is to set them up one at a time. Main thread.
#pragma once

#include "session/servos/servo_entry.h"
#include "ui/common/commands.h"

#include <QWidget>

class QLabel;
class QPushButton;

namespace ui {
class ServoObstacle final : public QWidget {
public:
    ServoObstacle(Commands& commands, const QString& name, QWidget* parent = nullptr);

    /// Null: no servo is selected.
    void showObstacle(const QString& why, const session::ServoEntry* entry);

private:
    QLabel* m_why;
    QPushButton* m_setUp;
    QAction* m_page; ///< what the button does
};

/// Of a servo that has been found without being identified.
QString unidentifiedText(const session::ServoEntry& entry);
} // namespace ui
