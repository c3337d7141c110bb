// SPDX-License-Identifier: GPL-3.0-or-later
// Sets and cancels the trigger of the live readings, shows its state in the toolbar, and shows the
// chart around the moment when it fired. Owned by the trend panel; main thread.
#pragma once

#include "session/recording/live_data.h"
#include "ui/common/selection.h"

class QWidget;

namespace ui {
class TrendChart;
class TrendReplay;
class TrendToolbar;

class TriggerControl final : public QObject {
    Q_OBJECT

public:
    struct Views {
        TrendChart& chart;
        TrendToolbar& toolbar;
        const TrendReplay& replay; ///< a recording that is shown stays in the chart
    };
    TriggerControl(const session::ServoRegistry& registry, session::LiveData& liveData,
                   const Selection& selection, const Views& views, QWidget* parent);

    /// Asks for the condition; cancels a trigger that is waiting.
    void choose();
    void retranslate();

private:
    void arm(const recording::TriggerSpec& spec);
    void showTrigger();
    recording::ChannelId movingChannel() const;

    const session::ServoRegistry& m_registry;
    session::LiveData& m_liveData;
    const Selection& m_selection;
    Views m_views;
    QWidget* m_parent;
};
} // namespace ui
