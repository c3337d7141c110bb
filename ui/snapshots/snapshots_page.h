// SPDX-License-Identifier: GPL-3.0-or-later
// Snapshots: taken, opened, compared with the selected servo, its factory default and other servos,
// and restored row by row. The compared servos are read regularly while the page is shown.
// Comparing writes nothing, and what a restore writes is visible before. Without a port it works on
// files and the history. Owned by the window; main thread, never waits.
#pragma once

#include "session/settings.h"
#include "session/snapshot/snapshots.h"
#include "ui/common/app_context.h"

#include <QPointer>
#include <QTimer>
#include <QWidget>

class QMenu;

namespace session {
struct RestoreCompletion;
}

namespace ui {
class Banner;
class CompareTables;
class RestorePanel;
class SnapshotActions;
class SnapshotBrowser;
class SnapshotPane;
struct SnapshotSelection;

class SnapshotsPage final : public QWidget {
    Q_OBJECT

public:
    SnapshotsPage(AppContext& appContext, session::Settings& settings, QWidget* parent = nullptr);

    void takeSnapshot(); ///< of the selected servo

    /// From other pages: a snapshot of the history, or a memory table that is saved nowhere.
    void showHistorySnapshot(std::int64_t number);
    void showTable(session::SharedSnapshot table, const QString& title);

protected:
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dropEvent(QDropEvent* event) override;
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;

private:
    void build();
    QWidget* buildBrowser();
    QWidget* buildCompare();
    void connectParts();
    void connectSession();

    void onServoSelected();
    void scheduleRefresh();
    void refresh();
    void updateControls();
    QString emptyText() const;
    QString titleText() const;
    bool isOfOtherModel(const snapshot::Snapshot& table) const;

    void onRestored(const session::RestoreCompletion& end);
    void showTaken(const session::SharedSnapshot& snapshot);
    void showSaved(const QString& path);
    void showError(const base::Error& error);

    AppContext& m_context;
    session::Workbench& m_workbench;
    QPointer<session::Workbench> m_workbenchGuard; ///< the window may hide its pages after it
    session::Settings& m_settings;
    session::Snapshots& m_snapshots;
    Selection& m_selection;

    Banner* m_banner = nullptr;
    SnapshotBrowser* m_browser = nullptr;
    SnapshotActions* m_actions = nullptr;
    SnapshotPane* m_pane = nullptr;
    RestorePanel* m_restore = nullptr;
    CompareTables* m_tables = nullptr;
    QMenu* m_columns = nullptr;
    bool m_bannerShowsRestore = false; ///< the banner is about the latest restore
    QTimer m_refreshTimer;
    QTimer m_ageTimer; ///< tables that are no longer read get older
};
} // namespace ui
