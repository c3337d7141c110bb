// SPDX-License-Identifier: GPL-3.0-or-later
// The page of the sweep test: test and servos at the left, with a preview that shows whether the
// test can run and the time is enough; results at the right. Opening it moves nothing and energizes
// nothing; the first run of a session asks. Owned by the window; main thread.
#pragma once

#include "session/history/history_service.h"
#include "session/settings.h"
#include "session/sweep/sweep_test.h"
#include "ui/common/app_context.h"
#include "ui/sweep/sweep_form.h"
#include "ui/sweep/sweep_start_question.h"

#include <QPointer>
#include <QWidget>

class QCheckBox;
class QLabel;
class QPushButton;
class QScrollArea;

namespace ui {
class AllowMovementButton;
class Banner;
class SweepLeftoversBanner;
class SweepPreviews;
class SweepResults;
class SweepServos;
class ThinProgress;

class SweepPage final : public QWidget {
    Q_OBJECT

public:
    SweepPage(AppContext& appContext, session::Settings& settings, QWidget* parent = nullptr);
    ~SweepPage() override;

Q_SIGNALS:
    void previousTestsRequested(); ///< the window of kept tests

protected:
    void changeEvent(QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void showEvent(QShowEvent* event) override;

private:
    void build();
    QWidget* buildRun();
    void connectAll();
    session::SweepTestRequest testRequest() const;
    void schedulePreview();
    void preview();
    void onPreviewsReceived();
    void onServoSelected();
    std::optional<session::SweepPreview> silentServo() const;
    void run();
    void start();
    void onTestFinished();
    void compareWithReference();
    void showReference();
    void showVerdicts();
    void onTestFailed(const base::Error& error);
    void editLimits(session::ServoRef ref);
    void showState();
    void showPreview();
    void showProgress();
    QString blockedReason() const; ///< nothing can be run now; empty: it can
    void retranslate();

    session::Workbench& m_workbench;
    QPointer<session::Workbench> m_workbenchGuard; ///< a window may hide its pages on its way out
    Selection& m_selection;
    session::SweepTest& m_test;
    session::HistoryService& m_historyService;
    session::Settings& m_settings;

    Banner* m_banner = nullptr;
    SweepLeftoversBanner* m_leftovers = nullptr; ///< fills the banner
    QScrollArea* m_scroll = nullptr;
    SweepForm* m_form = nullptr;
    SweepServos* m_servos = nullptr;
    QLabel* m_previewLabel = nullptr;
    QCheckBox* m_switchMode = nullptr;
    QPushButton* m_run = nullptr;
    AllowMovementButton* m_allow = nullptr;
    QPushButton* m_stop = nullptr;
    ThinProgress* m_progress = nullptr;
    QLabel* m_progressLabel = nullptr;
    SweepResults* m_results = nullptr;
    SweepPreviews* m_previews = nullptr;
    session::ServoRef m_shown = 0;                             ///< the fields are about it
    std::map<session::ServoRef, SweepForm::UserInput> m_typed; ///< for the servos shown before
    std::vector<session::ReferenceResult> m_references;        ///< of the latest test
    std::optional<SweepConsent> m_consent;                     ///< that was given in this session
};
} // namespace ui
