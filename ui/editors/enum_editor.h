// SPDX-License-Identifier: GPL-3.0-or-later
// The documented values of a register as a list, each with its number. A value that was read but
// has no name is in the list too. Owned by its parent; main thread.
#pragma once

#include "ui/editors/register_editor.h"

namespace ui {
class ValueComboBox;

class EnumEditor final : public RegisterEditor {
    Q_OBJECT

public:
    EnumEditor(const EditContext& context, QWidget* parent);

    void setRaw(std::optional<std::int64_t> raw) override;
    QString inputText() const override;
    QList<QWidget*> is() const override;

private:
    void fill(std::optional<std::int64_t> raw);
    void retranslate();

    ValueComboBox* m_box;
};
} // namespace ui
