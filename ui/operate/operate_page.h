// SPDX-License-Identifier: GPL-3.0-or-later
// Drives the selected servos and shows them on dial, gauges and charts. Subscribes to their
// registers while it is visible. Opening it and selecting a servo write nothing and move nothing.
// Owned by the window; main thread, never waits.
#pragma once

#include "session/motion/motion_controller.h"
#include "session/recording/live_data.h"
#include "session/settings.h"
#include "ui/common/app_context.h"

#include <QPointer>
#include <QTimer>
#include <QWidget>

#include <array>

namespace ui {
class ControlPanel;
class Gauge;
class OperateStatus;
class PositionDial;
class ServoStrip;
class TrendPanel;

class OperatePage final : public QWidget {
    Q_OBJECT

public:
    OperatePage(AppContext& appContext, session::Settings& settings, QWidget* parent = nullptr);
    ~OperatePage() override;

    TrendPanel* trend() const { return m_trend; }

protected:
    void resizeEvent(QResizeEvent* event) override;
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;

private:
    void build(session::Settings& settings);
    QWidget* buildWatch(session::Settings& settings);
    void connectAll();
    void select();
    void updateSubscription();
    void refresh();
    void showDial(const session::ServoEntry* entry);
    void showGauges(const session::ServoEntry* entry);
    const session::ServoEntry* entry() const;

    session::Workbench& m_workbench;
    QPointer<session::Workbench> m_workbenchGuard; ///< a window may hide its pages on its way out
    Commands& m_commands;
    Selection& m_selection;
    session::MotionController& m_motion;
    session::LiveData& m_liveData;

    ControlPanel* m_control = nullptr;
    PositionDial* m_dial = nullptr;
    bool m_gaugesShown = true; ///< by the user
    OperateStatus* m_status = nullptr;
    std::array<Gauge*, 5> m_gauges{};
    QWidget* m_watch = nullptr;
    TrendPanel* m_trend = nullptr;
    ServoStrip* m_strip = nullptr;
    QTimer m_refreshTimer;
};
} // namespace ui
