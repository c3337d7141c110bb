// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/app/plain_text_filter.h"

#include <QApplication>
#include <QEvent>
#include <QLabel>

namespace ui {
void PlainTextFilter::install()
{
    if (qApp->findChild<PlainTextFilter*>(QString(), Qt::FindDirectChildrenOnly) == nullptr)
        qApp->installEventFilter(new PlainTextFilter(qApp));
}

/// Before a widget is first shown it is polished; tooltips are labels too.
bool PlainTextFilter::eventFilter(QObject* watched, QEvent* event)
{
    if (event->type() == QEvent::Polish) {
        auto* label = qobject_cast<QLabel*>(watched);
        if (label != nullptr && label->textFormat() == Qt::AutoText)
            label->setTextFormat(Qt::PlainText);
    }
    return QObject::eventFilter(watched, event);
}
} // namespace ui
