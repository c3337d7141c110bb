// SPDX-License-Identifier: GPL-3.0-or-later
// A chip at the edge of a trend chart for each axis that the user has set and whose curves leave
// it: "mA off scale ↑ · Fit". Owned by the scene; main thread.
#pragma once

#include "ui/charts/trend_colors.h"

#include <QFont>
#include <QGraphicsItem>

#include <optional>
#include <vector>

namespace ui {
struct OffScale {
    QString unit;
    QRectF area; ///< of the axis
    bool above = false;
    bool below = false;
    bool operator==(const OffScale&) const = default;
};

class OffScaleChips final : public QGraphicsItem {
public:
    explicit OffScaleChips(QGraphicsItem* parent);

    void setColors(const TrendColors& colors);
    void setFont(const QFont& font);
    void setOffScale(std::vector<OffScale> axes);
    /// The unit whose chip is under this place.
    std::optional<QString> unitAt(const QPointF& position) const;

    QRectF boundingRect() const override;
    void paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget* widget) override;

private:
    struct Chip {
        QString text;
        QString unit;
        QRectF place;
    };
    std::vector<Chip> chips() const;

    std::vector<OffScale> m_axes;
    TrendColors m_colors;
    QFont m_font;
};
} // namespace ui
