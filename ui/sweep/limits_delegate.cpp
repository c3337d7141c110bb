// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/sweep/limits_delegate.h"

#include "ui/sweep/limits_model.h"
#include "ui/widgets/test_text.h"

#include <QComboBox>

namespace ui {
QWidget* LimitsDelegate::createEditor(QWidget* parent, const QStyleOptionViewItem& option,
                                      const QModelIndex& index) const
{
    const auto column = static_cast<LimitColumn>(index.column());
    QWidget* editor = nullptr;
    if (column == LimitColumn::Metric || column == LimitColumn::Direction) {
        auto* box = new QComboBox(parent);
        if (column == LimitColumn::Direction) {
            for (const bool atLeast : {false, true})
                box->addItem(limitDirection(atLeast), atLeast);
        } else {
            for (const results::SweepMetricKind& kind : results::sweepMetricKinds())
                box->addItem(metricName(kind.key), kind.key);
        }
        editor = box;
    } else {
        editor = ToneDelegate::createEditor(parent, option, index);
    }
    if (editor == nullptr)
        return nullptr;
    editor->setObjectName(QStringLiteral("limitEditor"));
    const QString heading = index.model()->headerData(index.column(), Qt::Horizontal).toString();
    editor->setAccessibleName(heading);
    editor->setToolTip(heading);
    return editor;
}

void LimitsDelegate::setEditorData(QWidget* editor, const QModelIndex& index) const
{
    if (auto* box = qobject_cast<QComboBox*>(editor))
        box->setCurrentIndex(box->findData(index.data(Qt::EditRole)));
    else
        ToneDelegate::setEditorData(editor, index);
}

void LimitsDelegate::setModelData(QWidget* editor, QAbstractItemModel* model,
                                  const QModelIndex& index) const
{
    if (const auto* box = qobject_cast<QComboBox*>(editor))
        model->setData(index, box->currentData());
    else
        ToneDelegate::setModelData(editor, model, index);
}
} // namespace ui
