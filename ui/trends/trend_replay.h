// SPDX-License-Identifier: GPL-3.0-or-later
// Shows a recording in the trend chart instead of live readings. Reads the file in the background;
// what cannot be read is shown in the banner. The panel returns to live readings on closed().
// Owned by the trend panel; main thread, never waits.
#pragma once

#include "session/recording/replay.h"
#include "session/servos/servo_registry.h"
#include "ui/trends/trend_settings.h"

class QWidget;

namespace ui {
class Banner;
class ReplayBar;
class TrendChart;
class TrendToolbar;

class TrendReplay final : public QObject {
    Q_OBJECT

public:
    struct Views {
        TrendChart& chart;
        ReplayBar& bar;
        TrendToolbar& toolbar;
        Banner& banner;
    };
    TrendReplay(const session::ServoRegistry& registry, const TrendSettings& settings,
                const Views& views, QWidget* parent);

    bool isActive() const { return m_data != nullptr; }
    void open(); ///< asks for the file
    void load(const QString& path);
    void close();
    void togglePlaying();

Q_SIGNALS:
    void shown();
    /// The chart must take another store before this returns: its samples are deleted then.
    void closed();

private:
    void show(const std::shared_ptr<session::ReplayData>& recording);
    void showChannels();
    void showReport();
    void moveTo(base::Duration position);

    const session::ServoRegistry& m_registry;
    const TrendSettings& m_settings;
    Views m_views;
    QWidget* m_parent;
    session::Replay m_reader;
    std::shared_ptr<session::ReplayData> m_data;
};
} // namespace ui
