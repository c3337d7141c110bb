// SPDX-License-Identifier: GPL-3.0-or-later
// Trend chart with everything around it: toolbar, curves, cursors, trigger, recording, replay.
// Shows the live readings or a recording, and subscribes to the registers of its curves. Owned by
// its page; main thread, never waits.
#pragma once

#include "session/recording/live_data.h"
#include "ui/common/selection.h"
#include "ui/trends/trend_settings.h"

#include <QPointer>
#include <QWidget>

#include <map>

namespace ui {
class Banner;
class CursorTable;
class ExportControl;
class RecordingControl;
class ReplayBar;
class TrendChart;
class TrendReplay;
class TrendToolbar;
class TriggerControl;

class TrendPanel final : public QWidget {
    Q_OBJECT

public:
    TrendPanel(session::Workbench& workbench, session::LiveData& liveData, Selection& selection,
               session::Settings& settings, QWidget* parent = nullptr);
    ~TrendPanel() override;

    QWidget* chart() const;
    bool isReplaying() const;
    base::Duration period() const { return m_period; } ///< of the readings, as chosen

public Q_SLOTS:
    void toggleFollowing();
    void toggleRecording();
    void openRecording();
    void load(const QString& path);

Q_SIGNALS:
    void periodChanged();
    void replayShown();

protected:
    void changeEvent(QEvent* event) override;
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;

private:
    void build();
    void connectToolbar();
    void connectChart();
    void connectLiveData();
    void setRate(int hz);
    void samplesAdded();
    bool followTorque();
    void showLiveReadings();
    void showCurves();
    void updateSubscription();
    void setCurves(const std::vector<TrendCurve>& curves);
    void showCurvesInDialog();
    void applyLegend();
    void chooseChannels();
    void showPresets();
    void savePresetAs();
    void savePresetAs(const QString& name);
    void applyPreset(const QString& name);
    TrendResolver resolver() const;

    session::Workbench& m_workbench;
    QPointer<session::Workbench> m_workbenchGuard; ///< a window may outlive its workbench
    session::LiveData& m_liveData;
    Selection& m_selection;
    TrendSettings m_settings;

    Banner* m_banner = nullptr;
    TrendToolbar* m_toolbar = nullptr;
    TrendChart* m_chart = nullptr;
    CursorTable* m_cursors = nullptr;
    ReplayBar* m_replayBar = nullptr;
    TrendReplay* m_replay = nullptr;
    TriggerControl* m_trigger = nullptr;
    ExportControl* m_export = nullptr;
    RecordingControl* m_recording = nullptr;

    std::vector<TrendCurve> m_curves;
    std::vector<std::size_t>
        m_shownCurves; ///< m_curves[m_shownCurves[i]] is channel i of the chart
    std::map<session::ServoRef, base::Duration> m_goalsFrom; ///< never, while torque is off
    base::Duration m_period{};
    bool m_updatingChart = false; ///< channelsChanged() of the chart comes from here
};
} // namespace ui
