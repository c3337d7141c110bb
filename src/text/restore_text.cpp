// SPDX-License-Identifier: GPL-3.0-or-later
#include "text/restore_text.h"

#include "text/translate.h"

#include <array>

namespace text {
namespace {
struct Words {
    const char* name;
    const char* words;
    const char* help = nullptr;
};

constexpr std::array reasons{
    Words{"same", QT_TRANSLATE_NOOP("text", "the same"),
          QT_TRANSLATE_NOOP("text", "The servo has this value already; nothing is written.")},
    Words{"identity", QT_TRANSLATE_NOOP("text", "identity: off unless you ask"),
          QT_TRANSLATE_NOOP("text", "ID and baud rate make this servo this servo. Written on "
                                    "request only, at the very end.")},
    Words{"live", QT_TRANSLATE_NOOP("text", "of the moment: never restored"),
          QT_TRANSLATE_NOOP("text", "Torque, goals and the lock are saved for the record. Writing "
                                    "them back could turn the shaft.")},
    Words{"off-unless-asked", QT_TRANSLATE_NOOP("text", "lost at power-off: off unless you ask"),
          QT_TRANSLATE_NOOP("text", "The servo sets it anew each time it is switched on.")},
    Words{"moves-shaft", QT_TRANSLATE_NOOP("text", "shifts where the shaft's zero is"),
          QT_TRANSLATE_NOOP("text", "After writing it the same goal is another place: the shaft "
                                    "may turn at once or when torque goes on.")},
    Words{"read-only", QT_TRANSLATE_NOOP("text", "can only be read"),
          QT_TRANSLATE_NOOP("text", "Set by the factory or by the servo itself.")},
    Words{"factory", QT_TRANSLATE_NOOP("text", "factory value"),
          QT_TRANSLATE_NOOP("text", "It belongs to the values the factory has set for this very "
                                    "servo.")},
    Words{"needs-consent", QT_TRANSLATE_NOOP("text", "dangerous: needs your consent"),
          QT_TRANSLATE_NOOP("text", "It decides how the servo is addressed, protected or turns.")},
    Words{"no-such-register", QT_TRANSLATE_NOOP("text", "this servo has no such register"),
          QT_TRANSLATE_NOOP("text", "The file is of another model or firmware; this row cannot be "
                                    "written here.")},
    Words{"not-in-file", QT_TRANSLATE_NOOP("text", "not in the file"),
          QT_TRANSLATE_NOOP("text", "The file is of another model or firmware; this row stays as "
                                    "it is.")},
    Words{"no-value", QT_TRANSLATE_NOOP("text", "no value in the file"),
          QT_TRANSLATE_NOOP("text", "It could not be read when the file was made.")},
    Words{"not-read", QT_TRANSLATE_NOOP("text", "could not be read"),
          QT_TRANSLATE_NOOP("text", "What cannot be read cannot be proved, and is not written.")},
    Words{"outside-range", QT_TRANSLATE_NOOP("text", "outside this model's range"),
          QT_TRANSLATE_NOOP("text", "This servo does not take the value in the file.")},
    Words{"other-meaning", QT_TRANSLATE_NOOP("text", "means something else here"),
          QT_TRANSLATE_NOOP("text", "Unit or kind of number differ between the file's servo and "
                                    "this one.")},
    Words{"converted", QT_TRANSLATE_NOOP("text", "converted to this servo's steps"),
          QT_TRANSLATE_NOOP("text", "The same physical value; the raw number differs.")},
    Words{"plain-number", QT_TRANSLATE_NOOP("text", "a plain number of another family"),
          QT_TRANSLATE_NOOP("text", "Without a unit nobody can say that it means the same here. "
                                    "Off unless you ask.")},
    Words{"not-chosen", QT_TRANSLATE_NOOP("text", "not chosen"),
          QT_TRANSLATE_NOOP("text", "Only some rows were asked for.")},
    Words{"other-model-limit", QT_TRANSLATE_NOOP("text", "limit of another model"),
          QT_TRANSLATE_NOOP("text", "Limits of voltage, temperature, current and torque belong to "
                                    "a model. Off unless you select the row yourself.")},
    Words{"only-temporary", QT_TRANSLATE_NOOP("text", "not kept yet"),
          QT_TRANSLATE_NOOP("text", "The servo has this value, but by a temporary write that ends "
                                    "at power-off. It is written once more, to be kept.")},
    Words{"would-alarm", QT_TRANSLATE_NOOP("text", "would cause an alarm now"),
          QT_TRANSLATE_NOOP("text", "The present reading is outside this limit: the servo would "
                                    "be in an alarm as soon as it is written.")},
};

constexpr std::array steps{
    Words{"torque-off", QT_TRANSLATE_NOOP("text", "torque off; it stays off")},
    Words{"unlock", QT_TRANSLATE_NOOP("text", "open the lock")},
    Words{"write", QT_TRANSLATE_NOOP("text", "write and read back")},
    Words{"settle", QT_TRANSLATE_NOOP("text", "bring to rest in the new mode")},
    Words{"lock", QT_TRANSLATE_NOOP("text", "close the lock, prove it")},
    Words{"set-id", QT_TRANSLATE_NOOP("text", "change the ID")},
    Words{"set-baud", QT_TRANSLATE_NOOP("text", "change the baud rate")},
};

constexpr std::array verdicts{
    Words{"already-so", QT_TRANSLATE_NOOP("text", "nothing to write")},
    Words{"done", QT_TRANSLATE_NOOP("text", "restored")},
    Words{"failed", QT_TRANSLATE_NOOP("text", "failed")},
    Words{"rolled-back", QT_TRANSLATE_NOOP("text", "failed; everything is as before")},
    Words{"planned", QT_TRANSLATE_NOOP("text", "would be written")},
    Words{"no-answer", QT_TRANSLATE_NOOP("text", "no answer")},
    Words{"other-servo", QT_TRANSLATE_NOOP("text", "another servo; left alone")},
    Words{"error", QT_TRANSLATE_NOOP("text", "not possible")},
};

/// With the sign that stands beside the word.
constexpr std::array comparisons{
    Words{"different", QT_TRANSLATE_NOOP("text", "different"), "≠"},
    Words{"missing", QT_TRANSLATE_NOOP("text", "missing"), "–"},
    Words{"unknown", QT_TRANSLATE_NOOP("text", "unknown"), "?"},
    Words{"identical", QT_TRANSLATE_NOOP("text", "identical"), "="},
    Words{"read-only", QT_TRANSLATE_NOOP("text", "read-only"), "·"},
};

template <std::size_t Count>
const Words* find(const std::array<Words, Count>& list, const QString& name)
{
    for (const Words& entry : list) {
        if (name == QLatin1String(entry.name))
            return &entry;
    }
    return nullptr;
}

template <std::size_t Count>
QString textFor(const std::array<Words, Count>& list, const QString& name)
{
    const Words* entry = find(list, name);
    return entry != nullptr ? translate("text", entry->words) : name;
}
} // namespace

QString restoreReasonText(const QString& reason)
{
    return textFor(reasons, reason);
}

QString restoreReasonText(const QStringList& names)
{
    QStringList all;
    for (const QString& name : names)
        all << restoreReasonText(name);
    return all.join(translate("text", "; ", "between reasons"));
}

QString restoreReasonHelp(const QString& reason)
{
    const Words* entry = find(reasons, reason);
    return entry != nullptr ? translate("text", entry->help) : QString();
}

QString restoreAlarmText(const QString& fault, const QString& limit, const QString& reading)
{
    if (fault == QLatin1String("voltage"))
        return translate("text", "voltage alarm at once: limit %1, supply %2 now")
            .arg(limit, reading);
    if (fault == QLatin1String("temperature"))
        return translate("text", "temperature alarm at once: limit %1, servo %2 now")
            .arg(limit, reading);
    if (fault == QLatin1String("current"))
        return translate("text", "overcurrent alarm: limit %1, current %2 now").arg(limit, reading);
    return translate("text", "overload alarm: limit %1, load %2 now").arg(limit, reading);
}

QString restoreStepText(const QString& step)
{
    return textFor(steps, step);
}

QString restoreVerdictText(const QString& verdict)
{
    return textFor(verdicts, verdict);
}

QString compareVerdictText(const QString& verdict)
{
    return textFor(comparisons, verdict);
}

QString compareVerdictSymbol(const QString& verdict)
{
    const Words* entry = find(comparisons, verdict);
    return entry != nullptr ? QString::fromUtf8(entry->help) : QString();
}
} // namespace text
