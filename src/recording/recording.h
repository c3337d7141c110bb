// SPDX-License-Identifier: GPL-3.0-or-later
// What was measured, as an open text file: CSV (time in µs, the servo, one column a channel with
// its unit in the header, a last column for marks, gaps empty) or JSON lines. A row is one reading
// of one servo; columns of other servos are empty in it. The CSV begins with '#' lines (version,
// start, port, servos). Numbers have as many digits as it takes to read the very same ones back.
// Values; reading runs on the caller's thread.
#pragma once

#include "base/error.h"
#include "base/stop_token.h"
#include "recording/trigger.h"

#include <QDateTime>

#include <functional>

namespace recording {
enum class RecordingFormat : std::uint8_t { Csv, JsonLines };
RecordingFormat recordingFormatOf(const QString& path); ///< by its end; .jsonl is JsonLines

struct RecordingChannel {
    int servo = 0;     ///< groups channels that are read together; any number, equal = one servo
    int servoId = -1;  ///< on the bus
    QString servoName; ///< "STS3215"
    QString protocol;  ///< "feetech"
    QString key;       ///< register, or "error" for what is computed
    QString unit;
    bool operator==(const RecordingChannel&) const = default;
};

struct RecordingHeader {
    QDateTime started{};
    QString program{}; ///< "ServoDesk 0.1.0"
    QString port{};
    int baud = 0;
    bool simulated = false;
    std::vector<RecordingChannel> channels{};
};

/// One reading of one servo. `values` are those of the channels with this `servo`, in their order;
/// NaN: not read this time. All NaN: the servo did not answer, a gap in all its channels.
struct RecordingRow {
    base::Duration at{}; ///< bus clock; in the file it counts from the first line
    int servo = 0;
    std::vector<double> values{};
};

struct RecordingReport {
    std::uint64_t rows = 0;
    std::uint64_t badLines = 0; ///< not understood, left out (edited by hand)
    bool isTruncated = false;   ///< the last line has no end: the program or the machine had died
    TimeSpan span{};            ///< of its rows, from the start of the recording
};

struct LoadedRecording {
    RecordingHeader head;
    std::vector<ChannelId> ids;
    std::vector<Mark> marks;
    RecordingReport report;
};

/// Reads a file into a store, block by block: channel i of the head becomes ids[i]. Times count
/// from 0. Errors: FileMissing, FileUnreadable, FileFormat (no recording, or of a newer version;
/// detail says where), Stopped; then no channel is left behind. Bad lines are left out and counted.
/// `onProgress` gets 0…1.
base::Result<LoadedRecording> loadRecording(const QString& path, SampleStore& into,
                                            const base::StopToken& stop,
                                            const std::function<void(double)>& onProgress = {});
} // namespace recording
