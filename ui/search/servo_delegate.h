// SPDX-License-Identifier: GPL-3.0-or-later
// Draws one servo of the list in two lines: ID, model and state, below them the details and when it
// was last seen; a further line for each remark. What does not fit is in the row's tooltip.
// Main thread.
#pragma once

#include <QStyledItemDelegate>

namespace ui {
struct ServoRow;

class ServoDelegate final : public QStyledItemDelegate {
    Q_OBJECT

public:
    using QStyledItemDelegate::QStyledItemDelegate;

    /// Everything gray: the port is not open.
    void setDimmed(bool dimmed) { m_dimmed = dimmed; }

    void paint(QPainter* painter, const QStyleOptionViewItem& option,
               const QModelIndex& index) const override;
    QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override;

private:
    void paintRow(QPainter& painter, const QStyleOptionViewItem& option, const ServoRow& row) const;

    bool m_dimmed = false;
};
} // namespace ui
