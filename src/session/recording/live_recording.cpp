// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/recording/live_recording.h"

#include "session/recording/live_data.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>
#include <limits>
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
constexpr auto checkInterval = 100ms;
constexpr double missingValue = std::numeric_limits<double>::quiet_NaN();
} // namespace

LiveRecording::LiveRecording(Workbench& workbench, const LiveData& liveData)
    : m_workbench(workbench)
    , m_liveData(liveData)
{
    m_timer.setInterval(checkInterval);
    connect(&m_timer, &QTimer::timeout, this, &LiveRecording::check);
}

LiveRecording::~LiveRecording()
{
    flush();
    if (m_recorder)
        close(std::move(m_recorder));
}

void LiveRecording::setPeriod(base::Duration period)
{
    m_period = period;
    updateSubscription();
}

/// What is recorded is read on every page and for every selection.
void LiveRecording::updateSubscription()
{
    Subscription subscription;
    subscription.period = m_period;
    for (const LiveChannel& channel : m_liveData.channels()) {
        if (m_columns.count(channel.id) > 0)
            subscription.parts.push_back(subscriptionTo(channel));
    }
    m_workbench.polling().subscribe(QStringLiteral("recording"), subscription);
}

void LiveRecording::beginRow(ServoRef servo)
{
    const auto size = m_rowSizes.find(servo);
    m_row.assign(size != m_rowSizes.end() ? size->second : 0, missingValue);
}

void LiveRecording::addValue(recording::ChannelId channel, double value)
{
    if (const auto column = m_columns.find(channel); column != m_columns.end())
        m_row[column->second] = value;
}

void LiveRecording::endRow(const Reading& reading)
{
    // A row of nothing says that the servo was silent.
    const bool any =
        std::any_of(m_row.begin(), m_row.end(), [](double value) { return !std::isnan(value); });
    if (!m_row.empty() && (any || !reading.answered))
        m_rows.push_back({reading.at, reading.servo, m_row});
}

void LiveRecording::addMark(const recording::Mark& mark)
{
    if (isRunning())
        m_marks.push_back(mark);
}

std::vector<recording::ChannelId> LiveRecording::polledChannels() const
{
    std::vector<recording::ChannelId> ids;
    for (const LiveChannel& channel : m_liveData.channels()) {
        const auto latest = m_liveData.store().latest(channel.id);
        if (latest && m_workbench.now() - latest->at < polledWithin)
            ids.push_back(channel.id);
    }
    return ids;
}

recording::RecordingChannel LiveRecording::describe(const LiveChannel& channel) const
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

base::Result<void> LiveRecording::start(const RecordingRequest& request)
{
    if (isRunning())
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
        const auto& all = m_liveData.channels();
        const auto channel = std::find_if(all.begin(), all.end(),
                                          [id](const LiveChannel& one) { return one.id == id; });
        if (channel == all.end())
            continue;
        columns[id] = sizes[channel->servo]++;
        spec.head.channels.push_back(describe(*channel));
    }
    if (columns.empty())
        return base::fail(base::ErrorCode::BadArgument, QStringLiteral("record"),
                          QStringLiteral("nothing-read"));
    m_path = request.path;
    m_columns = std::move(columns);
    m_rowSizes = std::move(sizes);
    updateSubscription();
    m_lastStatus = {};
    m_isOpening = true;
    m_isEnding = false;
    m_lostAtStart = 0;
    m_files.start([this, spec] {
        auto recorder = std::make_shared<base::Result<std::unique_ptr<recording::Recorder>>>(
            recording::Recorder::start(spec));
        m_mainQueue.post([this, recorder] { opened(std::move(*recorder)); });
    });
    return {};
}

/// What was read meanwhile waits in m_rows and is in it.
void LiveRecording::opened(base::Result<std::unique_ptr<recording::Recorder>> recorder)
{
    m_isOpening = false;
    if (!recorder) {
        clearColumns();
        Q_EMIT failed(recorder.error());
        Q_EMIT changed();
        return;
    }
    m_recorder = std::move(*recorder);
    m_recorder->lost(m_lostAtStart);
    m_timer.start();
    Q_EMIT began();
    Q_EMIT changed();
    if (m_isEnding)
        stop();
}

/// Closing a file may take as long as its disk likes.
void LiveRecording::close(std::unique_ptr<recording::Recorder> recorder)
{
    m_files.start([old = std::shared_ptr<recording::Recorder>(std::move(recorder))]() mutable {
        old.reset();
    });
}

std::vector<ServoRef> LiveRecording::servos() const
{
    std::vector<ServoRef> servos;
    for (const auto& [ref, size] : m_rowSizes)
        servos.push_back(ref);
    return servos;
}

void LiveRecording::clearColumns()
{
    m_columns.clear();
    m_rowSizes.clear();
    updateSubscription();
}

void LiveRecording::stop()
{
    m_isEnding = true;
    if (!m_recorder)
        return;
    flush();
    m_recorder->stop();
    clearColumns();
}

recording::RecorderStatus LiveRecording::status() const
{
    return m_recorder ? m_recorder->status() : m_lastStatus;
}

void LiveRecording::flush()
{
    if (!m_recorder) {
        if (m_isOpening && m_rows.size() <= maxPendingRows)
            return;
        m_lostAtStart += m_isOpening ? m_rows.size() : 0;
        m_rows.clear();
        m_marks.clear();
        return;
    }
    if (m_recorder->tryWrite(m_rows, m_marks)) {
        m_rows.clear();
        m_marks.clear();
    } else if (m_rows.size() > maxPendingRows) {
        m_recorder->lost(m_rows.size());
        m_rows.clear();
    }
    if (m_rows.empty())
        m_recorder->advanceTo(m_workbench.now() - recordingDelay);
}

void LiveRecording::check()
{
    flush();
    const recording::RecorderStatus status = m_recorder->status();
    if (!status.ended) {
        Q_EMIT changed();
        return;
    }
    m_timer.stop();
    m_lastStatus = status;
    close(std::move(m_recorder));
    clearColumns();
    flush();
    Q_EMIT changed();
    Q_EMIT ended(status, m_path);
}
} // namespace session
