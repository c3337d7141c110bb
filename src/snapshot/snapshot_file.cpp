// SPDX-License-Identifier: GPL-3.0-or-later
// Saves and loads snapshots; snapshot_json_reader.cpp encodes and decodes the text.
#include "files/text_file.h"
#include "snapshot/snapshot.h"

namespace snapshot {
namespace {
const QString saving = QStringLiteral("save-snapshot");
const QString loadSnapshotOperation = QStringLiteral("load-snapshot");
constexpr qint64 maxSnapshotFileSize = 4 * 1024 * 1024;
} // namespace

base::Result<void> saveSnapshot(const Snapshot& snapshot, const QString& path)
{
    return files::saveTextFile(saving, encodeSnapshot(snapshot), path);
}

base::Result<Snapshot> loadSnapshot(const QString& path)
{
    const auto text = files::readTextFile(loadSnapshotOperation, path, maxSnapshotFileSize);
    if (!text)
        return tl::unexpected(text.error());
    auto snapshot = decodeSnapshot(*text);
    if (!snapshot) {
        base::Error error = snapshot.error();
        error.detail = path + QStringLiteral(": ") + error.detail;
        return tl::unexpected(error);
    }
    return snapshot;
}
} // namespace snapshot
