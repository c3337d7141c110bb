// SPDX-License-Identifier: GPL-3.0-or-later
// What is drawn over the curves: marks with a sign and a text, the cursors A and B, the zoom box,
// the focus frame. Owned by the QChart; main thread.
#pragma once

#include "ui/charts/time_view.h"
#include "ui/charts/trend_channel.h"
#include "ui/charts/trend_colors.h"

#include <QFont>
#include <QGraphicsItem>
#include <QPixmap>

#include <map>

namespace ui {
enum class Cursor : std::uint8_t { A, B };

/// Marks that are too close to be distinguished.
struct MarkGroup {
    double x = 0;          ///< of the first, from the left of the plot
    std::size_t first = 0; ///< index
    std::size_t count = 1;
    recording::MarkKind highestSeverity = recording::MarkKind::Note;
};

class TrendOverlay final : public QGraphicsItem {
public:
    explicit TrendOverlay(QGraphicsItem* parent);

    void setPlot(const QRectF& plot);
    void setColors(const TrendColors& colors);
    void setFont(const QFont& font);
    void setView(const TimeView& view);
    void setMarks(const std::vector<recording::Mark>* marks,
                  const MarkTextFunction& words); ///< borrowed
    void setCursors(const std::optional<std::pair<base::Duration, base::Duration>>& cursors);
    void setActive(std::optional<Cursor> cursor); ///< held by the mouse, or under it
    void setBox(const QRectF& box);               ///< empty: none
    void setFocused(bool on);
    void setNotice(const QString& text); ///< in the middle of an empty plot

    double flagSize() const { return m_flagSize; }
    std::optional<Cursor> cursorAt(const QPointF& place) const;
    /// Empty: no mark there.
    QString marksAt(const QPointF& place) const;

    QRectF boundingRect() const override;
    void paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget* widget) override;

private:
    std::vector<MarkGroup> groups() const;
    QString markText(std::size_t mark) const;
    void paintMarks(QPainter* painter) const;
    double paintMark(QPainter* painter, const MarkGroup& group, double room, double roomLeft) const;
    const QPixmap& flagOf(recording::MarkKind kind, const QPainter& painter) const;
    void paintFlag(QPainter* painter, const QRectF& place, recording::MarkKind kind) const;
    void paintCursor(QPainter* painter, Cursor which, base::Duration at) const;
    double flagLeft(double x) const;
    QColor colorOf(recording::MarkKind kind) const;

    QRectF m_plot;
    TrendColors m_colors;
    QFont m_font;
    double m_flagSize = 16;
    TimeView m_view;
    const std::vector<recording::Mark>* m_marks = nullptr;
    MarkTextFunction m_text;
    std::optional<std::pair<base::Duration, base::Duration>> m_cursors;
    std::optional<Cursor> m_active;
    QRectF m_box;
    QString m_notice;
    bool m_focused = false;
    mutable std::map<recording::MarkKind, QPixmap> m_flags; ///< painted when first needed
};
} // namespace ui
