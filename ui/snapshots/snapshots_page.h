// SPDX-License-Identifier: GPL-3.0-or-later
// Snapshots: taken, opened, held against the selected servo, its factory default and others, and
// restored row by row. The servos' columns are read regularly while the page is shown, and say how
// old they are where that fails. Showing and comparing writes nothing; what would be written is
// visible before. Works without a port for files and the history. Owned by the window; main thread,
// never waits.
#pragma once

#include "jobs/restore/restore_plan.h"
#include "session/settings.h"
#include "session/snapshot/snapshots.h"
#include "ui/common/app_context.h"

#include <QPointer>
#include <QTimer>
#include <QWidget>

#include <map>
#include <set>

class QAction;
class QCheckBox;
class QLabel;
class QMenu;
class QPushButton;
class QToolButton;

namespace session {
struct RestoreCompletion;
}

namespace ui {
class Banner;
class SnapshotPane;
class SnapshotBrowser;
struct CompareColumn;
struct SnapshotSelection;

class SnapshotsPage final : public QWidget {
    Q_OBJECT

public:
    SnapshotsPage(AppContext& appContext, session::Settings& settings, QWidget* parent = nullptr);

    void takeSnapshot(); ///< of the selected servo

    /// From elsewhere: a row of the history, or a table that stands nowhere.
    void showHistorySnapshot(std::int64_t number);
    void showTable(session::SharedSnapshot table, const QString& title);

protected:
    void changeEvent(QEvent* event) override;
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dropEvent(QDropEvent* event) override;
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;

private:
    // snapshots_page_build.cpp
    void build();
    QWidget* buildBrowser();
    QWidget* buildActions();
    void connectAll();
    void retranslate();

    // snapshots_page.cpp
    const session::ServoEntry* entry() const;
    void onServoSelected();
    void scheduleRefresh();
    void refresh();
    void updateLive();
    QStringList ages() const;
    std::vector<CompareColumn>
    tables(const std::vector<SnapshotSelection>& selectedSnapshots) const;
    CompareColumn servoTable(session::ServoRef ref) const;
    std::optional<jobs::RestorePlan>
    makePlan(const std::vector<SnapshotSelection>& selectedSnapshots);
    void rememberChecks();
    void fillColumns();
    void showState();
    QString emptyText() const;
    bool isOfAnotherModel(const record::Snapshot& table) const;
    QString titleText(const std::vector<SnapshotSelection>& selectedSnapshots) const;

    // snapshots_page_actions.cpp
    void openFiles();
    void saveCopy();
    void saveBundle();
    void saveTemplate();
    void askTemplateFile(const session::SharedSnapshot& from, const QStringList& keys);
    void editNote();
    static bool torqueIsOn(const jobs::RestorePlan& plan);
    void deleteSnapshots();
    void confirmWrite();
    void sendPlan();
    void dryRun();
    void applyToSeveral();
    void restored(const session::RestoreCompletion& end, const QString& source);
    void askResultFile();
    void showSaved(const QString& path);
    void showError(const base::Error& error);
    QString folder() const;
    void askFile(const QString& title, const QString& name, const QStringList& filters,
                 const QString& suffix, std::function<void(const QString&)> selectedSnapshots);

    session::Desk& m_desk;
    QPointer<session::Desk> m_deskGuard; ///< a window may hide its pages on its way out
    session::HistoryService& m_historyService;
    Selection& m_selection;
    session::Settings& m_settings;
    session::Snapshots m_snapshots;

    Banner* m_banner = nullptr;
    SnapshotBrowser* m_browser = nullptr;
    SnapshotPane* m_pane = nullptr;
    QPushButton* m_take = nullptr;
    QPushButton* m_open = nullptr;
    QToolButton* m_more = nullptr;
    QAction* m_saveCopy = nullptr;
    QAction* m_note = nullptr;
    QAction* m_bundle = nullptr;
    QAction* m_remove = nullptr;
    QCheckBox* m_identity = nullptr;
    QCheckBox* m_rollBack = nullptr;
    QPushButton* m_write = nullptr;
    QPushButton* m_dryRun = nullptr;
    QPushButton* m_applyToSeveral = nullptr;
    QPushButton* m_template = nullptr;
    QLabel* m_order = nullptr;
    QMenu* m_columns = nullptr;
    QAction* m_saveResult = nullptr;

    std::map<QString, bool> m_checks;                  ///< set by hand, for this servo and snapshot
    const record::Snapshot* m_checkedSource = nullptr; ///< that the ticks are about; only compared
    session::ServoRef m_checkedServo = 0;
    bool m_factory = false;                 ///< a column
    std::set<session::ServoRef> m_others{}; ///< columns
    bool m_writing = false;
    bool m_bannerShowsRestore = false; ///< the banner is about the latest restore
    bool m_dryRunPending = false;
    std::vector<record::RestoreResult> m_results; ///< of the latest restore
    QTimer m_refresh;
    QTimer m_age;                                  ///< what is not read any more grows older
    std::vector<session::SubscriptionItem> m_live; ///< what is read regularly for this page
    bool m_showing = false;
};
} // namespace ui
