// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/snapshot/safety_snapshot.h"

#include "device/write_access.h"
#include "history/history.h"
#include "jobs/restore/take_snapshot.h"
#include "session/paths.h"

#include <QCoreApplication>
#include <QDir>
#include <QRegularExpression>

namespace session {
namespace {
/// A user's own model may be called anything; a file may not.
QString fileNamePart(const QString& name)
{
    static const QRegularExpression others(QStringLiteral("[^A-Za-z0-9._-]"));
    return QString(name).replace(others, QStringLiteral("_"));
}

QString newFile(const QDir& folder, const device::Servo& servo)
{
    const QString stem =
        QStringLiteral("%1-id%2-%3")
            .arg(fileNamePart(servo.profile->modelName))
            .arg(servo.id)
            .arg(QDateTime::currentDateTimeUtc().toString(QStringLiteral("yyyyMMdd-HHmmss")));
    QString name = stem + QStringLiteral(".servo.json");
    for (int n = 2; folder.exists(name); ++n)
        name = QStringLiteral("%1-%2.servo.json").arg(stem).arg(n);
    return folder.filePath(name);
}
} // namespace

QString programName()
{
    return QStringLiteral("servodesk ") + QCoreApplication::applicationVersion();
}

base::Result<QString> saveSafetySnapshot(const device::Context& context, device::Servo& servo,
                                         history::SnapshotReason reason)
{
    // A write that is refused has nothing to be saved from.
    const auto may = device::beginWriting(context, servo, QStringLiteral("write"));
    if (!may)
        return tl::unexpected(may.error());
    const QDir folder(dataFolder() + QStringLiteral("/snapshots"));
    if (!folder.mkpath(QStringLiteral(".")))
        return base::fail(base::ErrorCode::FileUnwritable, QStringLiteral("snapshot"),
                          folder.path());
    auto snapshot = jobs::takeSnapshot(context, servo, programName());
    if (!snapshot)
        return tl::unexpected(snapshot.error());
    // A history that cannot be used refuses the write itself; the file is worth having all the
    // same.
    const auto history = history::History::open(historyFile());
    if (history) {
        const auto known = (*history)->log().of(servo.identity());
        if (known && *known)
            snapshot->label = (*known)->label;
    }
    const QString path = newFile(folder, servo);
    if (const auto saved = snapshot::saveSnapshot(*snapshot, path); !saved)
        return tl::unexpected(saved.error());
    if (history)
        (void)(*history)->log().addSnapshot(*snapshot, reason, path);
    return path;
}

void removeSafetySnapshot(const QString& path)
{
    QFile::remove(path);
    const auto history = history::History::open(historyFile());
    if (!history)
        return;
    history::HistoryFilter latest;
    latest.limit = 10;
    const auto rows = (*history)->log().snapshots(latest);
    for (const history::HistorySnapshot& row :
         rows ? *rows : std::vector<history::HistorySnapshot>()) {
        if (row.file == path)
            (void)(*history)->log().removeSnapshot(row.number);
    }
}

void addToHistory(const snapshot::Snapshot& snapshot, history::SnapshotReason reason,
                  const QString& file)
{
    if (const auto history = history::History::open(historyFile()))
        (void)(*history)->log().addSnapshot(snapshot, reason, file);
}
} // namespace session
