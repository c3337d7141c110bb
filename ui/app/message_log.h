// SPDX-License-Identifier: GPL-3.0-or-later
// Everything that was reported since the start, newest last, with cause and remedy, as text that
// can be copied. The latest 1000 messages are kept. Owned by the window; main thread.
#pragma once

#include "session/event.h"
#include "session/servos/servo_registry.h"

#include <QPlainTextEdit>

#include <deque>

namespace ui {
class MessageLog final : public QPlainTextEdit {
    Q_OBJECT

public:
    explicit MessageLog(const session::ServoRegistry& registry, QWidget* parent = nullptr);

    void add(const session::Event& event);
    QSize sizeHint() const override;

private:
    void write(const session::Event& event);
    void retranslate();

    const session::ServoRegistry& m_registry;
    std::deque<session::Event> m_events;
};
} // namespace ui
