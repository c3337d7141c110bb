// SPDX-License-Identifier: GPL-3.0-or-later
#include "recording/sample_store.h"

#include "recording/sample_channel.h"

#include <algorithm>
#include <cmath>

namespace recording {
namespace {
using base::Duration;
using Position = SampleChannel::Position;

// Far beyond any clock, and far enough from the ends of the number for sums.
constexpr Duration maxTime{std::int64_t(1) << 60};

TimeSpan clampedSpan(TimeSpan span)
{
    return {std::clamp(span.from, -maxTime, maxTime), std::clamp(span.to, -maxTime, maxTime)};
}

/// Columns start at multiples of their width, counted from the clock's zero: then a sample stays in
/// its column while the picture moves on, and a following chart does not shimmer.
class Grid {
public:
    Grid(TimeSpan span, int pixels)
    {
        const std::int64_t length = (span.to - span.from).count() + 1;
        if (pixels < 2) {
            m_origin = span.from.count();
            m_width = length;
            return;
        }
        // One less than there are pixels, because both ends cut a column.
        m_width = (length + pixels - 2) / (pixels - 1);
        // In steps of less than 1 %, so that a span longer by a microsecond gives the same width.
        std::int64_t step = 1;
        while (m_width / step >= 256)
            step *= 2;
        m_width = (m_width + step - 1) / step * step;
    }

    Duration startOf(Duration at) const { return Duration(m_origin + indexOf(at) * m_width); }
    Duration endOf(Duration at) const { return startOf(at) + Duration(m_width); }

private:
    std::int64_t indexOf(Duration at) const
    {
        const std::int64_t distance = at.count() - m_origin;
        return distance / m_width - (distance % m_width < 0 ? 1 : 0);
    }

    std::int64_t m_origin = 0;
    std::int64_t m_width = 1;
};
} // namespace

struct SampleStore::Data {
    std::size_t budget = 0;
    std::size_t bytes = 0;
    std::uint64_t count = 0;
    std::uint64_t outOfOrder = 0;
    std::vector<std::unique_ptr<SampleChannel>> channels; ///< null: closed

