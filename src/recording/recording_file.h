// SPDX-License-Identifier: GPL-3.0-or-later
// The file a recording is written to. After any failure it ends with a whole line; no byte is
// counted that is not in it. Owned by the recorder's thread. Fails with FileUnwritable (also when
// the file is no longer there under its name) or DiskFull, and is of no use after that.
#pragma once

#include "base/error.h"
#include "files/file_handle.h"

#include <string>

namespace recording {
/// Whole lines, and where in the text those end that are rows.
struct RecordingBlock {
    std::string text;
    std::vector<std::size_t> rowEnds;
    void clear();
};

class RecordingFile {
public:
    /// Replaces what is in the file.
    static base::Result<std::unique_ptr<RecordingFile>> create(const QString& path,
                                                               const std::string& head);

    base::Result<void> append(const RecordingBlock& block);
    /// To the disk; and notices a file or folder that is gone.
    base::Result<void> flush();

    std::uint64_t bytes() const { return m_size; }
    std::uint64_t rows() const { return m_rows; }

private:
    explicit RecordingFile(const QString& path);
    base::Error lastError() const;
    base::Result<void> checkFile() const;
    void truncateToWholeLines(const RecordingBlock& block);

    QString m_path;
    files::FileHandle m_file;
    files::FileId m_fileId;
    std::uint64_t m_size = 0;
    std::uint64_t m_rows = 0;
};
} // namespace recording
