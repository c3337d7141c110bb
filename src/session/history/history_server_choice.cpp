// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/history/history_server_choice.h"

#include "history/server/server_address.h"

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
    choice.isFixedByEnvironment = !choice.address.isEmpty();
    if (!choice.isFixedByEnvironment)
        choice.address = settings.pageValue(serverKey, QString()).toString().trimmed();
    choice.bench = settings.pageValue(benchKey, QString()).toString().trimmed();
    if (choice.bench.isEmpty())
        choice.bench = QSysInfo::machineHostName();
    return choice;
}

base::Result<void> setHistoryServerChoice(Settings& settings, const HistoryServerChoice& choice)
{
    const QString address = choice.address.trimmed();
    if (!choice.isFixedByEnvironment) {
        const auto parsed = history::ServerAddress::parse(address);
        if (!address.isEmpty() && !parsed)
            return tl::unexpected(parsed.error());
        settings.setPageValue(serverKey, address);
    }
    settings.setPageValue(benchKey, choice.bench.trimmed() == QSysInfo::machineHostName()
                                        ? QString()
                                        : choice.bench.trimmed());
    return {};
}
} // namespace session
