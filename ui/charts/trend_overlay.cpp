// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/charts/trend_overlay.h"

#include "ui/charts/hairline.h"

#include <QFontMetricsF>
#include <QPaintEngine>
#include <QPainter>

#include <algorithm>

namespace ui {
using recording::Mark;
using recording::MarkKind;

namespace {
constexpr double minFlagSize = 16;
constexpr double flagSpace = 4;     ///< marks whose flags are closer share one
constexpr double textSpace = 5;     ///< beside a flag
constexpr double minTextWidth = 24; ///< less is not readable
constexpr double reach = 6;         ///< of the mouse
constexpr double frameWidth = 2;
constexpr std::size_t maxCheckedMarks =
    64; ///< marks of a group that are searched for the most serious
constexpr int maxListedMarks = 12;

QString symbolFor(MarkKind kind)
{
    switch (kind) {
    case MarkKind::Write:
        return QStringLiteral("W");
    case MarkKind::Fault:
        return QStringLiteral("!");
    case MarkKind::FaultCleared:
        return QStringLiteral("\u2713");
    case MarkKind::LinkError:
        return QStringLiteral("\u00d7");
    case MarkKind::LinkRestored:
        return QStringLiteral("+");
    case MarkKind::Move:
        return QStringLiteral("M");
    case MarkKind::Stop:
        return QStringLiteral("S");
    case MarkKind::Note:
        break;
    }
    return QStringLiteral("i");
}

int severity(MarkKind kind)
{
    switch (kind) {
    case MarkKind::Stop:
        return 5;
    case MarkKind::Fault:
        return 4;
    case MarkKind::LinkError:
        return 3;
    case MarkKind::Write:
        return 2;
    case MarkKind::FaultCleared:
    case MarkKind::LinkRestored:
    case MarkKind::Move:
        return 1;
    case MarkKind::Note:
        break;
    }
    return 0;
}
} // namespace

TrendOverlay::TrendOverlay(QGraphicsItem* parent)
    : QGraphicsItem(parent)
{
    setAcceptedMouseButtons(Qt::NoButton);
    setZValue(20);
}

void TrendOverlay::setPlot(const QRectF& plot)
{
    if (plot == m_plot)
        return;
    prepareGeometryChange();
    m_plot = plot;
}

void TrendOverlay::setColors(const TrendColors& colors)
{
    m_colors = colors;
    m_flags.clear();
    update();
}

void TrendOverlay::setFont(const QFont& font)
{
    prepareGeometryChange();
    m_font = font;
    m_flagSize = std::max(minFlagSize, std::ceil(QFontMetricsF(font).capHeight() * 1.7));
    m_flags.clear();
    update();
}

void TrendOverlay::setView(const TimeView& view)
{
    m_view = view;
    update();
}

void TrendOverlay::setMarks(const std::vector<Mark>* marks, const MarkTextFunction& markText)
{
    m_marks = marks;
    m_text = markText;
    update();
}

QString TrendOverlay::markText(std::size_t mark) const
{
    const Mark& one = (*m_marks)[mark];
    return m_text ? m_text(one) : one.text;
}

void TrendOverlay::setCursors(const std::optional<std::pair<base::Duration, base::Duration>>& pair)
{
    m_cursors = pair;
    update();
}

void TrendOverlay::setActive(std::optional<Cursor> cursor)
{
    if (cursor == m_active)
        return;
    m_active = cursor;
    update();
}

void TrendOverlay::setBox(const QRectF& box)
{
    m_box = box;
    update();
}

void TrendOverlay::setFocused(bool on)
{
    m_focused = on;
    update();
}

void TrendOverlay::setNotice(const QString& text)
{
    if (text == m_notice)
        return;
    m_notice = text;
    update();
}

QRectF TrendOverlay::boundingRect() const
{
    return m_plot.adjusted(-frameWidth, -m_flagSize - frameWidth, frameWidth, frameWidth);
}

std::optional<Cursor> TrendOverlay::cursorAt(const QPointF& place) const
{
    if (!m_cursors || !boundingRect().adjusted(-reach, 0, reach, 0).contains(place))
        return {};
    const auto distance = [&](base::Duration at) {
        const double x = m_plot.left() + m_view.fractionOf(at) * m_plot.width();
        const QRectF flag(flagLeft(x), m_plot.top(), m_flagSize, m_flagSize);
        const bool isSeen = x >= m_plot.left() && x <= m_plot.right();
        return isSeen && flag.contains(place) ? 0 : std::abs(x - place.x());
    };
    const double a = distance(m_cursors->first);
    const double b = distance(m_cursors->second);
    if (std::min(a, b) > reach)
        return {};
    return a < b ? Cursor::A : Cursor::B;
}

std::vector<MarkGroup> TrendOverlay::groups() const
{
    std::vector<MarkGroup> found;
    if (m_marks == nullptr || m_plot.width() <= 0)
        return found;
    const auto after = [&](base::Duration at) {
        return std::size_t(
            std::lower_bound(m_marks->begin(), m_marks->end(), at,
                             [](const Mark& m, base::Duration t) { return m.at < t; }) -
            m_marks->begin());
    };
    const std::size_t end = after(m_view.span().to + base::Duration(1));
    for (std::size_t i = after(m_view.span().from); i < end;) {
        MarkGroup group;
        group.first = i;
        group.x = m_view.fractionOf((*m_marks)[i].at) * m_plot.width();
        // Flags at the edges are moved into the plot.
        const double nextX = std::max(group.x, m_flagSize / 2) + m_flagSize + flagSpace;
        const bool isLast = nextX > m_plot.width() - m_flagSize / 2;
        const std::size_t next =
            isLast ? end : std::clamp(after(m_view.timeAt(nextX / m_plot.width())), i + 1, end);
        group.count = next - i;
        group.highestSeverity = (*m_marks)[i].kind;
        for (std::size_t k = i; k < std::min(next, i + maxCheckedMarks); ++k) {
            if (severity((*m_marks)[k].kind) > severity(group.highestSeverity))
                group.highestSeverity = (*m_marks)[k].kind;
        }
        found.push_back(group);
        i = next;
    }
    return found;
}

QString TrendOverlay::marksAt(const QPointF& place) const
{
    if (!boundingRect().contains(place))
        return {};
    const double x = place.x() - m_plot.left();
    QStringList lines;
    for (const MarkGroup& group : groups()) {
        if (x < std::min(group.x - reach, flagLeft(m_plot.left() + group.x) - m_plot.left()) ||
            x > group.x + (group.count > 1 ? m_flagSize + flagSpace : m_flagSize))
            continue;
        for (std::size_t i = 0; i < group.count && lines.size() < maxListedMarks; ++i)
            lines << markText(group.first + i);
        if (group.count > maxListedMarks)
            lines << QStringLiteral("\u2026 +%1").arg(group.count - maxListedMarks);
    }
    return lines.join(QLatin1Char('\n'));
}

QColor TrendOverlay::colorOf(MarkKind kind) const
{
    switch (kind) {
    case MarkKind::Write:
        return m_colors.accent;
    case MarkKind::Fault:
    case MarkKind::Stop:
        return m_colors.bad;
    case MarkKind::LinkError:
        return m_colors.warn;
    case MarkKind::FaultCleared:
    case MarkKind::LinkRestored:
        return m_colors.good;
    case MarkKind::Move:
    case MarkKind::Note:
        break;
    }
    return m_colors.muted;
}

void TrendOverlay::paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*)
{
    if (m_plot.isEmpty())
        return;
    painter->setFont(m_font);
    paintMarks(painter);
    if (m_cursors) {
        paintCursor(painter, Cursor::A, m_cursors->first);
        paintCursor(painter, Cursor::B, m_cursors->second);
    }
    if (!m_box.isEmpty()) {
        QColor inside = m_colors.accent;
        inside.setAlphaF(0.15F);
        painter->setPen(QPen(m_colors.accent, 1));
        painter->setBrush(inside);
        painter->drawRect(m_box);
    }
    if (!m_notice.isEmpty()) {
        painter->setPen(m_colors.muted);
        painter->drawText(m_plot, Qt::AlignCenter | Qt::TextWordWrap, m_notice);
    }
    painter->setBrush(Qt::NoBrush);
    if (m_focused) {
        painter->setPen(QPen(m_colors.accent, frameWidth));
        painter->drawRect(m_plot);
    }
}

