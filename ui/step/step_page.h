// SPDX-License-Identifier: GPL-3.0-or-later
// The step-response page: step, gains and values to try at the left; overlaid responses, figures
// before and after, and advice at the right. A trial lasts as long as its run; Keep gains
// writes permanently, Restore old writes the gains from before. Opening it moves nothing; the first
// run of a session asks. Earlier runs can be opened next to the measured ones. Owned by the window;
// main thread.
#pragma once

#include "session/history/history_service.h"
#include "session/settings.h"
#include "session/step/step_test.h"
#include "ui/common/app_context.h"

#include <QPointer>
#include <QWidget>

class QCheckBox;
class QLabel;
class QPushButton;
class QScrollArea;

namespace ui {
class AllowMovementButton;
class Banner;
struct BannerText;
class StepForm;
class StepGains;
class StepResults;
class ThinProgress;

class StepPage final : public QWidget {
    Q_OBJECT

public:
    StepPage(AppContext& appContext, session::Settings& settings, QWidget* parent = nullptr);

    session::StepTest& test() { return m_test; }
    void
    openStored(const std::vector<std::int64_t>& numbers); ///< runs of the history, oldest first

protected:
    void resizeEvent(QResizeEvent* event) override;
    void showEvent(QShowEvent* event) override;

private:
    void build(session::Settings& settings);
    QWidget* buildSetup(session::Settings& settings);
    QWidget* buildRun();
    QPushButton* button(const char* name, QWidget* parent);
    void connectAll();
    void onServoSelected();
    void showPreviousRuns();
    void run(bool trial);
    void start(bool trial);
    void askForConfirmation(bool trial);
    void accept();
    void onTestFinished();
    void onTestFailed(const base::Error& error);
    std::function<BannerText()> endMessage() const;
    void showState();
    void showProgress();
    bool otherMode() const;        ///< the servo is in one without positions
    QString blockedReason() const; ///< nothing can be run now; empty: it can
    QString trialBlockedReason() const;
    void retranslate();

    session::Workbench& m_workbench;
    QPointer<session::Workbench> m_workbenchGuard; ///< a window may hide its pages on its way out
    Selection& m_selection;
    session::HistoryService& m_historyService;
    session::StepTest& m_test;

    Banner* m_banner = nullptr;
    QScrollArea* m_scroll = nullptr;
    QWidget* m_setup = nullptr; ///< locked while a run lasts
    StepForm* m_form = nullptr;
    QLabel* m_gainsTitle = nullptr;
    StepGains* m_gains = nullptr;
    QCheckBox* m_switchMode = nullptr;
    QLabel* m_reasonLabel = nullptr;
    AllowMovementButton* m_allow = nullptr;
    QPushButton* m_run = nullptr;
    QPushButton* m_try = nullptr;
    QPushButton* m_stop = nullptr;
    QPushButton* m_accept = nullptr;
    QPushButton* m_back = nullptr;
    ThinProgress* m_progress = nullptr;
    StepResults* m_results = nullptr;
    bool m_confirmed = false; ///< whether it may move, in this session
};
} // namespace ui
