// SPDX-License-Identifier: GPL-3.0-or-later
// Saves what the trend chart shows as a picture or a table, and shows the result in the banner.
// Owned by the trend panel; main thread, never waits: a table is written by a thread of its own.
#pragma once

#include "base/job_thread.h"

#include <QObject>

#include <atomic>

class QWidget;

namespace session {
class Settings;
}

namespace ui {
class Banner;
class TrendChart;

class ExportControl final : public QObject {
    Q_OBJECT

public:
    ExportControl(TrendChart& chart, Banner& banner, session::Settings& settings, QWidget* parent);
    ~ExportControl() override; ///< a table that is being written is given up

    void choose(); ///< asks for the file; its suffix is the format

private:
    void save(const QString& path);
    void saveTable(const QString& path);
    void showResult(const QString& path, const QString& error); ///< empty: saved

    TrendChart& m_chart;
    Banner& m_banner;
    session::Settings& m_settings;
    QWidget* m_parent;
    std::atomic_bool m_stop = false;
    base::JobThread m_thread; ///< last: its job uses this
};
} // namespace ui
