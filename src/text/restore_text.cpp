// SPDX-License-Identifier: GPL-3.0-or-later
#include "text/restore_text.h"

#include "text/language.h"
#include "text/text_table.h"

#include <array>

namespace text {
namespace {
struct ReasonText {
    const char* key;
    const char* text;
    const char* help;
};

constexpr std::array reasons{
    ReasonText{"same", QT_TRANSLATE_NOOP("text", "unchanged"),
               QT_TRANSLATE_NOOP("text", "The servo already has this value; nothing is written.")},
    ReasonText{"identity", QT_TRANSLATE_NOOP("text", "identity: not written by default"),
               QT_TRANSLATE_NOOP("text", "The ID and baud rate identify the servo. They are "
                                         "written only on request, as the last step.")},
    ReasonText{"live", QT_TRANSLATE_NOOP("text", "live value: never restored"),
               QT_TRANSLATE_NOOP("text", "Torque, goals and the lock are saved for reference only, "
                                         "because writing them back could turn the shaft.")},
    ReasonText{"off-unless-asked",
               QT_TRANSLATE_NOOP("text", "lost at power-off: not written by "
                                         "default"),
               QT_TRANSLATE_NOOP("text", "The servo resets this value at each power-on.")},
    ReasonText{"moves-shaft", QT_TRANSLATE_NOOP("text", "shifts the zero position of the shaft"),
               QT_TRANSLATE_NOOP("text",
                                 "After the write, the same goal means a different position: the "
                                 "shaft may turn immediately or when torque is turned on.")},
    ReasonText{"read-only", QT_TRANSLATE_NOOP("text", "read-only"),
               QT_TRANSLATE_NOOP("text", "Set by the factory or by the servo itself.")},
    ReasonText{
        "factory", QT_TRANSLATE_NOOP("text", "factory value"),
        QT_TRANSLATE_NOOP("text", "This value was set at the factory for this individual servo.")},
    ReasonText{"needs-consent", QT_TRANSLATE_NOOP("text", "dangerous: requires confirmation"),
               QT_TRANSLATE_NOOP("text", "This register affects the servo's communication, "
                                         "protection or direction of rotation.")},
    ReasonText{
        "no-such-register", QT_TRANSLATE_NOOP("text", "this servo has no such register"),
        QT_TRANSLATE_NOOP(
            "text",
            "The file is from a different model or firmware version; this row cannot be written.")},
    ReasonText{
        "not-in-file", QT_TRANSLATE_NOOP("text", "not in the file"),
        QT_TRANSLATE_NOOP(
            "text",
            "The file is from a different model or firmware version; this row stays unchanged.")},
    ReasonText{"no-value", QT_TRANSLATE_NOOP("text", "no value in the file"),
               QT_TRANSLATE_NOOP("text", "The value could not be read when the file was saved.")},
    ReasonText{"not-read", QT_TRANSLATE_NOOP("text", "could not be read"),
               QT_TRANSLATE_NOOP("text",
                                 "A value that cannot be read back cannot be verified, so it "
                                 "is not written.")},
    ReasonText{"outside-range", QT_TRANSLATE_NOOP("text", "outside this model's range"),
               QT_TRANSLATE_NOOP("text", "This servo does not accept the value in the file.")},
    ReasonText{
        "other-meaning", QT_TRANSLATE_NOOP("text", "different meaning on this servo"),
        QT_TRANSLATE_NOOP(
            "text", "The unit or number format in the file differs from that of this servo.")},
    ReasonText{
        "converted", QT_TRANSLATE_NOOP("text", "converted to this servo's steps"),
        QT_TRANSLATE_NOOP("text", "The physical value is the same; only the raw number differs.")},
    ReasonText{"plain-number", QT_TRANSLATE_NOOP("text", "unitless number from another family"),
               QT_TRANSLATE_NOOP("text", "Without a unit, the number may have a different meaning "
                                         "on this servo. It is not written by default.")},
    ReasonText{"not-chosen", QT_TRANSLATE_NOOP("text", "not selected"),
               QT_TRANSLATE_NOOP("text", "The request did not include this row.")},
    ReasonText{"other-model-limit", QT_TRANSLATE_NOOP("text", "limit from a different model"),
               QT_TRANSLATE_NOOP("text",
                                 "Voltage, temperature, current and torque limits depend on the "
                                 "model. Each is written only if you select its row.")},
    ReasonText{"only-temporary", QT_TRANSLATE_NOOP("text", "not permanent yet"),
               QT_TRANSLATE_NOOP("text",
                                 "This value was written only temporarily and would be lost at "
                                 "power-off. It will be written again, this time permanently.")},
    ReasonText{"would-alarm", QT_TRANSLATE_NOOP("text", "would cause an alarm now"),
               QT_TRANSLATE_NOOP("text", "The present reading is outside this limit: the servo "
                                         "would report an alarm as soon as the limit is written.")},
};

constexpr std::array steps{
    NamedText{"torque-off", QT_TRANSLATE_NOOP("text", "turn torque off and leave it off")},
    NamedText{"unlock", QT_TRANSLATE_NOOP("text", "unlock the EPROM")},
    NamedText{"write", QT_TRANSLATE_NOOP("text", "write and read back")},
    NamedText{"settle", QT_TRANSLATE_NOOP("text", "stop in the new mode")},
    NamedText{"lock", QT_TRANSLATE_NOOP("text", "lock the EPROM and verify the lock")},
    NamedText{"set-id", QT_TRANSLATE_NOOP("text", "change the ID")},
    NamedText{"set-baud", QT_TRANSLATE_NOOP("text", "change the baud rate")},
};

constexpr std::array verdicts{
    NamedText{"already-so", QT_TRANSLATE_NOOP("text", "nothing to write")},
    NamedText{"done", QT_TRANSLATE_NOOP("text", "restored")},
    NamedText{"failed", QT_TRANSLATE_NOOP("text", "failed")},
    NamedText{"rolled-back", QT_TRANSLATE_NOOP("text", "failed; everything is unchanged")},
    NamedText{"planned", QT_TRANSLATE_NOOP("text", "would be written")},
    NamedText{"no-answer", QT_TRANSLATE_NOOP("text", "no reply")},
    NamedText{"other-servo", QT_TRANSLATE_NOOP("text", "different servo; not changed")},
    NamedText{"error", QT_TRANSLATE_NOOP("text", "not possible")},
};

struct ComparisonText {
    const char* key;
    const char* text;
    const char* symbol;
};

constexpr std::array comparisons{
    ComparisonText{"different", QT_TRANSLATE_NOOP("text", "different"), "≠"},
    ComparisonText{"missing", QT_TRANSLATE_NOOP("text", "missing"), "–"},
    ComparisonText{"unknown", QT_TRANSLATE_NOOP("text", "unknown"), "?"},
    ComparisonText{"identical", QT_TRANSLATE_NOOP("text", "identical"), "="},
    ComparisonText{"read-only", QT_TRANSLATE_NOOP("text", "read-only"), "·"},
};

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
    return joinClauses(all);
}

QString restoreReasonHelp(const QString& reason)
{
    const auto* entry = entryFor(reasons, reason);
    return entry != nullptr ? translate("text", entry->help) : QString();
}

QString restoreAlarmText(const QString& fault, const QString& limit, const QString& reading)
{
    if (fault == QLatin1String("voltage"))
        return translate("text", "would cause a voltage alarm now: limit %1, present voltage %2")
            .arg(limit, reading);
    if (fault == QLatin1String("temperature"))
        return translate("text",
                         "would cause a temperature alarm now: limit %1, present temperature %2")
            .arg(limit, reading);
    if (fault == QLatin1String("current"))
        return translate("text",
                         "would cause an overcurrent alarm now: limit %1, present current %2")
            .arg(limit, reading);
    return translate("text", "would cause an overload alarm now: limit %1, present load %2")
        .arg(limit, reading);
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
    const auto* entry = entryFor(comparisons, verdict);
    return entry != nullptr ? QString::fromUtf8(entry->symbol) : QString();
}
} // namespace text
