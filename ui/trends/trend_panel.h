// SPDX-License-Identifier: GPL-3.0-or-later
// Trend chart with everything around it: buttons, curves, cursors, trigger, recording, replay.
// Shows what the scope keeps, or a recording; says to Desk which registers are to be read for it.
// Owned by its page; main thread, never waits.
#pragma once

#include "session/recording/replay.h"
#include "session/settings.h"
#include "ui/common/selection.h"
#include "ui/trends/trend_curves.h"

#include <QPointer>
#include <QWidget>

namespace ui {
class Banner;
class CursorTable;
class RecordDialog;
class ReplayBar;
class TrendChart;
class TrendToolbar;
struct RecordRequest;

class TrendPanel final : public QWidget {
    Q_OBJECT

public:
    TrendPanel(session::Desk& desk, session::LiveData& scope, Selection& selection,
               session::Settings& settings, QWidget* parent = nullptr);
    ~TrendPanel() override;

    QWidget* chart() const;
    bool isReplaying() const { return m_replayed != nullptr; }
    base::Duration period() const { return m_period; } ///< of the readings that were chosen

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

private:
    void build();
    void connectToolbar();
    void connectScope();
    void samplesAdded();
    void showCurves();
    void updateSubscription();
    void saveCurves();
    void setCurves(const std::vector<TrendCurve>& curves);
    void applyLegend();
    void chooseChannels();
    void chooseTrigger();
    void armTrigger(const record::TriggerSpec& spec);
    void updateTriggerText();
    void showTrigger();
    void startRecording(const RecordRequest& request);
    void recordingFailed(const base::Error& error);
    void showRecording();
    void recordingEnded(const record::RecorderStatus& status, const QString& path);
    void showReplay(const std::shared_ptr<session::ReplayData>& recording);
    void closeReplay();
    void followReplay(base::Duration place);
    void saveImage();
    void writeImage(const QString& path);
    void showPresets();
    void savePresetAs();
    void applyPreset(const QString& name);
    void showError(const QString& message, const QString& remedy);
    base::Duration defaultWidth() const; ///< of live readings, as it was chosen
    QColor backgroundColor() const;
    TrendResolver resolver() const;

    session::Desk& m_desk;
    QPointer<session::Desk> m_deskGuard; ///< a window may go after its desk
    session::LiveData& m_liveData;
    Selection& m_selection;
    session::Settings& m_settings;
    session::Replay m_replay;
    std::shared_ptr<session::ReplayData> m_replayed;

    Banner* m_banner = nullptr;
    TrendToolbar* m_toolbar = nullptr;
    TrendChart* m_chart = nullptr;
    CursorTable* m_cursors = nullptr;
    ReplayBar* m_replayBar = nullptr;
    QPointer<RecordDialog> m_recordDialog;

    std::vector<TrendCurve> m_curves;
    std::vector<std::size_t> m_shownCurves; ///< channel i of the chart is this choice
    base::Duration m_period{};
    bool m_updatingChart = false; ///< the chart is being told, its answers are no wishes
};
} // namespace ui
