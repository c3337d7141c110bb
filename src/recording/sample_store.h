// SPDX-License-Identifier: GPL-3.0-or-later
// Samples of many channels over hours, kept so that a chart can ask for any stretch at any width:
// raw samples in chunks, and a min/max pyramid above them. Owned and used by one thread (in the
// window the main thread). Times are bus-clock instants; values are physical, in the channel's
// unit; one that is no number is a gap. Within a channel times never go back: a sample that would
// is dropped and counted. When the budget is used up, the oldest chunks are thinned to their
// extremes (statistics show it), and after that dropped.
#pragma once

#include "base/clock.h"

#include <QString>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace recording {
using ChannelId = int; ///< stable as long as the store lives

struct SamplePoint {
    base::Duration at{};
    double value = 0;
    bool operator==(const SamplePoint&) const = default;
};

/// What is drawn in one column of pixels. `first` and `last` join it to its neighbors.
struct SampleColumn {
    base::Duration from{}; ///< time of the first sample in it
    base::Duration to{};   ///< and of the last
    double first = 0;
    double last = 0;
    double min = 0;
    double max = 0;
    bool gapBefore = false; ///< nothing is known between the column before and this one
};

struct TimeSpan {
    base::Duration from{};
    base::Duration to{}; ///< inclusive
    bool operator==(const TimeSpan&) const = default;
};

/// Of the samples in a stretch, both ends included. sigma is that of the samples themselves
/// (divided by n); slope is the least-squares line's, per second.
struct SampleStatistics {
    std::uint64_t count = 0;
    double mean = 0;
    double min = 0;
    double max = 0;
    double sigma = 0;
    double slope = 0;
    /// False: it ends within a part of which only extremes are kept, or begins in what was dropped.
    bool exact = true;
};

class SampleStore {
public:
    static constexpr std::size_t defaultBudget = std::size_t(128) << 20;

    explicit SampleStore(std::size_t budgetBytes = defaultBudget);
    SampleStore(SampleStore&&) noexcept;
    SampleStore& operator=(SampleStore&&) noexcept;
    ~SampleStore();

    void setBudget(std::size_t bytes);

    ChannelId open(); ///< a new, empty channel
    /// Its samples go; the number is never given out again.
    void close(ChannelId channel);
    void clear(); ///< all samples; the channels stay

    void append(ChannelId channel, base::Duration at, double value);
    void append(ChannelId channel, std::span<const SamplePoint> points);
    /// Nothing is known from here to the next sample.
    void gap(ChannelId channel);

    std::optional<TimeSpan> span(ChannelId channel) const; ///< none: empty
    std::optional<TimeSpan> span() const;                  ///< of all channels
    std::optional<SamplePoint> latest(ChannelId channel) const;
    /// The sample in force at that instant: the latest one not after it; none before the first and
    /// within a gap.
    std::optional<SamplePoint> at(ChannelId channel, base::Duration instant) const;

    /// The nearest sample before or after that instant, whatever gap lies between.
    std::optional<SamplePoint> before(ChannelId channel, base::Duration instant) const;
    std::optional<SamplePoint> after(ChannelId channel, base::Duration instant) const;

    /// At most `pixels` columns that cover [from, to], and one more at each side where there are
    /// samples outside, so that lines run out of the picture. Cost grows with `pixels`, not with
    /// the number of samples. `out` is overwritten.
    void columns(ChannelId channel, TimeSpan span, int pixels,
                 std::vector<SampleColumn>& out) const;
    /// Min and max in the stretch; none where there is no sample. For axes.
    std::optional<std::pair<double, double>> range(ChannelId channel, TimeSpan span) const;
    SampleStatistics statistics(ChannelId channel, TimeSpan span) const;
    /// The samples themselves (extremes where it was thinned), oldest first.
    std::vector<SamplePoint> points(ChannelId channel, TimeSpan span) const;

    std::size_t bytes() const;        ///< memory in use
    std::uint64_t count() const;      ///< samples appended since the last clear()
    std::uint64_t outOfOrder() const; ///< samples dropped because time went back
    bool decimated() const;           ///< something is kept as extremes only, or was dropped

private:
    struct Data;
    std::unique_ptr<Data> m_data;
};
} // namespace recording
