// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/tone_delegate.h"

#include "ui/models/sweep_cells.h"

namespace ui {
void ToneDelegate::initStyleOption(QStyleOptionViewItem* option, const QModelIndex& index) const
{
    QStyledItemDelegate::initStyleOption(option, index);
    const QVariant wanted = index.data(toneRole);
    if (wanted.isValid())
        option->palette.setColor(QPalette::Text,
                                 tone(static_cast<Tone>(wanted.toInt()), option->palette));
}
} // namespace ui
