// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/tone_delegate.h"

#include "ui/widgets/test_text.h"

namespace ui {
void ToneDelegate::initStyleOption(QStyleOptionViewItem* option, const QModelIndex& index) const
{
    QStyledItemDelegate::initStyleOption(option, index);
    const QVariant toneValue = index.data(toneRole);
    if (toneValue.isValid()) {
        const QColor color = tone(static_cast<Tone>(toneValue.toInt()), option->palette);
        for (const auto role : {QPalette::Text, QPalette::HighlightedText}) // the selection is pale
            option->palette.setColor(role, color);
    }
}
} // namespace ui
