// SPDX-License-Identifier: GPL-3.0-or-later
// The memory table of the selected servo: reads it when it is selected, keeps the visible rows
// fresh, takes edits and has them written safely, and asks first where a write is dangerous or
// changes the mode. Selecting, filtering and reading write nothing. Owned by the window; main
// thread, never waits.
#pragma once

#include "session/settings.h"
#include "ui/common/commands.h"
#include "ui/memory/memory_filter.h"
#include "ui/memory/memory_model.h"

#include <QPointer>
#include <QTimer>
#include <QWidget>

class QSplitter;
class QStackedWidget;

namespace ui {
class Banner;
class ServoHistoryPanel;
class MemoryOutput;
class MemoryToolbar;
class MemoryView;
class RegisterDelegate;
class RegisterPanel;
class ServoObstacle;

class MemoryPage final : public QWidget {
    Q_OBJECT

public:
    MemoryPage(session::Workbench& workbench, Commands& commands, Selection& selection,
               session::Settings& settings, QWidget* parent = nullptr);
    ~MemoryPage() override;

    /// Asks first where that is due, then has it written.
    void requestWrite(const QString& key, std::int64_t raw, bool temporary);

protected:
    void resizeEvent(QResizeEvent* event) override;
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;

private:
    void build(session::Settings& settings);
    void connectTable();
    void connectToolbar();
    void connectWorkbench();
    void connectCommands();
    void retranslate();

    const session::ServoEntry* entry() const;
    void select();
    void read();
    void refresh();
    void scheduleRefresh();
    void showPanel();
    void updateVisibility();
    void showServoState();
    void showWarning(const QString& message);
    void clearWarning();
    void explainReadOnly(const QModelIndex& index);
    void updateLive();

    bool writeByOwnAction(const catalog::Register& reg, std::int64_t raw);
    void closeLock();

    session::Workbench& m_workbench;
    QPointer<session::Workbench> m_workbenchGuard; ///< a window may hide its pages on its way out
    Commands& m_commands;
    Selection& m_selection;
    MemoryModel m_model;
    MemoryFilter m_filter;

    MemoryToolbar* m_toolbar = nullptr;
    Banner* m_banner = nullptr;
    QStackedWidget* m_stack = nullptr;
    ServoObstacle* m_empty = nullptr;
    QSplitter* m_splitter = nullptr;
    MemoryView* m_view = nullptr;
    RegisterDelegate* m_delegate = nullptr;
    RegisterPanel* m_panel = nullptr;
    ServoHistoryPanel* m_history = nullptr;
    MemoryOutput* m_output = nullptr;

    QTimer m_refresh;               ///< many changes, one look
    QTimer m_age;                   ///< values grow old
    QTimer m_liveTimer;             ///< scrolling and typing first come to rest
    bool m_complete = false;        ///< the whole table has been read
    bool m_userSplit = false;       ///< the user has moved the splitter
    bool m_showsWarning = false;    ///< the banner is about an input
    bool m_showsServoState = false; ///< the banner is about the servo
};
} // namespace ui
