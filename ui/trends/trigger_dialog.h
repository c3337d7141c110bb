// SPDX-License-Identifier: GPL-3.0-or-later
// The event that the chart waits for: a level or an edge of a curve, the moving flag, a fault, a
// write. Not modal; arming the trigger closes it. Deletes itself. Main thread.
#pragma once

#include "recording/trigger.h"
#include "ui/charts/trend_channel.h"

#include <QDialog>

class QComboBox;
class QDoubleSpinBox;
class QFormLayout;
class QPushButton;

namespace ui {
class TriggerDialog final : public QDialog {
    Q_OBJECT

public:
    /// `curves`: those with samples; `moving`: the channel of the moving flag, −1 if it has none.
    TriggerDialog(std::vector<TrendChannel> curves, recording::ChannelId moving,
                  const recording::TriggerSpec& before, QWidget* parent);

    recording::TriggerSpec spec() const;

Q_SIGNALS:
    void triggerArmed(const recording::TriggerSpec& spec);

private:
    enum class TriggerKind : std::uint8_t {
        Rising,
        Falling,
        Above,
        Below,
        MoveBegins,
        MoveEnds,
        Fault,
        Write,
        LinkError
    };
    void build();
    void buildForm();
    void setSpec(const recording::TriggerSpec& before);
    void refresh();
    void retranslate();
    TriggerKind triggerKind() const;
    bool isCurveTrigger() const;

    std::vector<TrendChannel> m_curves;
    recording::ChannelId m_moving;
    QFormLayout* m_form = nullptr;
    QComboBox* m_kind = nullptr;
    QComboBox* m_curve = nullptr;
    QDoubleSpinBox* m_level = nullptr;
    QDoubleSpinBox* m_hysteresis = nullptr;
    QDoubleSpinBox* m_pre = nullptr;
    QDoubleSpinBox* m_post = nullptr;
    QPushButton* m_arm = nullptr;
    QPushButton* m_cancel = nullptr;
};
} // namespace ui
