// SPDX-License-Identifier: GPL-3.0-or-later
#include "text/alarm_text.h"

#include "text/text_table.h"

#include <array>

namespace text {
namespace {
struct AlarmEntry {
    const char* key;
    const char* text;
    const char* cause;
};

// Source: the fault table of the data sheets, rows 15–19, in our own words.
constexpr std::array alarms{
    AlarmEntry{"overload", QT_TRANSLATE_NOOP("text", "overload"),
               QT_TRANSLATE_NOOP("text",
                                 "The load was above its threshold for too long. Possible causes: "
                                 "a stall, a jammed bracket, or more load than the servo is rated "
                                 "for. The servo now provides only the protection torque.")},
    AlarmEntry{"current", QT_TRANSLATE_NOOP("text", "overcurrent"),
               QT_TRANSLATE_NOOP(
                   "text", "The current was above its threshold for too long. Possible causes: a "
                           "stall or a short circuit. The servo has turned its torque off.")},
    AlarmEntry{"voltage", QT_TRANSLATE_NOOP("text", "voltage"),
               QT_TRANSLATE_NOOP("text",
                                 "The supply voltage is outside the servo's limits. Possible "
                                 "causes: the wrong power supply, a power supply that is too "
                                 "weak, or thin wires that cause a voltage drop under load.")},
    AlarmEntry{"temperature", QT_TRANSLATE_NOOP("text", "temperature"),
               QT_TRANSLATE_NOOP("text",
                                 "The servo has exceeded its temperature limit. Possible causes: "
                                 "a prolonged load, a stall, poor cooling, or a limit that is set "
                                 "too low. Remove the load and let the servo cool down.")},
    AlarmEntry{"sensor", QT_TRANSLATE_NOOP("text", "sensor"),
               QT_TRANSLATE_NOOP("text",
                                 "The magnet, the encoder or a cable inside the servo is "
                                 "faulty. If the alarm returns after a power cycle, the servo "
                                 "needs repair.")},
};

constexpr std::array releases{
    NamedText{"nothing", QT_TRANSLATE_NOOP("text", "No alarms.")},
    NamedText{"turn-back",
              QT_TRANSLATE_NOOP(
                  "text", "Setting a goal slightly back from the stalled position clears this "
                          "alarm: the shaft turns back a little and holds that position.")},
    NamedText{"new-goal",
              QT_TRANSLATE_NOOP("text",
                                "Setting a new goal at the present position clears this alarm: "
                                "torque is turned on, and the servo holds that position.")},
    NamedText{"fault-reset",
              QT_TRANSLATE_NOOP("text", "Writing to the fault reset register clears this alarm. "
                                        "The servo is first set to hold its position.")},
    NamedText{
        "wait",
        QT_TRANSLATE_NOOP(
            "text",
            "This alarm clears when the value is back within its limits. Nothing is written.")},
    NamedText{"power-cycle",
              QT_TRANSLATE_NOOP("text", "Only turning the servo off and on clears this alarm.")},
    NamedText{"unknown",
              QT_TRANSLATE_NOOP("text", "The meaning of this status bit is not documented. "
                                        "Try turning the servo off and on.")},
};
} // namespace

QString alarmLabel(const QString& key)
{
    return textFor(alarms, key);
}

QString alarmCause(const QString& key)
{
    const AlarmEntry* entry = entryFor(alarms, key);
    return entry != nullptr ? translate("text", entry->cause) : QString();
}

QString releaseText(const QString& release)
{
    const NamedText* entry = entryFor(releases, release);
    return entry != nullptr ? translate("text", entry->text) : QString();
}
} // namespace text
