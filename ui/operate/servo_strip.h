// SPDX-License-Identifier: GPL-3.0-or-later
// All servos of the bus side by side as small cards. Pressing one selects it; with Ctrl it moves
// together with the others. Hidden while there are fewer than two. Owned by the page; main thread.
#pragma once

#include "session/link/link_controller.h"
#include "session/servos/servo_registry.h"
#include "ui/common/selection.h"

#include <QScrollArea>

class QHBoxLayout;

namespace ui {
class ServoCard;

class ServoStrip final : public QScrollArea {
    Q_OBJECT

public:
    ServoStrip(const session::ServoRegistry& registry, const session::LinkController& link,
               Selection& selection, QWidget* parent = nullptr);

    void refresh(); ///< new numbers

private:
    void rebuild();
    void selectServo(session::ServoRef ref);

    const session::ServoRegistry& m_registry;
    const session::LinkController& m_link;
    Selection& m_selection;
    QWidget* m_body = nullptr;
    QHBoxLayout* m_row = nullptr;
    std::vector<std::pair<session::ServoRef, ServoCard*>> m_cards;
};
} // namespace ui
