// SPDX-License-Identifier: GPL-3.0-or-later
// The pages of the window as tabs, and the commands and requests that lead from one to another.
// A page is made when it is first needed; operate and memory, which read the selected servo
// whatever page is shown, with the first of them. Owned by the window, which shows them once there
// is something to show; main thread.
#pragma once

#include "session/settings.h"
#include "ui/app/lazy_page.h"
#include "ui/common/app_context.h"

#include <QTabWidget>

namespace ui {
class HistoryPage;
class MemoryPage;
class OperatePage;
class SnapshotsPage;
class StepPage;
class SweepPage;
class TrendPanel;

class Pages final : public QTabWidget {
    Q_OBJECT

public:
    Pages(AppContext& appContext, session::Settings& settings, QWidget* parent);

    /// As the command line calls it: "operate", "memory" …; unknown names do nothing.
    void open(const QString& name);
    /// A snapshot, bundle or recording, on its page; a file that cannot be read is named there.
    void openFile(const QString& path);
    /// A page was requested that needs no servo, or a recording is shown.
    bool isUsableWithoutServo() const;
    void retranslate();

Q_SIGNALS:
    void usableWithoutServo(); ///< isUsableWithoutServo() has become true

protected:
    void paintEvent(QPaintEvent* event) override;
    void showEvent(QShowEvent* event) override;

private:
    template <typename Page>
    LazyPage<Page>* add(void (Pages::*connectPage)(Page&) = nullptr);
    template <typename Page>
    Page& open(LazyPage<Page>* page);
    void connectOperate(OperatePage& page);
    void connectSweep(SweepPage& page);
    void connectHistory(HistoryPage& page);
    void connectCommands();
    TrendPanel& openTrend();
    void openWithoutServo(QWidget* page);

    AppContext& m_context;
    session::Settings& m_settings;
    LazyPage<OperatePage>* m_operate = nullptr;
    LazyPage<MemoryPage>* m_memory = nullptr;
    LazyPage<StepPage>* m_step = nullptr;
    LazyPage<SnapshotsPage>* m_snapshots = nullptr;
    LazyPage<HistoryPage>* m_history = nullptr;
    bool m_openedWithoutServo = false;
};
} // namespace ui
