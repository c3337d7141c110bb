// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/gauge.h"

#include "ui/common/theme.h"

#include <QFontMetricsF>
#include <QPainter>

#include <algorithm>
#include <cmath>

namespace ui {
namespace {
/// Within this share of the scale a value counts as near a limit.
constexpr double nearFraction = 0.06;
constexpr int sixteenths = 16; ///< QPainter counts angles in these
constexpr double half = 180;
constexpr double smallestFont = 0.72; ///< of the usual one

Tone toneOf(Gauge::LimitState standing)
{
    switch (standing) {
    case Gauge::LimitState::Exceeded:
        return Tone::Bad;
    case Gauge::LimitState::Near:
        return Tone::Warn;
    case Gauge::LimitState::Unknown:
        return Tone::Quiet;
    case Gauge::LimitState::Ok:
        break;
    }
    return Tone::Accent;
}

void drawArc(QPainter& painter, const QRectF& box, double from, double to)
{
    painter.drawArc(box, qRound(from * sixteenths), qRound((to - from) * sixteenths));
}

/// In a smaller font where the text is too wide; cut only if that does not help.
void paintFitted(QPainter& painter, const QRect& room, const QString& text)
{
    const QFont usual = painter.font();
    QFont font = usual;
    // Step by step: hinted letters do not shrink evenly.
    for (double share = 1; share > smallestFont; share -= 0.04) {
        font.setPointSizeF(usual.pointSizeF() * share);
        if (QFontMetricsF(font).horizontalAdvance(text) <= room.width())
            break;
    }
    painter.setFont(font);
    painter.drawText(room, Qt::AlignCenter,
                     QFontMetricsF(font).elidedText(text, Qt::ElideRight, room.width()));
    painter.setFont(usual);
}
} // namespace

Gauge::Gauge(QWidget* parent)
    : QWidget(parent)
{
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
}

void Gauge::setTitle(const QString& title)
{
    if (title == m_title)
        return;
    m_title = title;
    describe();
    update();
}

void Gauge::setScale(const GaugeScale& scale)
{
    if (scale == m_scale)
        return;
    m_scale = scale;
    update();
}

void Gauge::setValue(std::optional<double> value, const QString& footer, bool stale)
{
    if (value && !std::isfinite(*value))
        value.reset();
    if (value == m_value && footer == m_footer && stale == m_stale)
        return;
    m_value = value;
    m_footer = footer;
    m_stale = stale;
    describe();
    update();
}

void Gauge::describe()
{
    setAccessibleName(m_title);
    const QString words = QStringList{valueText(), m_scale.unit, m_footer}.join(QLatin1Char(' '));
    setAccessibleDescription(words);
    setToolTip(m_title + QLatin1Char('\n') + words);
}

Gauge::LimitState Gauge::limitState() const
{
    if (!m_value)
        return LimitState::Unknown;
    const double span = std::max(m_scale.max - m_scale.min, 1e-9);
    const double value = m_scale.min < 0 ? std::abs(*m_value) : *m_value;
    const double above = m_scale.high ? value - *m_scale.high : -span;
    const double below = m_scale.low ? *m_scale.low - value : -span;
    const double worst = std::max(above, below);
    if (worst > 0)
        return LimitState::Exceeded;
    return worst > -nearFraction * span ? LimitState::Near : LimitState::Ok;
}

QString Gauge::valueText() const
{
    return m_value ? locale().toString(*m_value, 'f', m_scale.decimals) : QStringLiteral("—");
}

QSize Gauge::sizeHint() const
{
    return {fontMetrics().averageCharWidth() * 20, fontMetrics().height() * 7};
}

QSize Gauge::minimumSizeHint() const
{
    return {fontMetrics().averageCharWidth() * 13, fontMetrics().height() * 7};
}

double Gauge::angleOf(double value) const
{
    const double span = std::max(m_scale.max - m_scale.min, 1e-9);
    return half - std::clamp((value - m_scale.min) / span, 0.0, 1.0) * half;
}

void Gauge::paintArcs(QPainter& painter, const QRectF& box) const
{
    const double thick = std::clamp(box.width() / 11, 5.0, 14.0);
    const QColor track = palette().color(QPalette::Mid);
    painter.setBrush(Qt::NoBrush);
    const auto pen = [&](const QColor& color, double width) {
        painter.setPen(QPen(color, width, Qt::SolidLine, Qt::FlatCap));
    };
    const QRectF inner = box.adjusted(thick, thick, -thick, -thick);
    pen(track, thick);
    drawArc(painter, inner, 0, half);
    if (m_scale.low || m_scale.high) {
        const bool both = m_scale.min < 0;
        const double high = angleOf(m_scale.high.value_or(m_scale.max));
        const double low =
            angleOf(both && m_scale.high ? -*m_scale.high : m_scale.low.value_or(m_scale.min));
        pen(tone(Tone::Bad, palette()), 2);
        drawArc(painter, box, 0, half);
        pen(palette().color(QPalette::Base), 3);
        drawArc(painter, box, high, low);
        pen(tone(Tone::Good, palette()), 2);
        drawArc(painter, box, high, low);
    }
    if (!m_value)
        return;
    const double zero = angleOf(m_scale.min < 0 ? 0 : m_scale.min);
    const QColor color = tone(m_stale ? Tone::Quiet : toneOf(limitState()), palette());
    pen(color, thick);
    drawArc(painter, inner, angleOf(*m_value), zero);
}

void Gauge::paintTexts(QPainter& painter) const
{
    const int line = fontMetrics().height();
    painter.setPen(tone(Tone::Quiet, palette()));
    const QRect top(2, 4, width() - 4, line);
    paintFitted(painter, top, m_title);
    const LimitState now = limitState();
    QString sign;
    if (now == LimitState::Near)
        sign = QStringLiteral("! ");
    else if (now == LimitState::Exceeded)
        sign = QStringLiteral("✗ ");
    const QRect bottom(2, height() - line - 5, width() - 4, line);
    const QString footer = m_scale.unit.isEmpty() || m_footer.isEmpty()
                               ? m_scale.unit + m_footer
                               : m_scale.unit + QStringLiteral(" · ") + m_footer;
    paintFitted(painter, bottom, footer);
    QFont big = font();
    big.setPointSizeF(font().pointSizeF() * 1.55);
    big.setBold(true);
    painter.setFont(big);
    const bool remarkable = now == LimitState::Near || now == LimitState::Exceeded;
    painter.setPen(m_stale      ? tone(Tone::Quiet, palette())
                   : remarkable ? tone(toneOf(now), palette())
                                : palette().color(QPalette::WindowText));
    const QRect middle(2, bottom.top() - QFontMetrics(big).height() - 2, width() - 4,
                       QFontMetrics(big).height());
    painter.drawText(middle, Qt::AlignCenter, sign + valueText());
}

void Gauge::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(palette().color(QPalette::Mid));
    painter.setBrush(palette().color(QPalette::Base));
    painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), 6, 6);
    const int line = fontMetrics().height();
    const double top = line + 8;
    const double room = height() - top - line - 6;
    const double radius = std::min(room, width() / 2.0 - 10);
    if (radius > 10)
        paintArcs(painter, {width() / 2.0 - radius, top, 2 * radius, 2 * radius});
    paintTexts(painter);
}
} // namespace ui