void TrendOverlay::paintMarks(QPainter* painter) const
{
    const std::vector<MarkGroup> all = groups();
    double painted = 0; // up to here, from the left
    const auto left = [this](const MarkGroup& group) {
        return flagLeft(m_plot.left() + std::round(group.x)) - m_plot.left();
    };
    for (std::size_t i = 0; i < all.size(); ++i) {
        const bool isLast = i + 1 == all.size();
        const double next = isLast ? m_plot.width() : left(all[i + 1]);
        const double flag = left(all[i]);
        painted = paintMark(painter, all[i], next - flag - m_flagSize - 2 * textSpace,
                            isLast ? flag - 2 * textSpace - painted : 0);
    }
}

/// Painted once and copied: an hour of recording can have a hundred of them in every frame.
const QPixmap& TrendOverlay::flagOf(MarkKind kind, const QPainter& painter) const
{
    const double ratio = painter.device()->devicePixelRatioF();
    QPixmap& flag = m_flags[kind];
    if (flag.isNull() || flag.devicePixelRatio() != ratio) {
        flag = QPixmap((QSizeF(m_flagSize, m_flagSize) * ratio).toSize());
        flag.setDevicePixelRatio(ratio);
        flag.fill(Qt::transparent);
        QPainter onFlag(&flag);
        onFlag.setFont(m_font);
        paintFlag(&onFlag, QRectF(0, 0, m_flagSize, m_flagSize), kind);
    }
    return flag;
}

