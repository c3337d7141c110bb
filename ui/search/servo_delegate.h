// SPDX-License-Identifier: GPL-3.0-or-later
// Draws one servo of the list in two lines: ID, model and state, below them the details and when it
// was last seen; a further line for each remark. What finds no room is in the row's tooltip. Main
// thread.
#pragma once

#include <QStyledItemDelegate>

namespace ui {
class ServoDelegate final : public QStyledItemDelegate {
    Q_OBJECT

public:
    using QStyledItemDelegate::QStyledItemDelegate;

    /// Everything gray: the port is not open.
    void setDimmed(bool asleep) { m_dimmed = asleep; }

    void paint(QPainter* painter, const QStyleOptionViewItem& option,
               const QModelIndex& index) const override;
    QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override;

private:
    bool m_dimmed = false;
};
} // namespace ui
