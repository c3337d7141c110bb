// SPDX-License-Identifier: GPL-3.0-or-later
// The distribution of the steady errors of a sweep test: bars over steps, 0 in the middle, the
// limits as lines on both sides. Grows leg by leg; the width of the bars follows the spread and the
// available width. The numbers are in tooltip and accessible description, too. Memory is bounded:
// errors are counted by 1/64 step. Owned by its parent; main thread.
#pragma once

#include <QWidget>

#include <map>
#include <optional>
#include <span>
#include <vector>

namespace ui {
class ErrorHistogram final : public QWidget {
    Q_OBJECT

public:
    struct Bar {
        double from = 0; ///< steps
        double to = 0;
        std::uint64_t count = 0;
    };

    explicit ErrorHistogram(QWidget* parent = nullptr);

    /// In steps, reached − target. What is not a number is left out.
    void addErrors(double error) { addErrors(std::span(&error, 1)); }
    void addErrors(std::span<const double> errors);
    void clear();
    /// Of the size of an error, without its sign.
    void setLimits(std::optional<double> warn, std::optional<double> fail);

    std::uint64_t count() const { return m_count; }
    /// As they are painted at this size, without the empty ones.
    std::vector<Bar> bars() const;

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

protected:
    void paintEvent(QPaintEvent* event) override;
    bool event(QEvent* event) override;

private:
    struct Frame;
    Frame frame() const;
    double barWidth(double room) const;
    double maxAbsError() const;
    std::uint64_t countBeyond(double limit) const;
    QString summary() const;
    QString barText(const QPoint& bin) const;
    void describe();
    void paintBackground(QPainter& painter, const Frame& frame) const;
    void paintBars(QPainter& painter, const Frame& frame) const;
    void paintLimits(QPainter& painter, const Frame& frame) const;
    void paintCount(QPainter& painter, const Frame& frame) const;

    std::map<std::int64_t, std::uint64_t> m_errors; ///< by 1/64 step
    std::uint64_t m_count = 0;
    double m_sum = 0;
    std::optional<double> m_warn;
    std::optional<double> m_fail;
};
} // namespace ui
