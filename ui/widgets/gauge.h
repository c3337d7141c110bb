// SPDX-License-Identifier: GPL-3.0-or-later
// A half-round gauge: title, value, unit, and the servo's own limits. Color comes with a sign: "!"
// near a limit, "✗" beyond it. Values are physical. Owned by its parent; main thread.
#pragma once

#include <QWidget>

#include <optional>

namespace ui {
/// What the arc stands for. Equal specs repaint nothing.
struct GaugeScale {
    double min = 0;
    double max = 1;               ///< min = −max: zero stands at the top
    std::optional<double> low{};  ///< below: out of the servo's limits
    std::optional<double> high{}; ///< above (with min = −max: in both directions)
    int decimals = 0;
    QString unit{};
    bool operator==(const GaugeScale&) const = default;
};

class Gauge final : public QWidget {
    Q_OBJECT

public:
    explicit Gauge(QWidget* parent = nullptr);

    void setTitle(const QString& title);
    void setScale(const GaugeScale& scale);
    /// `foot`: the line below, the limits in words. `old`: grayed, nothing new has come.
    void setValue(std::optional<double> value, const QString& footer, bool stale);

    enum class LimitState : std::uint8_t { Unknown, Ok, Near, Exceeded };
    LimitState limitState() const;
    QString valueText() const; ///< "7.4", "—"

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    double angleOf(double value) const; ///< degrees, 180 at the left, 0 at the right
    void paintArcs(QPainter& painter, const QRectF& box) const;
    void paintTexts(QPainter& painter) const;
    void describe();

    QString m_title;
    GaugeScale m_scale;
    std::optional<double> m_value;
    QString m_footer;
    bool m_stale = false;
};
} // namespace ui
