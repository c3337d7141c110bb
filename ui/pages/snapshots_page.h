// SPDX-License-Identifier: GPL-3.0-or-later
// Snapshots: taken, opened, held against the selected servo, its factory default and others, and
// restored row by row. The servos' columns are read regularly while the page is shown, and say how
// old they are where that fails. Showing and comparing writes nothing; what would be written is
// visible before. Works without a port for files and the history. Owned by the window; main thread,
// never waits.
#pragma once

#include "jobs/restore_plan.h"
#include "session/settings.h"
#include "session/snapshots.h"
#include "ui/app/bench.h"

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
struct RestoreEnd;
}

namespace ui {
class Banner;
class SnapshotPane;
class SnapshotShelf;
struct ComparedTable;
struct ShelfChoice;

class SnapshotsPage final : public QWidget {
    Q_OBJECT

public:
    SnapshotsPage(Bench& bench, session::Settings& settings, QWidget* parent = nullptr);

    void take(); ///< of the selected servo

    /// From elsewhere: a row of the history, or a table that stands nowhere.
    void showKept(std::int64_t number);
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
    QWidget* buildShelf();
    QWidget* buildDeeds();
    void connectAll();
    void retranslate();

    // snapshots_page.cpp
    const session::ServoEntry* entry() const;
    void servoChosen();
    void refreshSoon();
    void refresh();
    void updateLive();
    QStringList ages() const;
    std::vector<ComparedTable> tables(const std::vector<ShelfChoice>& chosen) const;
    ComparedTable servoTable(session::ServoRef ref) const;
    std::optional<jobs::RestorePlan> plan(const std::vector<ShelfChoice>& chosen);
    void rememberTicks();
    void fillColumns();
    void showState();
    QString nothingWords() const;
    bool isOfAnotherModel(const record::Snapshot& table) const;
    QString titleWords(const std::vector<ShelfChoice>& chosen) const;

    // snapshots_page_deeds.cpp
    void openFiles();
    void saveCopy();
    void saveBundle();
    void saveTemplate();
    void askTemplateFile(const session::SharedSnapshot& from, const QStringList& keys);
    void editNote();
    static bool torqueIsOn(const jobs::RestorePlan& plan);
    void removeKept();
    void write();
    void sendPlan();
    void dryRun();
    void applyToSeveral();
    void restored(const session::RestoreEnd& end, const QString& source);
    void askResultFile();
    void tellSaved(const QString& path);
    void fail(const base::Error& error);
    QString folder() const;
    void askFile(const QString& title, const QString& name, const QStringList& filters,
                 const QString& suffix, std::function<void(const QString&)> chosen);

    session::Desk& m_desk;
    QPointer<session::Desk> m_deskLives; ///< a window may hide its pages on its way out
    session::Archive& m_archive;
    Selection& m_selection;
    session::Settings& m_settings;
    session::Snapshots m_snapshots;

    Banner* m_banner = nullptr;
    SnapshotShelf* m_shelf = nullptr;
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
    QPushButton* m_several = nullptr;
    QPushButton* m_template = nullptr;
    QLabel* m_order = nullptr;
    QMenu* m_columns = nullptr;
    QAction* m_saveResult = nullptr;

    std::map<QString, bool> m_ticks;            ///< set by hand, for this servo and snapshot
    const record::Snapshot* m_ticked = nullptr; ///< that the ticks are about; only compared
    session::ServoRef m_tickedServo = 0;
    bool m_factory = false;                 ///< a column
    std::set<session::ServoRef> m_others{}; ///< columns
    bool m_writing = false;
    bool m_tellsRestore = false; ///< the banner is about the latest restore
    bool m_dryRunComing = false;
    std::vector<record::RestoreResult> m_results; ///< of the latest restore
    QTimer m_refresh;
    QTimer m_age;                          ///< what is not read any more grows older
    std::vector<session::FeedPart> m_live; ///< what is read regularly for this page
    bool m_showing = false;
};
} // namespace ui
