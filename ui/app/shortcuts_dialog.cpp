// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/app/shortcuts_dialog.h"

#include <QDialogButtonBox>
#include <QHeaderView>
#include <QTreeWidget>
#include <QVBoxLayout>

namespace ui {
namespace {
void addRow(QTreeWidget& list, const QString& keys, const QString& name, const QString& what)
{
    auto* row = new QTreeWidgetItem(&list, {keys, name, what});
    for (int column = 0; column < 3; ++column)
        row->setToolTip(column, what);
}
} // namespace

ShortcutsDialog::ShortcutsDialog(const Commands& commands, QWidget* parent)
    : QDialog(parent)
{
    setAttribute(Qt::WA_DeleteOnClose);
    setObjectName(QStringLiteral("shortcutList"));
    setWindowTitle(tr("Keyboard shortcuts"));
    auto* list = new QTreeWidget(this);
    list->setObjectName(QStringLiteral("shortcuts"));
    list->setAccessibleName(tr("Keyboard shortcuts"));
    list->setToolTip(tr("The list of all shortcuts"));
    list->setRootIsDecorated(false);
    list->setHeaderLabels({tr("Keys"), tr("Command"), tr("What it does")});
    addRow(
        *list, QStringLiteral("Esc"), tr("Torque off — all"),
        tr("Takes torque off the whole bus at once, also from a field of the motion panel, which "
           "then shows the present value again; only in a table cell that is being edited, a "
           "menu or a dialog does the first Esc cancel that instead; while servos move or "
           "are jammed, it stops them from a menu or a dialog as well"));
    addRow(*list, QStringLiteral("Shift+Esc"), tr("Torque off — all"),
           tr("Takes torque off the whole bus at once, whatever is open"));
    for (int i = 0; i < static_cast<int>(Command::Count); ++i) {
        const QAction* action = commands.action(static_cast<Command>(i));
        if (action->shortcut().isEmpty())
            continue;
        addRow(*list, action->shortcut().toString(QKeySequence::NativeText), action->iconText(),
               action->whatsThis());
    }
    list->header()->setStretchLastSection(true);
    for (int column = 0; column < 2; ++column)
        list->resizeColumnToContents(column);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    auto* column = new QVBoxLayout(this);
    column->addWidget(list, 1);
    column->addWidget(buttons);
    resize(720, 520);
}
} // namespace ui
