// SPDX-License-Identifier: GPL-3.0-or-later
// The step-response lab: step, gains and what is to be tried at the left, responses over each
// other, figures before and after and advice at the right. A trial lasts as long as its run;
// Accept writes for good, Back writes what was accepted over. Opening it moves nothing; the first
// run of a session asks. Owned by the window; main thread.
#pragma once

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

protected:
    void changeEvent(QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void showEvent(QShowEvent* event) override;

private:
    void build(session::Settings& settings);
    QWidget* buildSetup(session::Settings& settings);
    QWidget* buildRun();
    QPushButton* button(const char* name, QWidget* parent);
    void connectAll();
    void onServoSelected();
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

    session::Desk& m_desk;
    QPointer<session::Desk> m_deskGuard; ///< a window may hide its pages on its way out
    Selection& m_selection;
    session::HistoryService& m_historyService;
    session::StepTest m_test;

    Banner* m_banner = nullptr;
    QScrollArea* m_scroll = nullptr;
    QWidget* m_setup = nullptr; ///< locked while a run lasts
    StepForm* m_form = nullptr;
    QLabel* m_gainsTitle = nullptr;
    StepGains* m_gains = nullptr;
    QCheckBox* m_switchMode = nullptr;
    QLabel* m_reasonLabel = nullptr;
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
