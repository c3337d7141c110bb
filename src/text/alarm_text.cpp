// SPDX-License-Identifier: GPL-3.0-or-later
#include "text/alarm_text.h"

#include "text/translate.h"

#include <array>

namespace text {
namespace {
struct AlarmEntry {
    const char* key;
    const char* word;
    const char* cause;
};

// Source: fault table of the sheets, rows 15–19, in words of our own.
constexpr std::array alarms{
    AlarmEntry{"overload", QT_TRANSLATE_NOOP("text", "overload"),
               QT_TRANSLATE_NOOP("text",
                                 "The load was above its threshold for too long: a stall, a jammed "
                                 "bracket, or more torque than the servo is rated for. Only the "
                                 "protection torque is left.")},
    AlarmEntry{"current", QT_TRANSLATE_NOOP("text", "overcurrent"),
               QT_TRANSLATE_NOOP("text",
                                 "The current was above its threshold for too long: a stall or a "
                                 "short circuit. The servo has switched its torque off.")},
    AlarmEntry{"voltage", QT_TRANSLATE_NOOP("text", "voltage"),
               QT_TRANSLATE_NOOP("text",
                                 "The supply is outside the servo's limits: the wrong supply, one "
                                 "that is too small, or thin leads that drop under load.")},
    AlarmEntry{"temperature", QT_TRANSLATE_NOOP("text", "temperature"),
               QT_TRANSLATE_NOOP("text",
                                 "The servo is too hot: a long load, a stall, poor cooling, or a "
                                 "limit set low. Take the load off and let it cool.")},
    AlarmEntry{"sensor", QT_TRANSLATE_NOOP("text", "encoder"),
               QT_TRANSLATE_NOOP("text",
                                 "The magnet, the encoder or a cable inside the servo is at fault. "
                                 "If the alarm returns after a power-cycle, the servo needs "
                                 "repair.")},
};

struct ReleaseEntry {
    const char* name;
    const char* words;
};

constexpr std::array releases{
    ReleaseEntry{"nothing", QT_TRANSLATE_NOOP("text", "There is no alarm.")},
    ReleaseEntry{"turn-back",
                 QT_TRANSLATE_NOOP("text", "A small goal away from the stall releases it: the "
                                           "shaft turns back a little and is held there.")},
    ReleaseEntry{"new-goal",
                 QT_TRANSLATE_NOOP("text", "A new goal releases it: its present place. Torque is "
                                           "switched on and holds there.")},
    ReleaseEntry{"fault-reset",
                 QT_TRANSLATE_NOOP("text", "The fault reset register clears it. The servo is told "
                                           "to hold where it is first.")},
    ReleaseEntry{"wait",
                 QT_TRANSLATE_NOOP("text", "It passes by itself when the value is back within its "
                                           "limits. Nothing is written.")},
    ReleaseEntry{"power-cycle",
                 QT_TRANSLATE_NOOP("text", "Only switching the servo off and on clears it.")},
    ReleaseEntry{"unknown",
                 QT_TRANSLATE_NOOP("text", "Nobody documents what this status bit means. Try "
                                           "switching the servo off and on.")},
};

const AlarmEntry* alarmFor(const QString& key)
{
    for (const AlarmEntry& entry : alarms) {
        if (key == QLatin1String(entry.key))
            return &entry;
    }
    return nullptr;
}
} // namespace

QString alarmLabel(const QString& key)
{
    const AlarmEntry* entry = alarmFor(key);
    return entry != nullptr ? translate("text", entry->word) : key;
}

QString alarmCause(const QString& key)
{
    const AlarmEntry* entry = alarmFor(key);
    return entry != nullptr ? translate("text", entry->cause) : QString();
}

QString releaseText(const QString& release)
{
    for (const ReleaseEntry& entry : releases) {
        if (release == QLatin1String(entry.name))
            return translate("text", entry.words);
    }
    return {};
}
} // namespace text
