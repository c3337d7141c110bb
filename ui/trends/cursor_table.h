// SPDX-License-Identifier: GPL-3.0-or-later
// What is read between the cursors of a chart, one line a channel: at A, at B, their difference,
// slope, mean, min, max, sigma, count. Copied as tab-separated text. Follows its chart, which must
// outlive it. Main thread.
#pragma once

#include "ui/charts/trend_chart.h"

class QAction;
class QLabel;
class QTableWidget;

namespace ui {
class CursorTable final : public QWidget {
    Q_OBJECT

public:
    explicit CursorTable(TrendChart* chart, QWidget* parent = nullptr);

    /// With a line of headings, and the times of the cursors above.
    QString text() const;

public Q_SLOTS:
    void copy() const;

protected:
    void changeEvent(QEvent* event) override;

private:
    void retranslate();
    void refresh();
    void fitHeight();
    void fillRow(int row, const TrendChannel& channel, const CursorReading& reading);

    TrendChart* m_chart;
    QLabel* m_times;
    QTableWidget* m_table;
    QAction* m_copy;
};
} // namespace ui
