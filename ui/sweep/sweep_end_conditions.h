// SPDX-License-Identifier: GPL-3.0-or-later
// What ends a sweep test early: alarm, stall, first failure. Owned by the form of the sweep test;
// main thread.
#pragma once

#include "results/sweep_spec.h"

#include <QWidget>

class QCheckBox;
class QLabel;

namespace ui {
class SweepEndConditions final : public QWidget {
    Q_OBJECT

public:
    explicit SweepEndConditions(QWidget* parent);

    void writeTo(results::SweepSpec& spec) const;
    void retranslate();

Q_SIGNALS:
    void changed();

private:
    QLabel* m_title;
    QCheckBox* m_onAlarm = nullptr;
    QCheckBox* m_onStall = nullptr;
    QCheckBox* m_onFailure = nullptr;
};
} // namespace ui
