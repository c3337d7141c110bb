// SPDX-License-Identifier: GPL-3.0-or-later
// A firmware image of the vendor's, in the user's own file. It is opaque: its bytes are passed on
// as they are. What it is for can only be told by its name. A value; any thread. Errors:
// FileMissing, FileUnreadable, NotSupported ("firmware-kind", "firmware-size").
#pragma once

#include "base/bytes.h"

namespace jobs {
struct FirmwareFile {
    QString path;
    base::Bytes bytes;
};

base::Result<FirmwareFile> loadFirmwareFile(const QString& path);

/// What the vendor's names tell of a file; empty: nothing. "SCServo21-GD32-TTL-250306": line
/// "SCServo21", chip "GD32", bus "TTL". SCServo21 and SCServo2.20 are of two families.
struct FirmwareName {
    QString line;
    QString chip;
    QString bus;
    bool operator==(const FirmwareName&) const = default;
};
FirmwareName firmwareNameOf(const QString& path);
} // namespace jobs
