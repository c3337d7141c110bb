// SPDX-License-Identifier: GPL-3.0-or-later
// A recording of what LiveData reads: collects the rows of each batch and passes them to a file.
// Owned and fed by LiveData; main thread, never waits (files are opened and closed on a thread of
// its own). What goes wrong arrives as failed() or ended().
#pragma once

#include "recording/recorder.h"
#include "session/polling/subscription.h"
#include "session/workbench.h"

#include <map>

namespace session {
class LiveData;
struct LiveChannel;

struct RecordingRequest {
    QString path;
    /// Empty: all that is being read when it begins.
    std::vector<recording::ChannelId> channels{};
    base::Duration length{}; ///< 0: until stopped
};

class LiveRecording final : public QObject {
    Q_OBJECT

public:
    LiveRecording(Workbench& workbench, const LiveData& liveData);
    ~LiveRecording() override; ///< a running recording is ended and on the disk

    /// BadArgument: nothing to record, or one runs already. Otherwise the file is opened beside,
    /// and began() or failed() (FileUnwritable, DiskFull …) follows.
    base::Result<void> start(const RecordingRequest& request);
    void stop();
    bool isRunning() const { return m_recorder != nullptr || m_isOpening; }
    recording::RecorderStatus status() const; ///< of the running or the latest one
    std::vector<ServoRef> servos() const;     ///< while it runs

    /// How often its channels are read; 0: as fast as the wire allows.
    void setPeriod(base::Duration period);

    // For LiveData: each reading is a row, each batch is flushed.
    void beginRow(ServoRef servo);
    void addValue(recording::ChannelId channel, double value);
    void endRow(const Reading& reading);
    void addMark(const recording::Mark& mark);
    void flush();

Q_SIGNALS:
    void began();
    void failed(const base::Error& error);
    void changed(); ///< begun or failed, or its figures (several times a second)
    void ended(const recording::RecorderStatus& status, const QString& path);

private:
    void opened(base::Result<std::unique_ptr<recording::Recorder>> recorder);
    void check();
    void close(std::unique_ptr<recording::Recorder> recorder);
    void clearColumns();
    void updateSubscription();
    std::vector<recording::ChannelId> polledChannels() const;
    recording::RecordingChannel describe(const LiveChannel& channel) const;

    Workbench& m_workbench;
    const LiveData& m_liveData;
    base::Duration m_period{};
    std::unique_ptr<recording::Recorder> m_recorder;
    bool m_isOpening = false;        ///< its file is being opened
    bool m_isEnding = false;         ///< stop() came before it was open
    std::uint64_t m_lostAtStart = 0; ///< rows, while its file was being opened
    std::map<recording::ChannelId, std::size_t> m_columns; ///< place in its servo's row
    std::map<ServoRef, std::size_t> m_rowSizes;            ///< of servos that are recorded
    std::vector<double> m_row; ///< of the reading that is processed; empty: it is not recorded
    std::vector<recording::RecordingRow> m_rows;
    std::vector<recording::Mark> m_marks;
    recording::RecorderStatus m_lastStatus;
    QString m_path;
    QTimer m_timer;
    MainThreadQueue m_mainQueue;
    base::JobThread m_files; ///< opens and closes files; last: its jobs use the others
};
} // namespace session
