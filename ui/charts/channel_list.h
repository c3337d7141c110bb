// SPDX-License-Identifier: GPL-3.0-or-later
// The channels of a chart as a list that keys reach: shown or not, scale and offset. Follows its
// chart and changes it; the chart must outlive it. Main thread.
#pragma once

#include "ui/charts/trend_chart.h"

class QTreeWidget;
class QTreeWidgetItem;

namespace ui {
class ChannelList final : public QWidget {
    Q_OBJECT

public:
    explicit ChannelList(TrendChart* chart, QWidget* parent = nullptr);

protected:
    void changeEvent(QEvent* event) override;

private:
    void retranslate();
    void refresh();
    void edited(QTreeWidgetItem* item, int column);

    TrendChart* m_chart;
    QTreeWidget* m_tree;
    bool m_filling = false;
};
} // namespace ui
