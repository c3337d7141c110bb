// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/popup_frame.h"

#include <QScreen>

namespace ui {
PopupFrame::PopupFrame(const char* name, QWidget* parent)
    : QFrame(parent, Qt::Popup)
{
    setObjectName(QLatin1String(name));
    setFrameShape(QFrame::StyledPanel);
}

void PopupFrame::popUpBelow(const QWidget& button)
{
    adjustSize();
    QPoint position = button.mapToGlobal(QPoint(0, button.height()));
    const QRect screen = button.screen()->availableGeometry();
    position.setX(
        qBound(screen.left(), position.x(), qMax(screen.left(), screen.right() - width())));
    position.setY(
        qBound(screen.top(), position.y(), qMax(screen.top(), screen.bottom() - height())));
    move(position);
    QFrame::show();
    setFocus();
}
} // namespace ui
