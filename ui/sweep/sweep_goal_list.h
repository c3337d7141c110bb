// SPDX-License-Identifier: GPL-3.0-or-later
// The button that opens a list of goals from a file and shows which one is open. Owned by the form
// of the sweep test; main thread.
#pragma once

#include "results/sweep_spec.h"
#include "session/settings.h"

#include <QPushButton>

namespace ui {
class SweepGoalList final : public QPushButton {
    Q_OBJECT

public:
    SweepGoalList(session::Settings& settings, QWidget* parent);

    /// Empty if no list is open, or if it cannot be read.
    const std::vector<results::SweepPoint>& points() const { return m_points; }
    QString error() const { return m_error; } ///< why it cannot be read; empty: it can
    void retranslate();

Q_SIGNALS:
    void changed(); ///< another list

private:
    void open();
    void read(const QString& path);

    session::Settings& m_settings;
    std::vector<results::SweepPoint> m_points;
    QString m_path;
    QString m_error;
};
} // namespace ui
