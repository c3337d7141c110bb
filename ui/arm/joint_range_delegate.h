// SPDX-License-Identifier: GPL-3.0-or-later
// Paints the range of a joint on the track of one turn, as recorded or as limited, and where it is
// now. The numbers stand beside it. Owned by its table; main thread.
#pragma once

#include <QStyledItemDelegate>

namespace ui {
class JointRangeDelegate final : public QStyledItemDelegate {
    Q_OBJECT

public:
    using QStyledItemDelegate::QStyledItemDelegate;

    void paint(QPainter* painter, const QStyleOptionViewItem& option,
               const QModelIndex& index) const override;
};
} // namespace ui
