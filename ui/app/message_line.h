// SPDX-License-Identifier: GPL-3.0-or-later
// The latest message, at the bottom of the window: sign and sentence (elided, whole in the
// tooltip). Owned by the window; main thread.
#pragma once

#include "ui/app/event_text.h"

#include <QWidget>

class QLabel;

namespace ui {
class MessageLine final : public QWidget {
    Q_OBJECT

public:
    explicit MessageLine(const session::ServoRegistry& registry, QWidget* parent = nullptr);

    void show(const session::Event& event);

protected:
    void changeEvent(QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    void fill();
    void elide();

    const session::ServoRegistry& m_registry;
    std::optional<session::Event> m_event; ///< kept, so that it can be worded in another language
    EventText m_eventText;
    QLabel* m_symbol;
    QLabel* m_text;
};
} // namespace ui
