// SPDX-License-Identifier: GPL-3.0-or-later
// The position of the servo and its goal: needle, goal knob, the allowed sector, turns. Dragging,
// the wheel (while it has the focus) and the keys request a goal by goalRequested(); the dial
// itself sets nothing. Raw values in steps of the position register; clockwise is positive. Owned
// by its parent; main thread.
#pragma once

#include <QWidget>

#include <cstdint>
#include <optional>

namespace ui {
struct DialState {
    double stepsPerTurn = 4096; ///< of the mechanical turn (resolution factor included)
    double rangeDegrees = 360;  ///< what stepsPerTurn covers: SCS 220, LX 240
    std::optional<double> position{};
    std::optional<double> goal{};
    std::optional<std::int64_t> minGoal{}; ///< none: no limits, the goal turns on
    std::optional<std::int64_t> maxGoal{};
    bool isGoalMovable = false;
    bool isStale = false; ///< the servo does not answer
    QString value{};      ///< "187.4°", or why there is none
    QString subtitle{};   ///< "2132 → 2400"
    QString turnsText{};  ///< "+3 turns since connecting"; empty: none
    bool operator==(const DialState&) const = default;
};

class PositionDial final : public QWidget {
    Q_OBJECT

public:
    explicit PositionDial(QWidget* parent = nullptr);

    void show(const DialState& view);
    const DialState& view() const { return m_view; }

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

Q_SIGNALS:
    void goalRequested(std::int64_t raw);

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    double angleOf(double raw) const; ///< degrees clockwise from the top
    QPointF pointAt(double raw, double radius) const;
    QRectF face() const;
    void requestGoal(double raw);
    void nudgeTo(double raw);
    void dragTo(const QPointF& place);
    void paintFace(QPainter& painter) const;
    void paintTicks(QPainter& painter) const;
    void paintNeedle(QPainter& painter) const;
    void paintTexts(QPainter& painter) const;

    DialState m_view;
    std::optional<double> m_drag; ///< the goal while it is being dragged
    double m_wheel = 0;           ///< steps of a fine wheel that make no whole one yet
};
} // namespace ui
