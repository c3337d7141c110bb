// SPDX-License-Identifier: GPL-3.0-or-later
// A servo's memory table at one moment, and its file (*.servo.json): its identity, when and where,
// then one register a line in address order, so that text diff and version control work. raw is
// signed where the register is; value is the physical value in unit. What could not be read has
// neither. A plain value; any thread. Files of every published format version load for ever.
// Fails with FileMissing, FileUnreadable, FileFormat (detail has the place; also for a name that
// one object has twice), FileUnwritable, DiskFull.
#pragma once

#include "base/error.h"
#include "catalog/register.h"

#include <QDateTime>

#include <vector>

namespace snapshot {
struct SnapshotServo {
    int id = -1;
    QString model;    ///< "STS3215"
    QString modelId;  ///< "9.3"
    QString firmware; ///< "3.10"
    QString map;      ///< register map the keys and units come from: "sts-sms"
    QString protocol; ///< "feetech"
    bool operator==(const SnapshotServo&) const = default;
};

struct SnapshotRegister {
    QString key;
    int address = 0;
    std::optional<std::int64_t> raw{};
    std::optional<double> value{};
    QString unit{};
    catalog::Area area = catalog::Area::Eprom;
    catalog::Access access = catalog::Access::ReadOnly;
    bool operator==(const SnapshotRegister&) const = default;
};

struct Snapshot {
    QString program; ///< name and version of the program that wrote it
    QDateTime at;    ///< UTC, to the second
    QString label;   ///< the user's name for this servo
    QString note;
    QString port;
    int baud = 0;
    SnapshotServo servo;
    std::vector<SnapshotRegister> registers;
    /// Only chosen rows, for other servos (snapshot/snapshot_template.h): what is not in it is left
    /// alone and not "missing".
    bool isTemplate = false;

    const SnapshotRegister* find(const QString& key) const; ///< null: no such row
    bool operator==(const Snapshot&) const = default;
};

/// Stable: the same snapshot gives the same bytes, independent of the order of its registers.
QByteArray encodeSnapshot(const Snapshot& snapshot);
base::Result<Snapshot> decodeSnapshot(const QByteArray& text);

/// Replaces the file in one step: afterwards it is the old one or the new one, never half of one.
base::Result<void> saveSnapshot(const Snapshot& snapshot, const QString& path);
base::Result<Snapshot> loadSnapshot(const QString& path);

/// For spreadsheets: one line a register, the servo's own columns (id, model, firmware, map, time,
/// label) in each, so that several exports can be put together. UTF-8, decimal points, empty cells
/// for what is not known.
QByteArray encodeSnapshotCsv(const Snapshot& snapshot);
/// With a byte order mark.
base::Result<void> saveSnapshotCsv(const Snapshot& snapshot, const QString& path);
} // namespace snapshot
