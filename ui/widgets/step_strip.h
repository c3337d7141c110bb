// SPDX-License-Identifier: GPL-3.0-or-later
// The steps of a procedure in a row: done, under way, still to come. Owned by its parent; main
// thread.
#pragma once

#include <QStringList>
#include <QWidget>

namespace ui {
class StepStrip final : public QWidget {
    Q_OBJECT

public:
    explicit StepStrip(QWidget* parent);

    void setSteps(const QStringList& steps);
    /// From 0; -1: none has begun.
    void setCurrent(int step);
    int current() const { return m_current; }

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    void describe();

    QStringList m_steps;
    int m_current = -1;
};
} // namespace ui
