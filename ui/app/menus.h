// SPDX-License-Identifier: GPL-3.0-or-later
// The menus of the window, all from the command table. Owned by the window's menu bar; main thread.
#pragma once

#include "ui/common/commands.h"

#include <QMenuBar>

namespace ui {
class Menus final : public QObject {
    Q_OBJECT

public:
    /// `docks`: the window's own switches for its docks.
    Menus(QMenuBar& bar, const Commands& commands, const QList<QAction*>& docks);

    void retranslate();

    /// The servo menu's entries, for context menus of servos too.
    static void addServoCommands(QMenu& menu, const Commands& commands);

private:
    QMenu* m_port;
    QMenu* m_edit;
    QMenu* m_servo;
    QMenu* m_view;
    QMenu* m_theme;
    QMenu* m_language;
    QMenu* m_help;
};
} // namespace ui
