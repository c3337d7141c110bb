// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/paths.h"

#include <QStandardPaths>

namespace session {
QString dataFolder()
{
    const QString own = qEnvironmentVariable("SERVODESK_DATA_DIR");
    return own.isEmpty() ? QStandardPaths::writableLocation(QStandardPaths::AppDataLocation) : own;
}

QString historyFile()
{
    return dataFolder() + QStringLiteral("/history.sqlite");
}

QString modelFolder()
{
    return QStandardPaths::writableLocation(QStandardPaths::AppConfigLocation) +
           QStringLiteral("/models");
}
} // namespace session
