// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/commission_text.h"

#include "report/bilingual.h"
#include "text/text_table.h"

#include <array>

namespace report {
namespace {
using results::CommissionIssue;
using results::CommissionVerdict;
using text::NamedText;

/// %1: the detail
constexpr std::array issueTexts{
    NamedText{"not-writable",
              QT_TRANSLATE_NOOP("CommissionText", "no register map for %1, so nothing is written")},
    NamedText{"no-such-rate",
              QT_TRANSLATE_NOOP("CommissionText", "the servo does not support %1 baud")},
    NamedText{"no-such-id",
              QT_TRANSLATE_NOOP("CommissionText", "the servo does not support ID %1")},
    NamedText{"no-centring",
              QT_TRANSLATE_NOOP("CommissionText", "%1 servos have no command to set the midpoint")},
    NamedText{"other-model",
              QT_TRANSLATE_NOOP("CommissionText", "the template is for a different model: %1")},
    NamedText{"rows-left", QT_TRANSLATE_NOOP("CommissionText", "template rows not written: %1")},
    NamedText{"other-id",
              QT_TRANSLATE_NOOP("CommissionText", "its ID is %1, not the factory default")},
    NamedText{"no-id-left", QT_TRANSLATE_NOOP("CommissionText", "no ID is left to assign")},
    NamedText{"already-done", QT_TRANSLATE_NOOP("CommissionText", "it is already set up")},
    NamedText{"by-hand", QT_TRANSLATE_NOOP("CommissionText", "set aside manually")},
    NamedText{
        "label-not-kept",
        QT_TRANSLATE_NOOP("CommissionText", "its label could not be saved to the history (%1)")},
    NamedText{"rate-after-restart",
              QT_TRANSLATE_NOOP("CommissionText", "%1 baud takes effect only after a reboot")},
    NamedText{"rate-differs",
              QT_TRANSLATE_NOOP("CommissionText", "its baud rate register is set to %1")},
    NamedText{"torque-was-on",
              QT_TRANSLATE_NOOP("CommissionText", "torque was on; it has been turned off")},
    NamedText{"row-mismatch", QT_TRANSLATE_NOOP("CommissionText", "%1 differs when read back")},
    NamedText{"row-refused", QT_TRANSLATE_NOOP("CommissionText", "the write to %1 was refused")},
    NamedText{"row-not-sent", QT_TRANSLATE_NOOP("CommissionText", "the write to %1 was not sent")},
    NamedText{"row-no-answer", QT_TRANSLATE_NOOP("CommissionText", "no reply while writing %1")},
    NamedText{"row-unknown",
              QT_TRANSLATE_NOOP("CommissionText", "the result of writing %1 is unknown")},
    NamedText{"no-answer", QT_TRANSLATE_NOOP("CommissionText", "the servo did not reply")},
    NamedText{"garbled", QT_TRANSLATE_NOOP("CommissionText", "its replies could not be decoded")},
    NamedText{"id-in-use",
              QT_TRANSLATE_NOOP("CommissionText",
                                "the ID is already in use by another servo on the bus")},
    NamedText{"several-servos",
              QT_TRANSLATE_NOOP("CommissionText", "two servos reply with this ID")},
    NamedText{"family-unclear",
              QT_TRANSLATE_NOOP("CommissionText", "its family is unclear, so nothing is written")},
    NamedText{"unknown-model", QT_TRANSLATE_NOOP("CommissionText",
                                                 "its firmware is unknown, so nothing is written")},
    NamedText{"mismatch", QT_TRANSLATE_NOOP("CommissionText", "%1 does not match the template")},
    NamedText{"wrong-answer",
              QT_TRANSLATE_NOOP("CommissionText", "its replies did not match the requests")},
    NamedText{"line-busy", QT_TRANSLATE_NOOP("CommissionText", "the bus was never idle")},
    NamedText{"refused", QT_TRANSLATE_NOOP("CommissionText", "the servo did not accept the write")},
    NamedText{"lock-open",
              QT_TRANSLATE_NOOP("CommissionText", "the EPROM lock could not be confirmed")},
    NamedText{"identity-differs",
              QT_TRANSLATE_NOOP("CommissionText", "a different servo is replying now: %1")},
    NamedText{"out-of-range", QT_TRANSLATE_NOOP("CommissionText", "the value is out of range: %1")},
    NamedText{"not-supported", QT_TRANSLATE_NOOP("CommissionText", "not supported: %1")},
    NamedText{"unfinished-id",
              QT_TRANSLATE_NOOP("CommissionText", "the servo that is still unfinished has ID %1")},
    NamedText{
        "unfinished-ids",
        QT_TRANSLATE_NOOP("CommissionText",
                          "the servo whose setup was not finished may have one of these IDs: %1")},
    NamedText{
        "unfinished-lock",
        QT_TRANSLATE_NOOP("CommissionText",
                          "its EPROM was unlocked, and the EPROM lock could not be confirmed")},
    NamedText{"uncertain", QT_TRANSLATE_NOOP("CommissionText", "the result of a write is unknown")},
};

constexpr std::array alarmTexts{
    NamedText{"voltage", QT_TRANSLATE_NOOP("CommissionText", "voltage alarm")},
    NamedText{"temperature", QT_TRANSLATE_NOOP("CommissionText", "temperature alarm")},
    NamedText{"overload", QT_TRANSLATE_NOOP("CommissionText", "overload alarm")},
    NamedText{"current", QT_TRANSLATE_NOOP("CommissionText", "overcurrent alarm")},
    NamedText{"sensor", QT_TRANSLATE_NOOP("CommissionText", "sensor alarm")},
};

Text withDetail(Text text, const QString& detail)
{
    for (QString* half : {&text.en, &text.zh}) {
        if (half->contains(QLatin1String("%1")))
            *half = half->arg(detail);
    }
    return text;
}

struct VerdictText {
    CommissionVerdict key;
    const char* text;
    const char* sign;
};
constexpr std::array verdictTexts{
    VerdictText{CommissionVerdict::Good, QT_TRANSLATE_NOOP("CommissionText", "Good"), "✔"},
    VerdictText{CommissionVerdict::Remark, QT_TRANSLATE_NOOP("CommissionText", "Done, see remarks"),
                "▲"},
    VerdictText{CommissionVerdict::Failed, QT_TRANSLATE_NOOP("CommissionText", "Failed"), "✖"},
    VerdictText{CommissionVerdict::Skipped, QT_TRANSLATE_NOOP("CommissionText", "Set aside"), "–"},
};

const VerdictText& entryOf(CommissionVerdict verdict)
{
    const VerdictText* entry = text::entryFor(verdictTexts, verdict);
    return entry != nullptr ? *entry : verdictTexts.front();
}
} // namespace

Text commissionIssueText(const CommissionIssue& issue)
{
    if (issue.word == QLatin1String("alarm")) {
        const NamedText* alarm = text::entryFor(alarmTexts, issue.detail);
        return alarm != nullptr
                   ? translate("CommissionText", alarm->text)
                   : withDetail(translate("CommissionText", "alarm: %1"), issue.detail);
    }
    if (const NamedText* entry = text::entryFor(issueTexts, issue.word))
        return withDetail(translate("CommissionText", entry->text), issue.detail);
    const QString plain = issue.detail.isEmpty()
                              ? issue.word
                              : QStringLiteral("%1 (%2)").arg(issue.word, issue.detail);
    return inBoth(plain);
}

Text commissionIssuesText(const std::vector<CommissionIssue>& issues)
{
    QStringList english;
    QStringList chinese;
    for (const CommissionIssue& issue : issues) {
        const Text words = commissionIssueText(issue);
        english.append(words.en);
        chinese.append(words.zh);
    }
    return {english.join(QStringLiteral("; ")), chinese.join(QStringLiteral("；"))};
}

Text commissionVerdictText(CommissionVerdict verdict)
{
    return translate("CommissionText", entryOf(verdict).text);
}

QString commissionVerdictSign(CommissionVerdict verdict)
{
    return QString::fromUtf8(entryOf(verdict).sign);
}
} // namespace report
