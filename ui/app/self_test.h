// SPDX-License-Identifier: GPL-3.0-or-later
// Tries the installed program on its simulated bus: searches, opens every page, writes and undoes,
// sweeps, saves a report; says what came of each step on stdout. Data, settings and model files are
// those that runProgram() has set for it. Owned by it; main thread; ends the event loop with 0
// or 1.
#pragma once

#include "session/sweep/sweep_test.h"
#include "ui/common/app_context.h"

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>

namespace ui {
class MainWindow;

class SelfTest final : public QObject {
    Q_OBJECT

public:
    /// `folder`: for its report.
    SelfTest(AppContext& context, MainWindow& window, const QString& folder);

    void start();

private:
    struct Step {
        QString name;
        std::function<void()> begin;
        std::function<bool()> isDone;
        std::function<QString()> problem; ///< once it is done; empty: all is well
    };
    void addSteps();
    void addPages();
    void addWrite();
    void addSweep();
    void beginNext();
    void check();
    void end(const QString& problem);

    session::ServoRef firstServo() const; ///< 0: none
    std::optional<std::int64_t> gain() const;
    bool isIdle() const;
    bool isPageShown(int index) const;

    AppContext& m_context;
    session::Workbench& m_workbench;
    MainWindow& m_window;
    const QString m_reportPath;
    std::vector<Step> m_steps;
    std::size_t m_at = 0;
    base::Duration m_readAt{};
    std::int64_t m_oldGain = 0;
    QString m_sweepError;
    bool m_isReportSaved = false;
    QTimer m_timer;
    QElapsedTimer m_stepTime;
    QElapsedTimer m_time;
};
} // namespace ui
