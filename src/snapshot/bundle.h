// SPDX-License-Identifier: GPL-3.0-or-later
// All servos of a bus in one file (*.bundle.json): the snapshots as they would stand in files of
// their own, one register a line. A plain value; any thread. Files of every published format
// version load for ever. Fails as snapshots do; an ID that is there twice in one language is
// FileFormat.
#pragma once

#include "snapshot/snapshot.h"

namespace snapshot {
struct Bundle {
    QString program;
    QDateTime at; ///< UTC, to the second
    QString label;
    QString note;
    QString port;
    std::vector<Snapshot> servos; ///< by ID
    bool operator==(const Bundle&) const = default;
};

QByteArray encodeBundle(const Bundle& bundle);
base::Result<Bundle> decodeBundle(const QByteArray& text);

base::Result<void> saveBundle(const Bundle& bundle, const QString& path);
base::Result<Bundle> loadBundle(const QString& path);
} // namespace snapshot
