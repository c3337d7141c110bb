// SPDX-License-Identifier: GPL-3.0-or-later
// The data behind the trend charts: keeps every reading in a sample store, with the marks of
// events, watches for a trigger, and passes rows to a recording. Goes on
// while other pages are shown. Owned by Workbench; main thread, never waits
// (recordings are written and loaded on threads of their own). Samples live until the list of
// servos is cleared or clear() is called. What goes wrong with a recording arrives as
// recordingEnded.
#pragma once

#include "recording/recorder.h"
#include "session/workbench.h"

#include <map>

namespace session {
/// The key of the channel that is goal − position, worked out here for each reading with both.
inline const QString errorKey = QStringLiteral("error");
QString goalKey(const catalog::Profile& profile); ///< what a chart shows as the goal; empty: none

/// One curve that can be shown. Where a register changes its unit (mode, phase), it goes on as
/// another channel: no curve mixes units.
struct LiveChannel {
    recording::ChannelId id = -1;
    ServoRef servo = 0;
    catalog::ProfilePtr profile;
    QString key;  ///< register key, or errorKey
    QString unit; ///< as the catalog has it: "deg", "rpm", empty
};

struct RecordingRequest {
    QString path;
    /// Empty: all that is being read when it begins.
    std::vector<recording::ChannelId> channels{};
    base::Duration length{}; ///< 0: until stopped
};

class LiveData final : public QObject {
    Q_OBJECT

public:
    explicit LiveData(Workbench& workbench, QObject* parent = nullptr);
    ~LiveData() override; ///< a running recording is ended and on the disk

    const recording::SampleStore& store() const { return m_store; }
    const std::vector<recording::Mark>& marks() const { return m_marks; }
    const std::vector<LiveChannel>& channels() const { return m_channels; }
    const LiveChannel* find(ServoRef servo, const QString& key) const; ///< the latest one of it
    void clear();
    /// How much memory the readings may take; the oldest lose detail first.
    void setBudget(std::size_t bytes) { m_store.setBudget(bytes); }

    /// How often what is recorded and waited for is read; 0: as fast as the wire allows.
    void setPeriod(base::Duration period);

    void armTrigger(const recording::TriggerSpec& spec);
    void disarmTrigger();
    const recording::Trigger& trigger() const { return m_trigger; }

    /// BadArgument: nothing to record, or one runs already. Otherwise the file is opened beside,
    /// and recordingBegan or recordingFailed (FileUnwritable, DiskFull …) follows.
    base::Result<void> startRecording(const RecordingRequest& request);
    void stopRecording();
    bool isRecording() const { return m_recorder != nullptr || m_beginning; }
    recording::RecorderStatus recordingStatus() const; ///< of the running or the latest one
    std::vector<ServoRef> recordedServos() const;      ///< while recording

Q_SIGNALS:
    void samplesAdded();    ///< new samples or marks; at most once a batch
    void channelsChanged(); ///< more of them, or none
    void triggerChanged();  ///< armed, fired, complete
    void recordingBegan();
    void recordingFailed(const base::Error& error);
    void recordingChanged(); ///< begun, or its figures (about twice a second)
    void recordingEnded(const recording::RecorderStatus& status, const QString& path);

private:
    struct Source; ///< the curves of one servo
    struct Slot;   ///< one of them

    // live_data.cpp
    void process(const std::vector<Reading>& batch);
    void process(const Reading& reading);
    void processValues(Source& source, const Reading& reading, const ServoEntry& entry);
    Source& sourceOf(const Reading& reading);
    static void refresh(Source& source, const ServoEntry& entry);
    Slot& slotFor(Source& source, ServoRef servo, const catalog::Register* reg, const QString& key,
                  const QString& unit);
    void append(Slot& slot, base::Duration at, double value);
    void addMark(const recording::Mark& mark);
    void resetServos();
    void updateSubscription();

    // live_data_recording.cpp
    void flushRows();
    void clearColumns();
    void recorderOpened(base::Result<std::unique_ptr<recording::Recorder>> opened);
    void checkRecorder();
    void closeRecorder(std::unique_ptr<recording::Recorder> recorder);
    std::vector<recording::ChannelId> polledChannels() const;
    recording::RecordingChannel describe(const LiveChannel& channel) const;

    Workbench& m_workbench;
    recording::SampleStore m_store;
    std::vector<recording::Mark> m_marks;
    std::vector<LiveChannel> m_channels;
    std::map<ServoRef, std::unique_ptr<Source>> m_sources;
    base::Duration m_period{};
    bool m_newChannels = false;
    recording::Trigger m_trigger;

    std::unique_ptr<recording::Recorder> m_recorder;
    bool m_beginning = false;        ///< its file is being opened
    std::uint64_t m_lostAtStart = 0; ///< rows, while its file was being opened
    bool m_ending = false;           ///< stopRecording() came before it was open
    std::map<recording::ChannelId, std::size_t> m_columns; ///< place in its servo's row
    std::map<ServoRef, std::size_t> m_rowSizes;            ///< of servos that are recorded
    std::vector<double> m_row;
    std::vector<recording::RecordingRow> m_rows;
    std::vector<recording::Mark> m_rowMarks;
    recording::RecorderStatus m_lastStatus;
    QString m_recordingPath;
    QTimer m_recorderTimer;
    MainThreadQueue m_mainQueue;
    base::JobThread m_files; ///< opens and closes files; last: its jobs use the others
};
} // namespace session
