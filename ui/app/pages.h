// SPDX-License-Identifier: GPL-3.0-or-later
// The pages of the window as tabs, and the commands and requests that lead from one to another.
// Owned by the window, which shows them once there is something to show; main thread.
#pragma once

#include "session/settings.h"
#include "ui/common/app_context.h"

#include <QTabWidget>

namespace ui {
class HistoryPage;
class OperatePage;
class SnapshotsPage;
class StepPage;
class TrendPanel;

class Pages final : public QTabWidget {
    Q_OBJECT

public:
    Pages(AppContext& appContext, session::Settings& settings, QWidget* parent);

    /// As the command line calls it: "operate", "memory" …; unknown names do nothing.
    void open(const QString& name);
    /// A page was requested that needs no servo, or a recording is shown.
    bool isUsableWithoutServo() const;
    void retranslate();

Q_SIGNALS:
    void usableWithoutServo(); ///< isUsableWithoutServo() has become true

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    void connectCommands(const Commands& commands);
    void connectHistory(const Commands& commands);
    void openWithoutServo(QWidget* page);

    OperatePage* m_operate;
    StepPage* m_step;
    SnapshotsPage* m_snapshots;
    HistoryPage* m_history;
    TrendPanel* m_trend;
    bool m_openedWithoutServo = false;
};
} // namespace ui
