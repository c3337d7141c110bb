// SPDX-License-Identifier: GPL-3.0-or-later
// The sample store with 8 channels x 200 Hz x 60 min (5.76 M samples): memory with its pyramid,
// appending, and what a chart asks for: columns of 1600 pixels and statistics at several zooms;
// beside a loop that only puts the same samples into vectors. Wanted: 120 MB, 10 M samples/s.
// Then the same with a budget of a tenth of that, so that the old is thinned.
#include "recording/sample_store.h"

#include <cmath>
#include <cstdio>
#include <ctime>

namespace {
using base::Duration;

constexpr int channelCount = 8;
constexpr int samplesPerChannel = 200 * 3600;
constexpr Duration period{5000};
constexpr double megabyte = 1024.0 * 1024.0;
constexpr double maxMegabytes = 120;
constexpr double minRate = 10e6;

/// CPU time, so that other programs on this machine do not count.
double seconds()
{
    return double(std::clock()) / CLOCKS_PER_SEC;
}

double valueAt(int sample)
{
    return 90 * std::sin(sample * 0.001) + (sample % 1009 * 7919 % 13) * 0.088;
}

double fill(recording::SampleStore& store)
{
    for (int i = 0; i < channelCount; ++i)
        store.open();
    std::vector<double> values;
    for (int i = 0; i < samplesPerChannel; ++i)
        values.push_back(valueAt(i));
    const double start = seconds();
    for (int i = 0; i < samplesPerChannel; ++i) {
        for (int channel = 0; channel < channelCount; ++channel)
            store.append(channel, period * i, values[std::size_t(i)]);
    }
    return channelCount * double(samplesPerChannel) / (seconds() - start);
}

double baselineRate()
{
    std::vector<std::vector<recording::SamplePoint>> baseline(channelCount);
    const double start = seconds();
    for (int i = 0; i < samplesPerChannel; ++i) {
        for (auto& channel : baseline)
            channel.push_back({period * i, double(i)});
    }
    return channelCount * double(samplesPerChannel) / (seconds() - start);
}

/// Milliseconds for all channels, following: the stretch ends later each time.
template <typename Function>
double secondsPerFrame(Duration length, const Function& ask)
{
    constexpr int frames = 50;
    const Duration last = period * samplesPerChannel;
    const double start = seconds();
    for (int i = 0; i < frames; ++i) {
        const Duration end = last - std::chrono::milliseconds(33) * (frames - i);
        for (int channel = 0; channel < channelCount; ++channel)
            ask(channel, recording::TimeSpan{std::max(end - length, Duration(0)), end});
    }
    return (seconds() - start) * 1000 / frames;
}

void benchmarkQueries(const recording::SampleStore& store)
{
    for (const int shown : {1, 10, 60, 600, 3600}) {
        const Duration length = std::chrono::seconds(shown);
        std::vector<recording::SampleColumn> columns;
        std::size_t got = 0;
        const double columnTime =
            secondsPerFrame(length, [&](int channel, recording::TimeSpan span) {
                store.columns(channel, span, 1600, columns);
                got = columns.size();
            });
        double sum = 0;
        const double rangeTime =
            secondsPerFrame(length, [&](int channel, recording::TimeSpan span) {
                sum += store.range(channel, span)->first;
            });
        const double statisticsTime =
            secondsPerFrame(length, [&](int channel, recording::TimeSpan span) {
                sum += store.statistics(channel, span).sigma;
            });
        std::printf("%5d s shown, 8 channels: columns %.3f ms (%zu each), range %.3f ms, "
                    "statistics %.3f ms%s\n",
                    shown, columnTime, got, rangeTime, statisticsTime,
                    std::isfinite(sum) ? "" : "!");
    }
}
} // namespace

int main()
{
    recording::SampleStore store{std::size_t(384) << 20};
    const double rate = fill(store);
    const double used = double(store.bytes()) / megabyte;
    std::printf("%llu samples: %.1f MB (wanted <= %.0f)\n",
                static_cast<unsigned long long>(store.count()), used, maxMegabytes);
    std::printf("appending: %.1f M samples/s (wanted >= %.0f); bare vectors %.1f M/s\n", rate / 1e6,
                minRate / 1e6, baselineRate() / 1e6);
    benchmarkQueries(store);

    recording::SampleStore small(store.bytes() / 10);
    const double thinRate = fill(small);
    std::printf("with a tenth of the room: %.1f MB, %.1f M samples/s, all %s there\n",
                double(small.bytes()) / megabyte, thinRate / 1e6,
                small.span() == store.span() ? "still" : "NOT");
    benchmarkQueries(small);
    return used <= maxMegabytes && rate >= minRate ? 0 : 1;
}
