// SPDX-License-Identifier: GPL-3.0-or-later
// Writes a recording on a thread of its own. Rows are handed over in batches and never block the
// caller; what waits is bounded: a batch that finds no room is refused, and what the caller then
// drops is counted in `lost`. The file is flushed to the disk at least twice a second, so that a
// crash costs the last second at most. A full disk or a folder that is gone ends it: status() has
// the error, what was written stays valid. Owner's thread, except the thread it owns itself.
#pragma once

#include "recording/recording.h"

#include <memory>

namespace recording {
struct RecorderSpec {
    QString path;
    RecordingFormat format = RecordingFormat::Csv;
    RecordingHeader head;
    base::Duration length{}; ///< 0: until stopped; counted from the first row
};

struct RecorderStatus {
    std::uint64_t rows = 0; ///< written
    std::uint64_t bytes = 0;
    std::uint64_t lost = 0;   ///< rows the caller could not hand over
    base::Duration elapsed{}; ///< from the first row to the latest
    bool ended = false;       ///< stopped, at its length, or failed; everything is on the disk
    std::optional<base::Error> error{};
};

class Recorder {
public:
    static constexpr std::size_t maxPending = 65536; ///< rows

    /// Replaces what is in the file. FileUnwritable and DiskFull are reported here, before anything
    /// is lost.
    static base::Result<std::unique_ptr<Recorder>> start(const RecorderSpec& spec);
    Recorder(const Recorder&) = delete;
    Recorder& operator=(const Recorder&) = delete;
    ~Recorder(); ///< writes what waits

    /// False: no room, nothing was taken; offer it again, or call lost(). Both come back empty when
    /// they were taken. After the end everything is taken and dropped (after an error: as lost).
    bool tryWrite(std::vector<RecordingRow>& rows, std::vector<Mark>& marks);
    void lost(std::uint64_t rows);
    /// Called as time passes without rows: ends a recording whose length is over.
    void advanceTo(base::Duration now);
    /// Returns at once; status().ended follows when everything is on the disk.
    void stop();
    RecorderStatus status() const;
    const RecorderSpec& spec() const;

private:
    class Worker;
    explicit Recorder(std::unique_ptr<Worker> thread);
    std::unique_ptr<Worker> m_thread;
};
} // namespace recording
