// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/history_server_choice.h"

#include <QSysInfo>

namespace session {
namespace {
const QString serverKey = QStringLiteral("history/server");
const QString benchKey = QStringLiteral("history/bench");
} // namespace

HistoryServerChoice historyServerChoice(const Settings& settings)
{
    HistoryServerChoice choice;
    choice.address = qEnvironmentVariable("SERVODESK_HISTORY_SERVER").trimmed();
    choice.fixed = !choice.address.isEmpty();
    if (!choice.fixed)
        choice.address = settings.choice(serverKey, QString()).toString().trimmed();
    choice.bench = settings.choice(benchKey, QString()).toString().trimmed();
    if (choice.bench.isEmpty())
        choice.bench = QSysInfo::machineHostName();
    return choice;
}

void setHistoryServerChoice(Settings& settings, const HistoryServerChoice& choice)
{
    settings.setChoice(serverKey, choice.address.trimmed());
    settings.setChoice(benchKey, choice.bench.trimmed() == QSysInfo::machineHostName()
                                     ? QString()
                                     : choice.bench.trimmed());
}
} // namespace session
