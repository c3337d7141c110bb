// SPDX-License-Identifier: GPL-3.0-or-later
// The curves of the trend chart: predefined ones of the selected servo, and any register of any
// servo, with color, scale and offset. Not modal: changes are shown at once. Deletes itself. Main
// thread.
#pragma once

#include "ui/trends/trend_curves.h"

#include <QDialog>

class QDoubleSpinBox;
class QFormLayout;
class QLineEdit;
class QPushButton;
class QTreeWidget;
class QTreeWidgetItem;

namespace ui {
class ChannelsDialog final : public QDialog {
    Q_OBJECT

public:
    ChannelsDialog(const session::ServoRegistry& registry, std::vector<TrendCurve> curves,
                   QWidget* parent);

    void setCurves(std::vector<TrendCurve> curves);

Q_SIGNALS:
    void curvesChanged(const std::vector<ui::TrendCurve>& curves);

private:
    void build();
    QFormLayout* buildStyle();
    void fill();
    void addBuiltIn();
    void addServo(const session::ServoEntry& entry);
    QTreeWidgetItem* addRow(QTreeWidgetItem* parent, const QString& id, const QString& name,
                            const QString& unit);
    void filter(const QString& text);
    void onItemChanged(QTreeWidgetItem* item);
    void showStyle();
    void applyStyle();
    void pickColor();
    TrendCurve* current();
    TrendCurve* curve(const QString& id);
    void retranslate();

    const session::ServoRegistry& m_registry;
    std::vector<TrendCurve> m_curves;
    QLineEdit* m_find = nullptr;
    QTreeWidget* m_tree = nullptr;
    QPushButton* m_color = nullptr;
    QDoubleSpinBox* m_scale = nullptr;
    QDoubleSpinBox* m_offset = nullptr;
    QPushButton* m_reset = nullptr;
    QPushButton* m_close = nullptr;
    bool m_filling = false;
};
} // namespace ui
