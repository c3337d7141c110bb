// SPDX-License-Identifier: GPL-3.0-or-later
// A bit field as named checkboxes with their sum. Bits without a name are shown while they are set,
// and kept; the sum can be typed as well, and sets the checkboxes. Owned by its parent; main
// thread.
#pragma once

#include "ui/editors/register_editor.h"

class QCheckBox;
class QGridLayout;
class QLabel;
class QLineEdit;

namespace ui {
class BitsEditor final : public RegisterEditor {
    Q_OBJECT

public:
    BitsEditor(const EditContext& context, QWidget* parent);

    void setRaw(std::optional<std::int64_t> raw) override;
    QString inputText() const override;
    QList<QWidget*> is() const override;
    void selectAll() override;

private:
    struct Box {
        int bit = 0;
        QCheckBox* box = nullptr;
        bool listed = true; ///< named, or set since setRaw()
    };
    void build();
    QCheckBox* makeBox(int bit);
    bool isNamed(int bit) const;
    QString bitLabel(int bit) const;
    void onBoxClicked();
    void onSumEdited();
    void showBitValues(std::int64_t raw, bool fresh);
    void showSum(std::int64_t raw);
    void arrange();
    void retranslate();
    void paintEvent(QPaintEvent* event) override;

    QGridLayout* m_grid;
    QLabel* m_label;
    QLineEdit* m_sum;
    QLabel* m_hex;
    std::vector<Box> m_boxes; ///< all bits, by number
};
} // namespace ui
