// SPDX-License-Identifier: GPL-3.0-or-later
#include "jobs/sweep/sweep_recording.h"

#include <array>
#include <cmath>
#include <limits>
#include <thread>

namespace jobs {
using base::Duration;
using namespace std::chrono_literals;

namespace {
constexpr std::size_t chartBudget = std::size_t(48) << 20;
constexpr Duration decimateAfter = 10min;
constexpr Duration decimatedInterval = 20ms;
constexpr std::size_t batch = 256; ///< rows
constexpr std::size_t positionColumn = 2;

struct Column {
    const char* key;
    const char* unit;
};
constexpr std::array columns{Column{"goal", "step"},     Column{"leg", ""},
                             Column{"position", "step"}, Column{"speed", "step/s"},
                             Column{"load", "%"},        Column{"current", "mA"},
                             Column{"voltage", "V"},     Column{"temperature", "degC"},
                             Column{"moving", ""},       Column{"status", ""}};

double orNan(std::optional<double> value)
{
    return value.value_or(std::numeric_limits<double>::quiet_NaN());
}

recording::RecordingHeader makeHeader(const results::SweepRun& run)
{
    recording::RecordingHeader head;
    head.started = run.at;
    head.program = run.program;
    head.port = run.port;
    head.baud = run.baud;
    head.simulated = run.simulated;
    for (std::size_t i = 0; i < run.servos.size(); ++i) {
        const snapshot::SnapshotServo& servo = run.servos[i].parameters.servo;
        for (const Column& column : columns)
            head.channels.push_back({int(i), servo.id, servo.model, servo.protocol,
                                     QString::fromLatin1(column.key),
                                     QString::fromLatin1(column.unit)});
    }
    return head;
}

recording::RecordingRow makeRow(std::size_t servo, const SweepSample& sample, double goal, int leg)
{
    recording::RecordingRow row{sample.at, int(servo), {}};
    if (!sample.answered) {
        row.values.assign(columns.size(), orNan({}));
        return row;
    }
    const auto moving = sample.moving ? std::optional(*sample.moving ? 1.0 : 0.0) : std::nullopt;
    row.values = {goal,
                  double(leg),
                  orNan(sample.position),
                  orNan(sample.speed),
                  orNan(sample.load),
                  orNan(sample.current),
                  orNan(sample.voltage),
                  orNan(sample.temperature),
                  orNan(moving),
                  double(sample.status)};
    return row;
}
} // namespace

void appendReading(recording::SampleStore& store, const SweepCurves& curves, Duration at,
                   std::optional<double> position, double goal)
{
    if (position) {
        store.append(curves.position, at, *position);
        store.append(curves.goal, at, goal);
    } else {
        store.gap(curves.position);
        store.gap(curves.goal);
    }
}

SweepRecording::SweepRecording()
    : m_store(chartBudget)
{}

base::Result<std::unique_ptr<SweepRecording>> SweepRecording::start(const results::SweepRun& run,
                                                                    const QString& path)
{
    std::unique_ptr<SweepRecording> made(new SweepRecording);
    for (std::size_t i = 0; i < run.servos.size(); ++i) {
        made->m_curves.push_back({made->m_store.open(), made->m_store.open()});
        made->m_decimators.emplace_back();
        made->m_ids.push_back(run.servos[i].parameters.servo.id);
    }
    if (!path.isEmpty()) {
        recording::RecorderSpec spec;
        spec.path = path;
        spec.format = recording::recordingFormatOf(path);
        spec.head = makeHeader(run);
        auto recorder = recording::Recorder::start(spec);
        if (!recorder)
            return tl::unexpected(recorder.error());
        made->m_recorder = std::move(*recorder);
    }
    return made;
}

void SweepRecording::add(std::size_t servo, const SweepSample& sample, double goal, int leg)
{
    if (!m_start)
        m_start = sample.at;
    appendReading(m_store, m_curves.at(servo), sample.at,
                  sample.answered ? sample.position : std::nullopt, goal);
    if (m_recorder)
        write(servo, makeRow(servo, sample, goal, leg));
}

void SweepRecording::goal(std::size_t servo, int leg, Duration at)
{
    if (m_recorder)
        m_marks.push_back(
            {at, recording::MarkKind::Move, m_ids.at(servo), QStringLiteral("leg %1").arg(leg)});
}

/// The first ten minutes whole; after them lowest and highest of each stretch, and every row that
/// begins a leg, a silence or a fault.
void SweepRecording::write(std::size_t servo, recording::RecordingRow row)
{
    Decimator& decimator = m_decimators[servo];
    const double position = row.values[positionColumn];
    const bool mustDecimate = row.at - *m_start > decimateAfter && !std::isnan(position);
    if (!mustDecimate) {
        flushDecimator(decimator);
        enqueue(std::move(row));
        return;
    }
    const auto same = [&row](const std::optional<recording::RecordingRow>& kept) {
        return !kept || (kept->values[0] == row.values[0] && kept->values[1] == row.values[1] &&
                         kept->values.back() == row.values.back());
    };
    if (row.at >= decimator.until || !same(decimator.low)) {
        flushDecimator(decimator);
        // Lowest and highest: two readings a stretch.
        decimator.until = row.at + 2 * decimatedInterval;
    }
    if (!decimator.low || position < decimator.low->values[positionColumn])
        decimator.low = row;
    if (!decimator.high || position > decimator.high->values[positionColumn])
        decimator.high = std::move(row);
}

void SweepRecording::flushDecimator(Decimator& decimator)
{
    if (decimator.low && decimator.high) {
        const bool lowFirst = decimator.low->at <= decimator.high->at;
        const bool one = decimator.low->at == decimator.high->at;
        enqueue(lowFirst ? *decimator.low : *decimator.high);
        if (!one)
            enqueue(lowFirst ? *decimator.high : *decimator.low);
    }
    decimator.low.reset();
    decimator.high.reset();
}

void SweepRecording::enqueue(recording::RecordingRow row)
{
    m_rows.push_back(std::move(row));
    if (m_rows.size() >= batch)
        enqueue(false);
}

/// The recorder's thread may be behind: readings without room there stay here.
void SweepRecording::enqueue(bool all)
{
    while (!m_recorder->tryWrite(m_rows, m_marks) && all)
        std::this_thread::sleep_for(1ms);
}

void SweepRecording::finish()
{
    if (!m_recorder)
        return;
    for (Decimator& one : m_decimators)
        flushDecimator(one);
    enqueue(true);
    m_recorder->stop();
    while (!m_recorder->status().ended)
        std::this_thread::sleep_for(1ms);
}

std::optional<base::Error> SweepRecording::failure() const
{
    return m_recorder ? m_recorder->status().error : std::nullopt;
}

std::uint64_t SweepRecording::lost() const
{
    return m_recorder ? m_recorder->status().lost : 0;
}
} // namespace jobs
