// SPDX-License-Identifier: GPL-3.0-or-later
// Which curves the trend chart shows: ready-made ones of the selected servo, and any register of
// any servo, with colour, scale and offset. Beside the window, not before it: what is ticked is
// shown at once. Deletes itself. Main thread.
#pragma once

#include "ui/pages/trend_choice.h"

#include <QDialog>

class QDoubleSpinBox;
class QLineEdit;
class QPushButton;
class QTreeWidget;
class QTreeWidgetItem;

namespace ui {
class ChannelsDialog final : public QDialog {
    Q_OBJECT

public:
    ChannelsDialog(const session::Desk& desk, std::vector<TrendChoice> choices, QWidget* parent);

    void setChoices(std::vector<TrendChoice> choices);

Q_SIGNALS:
    void chosen(const std::vector<ui::TrendChoice>& choices);

protected:
    void changeEvent(QEvent* event) override;

private:
    void build();
    void fill();
    void addReadyMade();
    void addServo(const session::ServoEntry& entry);
    QTreeWidgetItem* addRow(QTreeWidgetItem* parent, const QString& id, const QString& name,
                            const QString& unit);
    void filter(const QString& text);
    void tick(QTreeWidgetItem* item);
    void showLook();
    void applyLook();
    void pickColour();
    TrendChoice* current();
    TrendChoice* choice(const QString& id);
    void retranslate();

    const session::Desk& m_desk;
    std::vector<TrendChoice> m_choices;
    QLineEdit* m_find = nullptr;
    QTreeWidget* m_tree = nullptr;
    QPushButton* m_colour = nullptr;
    QDoubleSpinBox* m_scale = nullptr;
    QDoubleSpinBox* m_offset = nullptr;
    QPushButton* m_usual = nullptr;
    QPushButton* m_close = nullptr;
    bool m_filling = false;
};
} // namespace ui
