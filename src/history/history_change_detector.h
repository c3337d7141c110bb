// SPDX-License-Identifier: GPL-3.0-or-later
// Whether other connections have changed the history file, asked now and then. Keeps a connection
// of its own without holding a lock between two questions, and opens another one when the file was
// replaced. Makes no file. The thread that asks first.
#pragma once

#include "files/file_handle.h"
#include "history/history_file.h"

namespace history {
class HistoryChangeDetector {
public:
    explicit HistoryChangeDetector(QString path)
        : m_path(std::move(path))
    {}

    /// True: something was committed since the last call, or the file can be read again. The first
    /// call after construction or close() answers false.
    bool hasChanged();
    void close();

private:
    std::optional<qint64> version();
    bool open();

    const QString m_path;
    std::unique_ptr<HistoryFile> m_file;
    files::FileId m_fileId{}; ///< of the open file
    std::optional<qint64> m_version;
    bool m_lost = false; ///< it could not be read since the last answer
};
} // namespace history
