// SPDX-License-Identifier: GPL-3.0-or-later
#include "text/write_text.h"

#include "text/notice_text.h"
#include "text/translate.h"

namespace text {
QString intentLabel(base::IntentKind kind, bool temporary, bool ownDefaults)
{
    using base::IntentKind;
    switch (kind) {
    case IntentKind::Write:
        return temporary ? translate("History", "temporary write") : translate("History", "write");
    case IntentKind::SetId:
        return translate("History", "set ID");
    case IntentKind::SetBaud:
        return translate("History", "set baud rate");
    case IntentKind::Mode:
        return translate("History", "change mode");
    case IntentKind::Calibrate:
        return translate("History", "set midpoint");
    case IntentKind::Restore:
        return ownDefaults ? translate("History", "reset to factory defaults")
                           : translate("History", "restore");
    case IntentKind::Identify:
        return translate("History", "blink LED");
    case IntentKind::Trial:
        return translate("History", "trial");
    case IntentKind::Undo:
        return translate("History", "undo");
    }
    return {};
}

QString writeOutcomeLabel(const QString& outcome)
{
    if (outcome.isEmpty())
        return translate("History", "unfinished"); // running or interrupted
    if (outcome == QLatin1StringView("done"))
        return translate("History", "done");
    if (outcome == QLatin1StringView("undone"))
        return translate("History", "undone");
    if (outcome == QLatin1StringView("failed"))
        return translate("History", "failed");
    if (outcome == QLatin1StringView("abandoned"))
        return translate("History", "abandoned");
    return outcomeLabel(outcome);
}
} // namespace text
