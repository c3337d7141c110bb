// SPDX-License-Identifier: GPL-3.0-or-later
// A data folder of the test's own as long as this lives: journal and saved tables of the user stay
// untouched, with any environment. Make it before the session.
#pragma once

#include <QTemporaryDir>

namespace support {
struct TemporaryDataFolder {
    TemporaryDataFolder() { qputenv("SERVODESK_DATA_DIR", folder.path().toLocal8Bit()); }
    QString path() const { return folder.path(); }
    QTemporaryDir folder;
};
} // namespace support
