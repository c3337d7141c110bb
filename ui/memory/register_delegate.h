// SPDX-License-Identifier: GPL-3.0-or-later
// Draws the cells of the memory table in their colors and opens the editor a register needs. Enter
// writes, Esc cancels; a value that cannot be written keeps the editor open, with the reason beside
// it. Leaving the cell in another way writes nothing and reports that. Owned by the page; main
// thread.
#pragma once

#include "ui/editors/register_editor.h"

#include <QPointer>
#include <QStyledItemDelegate>

class QLabel;

namespace ui {
struct MemoryRow;

class RegisterDelegate final : public QStyledItemDelegate {
    Q_OBJECT

public:
    using QStyledItemDelegate::QStyledItemDelegate;

    QWidget* createEditor(QWidget* parent, const QStyleOptionViewItem& option,
                          const QModelIndex& index) const override;
    void setEditorData(QWidget* editor, const QModelIndex& index) const override;
    void setModelData(QWidget* editor, QAbstractItemModel* model,
                      const QModelIndex& index) const override;
    void updateEditorGeometry(QWidget* editor, const QStyleOptionViewItem& option,
                              const QModelIndex& index) const override;
    QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override;

    RegisterEditor* openEditor() const { return m_editor; } ///< null: none

Q_SIGNALS:
    void editorLeft(const QString& reason); ///< the editor was left without Enter

protected:
    void initStyleOption(QStyleOptionViewItem* option, const QModelIndex& index) const override;
    bool eventFilter(QObject* object, QEvent* event) override;

private:
    bool keyPressed(RegisterEditor* editor, int key);
    void finish(RegisterEditor* editor);
    void discard(RegisterEditor* editor);
    void positionMessage(RegisterEditor* editor) const;
    void showMessage(RegisterEditor* editor, const QString& message) const;

    mutable QPointer<RegisterEditor> m_editor;
    mutable QPointer<QLabel> m_message;
};
} // namespace ui
