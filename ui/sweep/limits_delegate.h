// SPDX-License-Identifier: GPL-3.0-or-later
// Editors of the limits table: a list of figures, a list of directions, a line for numbers. Owned
// by the dialog; main thread.
#pragma once

#include "ui/widgets/tone_delegate.h"

namespace ui {
class LimitsDelegate final : public ToneDelegate {
    Q_OBJECT

public:
    using ToneDelegate::ToneDelegate;

    QWidget* createEditor(QWidget* parent, const QStyleOptionViewItem& option,
                          const QModelIndex& index) const override;
    void setEditorData(QWidget* editor, const QModelIndex& index) const override;
    void setModelData(QWidget* editor, QAbstractItemModel* model,
                      const QModelIndex& index) const override;
};
} // namespace ui
