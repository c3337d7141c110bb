// SPDX-License-Identifier: GPL-3.0-or-later
// Reads and operates dialogs as a user does. Main thread.
#pragma once

#include <QLabel>
#include <QPushButton>
#include <QtTest>

namespace gui {
inline QPushButton* button(QWidget* dialog, const char* name)
{
    return dialog->findChild<QPushButton*>(QLatin1String(name));
}

inline void click(QWidget* dialog, const char* name)
{
    QTest::mouseClick(button(dialog, name), Qt::LeftButton);
}

inline QString textOf(QWidget* dialog, const char* name)
{
    const auto* label = dialog->findChild<QLabel*>(QLatin1String(name));
    return label != nullptr && label->isVisibleTo(dialog) ? label->text() : QString();
}

/// All its labels, a line each.
inline QString labelsOf(const QWidget* dialog)
{
    QString all;
    for (const QLabel* label : dialog->findChildren<QLabel*>())
        all += label->text() + QLatin1Char('\n');
    return all;
}
} // namespace gui
