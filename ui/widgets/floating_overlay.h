// SPDX-License-Identifier: GPL-3.0-or-later
// Lets a widget float over an area instead of taking space in a layout, so that nothing else moves
// when it appears, grows or goes. It is as high as its text needs. Owned by the floating widget;
// the area becomes the parent of that widget. Main thread.
#pragma once

#include <QObject>

class QWidget;

namespace ui {
class FloatingOverlay final : public QObject {
    Q_OBJECT

public:
    enum class Corner : std::uint8_t { TopLeft, BottomRight };

    FloatingOverlay(QWidget* floating, QWidget* area, Corner corner);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void reposition();

    QWidget& m_floating;
    QWidget& m_area;
    const Corner m_corner;
};
} // namespace ui
