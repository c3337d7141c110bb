// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/common/widget_text.h"

#include <QAbstractButton>
#include <QFormLayout>
#include <QLabel>

namespace ui {
void setAccessText(QWidget* control, const QString& name, const QString& toolTip)
{
    control->setAccessibleName(name);
    control->setToolTip(toolTip);
}

void setButtonText(QAbstractButton* button, const QString& text, const QString& toolTip)
{
    button->setText(text);
    setAccessText(button, text, toolTip);
}

void setFieldText(const QFormLayout* form, QWidget* field, const QString& label,
                  const QString& toolTip)
{
    static_cast<QLabel*>(form->labelForField(field))->setText(label);
    setAccessText(field, label, toolTip);
}
} // namespace ui
