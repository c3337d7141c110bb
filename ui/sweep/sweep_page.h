// SPDX-License-Identifier: GPL-3.0-or-later
// The sweep test: chooses test and servos at the left, tells beforehand whether it can be run and
// whether the time is enough, runs it, shows what is measured at the right. Opening it moves
// nothing and energizes nothing; the first run of a session asks. Owned by the window; main thread.
#pragma once

#include "session/settings.h"
#include "ui/common/app_context.h"
#include "ui/sweep/sweep_form.h"

#include <QPointer>
#include <QTimer>
#include <QWidget>

class QCheckBox;
class QLabel;
class QPushButton;
class QScrollArea;

namespace ui {
class Banner;
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
    /// What was said before servos moved, and agreed to.
    struct Consent {
        std::vector<session::ServoRef> servos;
        bool released = false; ///< torque off afterwards
        bool switchMode = false;
        bool operator==(const Consent&) const = default;
    };
    void build(session::Settings& settings);
    QWidget* buildRun();
    void connectAll();
    session::SweepTestRequest testRequest() const;
    void schedulePreview();
    void preview();
    void setPreviews(const std::vector<session::SweepPreview>& previews);
    void onServoSelected();
    void retryPreview();
    void onSettingsRead(session::ServoRef ref);
    QString rangeOf(session::ServoRef ref, const record::SweepSpec& spec) const;
    void rememberSettings(const std::vector<session::ServoRef>& servos);
    QStringList servosHeldByStop() const;
    std::optional<session::SweepPreview> silentServo() const;
    static QString torqueAfterwards(const Consent& consent);
    void run();
    void start();
    QString unrevertedSettingsText() const;
    void showLeftovers(const std::optional<base::Error>& error);
    void showRemainingLeftovers();
    void onTestFinished();
    void saveRun();
    void showReference();
    void showVerdicts();
    void onTestFailed(const base::Error& error);
    void editLimits(session::ServoRef ref);
    void showState();
    void showPreview();
    void showProgress();
    QString blockedReason() const; ///< nothing can be run now; empty: it can
    void retranslate();

    session::Desk& m_desk;
    QPointer<session::Desk> m_deskGuard; ///< a window may hide its pages on its way out
    Selection& m_selection;
    session::SweepTest& m_test;
    session::HistoryService& m_historyService;

    Banner* m_banner = nullptr;
    bool m_leftoversShown = false;        ///< in it: what the test has left in its servos
    std::optional<base::Error> m_failure; ///< likewise, beside it
    QScrollArea* m_scroll = nullptr;
    SweepForm* m_form = nullptr;
    SweepServos* m_servos = nullptr;
    QLabel* m_previewLabel = nullptr;
    QCheckBox* m_switchMode = nullptr;
    QPushButton* m_run = nullptr;
    QPushButton* m_stop = nullptr;
    ThinProgress* m_progress = nullptr;
    QLabel* m_progressLabel = nullptr;
    SweepResults* m_results = nullptr;
    QTimer m_previewTimer;
    QTimer m_retryTimer; ///< after a reading that got no answer: nothing else may read those servos
    std::vector<session::SweepPreview> m_previews;
    base::Duration m_previewTime{};                            ///< desk clock
    session::ServoRef m_shown = 0;                             ///< the fields are about it
    std::map<session::ServoRef, SweepForm::UserInput> m_typed; ///< for the servos shown before
    std::map<session::ServoRef, QString> m_knownSettings; ///< mode and limits when it was looked at
    std::vector<session::ReferenceResult> m_references;   ///< of the latest test
    std::optional<Consent> m_consent;                     ///< that was given in this session
};
} // namespace ui
