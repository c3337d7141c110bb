// SPDX-License-Identifier: GPL-3.0-or-later
// The left dock: what to search, the progress, the servos as they are found, and the way to the
// reason if one is missing. Selecting a servo here selects it everywhere, and vice versa. Executes
// Command::Search. Searching writes nothing. Owned by the window; main thread.
#pragma once

#include "session/settings.h"
#include "session/workbench.h"
#include "ui/common/commands.h"
#include "ui/common/selection.h"

#include <QWidget>

class QLabel;
class QListView;
class QPushButton;
class QStackedWidget;

namespace ui {
class SearchScope;
class ServoDelegate;
class ServoListModel;
class ThinProgress;

class SearchPanel final : public QWidget {
    Q_OBJECT

public:
    SearchPanel(session::Workbench& workbench, Commands& commands, Selection& selection,
                session::Settings& settings, QWidget* parent = nullptr);

    QSize sizeHint() const override;

private:
    void build();
    QWidget* buildList();
    void connectWorkbench();
    void connectList();
    void search();
    void searchChanged();
    void searchEnded();
    void showProgress(const jobs::Progress& progress);
    void showStatus();
    void showScope();
    void showList();
    void showContextMenu(const QPoint& place);
    void onListSelectionChanged();
    void followSelection();
    void onEvent(const session::Event& event);
    void linkChanged();
    QString emptyText() const;
    void retranslate();

    static constexpr int permille = 1000; ///< of the progress

    session::Workbench& m_workbench;
    Commands& m_commands;
    Selection& m_selection;

    SearchScope* m_scope;
    QLabel* m_estimate;
    QPushButton* m_search;
    QPushButton* m_stop;
    ThinProgress* m_progress;
    QLabel* m_status;
    QStackedWidget* m_stack;
    QListView* m_list;
    QLabel* m_empty;
    ServoListModel* m_model;
    ServoDelegate* m_delegate;
    QPushButton* m_findOut; ///< below the empty list
    QPushButton* m_why;     ///< below the list

    QTimer m_tick;
    bool m_searching = false;
    bool m_commissioning = false; ///< commissioning runs
    std::optional<jobs::Progress> m_lastProgress;
    std::optional<base::Error> m_error; ///< of the latest search
};
} // namespace ui
