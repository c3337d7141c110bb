// SPDX-License-Identifier: GPL-3.0-or-later
// The latest message, at the bottom of the window: sign, sentence (elided, whole in the tooltip),
// and the way back. Owned by the window; main thread.
#pragma once

#include "session/desk.h"
#include "ui/app/commands.h"
#include "ui/app/event_words.h"

#include <QWidget>

class QLabel;
class QToolButton;

namespace ui {
class MessageLine final : public QWidget {
    Q_OBJECT

public:
    MessageLine(const session::Desk& desk, const Commands& commands, QWidget* parent = nullptr);

    void show(const session::Event& event);

protected:
    void changeEvent(QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    void fill();
    void elide();
    void updateUndo();

    const session::Desk& m_desk;
    const Commands& m_commands;
    std::optional<session::Event> m_event; ///< kept, so that it can be worded in another language
    EventWords m_words;
    QLabel* m_sign;
    QLabel* m_text;
    QToolButton* m_undo;
};
} // namespace ui
