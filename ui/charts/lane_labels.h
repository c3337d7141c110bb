// SPDX-License-Identifier: GPL-3.0-or-later
// What is written right of the lanes of a trend chart: name and value of each channel, and only the
// values where a lane is too low for both. Owned by the scene; main thread.
#pragma once

#include "ui/charts/trend_colors.h"

#include <QFont>
#include <QGraphicsItem>

#include <vector>

namespace ui {
struct LaneLabel {
    QString name;
    QString value; ///< with its unit
    QColor color;
    QRectF lane;
    bool operator==(const LaneLabel&) const = default;
};

class LaneLabels final : public QGraphicsItem {
public:
    explicit LaneLabels(QGraphicsItem* parent);

    void setColors(const TrendColors& colors);
    void setFont(const QFont& font);
    void setLabels(std::vector<LaneLabel> labels); ///< those of one lane in a row
    /// What they need beside the lanes; it does not change with each digit.
    double width() const { return m_width; }

    QRectF boundingRect() const override;
    void paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget* widget) override;

private:
    void measure();
    void paintLane(QPainter* painter, std::size_t first, std::size_t end) const;

    std::vector<LaneLabel> m_labels;
    TrendColors m_colors;
    QFont m_font;
    double m_width = 0;
};
} // namespace ui