    SampleChannel* find(ChannelId id)
    {
        return id >= 0 && std::size_t(id) < channels.size() ? channels[std::size_t(id)].get()
                                                            : nullptr;
    }
    /// None if it is closed or empty.
    const SampleChannel* findNonEmpty(ChannelId id)
    {
        const SampleChannel* channel = find(id);
        return channel && !channel->empty() ? channel : nullptr;
    }
    void append(SampleChannel& channel, Duration at, double value);
    void enforceBudget();
    SampleChannel* oldest(std::optional<Duration> (SampleChannel::*age)() const) const;
};

void SampleStore::Data::append(SampleChannel& channel, Duration at, double value)
{
    if (!std::isfinite(value)) {
        channel.gap();
        return;
    }
    if (channel.append(at, value, bytes) == SampleChannel::AppendResult::Appended)
        ++count;
    else
        ++outOfOrder;
    if (bytes > budget)
        enforceBudget();
}

SampleChannel* SampleStore::Data::oldest(std::optional<Duration> (SampleChannel::*age)()
                                             const) const
{
    SampleChannel* found = nullptr;
    Duration foundAge{};
    for (const auto& channel : channels) {
        const std::optional<Duration> its = channel ? (*channel.*age)() : std::nullopt;
        if (its && (!found || *its < foundAge)) {
            found = channel.get();
            foundAge = *its;
        }
    }
    return found;
}

void SampleStore::Data::enforceBudget()
{
    while (bytes > budget) {
        if (SampleChannel* channel = oldest(&SampleChannel::oldestToDecimate))
            channel->decimateOldest(bytes);
        else if (SampleChannel* last = oldest(&SampleChannel::oldestDroppable))
            last->dropOldest(bytes);
        else
            return;
    }
}

SampleStore::SampleStore(std::size_t budgetBytes)
    : m_data(std::make_unique<Data>())
{
    m_data->budget = budgetBytes;
}

void SampleStore::setBudget(std::size_t bytes)
{
    m_data->budget = bytes;
    m_data->enforceBudget();
}

SampleStore::SampleStore(SampleStore&&) noexcept = default;
SampleStore& SampleStore::operator=(SampleStore&&) noexcept = default;
SampleStore::~SampleStore() = default;

ChannelId SampleStore::open()
{
    m_data->channels.push_back(std::make_unique<SampleChannel>());
    return ChannelId(m_data->channels.size() - 1);
}

void SampleStore::close(ChannelId channel)
{
    if (SampleChannel* found = m_data->find(channel)) {
        m_data->bytes -= found->bytes();
        m_data->channels[std::size_t(channel)].reset();
    }
}

void SampleStore::clear()
{
    for (const auto& channel : m_data->channels) {
        if (channel)
            channel->clear();
    }
    m_data->bytes = 0;
    m_data->count = 0;
    m_data->outOfOrder = 0;
}

void SampleStore::append(ChannelId channel, Duration at, double value)
{
    if (SampleChannel* found = m_data->find(channel))
        m_data->append(*found, at, value);
}

void SampleStore::append(ChannelId channel, std::span<const SamplePoint> points)
{
    if (SampleChannel* found = m_data->find(channel)) {
        for (const SamplePoint& point : points)
            m_data->append(*found, point.at, point.value);
    }
}

void SampleStore::gap(ChannelId channel)
{
    if (SampleChannel* found = m_data->find(channel))
        found->gap();
}

std::optional<TimeSpan> SampleStore::span(ChannelId channel) const
{
    const SampleChannel* found = m_data->findNonEmpty(channel);
    return found ? std::optional(found->span()) : std::nullopt;
}

std::optional<TimeSpan> SampleStore::span() const
{
    std::optional<TimeSpan> all;
    for (const auto& channel : m_data->channels) {
        if (!channel || channel->empty())
            continue;
        const TimeSpan its = channel->span();
        all = all ? TimeSpan{std::min(all->from, its.from), std::max(all->to, its.to)} : its;
    }
    return all;
}

std::optional<SamplePoint> SampleStore::latest(ChannelId channel) const
{
    const SampleChannel* found = m_data->findNonEmpty(channel);
    return found ? std::optional(found->point(found->previous(found->end()))) : std::nullopt;
}

std::optional<SamplePoint> SampleStore::at(ChannelId channel, Duration instant) const
{
    const SampleChannel* found = m_data->findNonEmpty(channel);
    if (!found || instant < found->span().from)
        return std::nullopt;
    const Position after = found->lowerBound(std::min(instant, maxTime) + Duration(1));
    const SamplePoint point = found->point(found->previous(after));
    const bool gapFollows = after == found->end() ? found->endsInGap() : found->gapAt(after);
    if (gapFollows && point.at < instant)
        return std::nullopt;
    return point;
}

std::optional<SamplePoint> SampleStore::before(ChannelId channel, Duration instant) const
{
    const SampleChannel* found = m_data->findNonEmpty(channel);
    if (!found || instant <= found->span().from)
        return std::nullopt;
    return found->point(found->previous(found->lowerBound(instant)));
}

std::optional<SamplePoint> SampleStore::after(ChannelId channel, Duration instant) const
{
    const SampleChannel* found = m_data->findNonEmpty(channel);
    if (!found || instant >= found->span().to)
        return std::nullopt;
    return found->point(found->lowerBound(instant + Duration(1)));
}

void SampleStore::columns(ChannelId channel, TimeSpan span, int pixels,
                          std::vector<SampleColumn>& out) const
{
    out.clear();
    const SampleChannel* found = m_data->findNonEmpty(channel);
    span = clampedSpan(span);
    if (!found || pixels < 1 || span.to < span.from)
        return;
    const Grid grid(span, pixels);
    Position position = found->lowerBound(grid.startOf(span.from));
    if (!(position == found->begin()))
        out.push_back(found->column(found->previous(position), position));
    const Position end = found->lowerBound(grid.endOf(span.to), position);
    while (!(position == end)) {
        const Position next = found->lowerBound(grid.endOf(found->point(position).at), position);
        out.push_back(found->column(position, next));
        position = next;
    }
    if (!(end == found->end()))
        out.push_back(found->column(end, found->next(end)));
}

std::optional<std::pair<double, double>> SampleStore::range(ChannelId channel, TimeSpan span) const
{
    const SampleChannel* found = m_data->findNonEmpty(channel);
    span = clampedSpan(span);
    if (!found || span.to < span.from)
        return std::nullopt;
    const Position from = found->lowerBound(span.from);
    const auto extremes = found->extremes(from, found->lowerBound(span.to + Duration(1), from));
    if (!extremes)
        return std::nullopt;
    return std::pair(extremes->min, extremes->max);
}

SampleStatistics SampleStore::statistics(ChannelId channel, TimeSpan span) const
{
    const SampleChannel* found = m_data->findNonEmpty(channel);
    span = clampedSpan(span);
    if (!found || span.to < span.from)
        return {};
    const Position from = found->lowerBound(span.from);
    const Position to = found->lowerBound(span.to + Duration(1), from);
    const bool dropped = found->droppedUntil() && *found->droppedUntil() >= span.from;
    SampleStatistics statistics;
    statistics.exact = !dropped && found->exact(from, to);
    const auto extremes = found->extremes(from, to);
    if (!extremes)
        return statistics;
    const Moments moments = found->moments(from, to, span.from);
    statistics.count = moments.count;
    statistics.mean = moments.mean;
    statistics.min = extremes->min;
    statistics.max = extremes->max;
    statistics.sigma = std::sqrt(moments.squares / double(moments.count));
    statistics.slope = moments.timeSquares > 0 ? moments.products / moments.timeSquares : 0;
    return statistics;
}

std::vector<SamplePoint> SampleStore::points(ChannelId channel, TimeSpan span) const
{
    std::vector<SamplePoint> points;
    const SampleChannel* found = m_data->findNonEmpty(channel);
    span = clampedSpan(span);
    if (!found || span.to < span.from)
        return points;
    const Position from = found->lowerBound(span.from);
    const Position end = found->lowerBound(span.to + Duration(1), from);
    for (Position position = from; !(position == end); position = found->next(position))
        points.push_back(found->point(position));
    return points;
}

std::size_t SampleStore::bytes() const
{
    return m_data->bytes;
}

std::uint64_t SampleStore::count() const
{
    return m_data->count;
}

std::uint64_t SampleStore::outOfOrder() const
{
    return m_data->outOfOrder;
}

bool SampleStore::decimated() const
{
    return std::any_of(m_data->channels.begin(), m_data->channels.end(),
                       [](const auto& channel) { return channel && channel->decimated(); });
}
} // namespace recording
