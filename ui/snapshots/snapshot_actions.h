// SPDX-License-Identifier: GPL-3.0-or-later
// The buttons below the list of snapshots: takes and opens snapshots, saves them as files, bundles
// and templates, labels and deletes them. Owned by the snapshots page, which shows the messages;
// main thread, never waits.
#pragma once

#include "session/settings.h"
#include "session/snapshot/snapshots.h"
#include "ui/common/app_context.h"
#include "ui/common/file_dialog.h"

#include <QPointer>
#include <QWidget>

class QAction;
class QPushButton;
class QToolButton;

namespace ui {
class SnapshotBrowser;

class SnapshotActions final : public QWidget {
    Q_OBJECT

public:
    SnapshotActions(AppContext& appContext, session::Settings& settings, SnapshotBrowser& browser,
                    QWidget* parent);

    static QString folderKey(); ///< in the settings: of snapshots and results of a restore

    void take(); ///< of the selected servo
    /// Asks which rows of the selected snapshot become a template, and for its file.
    void saveTemplate();
    void updateControls();

Q_SIGNALS:
    void started(); ///< something whose result will be shown
    void failed(const base::Error& error);

private:
    void build();
    void connectAll();
    void retranslate();
    session::SharedSnapshot selected() const; ///< null: none
    void open();
    void saveCopy();
    void saveBundle();
    void askTemplateFile(const session::SharedSnapshot& from, const QStringList& keys);
    void editNote();
    void deleteSnapshots();
    void askForPath(const QString& title, const QString& name, const QStringList& filters,
                    FileChosen chosen);

    session::Workbench& m_workbench;
    QPointer<session::Workbench> m_workbenchGuard; ///< the window may hide its pages after it
    session::Snapshots& m_snapshots;
    Selection& m_selection;
    session::Settings& m_settings;
    SnapshotBrowser& m_browser;
    QPushButton* m_take = nullptr;
    QPushButton* m_open = nullptr;
    QToolButton* m_more = nullptr;
    QAction* m_saveCopy = nullptr;
    QAction* m_note = nullptr;
    QAction* m_bundle = nullptr;
    QAction* m_remove = nullptr;
};
} // namespace ui
