// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/common/dialog_sizes.h"

#include <QCoreApplication>
#include <QDialog>
#include <QEvent>
#include <QScreen>

namespace ui {
namespace {
constexpr const char* mark = "remembersSize";

QString widthKey(const QObject& dialog)
{
    return QStringLiteral("dialogs/%1_width").arg(dialog.objectName());
}

QString heightKey(const QObject& dialog)
{
    return QStringLiteral("dialogs/%1_height").arg(dialog.objectName());
}
} // namespace

void rememberSize(QDialog& dialog)
{
    dialog.setProperty(mark, true);
}

DialogSizes::DialogSizes(session::Settings& settings, QObject* parent)
    : QObject(parent)
    , m_settings(settings)
{
    QCoreApplication::instance()->installEventFilter(this);
}

bool DialogSizes::eventFilter(QObject* watched, QEvent* event)
{
    const bool shows = event->type() == QEvent::Show;
    if ((!shows && event->type() != QEvent::Hide) || !watched->property(mark).toBool())
        return false;
    auto& dialog = *qobject_cast<QDialog*>(watched);
    if (shows)
        restore(dialog);
    else
        save(dialog);
    return false;
}

/// Never larger than the screen, which may be another one today, nor smaller than its content.
void DialogSizes::restore(QDialog& dialog)
{
    const QSize size(m_settings.pageValue(widthKey(dialog), 0).toInt(),
                     m_settings.pageValue(heightKey(dialog), 0).toInt());
    if (!size.isEmpty())
        dialog.resize(
            size.boundedTo(dialog.screen()->availableSize()).expandedTo(dialog.minimumSizeHint()));
    m_shown.insert(&dialog, dialog.size());
}

void DialogSizes::save(const QDialog& dialog)
{
    if (m_shown.take(&dialog) == dialog.size())
        return; // the user has not chosen it
    m_settings.setPageValue(widthKey(dialog), dialog.width());
    m_settings.setPageValue(heightKey(dialog), dialog.height());
}
} // namespace ui