void TrendOverlay::paintFlag(QPainter* painter, const QRectF& place, MarkKind kind) const
{
    painter->setRenderHint(QPainter::Antialiasing);
    painter->setPen(Qt::NoPen);
    painter->setBrush(colorOf(kind));
    painter->drawRoundedRect(place, 3, 3);
    painter->setRenderHint(QPainter::Antialiasing, false);
    painter->setPen(m_colors.background);
    painter->drawText(place, Qt::AlignCenter, symbolFor(kind));
}

/// Around its line, but within the plot: beside it are the texts of the axes.
double TrendOverlay::flagLeft(double x) const
{
    return std::max(std::min(x - m_flagSize / 2, m_plot.right() - m_flagSize), m_plot.left());
}

/// With its text to the right, or to the left where only there is room for all of it. Returns how
/// far to the right it reaches.
double TrendOverlay::paintMark(QPainter* painter, const MarkGroup& group, double room,
                               double roomLeft) const
{
    const QColor color = colorOf(group.highestSeverity);
    const double x = m_plot.left() + std::round(group.x);
    paintVertical(*painter, x, m_plot.top(), m_plot.bottom(), color);
    const QRectF flag(flagLeft(x), m_plot.top() - m_flagSize, m_flagSize, m_flagSize);
    if (painter->paintEngine()->type() == QPaintEngine::Raster)
        painter->drawPixmap(flag.topLeft(), flagOf(group.highestSeverity, *painter));
    else
        paintFlag(painter, flag, group.highestSeverity);
    const double flagEnd = flag.right() - m_plot.left();
    if (room < minTextWidth && roomLeft < minTextWidth && group.count == 1)
        return flagEnd; // words do not fit; measuring them for each mark would take its time
    const QFontMetricsF metrics(m_font);
    const QString text =
        group.count > 1 ? QStringLiteral("+%1").arg(group.count - 1) : markText(group.first);
    const double width = metrics.horizontalAdvance(text);
    const double baseline = m_plot.top() - textSpace;
    painter->setPen(color);
    if (width > room && width <= roomLeft) {
        painter->drawText(QPointF(flag.left() - textSpace - width, baseline), text);
        return flagEnd;
    }
    if (width > room && room < minTextWidth)
        return flagEnd;
    painter->drawText(QPointF(flag.right() + textSpace, baseline),
                      width <= room ? text : metrics.elidedText(text, Qt::ElideRight, room));
    return flagEnd + textSpace + std::min(width, room);
}

void TrendOverlay::paintCursor(QPainter* painter, Cursor which, base::Duration at) const
{
    const double place = m_view.fractionOf(at);
    if (place < 0 || place > 1)
        return;
    const double x = m_plot.left() + std::round(place * m_plot.width());
    painter->setPen(QPen(m_colors.accent, m_active == which ? 2 : 1, Qt::DashLine));
    painter->drawLine(QPointF(x, m_plot.top()), QPointF(x, m_plot.bottom()));
    const QRectF flag(flagLeft(x), m_plot.top() + 1, m_flagSize, m_flagSize);
    painter->setRenderHint(QPainter::Antialiasing);
    painter->setPen(Qt::NoPen);
    painter->setBrush(m_colors.accent);
    painter->drawRoundedRect(flag, 3, 3);
    painter->setRenderHint(QPainter::Antialiasing, false);
    painter->setPen(m_colors.onAccent);
    painter->drawText(flag, Qt::AlignCenter,
                      which == Cursor::A ? QStringLiteral("A") : QStringLiteral("B"));
}
} // namespace ui
