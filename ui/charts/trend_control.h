// SPDX-License-Identifier: GPL-3.0-or-later
// Keeps the view of a chart and changes it on request (box, wheel, keys, buttons); keeps the
// previous views. Draws nothing. Owned by the chart; main thread.
#pragma once

#include "ui/charts/trend_scene.h"

#include <QElapsedTimer>

namespace ui {
class TrendControl final : public QObject {
    Q_OBJECT

public:
    explicit TrendControl(QObject* parent);

    TrendState& state() { return m_state; }
    const TrendState& state() const { return m_state; }
    void setAxes(TrendAxes* axes) { m_axes = axes; }

    void follow(bool on);
    void setWidth(base::Duration width);
    void show(const recording::TimeSpan& span);
    void zoomToFit();
    void fitValues(const QString& unit); ///< its axis follows its curves again
    void goBack();
    void clearViewHistory() { m_previousViews.clear(); }

    void pushView() { remember(Kind::Single); }
    void drag(const recording::TimeSpan& span); ///< show() without a way back of its own
    void zoomToBox(const QRectF& shares);
    /// `y`: of the axes that do not range by themselves.
    void pan(double x, double y);
    void panValues(const QString* unit, double y); ///< null: all; they keep their range then
    void zoom(double factor, double place);
    void zoomValues(const QString* unit, double factor, double place);
    void showEnd(bool newest);

    void showCursors(bool on);
    void setCursors(base::Duration a, base::Duration b);
    void moveCursor(Cursor which, base::Duration to);
    void stepCursor(int samples); ///< the one that was moved last; by those of any visible channel

Q_SIGNALS:
    void viewChanged();
    void cursorsChanged();

private:
    enum class Kind : std::uint8_t { Single, Wheel, Values };
    struct View {
        bool following = true;
        recording::TimeSpan span{};
        std::vector<std::pair<QString, AxisRange>> fixed{};
    };

    void remember(Kind kind);
    void zoomValuesTo(double low, double high);
    std::optional<base::Duration> neighborOf(base::Duration at, bool next) const;
    void moveAxis(TrendAxes::ValueAxis& axis, double y);
    template <typename Change>
    void changeAxes(const QString* unit, Change change);

    TrendState m_state;
    TrendAxes* m_axes = nullptr;
    std::vector<View> m_previousViews;
    Kind m_lastKind = Kind::Single;
    Cursor m_movedCursor = Cursor::A;
    QElapsedTimer m_sinceZoom;
};
} // namespace ui
