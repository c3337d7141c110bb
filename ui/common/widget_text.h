// SPDX-License-Identifier: GPL-3.0-or-later
// Sets the texts of a control together: what it shows, its name for screen readers, its tooltip.
// Free functions; main thread.
#pragma once

#include <QString>

class QAbstractButton;
class QFormLayout;
class QWidget;

namespace ui {
/// For a control without a text of its own.
void setAccessText(QWidget* control, const QString& name, const QString& toolTip);
/// The text is the name, too.
void setButtonText(QAbstractButton* button, const QString& text, const QString& toolTip);
/// The label of the field in this form is its name, too.
void setFieldText(const QFormLayout* form, QWidget* field, const QString& label,
                  const QString& toolTip);
} // namespace ui
