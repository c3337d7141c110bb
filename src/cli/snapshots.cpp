// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/snapshots.h"

#include "jobs/snapshot.h"
#include "session/paths.h"

#include <QCoreApplication>
#include <QDir>

namespace cli {
base::Result<record::Snapshot> saveSnapshotOf(Run& run, device::Servo& servo, const QString& file)
{
    const auto context = run.context();
    if (!context)
        return tl::unexpected(context.error());
    const QString program = QStringLiteral("servodesk ") + QCoreApplication::applicationVersion();
    auto snapshot = jobs::takeSnapshot(*context, servo, program);
    if (!snapshot)
        return snapshot;
    if (const auto saved = record::saveSnapshot(*snapshot, file); !saved)
        return tl::unexpected(saved.error());
    return snapshot;
}

base::Result<QString> saveSafetySnapshot(Run& run, device::Servo& servo)
{
    const QDir folder(session::dataFolder() + QStringLiteral("/snapshots"));
    if (!folder.mkpath(QStringLiteral(".")))
        return base::fail(base::ErrorCode::FileUnwritable, QStringLiteral("snapshot"),
                          folder.path());
    const QString name =
        QStringLiteral("%1-id%2-%3.servo.json")
            .arg(servo.profile->modelName)
            .arg(servo.id)
            .arg(QDateTime::currentDateTimeUtc().toString(QStringLiteral("yyyyMMdd-HHmmss")));
    const QString path = folder.filePath(name);
    if (const auto saved = saveSnapshotOf(run, servo, path); !saved)
        return tl::unexpected(saved.error());
    return path;
}
} // namespace cli
