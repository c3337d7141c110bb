// SPDX-License-Identifier: GPL-3.0-or-later
// Paints the cells of a table in the tone their model names by ui::toneRole, in the view's palette
// of the moment; the model's words stand beside the color. Owned by its parent; main thread.
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
