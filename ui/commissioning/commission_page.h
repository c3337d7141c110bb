// SPDX-License-Identifier: GPL-3.0-or-later
// Commissioning: factory servos are set up one after the other with template, ID and baud rate. The
// settings are at the left, the next step in large words and the batch at the right. Opening the
// page writes nothing; once started, a servo that is connected alone is set up after one click, or
// without any. Owned by the window; main thread.
#pragma once

#include "session/commission/commissioning.h"
#include "session/settings.h"
#include "ui/common/app_context.h"

#include <QPointer>
#include <QTimer>
#include <QWidget>

class QLabel;
class QPushButton;

namespace ui {
class Banner;
class CommissionBatchView;
class CommissionForm;
class CommissionStatus;

class CommissionPage final : public QWidget {
    Q_OBJECT

public:
    CommissionPage(AppContext& appContext, session::Settings& settings, QWidget* parent = nullptr);

    session::Commissioning& commissioning() { return m_commissioning; }

protected:
    void showEvent(QShowEvent* event) override;

private:
    void build();
    QWidget* buildSetup();
    QWidget* buildWork();
    void connectForm();
    void connectAll();
    void retranslate();
    void checkFilesAndStart();
    void onFilesChecked();
    void askForConfirmation();
    void start();
    void onFinished(const std::optional<base::Error>& error);
    void askForReportPath();
    void showState();
    QString blockedReason() const; ///< why the line cannot start; empty: it can

    session::Workbench& m_workbench;
    QPointer<session::Workbench> m_workbenchGuard; ///< the window may hide its pages after it
    session::Settings& m_settings;
    session::Commissioning& m_commissioning;
    QTimer m_fileCheckTimer;     ///< checks the files when typing has ended
    bool m_startPending = false; ///< Start was clicked: begins when the files have been checked
    bool m_batchEnded = false;   ///< the line has run on this batch

    Banner* m_banner = nullptr;
    CommissionForm* m_form = nullptr; ///< locked while the line runs
    QPushButton* m_start = nullptr;
    QPushButton* m_stop = nullptr;
    QPushButton* m_plug = nullptr; ///< simulated servos only
    QPushButton* m_unplug = nullptr;
    QLabel* m_reasonLabel = nullptr;
    CommissionStatus* m_status = nullptr;
    CommissionBatchView* m_batch = nullptr;
};
} // namespace ui
