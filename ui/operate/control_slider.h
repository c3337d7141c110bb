// SPDX-License-Identifier: GPL-3.0-or-later
// A slider that draws the whole scale, the allowed part of it, and the numbers at its ends; it
// cannot be dragged beyond the limits. Left/Right and Up/Down move it one step (with Shift ten),
// Page Up/Down a twentieth of the scale, Home and End to the limits. The wheel moves it only after
// a click on it, until the pointer or the focus leaves it or it scrolls away, so that scrolling the
// page moves nothing: a notch is ten steps, with Ctrl one, with Shift a twentieth. Owned by its
// parent; main thread.
#pragma once

#include <QWidget>

#include <cstdint>
#include <optional>

namespace ui {
class ControlSlider final : public QWidget {
    Q_OBJECT

public:
    struct Scale {
        std::int64_t low = 0;
        std::int64_t high = 0;
        std::int64_t min = 0;  ///< the allowed part
        std::int64_t max = -1; ///< below `min`: nothing can be set yet
        bool centered = false; ///< the bar begins at 0
        QString minText{};     ///< under the limits
        QString maxText{};
        bool operator==(const Scale&) const = default;
    };

    explicit ControlSlider(QWidget* parent);

    void setScale(const Scale& scale);
    const Scale& scale() const { return m_scale; }
    /// Nullopt: not known; the knob is not drawn. Passed over while it is being dragged.
    void setValue(std::optional<std::int64_t> value);
    std::optional<std::int64_t> value() const { return m_value; }
    bool isDragging() const { return m_dragging; }
    /// Where a value stands, in the slider's own coordinates.
    QPoint pointOf(std::int64_t value) const;

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

Q_SIGNALS:
    void moved(std::int64_t value, bool dragged); ///< by the user
    void released();                              ///< the drag has ended

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void changeEvent(QEvent* event) override;
    void hideEvent(QHideEvent* event) override;
    void leaveEvent(QEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;

private:
    void paintScale(QPainter& painter) const;
    double track(std::int64_t value) const; ///< x of a value
    std::int64_t valueAt(double x) const;
    std::int64_t pageStep() const;
    void setUserValue(std::int64_t value, bool dragged);
    void step(std::int64_t by);
    void endDrag();

    Scale m_scale;
    std::optional<std::int64_t> m_value;
    bool m_dragging = false;
    std::optional<QPoint> m_clickedAt; ///< where it was on the screen; the wheel acts
    int m_wheel = 0;                   ///< parts of a notch
};
} // namespace ui
