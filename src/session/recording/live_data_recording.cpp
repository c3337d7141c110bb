// SPDX-License-Identifier: GPL-3.0-or-later
// The recordings of LiveData.
#include "session/recording/live_data.h"

#include <QCoreApplication>

#include <algorithm>
#include <utility>

namespace session {
using namespace std::chrono_literals;

namespace {
/// What waits here while the disk is busy, beyond what waits in the recorder.
constexpr std::size_t maxPendingRows = 65536;
/// A channel that was heard from so lately is being read.
constexpr base::Duration polledWithin = 2s;
/// The greatest age of a reading that has not arrived here yet.
constexpr base::Duration recordingDelay = 250ms;
} // namespace

std::vector<recording::ChannelId> LiveData::polledChannels() const
{
    std::vector<recording::ChannelId> ids;
    for (const LiveChannel& channel : m_channels) {
        const auto latest = m_store.latest(channel.id);
        if (latest && m_workbench.now() - latest->at < polledWithin)
            ids.push_back(channel.id);
    }
    return ids;
}

recording::RecordingChannel LiveData::describe(const LiveChannel& channel) const
{
    recording::RecordingChannel column;
    column.servo = channel.servo;
    column.key = channel.key;
    column.unit = channel.unit;
    column.servoName = channel.profile->modelName;
    column.protocol = base::protocolName(channel.profile->protocol);
    if (const ServoEntry* entry = m_workbench.registry().servo(channel.servo))
        column.servoId = entry->servo.id;
    return column;
}

base::Result<void> LiveData::startRecording(const RecordingRequest& request)
{
    if (isRecording())
        return base::fail(base::ErrorCode::BadArgument, QStringLiteral("record"),
                          QStringLiteral("running"));
    const auto requested = request.channels.empty() ? polledChannels() : request.channels;
    recording::RecorderSpec spec;
    spec.path = request.path;
    spec.format = recording::recordingFormatOf(request.path);
    spec.length = request.length;
    spec.head.started = QDateTime::currentDateTime();
    spec.head.program = QStringLiteral("ServoDesk ") + QCoreApplication::applicationVersion();
    spec.head.port = m_workbench.link().lastRequest().name;
    spec.head.baud = m_workbench.link().baud();
    spec.head.simulated = m_workbench.link().isSimulated();
    std::map<recording::ChannelId, std::size_t> columns;
    std::map<ServoRef, std::size_t> sizes;
    for (const recording::ChannelId id : requested) {
        const auto channel = std::find_if(m_channels.begin(), m_channels.end(),
                                          [id](const LiveChannel& one) { return one.id == id; });
        if (channel == m_channels.end())
            continue;
        columns[id] = sizes[channel->servo]++;
        spec.head.channels.push_back(describe(*channel));
    }
    if (columns.empty())
        return base::fail(base::ErrorCode::BadArgument, QStringLiteral("record"),
                          QStringLiteral("nothing-read"));
    m_recordingPath = request.path;
    m_columns = std::move(columns);
    m_rowSizes = std::move(sizes);
    updateSubscription();
    m_lastStatus = {};
    m_beginning = true;
    m_ending = false;
    m_lostAtStart = 0;
    m_files.start([this, spec] {
        auto opened = std::make_shared<base::Result<std::unique_ptr<recording::Recorder>>>(
            recording::Recorder::start(spec));
        m_mainQueue.post([this, opened] { recorderOpened(std::move(*opened)); });
    });
    return {};
}

/// What was read meanwhile waits in m_rows and is in it.
void LiveData::recorderOpened(base::Result<std::unique_ptr<recording::Recorder>> opened)
{
    m_beginning = false;
    if (!opened) {
        clearColumns();
        Q_EMIT recordingFailed(opened.error());
        Q_EMIT recordingChanged();
        return;
    }
    m_recorder = std::move(*opened);
    m_recorder->lost(m_lostAtStart);
    m_recorderTimer.start();
    Q_EMIT recordingBegan();
    Q_EMIT recordingChanged();
    if (m_ending)
        stopRecording();
}

/// Closing a file may take as long as its disk likes.
void LiveData::closeRecorder(std::unique_ptr<recording::Recorder> recorder)
{
    m_files.start([old = std::shared_ptr<recording::Recorder>(std::move(recorder))]() mutable {
        old.reset();
    });
}

std::vector<ServoRef> LiveData::recordedServos() const
{
    std::vector<ServoRef> servos;
    for (const auto& [ref, size] : m_rowSizes)
        servos.push_back(ref);
    return servos;
}

void LiveData::clearColumns()
{
    m_columns.clear();
    m_rowSizes.clear();
    updateSubscription();
}

void LiveData::stopRecording()
{
    m_ending = true;
    if (!m_recorder)
        return;
    flushRows();
    m_recorder->stop();
    clearColumns();
}

recording::RecorderStatus LiveData::recordingStatus() const
{
    return m_recorder ? m_recorder->status() : m_lastStatus;
}

void LiveData::flushRows()
{
    if (!m_recorder) {
        if (m_beginning && m_rows.size() <= maxPendingRows)
            return;
        m_lostAtStart += m_beginning ? m_rows.size() : 0;
        m_rows.clear();
        m_rowMarks.clear();
        return;
    }
    if (m_recorder->tryWrite(m_rows, m_rowMarks)) {
        m_rows.clear();
        m_rowMarks.clear();
    } else if (m_rows.size() > maxPendingRows) {
        m_recorder->lost(m_rows.size());
        m_rows.clear();
    }
    if (m_rows.empty())
        m_recorder->advanceTo(m_workbench.now() - recordingDelay);
}

void LiveData::checkRecorder()
{
    flushRows();
    const recording::RecorderStatus status = m_recorder->status();
    if (!status.ended) {
        Q_EMIT recordingChanged();
        return;
    }
    m_recorderTimer.stop();
    m_lastStatus = status;
    closeRecorder(std::move(m_recorder));
    clearColumns();
    flushRows();
    Q_EMIT recordingChanged();
    Q_EMIT recordingEnded(status, m_recordingPath);
}
} // namespace session
