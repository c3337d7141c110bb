// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/error_histogram.h"

#include "ui/common/follow_language.h"
#include "ui/widgets/test_text.h"

#include <QEvent>
#include <QHelpEvent>
#include <QPainter>
#include <QToolTip>

#include <algorithm>
#include <cmath>

namespace ui {
namespace {
constexpr double parts = 64; ///< of a step
constexpr double maxSteps = 1e9;
constexpr double minBarWidth = 6;     ///< pixels
constexpr double defaultBars = 12;    ///< over the errors' own range
constexpr double minBinWidth = 0.125; ///< steps a bar
constexpr int plotMargin = 6;

/// 1, 2 or 5 times a power of ten, not below `rough`.
double niceStep(double rough)
{
    const double power = std::pow(10.0, std::floor(std::log10(rough)));
    const double times = rough / power;
    return power * (times <= 1 ? 1 : times <= 2 ? 2 : times <= 5 ? 5 : 10);
}

QString signedNumber(double value)
{
    const QString number = sweepNumber(std::abs(value));
    if (number == QLatin1String("0"))
        return number;
    return (value < 0 ? QStringLiteral("−") : QStringLiteral("+")) + number;
}
} // namespace

/// The geometry of the picture.
struct ErrorHistogram::Frame {
    QRectF plot;
    double maxAbsError = 1; ///< steps to both sides of 0
    double width = 1;       ///< steps a bar
    std::uint64_t maxCount = 1;
    double x(double steps) const
    {
        return plot.center().x() + steps / maxAbsError * plot.width() / 2;
    }
    double y(double count) const
    {
        return plot.bottom() - count / double(maxCount) * plot.height();
    }
};

ErrorHistogram::ErrorHistogram(QWidget* parent)
    : QWidget(parent)
{
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    followLanguage(this, [this] {
        describe();
        update();
    });
}

void ErrorHistogram::addErrors(std::span<const double> errors)
{
    const std::uint64_t before = m_count;
    for (const double error : errors) {
        if (!std::isfinite(error))
            continue;
        ++m_errors[std::llround(std::clamp(error, -maxSteps, maxSteps) * parts)];
        m_sum += error;
        ++m_count;
    }
    if (m_count == before)
        return;
    describe();
    update();
}

void ErrorHistogram::clear()
{
    m_errors.clear();
    m_count = 0;
    m_sum = 0;
    describe();
    update();
}

void ErrorHistogram::setLimits(std::optional<double> warn, std::optional<double> fail)
{
    if (warn == m_warn && fail == m_fail)
        return;
    m_warn = warn;
    m_fail = fail;
    describe();
    update();
}

/// 0 is in the middle. The nearer limit is always visible, unless the errors would look like one
/// line beside it; the farther one if it is not far.
double ErrorHistogram::maxAbsError() const
{
    double far = 1;
    if (!m_errors.empty())
        far = std::max({far, std::abs(double(m_errors.begin()->first)) / parts,
                        std::abs(double(m_errors.rbegin()->first)) / parts});
    constexpr double maxEmpty = 4;
    const double errors = far;
    for (const auto& limit : {m_warn, m_fail}) {
        if (limit && *limit <= maxEmpty * errors)
            far = std::max(far, *limit);
    }
    return far;
}

double ErrorHistogram::barWidth(double room) const
{
    double range = 1;
    if (!m_errors.empty())
        range = std::max(range, double(m_errors.rbegin()->first - m_errors.begin()->first) / parts);
    const double ofPixels = 2 * maxAbsError() * minBarWidth / std::max(room, 1.0);
    const double width = niceStep(std::max(range / defaultBars, ofPixels));
    // Servos count in whole steps; only means of them lie between.
    return std::max(width, minBinWidth);
}

ErrorHistogram::Frame ErrorHistogram::frame() const
{
    const int line = fontMetrics().height();
    Frame frame;
    frame.plot =
        QRectF(rect()).adjusted(plotMargin, line + plotMargin, -plotMargin, -(line + plotMargin));
    frame.width = barWidth(frame.plot.width());
    frame.maxAbsError = maxAbsError() + frame.width;
    return frame;
}

std::vector<ErrorHistogram::Bar> ErrorHistogram::bars() const
{
    const double width = frame().width;
    std::vector<Bar> bars;
    for (const auto& [bin, count] : m_errors) {
        // A bar is centered on its value, so that 0 is the middle of one.
        const double middle = std::floor(double(bin) / parts / width + 0.5) * width;
        if (bars.empty() || bars.back().from + width / 2 < middle - width / 4)
            bars.push_back({middle - width / 2, middle + width / 2, 0});
        bars.back().count += count;
    }
    return bars;
}

std::uint64_t ErrorHistogram::countBeyond(double limit) const
{
    std::uint64_t count = 0;
    for (const auto& [bin, times] : m_errors)
        count += std::abs(double(bin)) / parts > limit ? times : 0;
    return count;
}

QString ErrorHistogram::summary() const
{
    if (m_count == 0)
        return tr("No steady-state error has been measured yet.");
    const QString step = unitName(QStringLiteral("step"));
    QStringList lines{tr("Moves: %1. Error: %2 to %3 %4, mean %5 %4.")
                          .arg(locale().toString(qulonglong(m_count)),
                               signedNumber(double(m_errors.begin()->first) / parts),
                               signedNumber(double(m_errors.rbegin()->first) / parts), step,
                               signedNumber(m_sum / double(m_count)))};
    if (m_warn)
        lines << tr("Beyond the warning limit of %1 %2: %3.")
                     .arg(sweepNumber(m_warn), step,
                          locale().toString(qulonglong(countBeyond(*m_warn))));
    if (m_fail)
        lines << tr("Beyond the limit of %1 %2: %3.")
                     .arg(sweepNumber(m_fail), step,
                          locale().toString(qulonglong(countBeyond(*m_fail))));
    return lines.join(QLatin1Char('\n'));
}

void ErrorHistogram::describe()
{
    setAccessibleName(tr("Steady-state error"));
    setAccessibleDescription(summary());
}

QString ErrorHistogram::barText(const QPoint& bin) const
{
    const Frame frame = this->frame();
    for (const Bar& bar : bars()) {
        if (bin.x() < frame.x(bar.from) || bin.x() >= frame.x(bar.to))
            continue;
        const double share = 100.0 * double(bar.count) / double(m_count);
        return tr("%1 to %2 %3: %4 of %5 moves (%6 %)")
            .arg(signedNumber(bar.from), signedNumber(bar.to), unitName(QStringLiteral("step")),
                 locale().toString(qulonglong(bar.count)), locale().toString(qulonglong(m_count)),
                 locale().toString(share, 'f', 1));
    }
    return {};
}

bool ErrorHistogram::event(QEvent* event)
{
    if (event->type() != QEvent::ToolTip)
        return QWidget::event(event);
    const auto* help = static_cast<QHelpEvent*>(event);
    const QString bar = barText(help->pos());
    QToolTip::showText(help->globalPos(), bar.isEmpty() ? summary() : bar, this);
    return true;
}

QSize ErrorHistogram::sizeHint() const
{
    return {fontMetrics().averageCharWidth() * 36, fontMetrics().height() * 9};
}

QSize ErrorHistogram::minimumSizeHint() const
{
    return {fontMetrics().averageCharWidth() * 18, fontMetrics().height() * 5};
}

/// The base line of the bars, with as many labels below it as fit.
void ErrorHistogram::paintBackground(QPainter& painter, const Frame& frame) const
{
    painter.setPen(palette().color(QPalette::Mid));
    painter.drawLine(frame.plot.bottomLeft(), frame.plot.bottomRight());
    const QString unit = QLatin1Char(' ') + unitName(QStringLiteral("step"));
    const double widest = fontMetrics().horizontalAdvance(signedNumber(-frame.maxAbsError) + unit);
    const double labels = std::max(2.0, frame.plot.width() / (widest + 2 * plotMargin));
    double every = niceStep(std::max(2 * frame.maxAbsError / labels, frame.width));
    // A small one still shows its range.
    if (every > frame.maxAbsError && 3 * widest < frame.plot.width())
        every = niceStep(frame.maxAbsError / 2.5);
    const double last = std::floor(frame.maxAbsError / every) * every;
    painter.setPen(tone(Tone::Quiet, palette()));
    const double top = frame.plot.bottom() + 2;
    const double height = fontMetrics().height();
    for (double at = -last; at <= last + every / 2; at += every) {
        const bool end = at > last - every / 2;
        const QString text = signedNumber(at) + (end ? unit : QString());
        const double width = fontMetrics().horizontalAdvance(text) + 2;
        const double left =
            std::clamp(frame.x(at) - width / 2, 0.0, std::max(0.0, this->width() - width));
        painter.drawText(QRectF(left, top, width, height), Qt::AlignCenter, text);
    }
}

void ErrorHistogram::paintBars(QPainter& painter, const Frame& frame) const
{
    painter.setPen(Qt::NoPen);
    painter.setBrush(tone(Tone::Accent, palette()));
    for (const Bar& bar : bars()) {
        const double left = frame.x(bar.from);
        const double right = frame.x(bar.to);
        const double gap = std::min(2.0, (right - left) / 5);
        // One leg among thousands is still visible.
        const double top = std::min(frame.y(double(bar.count)), frame.plot.bottom() - 1.5);
        painter.drawRect(
            QRectF(left + gap, top, right - left - 2 * gap, frame.plot.bottom() - top));
    }
}

/// A sign above each line, if the two do not overlap.
void ErrorHistogram::paintLimits(QPainter& painter, const Frame& frame) const
{
    const int line = fontMetrics().height();
    const bool apart = !m_warn || !m_fail || frame.x(*m_fail) - frame.x(*m_warn) > line;
    const auto paint = [&](const std::optional<double>& limit, Tone meaning, Qt::PenStyle style,
                           const QString& sign) {
        if (!limit || *limit > frame.maxAbsError)
            return;
        for (const double side : {-1.0, 1.0}) {
            const double x = frame.x(side * *limit);
            painter.setPen(QPen(tone(meaning, palette()), 1.5, style));
            painter.drawLine(QPointF(x, frame.plot.top()), QPointF(x, frame.plot.bottom()));
            painter.drawText(QRectF(x - line, 1, 2 * line, line), Qt::AlignCenter, sign);
        }
    };
    paint(m_warn, Tone::Warn, Qt::DashLine,
          apart ? gradeText(results::Grade::Warn).left(1) : QString());
    paint(m_fail, Tone::Bad, Qt::DotLine, gradeText(results::Grade::Fail).left(1));
}

/// The number of legs, where there is no sign of a limit.
void ErrorHistogram::paintCount(QPainter& painter, const Frame& frame) const
{
    const QString text = QStringLiteral("n = %1").arg(locale().toString(qulonglong(m_count)));
    const double half = fontMetrics().horizontalAdvance(text) / 2.0 + fontMetrics().height();
    for (const auto& limit : {m_warn, m_fail}) {
        if (limit && *limit <= frame.maxAbsError && frame.x(*limit) - frame.x(0) < half)
            return;
    }
    painter.setPen(tone(Tone::Quiet, palette()));
    painter.drawText(QRectF(0, 1, width(), fontMetrics().height()), Qt::AlignHCenter, text);
}

void ErrorHistogram::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    if (m_count == 0) {
        painter.setPen(tone(Tone::Quiet, palette()));
        painter.drawText(rect().adjusted(plotMargin, plotMargin, -plotMargin, -plotMargin),
                         Qt::AlignCenter | Qt::TextWordWrap, summary());
        return;
    }
    Frame frame = this->frame();
    for (const Bar& bar : bars())
        frame.maxCount = std::max(frame.maxCount, bar.count);
    painter.setRenderHint(QPainter::Antialiasing);
    paintBackground(painter, frame);
    paintBars(painter, frame);
    paintLimits(painter, frame);
    paintCount(painter, frame);
}
} // namespace ui
