// SPDX-License-Identifier: GPL-3.0-or-later
// The task that has been running for more than a second, in the status bar: its name, how much is
// done, the time left, and Stop. Shown on every page. Owned by the window; main thread.
#pragma once

#include "jobs/job.h"

#include <QTimer>
#include <QWidget>

class QLabel;
class QToolButton;

namespace session {
class TaskQueue;
} // namespace session

namespace ui {
class ThinProgress;

class TaskStatus final : public QWidget {
    Q_OBJECT

public:
    TaskStatus(const session::TaskQueue& tasks, QAction* stop, QWidget* parent);

protected:
    void changeEvent(QEvent* event) override;

private:
    void taskChanged();
    void showProgress(const jobs::Progress& progress);
    void showTask();
    void showText();

    const session::TaskQueue& m_tasks;
    QLabel* m_text;
    ThinProgress* m_bar;
    QToolButton* m_stop;
    QTimer m_delay;
    std::optional<jobs::Progress> m_progress; ///< of the task that runs, if it reports any
};
} // namespace ui
