// SPDX-License-Identifier: GPL-3.0-or-later
// Restores the selected rows of a snapshot to the selected servo: which rows, the dry run, the
// question before it, and the result as a file; or the snapshot to several servos. Shows no
// message: the snapshots page, which owns it, does. Main thread, never waits.
#pragma once

#include "session/settings.h"
#include "session/snapshot/restore_request.h"
#include "snapshot/restore_result.h"
#include "ui/common/app_context.h"
#include "ui/snapshots/restore_ticks.h"

#include <QPointer>
#include <QWidget>

class QAction;
class QCheckBox;
class QLabel;
class QPushButton;

namespace ui {
class CompareModel;
class SnapshotBrowser;

class RestorePanel final : public QWidget {
    Q_OBJECT

public:
    RestorePanel(AppContext& appContext, session::Settings& settings, SnapshotBrowser& browser,
                 CompareModel& model, QWidget* parent);

    /// From the first of the selected snapshots to `entry`; null: none is selected.
    std::optional<jobs::RestorePlan> makePlan(const session::ServoEntry* entry);
    bool isWriting() const { return m_writing; }
    QAction* saveResultAction() const { return m_saveResult; } ///< of the latest restore
    void updateControls();

Q_SIGNALS:
    void started();
    void finished(const session::RestoreCompletion& end);
    void failed(const base::Error& error); ///< the dry run
    void templateRequested();

private:
    void build();
    void connectAll();
    void retranslate();
    QString orderText() const;
    void rememberTicks();
    void dryRun();
    void confirmWrite();
    QStringList risks() const;
    void write();
    void onFinished(const session::RestoreCompletion& end, const QString& source);
    void applyToSeveral();
    void saveResult();

    session::Workbench& m_workbench;
    QPointer<session::Workbench> m_workbenchGuard; ///< the window may hide its pages after it
    Selection& m_selection;
    session::Settings& m_settings;
    SnapshotBrowser& m_browser;
    CompareModel& m_model;
    RestoreTicks m_ticks;
    bool m_writing = false;
    bool m_dryRunPending = false;
    std::vector<snapshot::RestoreResult> m_results; ///< of the latest restore
    QCheckBox* m_identity = nullptr;
    QCheckBox* m_rollBack = nullptr;
    QLabel* m_order = nullptr;
    QPushButton* m_write = nullptr;
    QPushButton* m_dryRun = nullptr;
    QPushButton* m_applyToSeveral = nullptr;
    QPushButton* m_template = nullptr;
    QAction* m_saveResult = nullptr;
};
} // namespace ui
