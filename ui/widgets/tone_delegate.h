// SPDX-License-Identifier: GPL-3.0-or-later
// Paints the cells of a table in the tone that their model names by ui::toneRole, in the current
// palette of the view; the model's text comes with the color. Owned by its parent; main thread.
#pragma once

#include <QStyledItemDelegate>

namespace ui {
class ToneDelegate : public QStyledItemDelegate {
    Q_OBJECT

public:
    using QStyledItemDelegate::QStyledItemDelegate;

protected:
    void initStyleOption(QStyleOptionViewItem* option, const QModelIndex& index) const override;
};
} // namespace ui
