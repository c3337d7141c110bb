// SPDX-License-Identifier: GPL-3.0-or-later
// What the gauges, the dial and the lights of the operate page show of one servo: scales and limits
// from its own registers, values only if they were really read, texts in the current language. Pure
// functions of an entry; main thread.
#pragma once

#include "session/link/link_controller.h"
#include "session/servos/servo_entry.h"
#include "ui/common/theme.h"
#include "ui/widgets/gauge.h"
#include "ui/widgets/position_dial.h"

#include <array>

namespace ui {
enum class Quantity : std::uint8_t { Voltage, Temperature, Load, Current, Speed };
inline constexpr std::array allQuantities{Quantity::Voltage, Quantity::Temperature, Quantity::Load,
                                          Quantity::Current, Quantity::Speed};

struct GaugeState {
    QString title;
    GaugeScale scale;
    std::optional<double> value; ///< none: not read
    QString caption;
    bool isMeasured = true; ///< false: this model has no such measurement
};
GaugeState gaugeState(const session::ServoEntry& entry, Quantity measure);

/// The registers the page reads of a servo as fast as it can, and those it looks at now and then.
QStringList feedbackKeys(const device::Servo& servo);
QStringList settingKeys(const device::Servo& servo);

/// Without the text of the turns and with a fixed goal: the operate page adds both.
DialState dialState(const session::ServoEntry& entry, bool fresh);

/// It answers, the port is open and the last answer is recent: what is shown is so now.
bool isFresh(const session::ServoEntry& entry, const session::LinkController& link,
             base::Duration now);

/// Goals are then what is left of an earlier move.
bool isTorqueOff(const session::ServoEntry& entry);

/// "过温": what a fault bit is called beside its light. `key` as the catalog names the bit.
QString faultText(const QString& key);

/// "12.3°", "30 rpm": a number with its unit, for labels.
QString withUnit(double value, const QString& unit, int decimals);
} // namespace ui
