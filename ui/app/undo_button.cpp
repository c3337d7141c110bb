// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/app/undo_button.h"

#include <QAction>

namespace ui {
namespace {
constexpr int maxChars = 26;
}

UndoButton::UndoButton(QAction* undo, QWidget* parent)
    : QToolButton(parent)
{
    setObjectName(QStringLiteral("undoButton"));
    setDefaultAction(undo);
    setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    setFixedWidth(maxChars * fontMetrics().averageCharWidth() + 2 * iconSize().width());
    connect(undo, &QAction::changed, this, &UndoButton::showName);
    showName();
}

void UndoButton::showName()
{
    const QString name = defaultAction()->iconText();
    setAccessibleName(name);
    setText(fontMetrics().elidedText(name, Qt::ElideRight,
                                     maxChars * fontMetrics().averageCharWidth()));
}
} // namespace ui
