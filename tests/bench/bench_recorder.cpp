// SPDX-License-Identifier: GPL-3.0-or-later
// A recording of six servos x 200 Hz x 6 h (26 M rows of six values), fed at full speed; a feeder
// whose batch is refused waits. Counts the rows in the file, watches the memory, and puts the speed
// beside a bare fwrite() of the same bytes; then reads the file back into a sample store. Wanted:
// no row lost, memory flat (16 MB of growth are what may wait). `bench_recorder 1000000` does so
// with fewer rows; the folder is that of temporary files (TMPDIR).
#include "recording/recorder.h"
#include "session/recording/replay.h"

#include <QFile>
#include <QTemporaryDir>

#include <chrono>
#include <cstdio>
#include <thread>
#include <unistd.h>

namespace {
using Steady = std::chrono::steady_clock;
using recording::RecordingRow;

constexpr int servos = 6;
constexpr int totalSamples = servos * 200 * 3600 * 6;
constexpr int batchRows = 40; // what six servos give in a frame of the window
constexpr double megabyte = 1024.0 * 1024.0;
constexpr double maxGrowthMegabytes = 16;

double secondsSince(Steady::time_point start)
{
    return std::chrono::duration<double>(Steady::now() - start).count();
}

double residentMegabytes()
{
    long total = 0;
    long resident = 0;
    if (FILE* file = std::fopen("/proc/self/statm", "r")) {
        if (std::fscanf(file, "%ld %ld", &total, &resident) != 2)
            resident = 0;
        std::fclose(file);
    }
    return double(resident) * double(::sysconf(_SC_PAGESIZE)) / megabyte;
}

recording::RecorderSpec specFor(const QString& path)
{
    recording::RecorderSpec spec;
    spec.path = path;
    spec.format = recording::recordingFormatOf(path);
    spec.head.started = QDateTime(QDate(2026, 1, 1), QTime(0, 0), Qt::UTC);
    for (int servo = 0; servo < servos; ++servo) {
        for (const char* key : {"position", "speed", "load", "voltage", "temperature", "current"})
            spec.head.channels.push_back({servo, servo + 1, QStringLiteral("STS3215"),
                                          QStringLiteral("feetech"), QString::fromLatin1(key),
                                          QStringLiteral("unit")});
    }
    return spec;
}

RecordingRow rowAt(int i)
{
    const int round = i / servos;
    const int step = (round * 7 + i % servos * 600) % 4096;
    return {base::Duration(5000) * round,
            i % servos,
            {step * 360.0 / 4096, (step % 300) * 0.732, (step % 1000) / 10.0, 12 - step % 7 * 0.1,
             double(31 + round / 100000), (step % 77) * 6.5}};
}

struct MemoryUsage {
    double before = 0;
    double peak = 0;
    double after = 0;
    void look() { peak = std::max(peak, residentMegabytes()); }
};

/// Seconds; ends the program when the recorder says that something went wrong.
double recordRows(recording::Recorder& recorder, int count, MemoryUsage& memory)
{
    const auto start = Steady::now();
    std::vector<RecordingRow> rows;
    std::vector<recording::Mark> marks;
    for (int i = 0; i < count;) {
        for (int end = std::min(i + batchRows, count); i < end; ++i)
            rows.push_back(rowAt(i));
        while (!recorder.tryWrite(rows, marks))
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        if (i % (batchRows * 1000) == 0)
            memory.look();
    }
    recorder.stop();
    while (!recorder.status().ended)
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    if (const auto error = recorder.status().error)
        qFatal("%s", qPrintable(error->detail));
    return secondsSince(start);
}

/// Lines that are no '#' lines and not the columns, and the bytes of the file.
std::pair<int, double> countRows(const QString& path)
{
    FILE* file = std::fopen(QFile::encodeName(path).constData(), "rb");
    std::vector<char> block(1 << 20);
    int lines = 0;
    double bytes = 0;
    while (const std::size_t got = std::fread(block.data(), 1, block.size(), file)) {
        bytes += double(got);
        for (std::size_t i = 0; i < got; ++i)
            lines += block[i] == '\n' ? 1 : 0;
    }
    std::fclose(file);
    return {lines, bytes};
}

/// Writes the lines of `path` once more: the first megabytes of them over and over.
double baselineSeconds(const QString& path, const QString& copy, double bytes)
{
    QFile source(path);
    if (!source.open(QIODevice::ReadOnly))
        return 0;
    std::vector<QByteArray> lines;
    while (lines.size() < 50000 && !source.atEnd())
        lines.push_back(source.readLine());
    FILE* file = std::fopen(QFile::encodeName(copy).constData(), "wb");
    const auto start = Steady::now();
    std::size_t next = 0;
    for (double written = 0; written < bytes; next = (next + 1) % lines.size())
        written +=
            double(std::fwrite(lines[next].constData(), 1, std::size_t(lines[next].size()), file));
    std::fflush(file);
    ::fsync(::fileno(file));
    std::fclose(file);
    return secondsSince(start);
}

const char* nameOf(const QString& path)
{
    return recording::recordingFormatOf(path) == recording::RecordingFormat::Csv ? "CSV"
                                                                                 : "JSON lines";
}

bool benchmarkRecorder(const QString& path, int count)
{
    MemoryUsage memory;
    auto recorder = recording::Recorder::start(specFor(path));
    if (!recorder)
        qFatal("%s", qPrintable(recorder.error().detail));
    const int headLines = countRows(path).first;
    memory.before = memory.peak = residentMegabytes();
    const double seconds = recordRows(**recorder, count, memory);
    memory.after = residentMegabytes();
    const auto status = (*recorder)->status();
    recorder->reset();

    const auto [lines, bytes] = countRows(path);
    const int rows = lines - headLines;
    const bool whole = rows == count && status.lost == 0 && status.rows == std::uint64_t(count);
    std::printf("%s: %d rows in %.1f s, %.2f M rows/s, %.0f MB/s; in the file %d, lost %d%s\n",
                nameOf(path), count, seconds, count / seconds / 1e6, bytes / megabyte / seconds,
                rows, count - rows, whole ? "" : " (WRONG)");
    std::printf("  memory: %.1f MB before, %.1f at most, %.1f after (wanted <= %.0f more)\n",
                memory.before, memory.peak, memory.after, maxGrowthMegabytes);
    const QString copy = path + QStringLiteral(".bare");
    const double baseline = baselineSeconds(path, copy, bytes);
    QFile::remove(copy);
    std::printf("  bare fwrite of such lines: %.1f s, %.0f MB/s; the recorder takes %.2f x that\n",
                baseline, bytes / megabyte / baseline, seconds / baseline);
    return whole && memory.peak - memory.before <= maxGrowthMegabytes;
}

bool benchmarkLoading(const QString& path, int count)
{
    recording::SampleStore store{session::ReplayData::budget};
    const base::StopToken stop;
    const auto start = Steady::now();
    const auto loaded = recording::loadRecording(path, store, stop);
    const double seconds = secondsSince(start);
    if (!loaded)
        qFatal("%s", qPrintable(loaded.error().detail));
    std::printf("%s read back: %llu rows in %.1f s, %.2f M rows/s; the store has %.0f MB%s\n",
                nameOf(path), static_cast<unsigned long long>(loaded->report.rows), seconds,
                count / seconds / 1e6, double(store.bytes()) / megabyte,
                store.decimated() ? ", thinned" : "");
    return loaded->report.rows == std::uint64_t(count) && loaded->report.badLines == 0;
}
} // namespace

int main(int argc, char* argv[])
{
    const int count = argc > 1 ? std::atoi(argv[1]) : totalSamples;
    if (count < 1) {
        std::fprintf(stderr, "usage: bench_recorder [ROWS]\n");
        return 2;
    }
    const QTemporaryDir folder;
    bool good = true;
    for (const char* name : {"run.csv", "run.jsonl"})
        good = benchmarkRecorder(folder.filePath(QLatin1String(name)), count) && good;
    for (const char* name : {"run.csv", "run.jsonl"})
        good = benchmarkLoading(folder.filePath(QLatin1String(name)), count) && good;
    return good ? 0 : 1;
}
