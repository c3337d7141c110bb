// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/app/shortcuts_dialog.h"

#include "ui/common/dialog_sizes.h"

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
    rememberSize(*this);
    setWindowTitle(tr("Keyboard shortcuts"));
    auto* list = new QTreeWidget(this);
    list->setObjectName(QStringLiteral("shortcuts"));
    list->setAccessibleName(tr("Keyboard shortcuts"));
    list->setToolTip(tr("Lists all shortcuts"));
    list->setRootIsDecorated(false);
    list->setHeaderLabels({tr("Keys"), tr("Command"), tr("Description")});
    addRow(*list, QStringLiteral("Esc"), tr("All torque off"),
           tr("Immediately turns torque off on the whole bus. In a field of the motion panel, Esc "
              "also shows the present value again. In a menu, a dialog or a table cell being "
              "edited, the first Esc only closes the menu or dialog or cancels the edit. While "
              "servos are moving or jammed, Esc stops them even from a menu or a dialog."));
    addRow(*list, QStringLiteral("Shift+Esc"), tr("All torque off"),
           tr("Immediately turns torque off on the whole bus; works everywhere"));
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
