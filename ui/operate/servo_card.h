// SPDX-License-Identifier: GPL-3.0-or-later
// One of many servos as a small card: ID, state, position between its limits, measurements that
// warn. A button: pressing it selects the servo. Owned by the strip; main thread.
#pragma once

#include "session/servos/servo_entry.h"
#include "ui/common/theme.h"

#include <QAbstractButton>

namespace ui {
struct CardState {
    QString title; ///< "1 · STS3215"
    QString state; ///< "fine", "overload", "no answer", "fine · 8 s ago"
    Tone tone = Tone::Quiet;
    std::optional<double> position{}; ///< 0 … 1 between the limits
    std::optional<double> goal{};
    QStringList numbers; ///< "187.4°", "7.4 V", "31 °C"; those that fit are shown
    QString toolTip;
    bool isStale = false; ///< the values may have changed since
    bool operator==(const CardState&) const = default;
};
/// `fresh`: isFresh() of the same moment.
CardState cardState(const session::ServoEntry& entry, bool fresh, base::Duration now);

class ServoCard final : public QAbstractButton {
    Q_OBJECT

public:
    explicit ServoCard(QWidget* parent = nullptr);
    void show(const CardState& view, bool selected);
    const CardState& view() const { return m_view; }
    QSize sizeHint() const override;

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    QString numbersText(int width) const;
    void paintBar(QPainter& painter, const QRectF& bar) const;

    CardState m_view;
    bool m_selected = false;
};
} // namespace ui
