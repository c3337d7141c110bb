// SPDX-License-Identifier: GPL-3.0-or-later
// Starts and stops the recording of live readings, and shows its progress in the toolbar and its
// result in the banner. What fails before it begins is shown in the dialog. Owned by the trend
// panel; main thread, never waits.
#pragma once

#include "session/recording/live_recording.h"
#include "session/settings.h"

#include <QPointer>

class QWidget;

namespace ui {
class Banner;
class RecordDialog;
class TrendChart;
class TrendToolbar;
struct RecordRequest;

class RecordingControl final : public QObject {
    Q_OBJECT

public:
    struct Views {
        const TrendChart& chart; ///< its visible curves can be what is recorded
        TrendToolbar& toolbar;
        Banner& banner;
    };
    RecordingControl(session::LiveRecording& recording, session::Settings& settings,
                     const Views& views, QWidget* parent);

    void toggle();
    void retranslate() { showProgress(); }

private:
    void start(const RecordRequest& request);
    void showFailure(const base::Error& error);
    void showProgress();
    void showResult(const recording::RecorderStatus& status, const QString& path);

    session::LiveRecording& m_recording;
    session::Settings& m_settings;
    Views m_views;
    QWidget* m_parent;
    QPointer<RecordDialog> m_dialog;
};
} // namespace ui
