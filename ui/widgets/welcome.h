// SPDX-License-Identifier: GPL-3.0-or-later
// The middle of the window while nothing is connected: the ways to begin, each one click. Owned
// by the window; main thread.
#pragma once

#include "ui/common/commands.h"

#include <QWidget>

class QLabel;
class QPushButton;

namespace ui {
class Welcome final : public QWidget {
    Q_OBJECT

public:
    explicit Welcome(Commands& commands, QWidget* parent = nullptr);

private:
    void retranslate();
    void updateEnabled();

    Commands& m_commands;
    QLabel* m_title;
    QLabel* m_adapterText;
    QLabel* m_simulationText;
    QPushButton* m_adapter;
    QPushButton* m_find;
    QPushButton* m_simulation;
    QPushButton* m_arm;
};
} // namespace ui
