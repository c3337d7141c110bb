// SPDX-License-Identifier: GPL-3.0-or-later
// What a chart is told about samples, held against plain arithmetic over all of the same samples:
// columns, ranges, statistics, gaps; and what is left when the room is used up.
#include "recording/sample_store.h"
#include "support/test_main.h"

#include <QtTest>

#include <algorithm>
#include <cmath>
#include <random>

using base::Duration;
using recording::SampleColumn;
using recording::SamplePoint;
using recording::SampleStatistics;
using recording::SampleStore;
using recording::TimeSpan;

namespace {
constexpr Duration second = std::chrono::seconds(1);

/// The same samples without any art: a list.
struct ReferenceStore {
    std::vector<SamplePoint> points;
    std::vector<bool> gapBefore;
    bool gapNext = false;

    void add(SampleStore& store, int channel, SamplePoint point)
    {
        store.append(channel, point.at, point.value);
        points.push_back(point);
        gapBefore.push_back(gapNext);
        gapNext = false;
    }
    void gap(SampleStore& store, int channel)
    {
        store.gap(channel);
        gapNext = true;
    }
    std::vector<SamplePoint> within(TimeSpan span) const
    {
        std::vector<SamplePoint> some;
        for (const SamplePoint& point : points) {
            if (point.at >= span.from && point.at <= span.to)
                some.push_back(point);
        }
        return some;
    }
};

/// Uneven times (some equal, some hours apart), noise around a walk, gaps.
ReferenceStore fill(SampleStore& store, int channel, std::mt19937& random, int count)
{
    ReferenceStore plain;
    Duration at{std::int64_t(random() % 1000000) - 500000};
    double value = double(random() % 100000);
    for (int i = 0; i < count; ++i) {
        const unsigned dice = random() % 1000;
        at += dice == 0   ? std::chrono::hours(2)
              : dice < 50 ? Duration(0)
                          : Duration(random() % 10000);
        value += double(random() % 2001) / 1000 - 1;
        if (dice >= 990)
            plain.gap(store, channel);
        plain.add(store, channel, {at, value});
    }
    return plain;
}

TimeSpan randomSpan(const ReferenceStore& plain, std::mt19937& random)
{
    const Duration first = plain.points[random() % plain.points.size()].at;
    const Duration last = plain.points[random() % plain.points.size()].at;
    const Duration shift(std::int64_t(random() % 3) - 1);
    return {std::min(first, last) + shift, std::max(first, last) + shift};
}

SampleStatistics naiveStatistics(const std::vector<SamplePoint>& points)
{
    SampleStatistics sum;
    long double mean = 0;
    long double meanTime = 0;
    for (const SamplePoint& point : points) {
        mean += point.value;
        meanTime += (long double)(point.at.count()) * 1e-6L;
    }
    sum.count = points.size();
    mean /= (long double)(points.size());
    meanTime /= (long double)(points.size());
    long double squares = 0;
    long double timeSquares = 0;
    long double products = 0;
    sum.min = sum.max = points.front().value;
    for (const SamplePoint& point : points) {
        const long double time = (long double)(point.at.count()) * 1e-6L - meanTime;
        squares += (point.value - mean) * (point.value - mean);
        timeSquares += time * time;
        products += time * (point.value - mean);
        sum.min = std::min(sum.min, point.value);
        sum.max = std::max(sum.max, point.value);
    }
    sum.mean = double(mean);
    sum.sigma = double(std::sqrt(squares / (long double)(points.size())));
    sum.slope = timeSquares > 0 ? double(products / timeSquares) : 0;
    return sum;
}

bool near(double a, double b)
{
    return std::abs(a - b) <= 1e-9 * std::max({std::abs(a), std::abs(b), 1e-3});
}

/// Each sample of the stretch is in one column, in order; a column says the truth about its own.
void verifyColumns(const std::vector<SampleColumn>& columns, const ReferenceStore& plain,
                   TimeSpan span, int pixels)
{
    const auto first = std::find_if(plain.points.begin(), plain.points.end(),
                                    [&](const SamplePoint& p) { return p.at >= span.from; });
    const auto last = std::find_if(first, plain.points.end(),
                                   [&](const SamplePoint& p) { return p.at > span.to; });
    QVERIFY(std::ssize(columns) <= pixels + 2);
    if (columns.empty()) {
        QVERIFY(first == last);
        return;
    }
    auto i = std::size_t(
        std::find_if(plain.points.begin(), plain.points.end(),
                     [&](const SamplePoint& p) { return p.at >= columns.front().from; }) -
        plain.points.begin());
    // Of several samples at the instant, the column before the picture has the last only.
    while (i + 1 < plain.points.size() && plain.points[i].at == columns.front().from &&
           plain.points[i].value != columns.front().first)
        ++i;
    const std::size_t begin = i;
    for (const SampleColumn& column : columns) {
        QCOMPARE(column.from, plain.points[i].at);
        QCOMPARE(column.first, plain.points[i].value);
        QCOMPARE(column.gapBefore, bool(plain.gapBefore[i]));
        double min = column.first;
        double max = column.first;
        double value = column.first;
        const bool extra = &column == &columns.back() && column.from > span.to;
        while (i < plain.points.size() && plain.points[i].at <= column.to) {
            value = plain.points[i].value;
            min = std::min(min, value);
            max = std::max(max, value);
            ++i;
            if (extra)
                break;
        }
        QCOMPARE(column.last, value);
        QCOMPARE(column.min, min);
        QCOMPARE(column.max, max);
        QVERIFY(column.to >= column.from);
    }
    // Lines run out of the picture on both sides.
    const auto shownFrom = std::size_t(first - plain.points.begin());
    const auto shownTo = std::size_t(last - plain.points.begin());
    QVERIFY(shownFrom == 0 ? begin == 0 : begin < shownFrom);
    QVERIFY(shownTo == plain.points.size() ? i == shownTo : i > shownTo);
}
} // namespace

class TestSampleStore : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { QTest::failOnWarning(QRegularExpression(QStringLiteral(".*"))); }

    void emptyStore()
    {
        SampleStore store;
        const int channel = store.open();
        std::vector<SampleColumn> columns(3);
        for (const int any : {channel, -1, 77}) {
            QVERIFY(!store.span(any));
            QVERIFY(!store.latest(any));
            QVERIFY(!store.at(any, Duration(0)));
            QVERIFY(!store.range(any, {Duration(0), second}));
            QCOMPARE(store.statistics(any, {Duration(0), second}).count, 0U);
            QVERIFY(store.points(any, {Duration(0), second}).empty());
            store.columns(any, {Duration(0), second}, 100, columns);
            QVERIFY(columns.empty());
        }
        QVERIFY(!store.span());
        store.append(77, Duration(0), 1);
        store.gap(77);
        QCOMPARE(store.count(), 0U);
    }

    void statisticsMatchTheSamples()
    {
        std::mt19937 random(5);
        for (const int count : {1, 2, 63, 64, 65, 4095, 4096, 4097, 30000}) {
            SampleStore store;
            const int channel = store.open();
            const ReferenceStore plain = fill(store, channel, random, count);
            for (int i = 0; i < 60; ++i) {
                const TimeSpan span = randomSpan(plain, random);
                const auto samples = plain.within(span);
                const SampleStatistics got = store.statistics(channel, span);
                QCOMPARE(got.count, samples.size());
                QCOMPARE(store.points(channel, span), samples);
                QVERIFY(got.exact);
                const auto range = store.range(channel, span);
                QCOMPARE(range.has_value(), !samples.empty());
                if (samples.empty())
                    continue;
                const SampleStatistics wanted = naiveStatistics(samples);
                QCOMPARE(got.min, wanted.min);
                QCOMPARE(got.max, wanted.max);
                QCOMPARE(*range, std::pair(wanted.min, wanted.max));
                QVERIFY2(near(got.mean, wanted.mean), qPrintable(QString::number(got.mean)));
                QVERIFY(near(got.sigma, wanted.sigma));
                QVERIFY(near(got.slope, wanted.slope));
            }
        }
    }

    // A small noise on a large number, after days of the clock.
    void statisticsKeepTheirDigits()
    {
        SampleStore store;
        const int channel = store.open();
        const Duration start = std::chrono::hours(24 * 30);
        for (int i = 0; i < 20000; ++i)
            store.append(channel, start + Duration(5000) * i, 1e7 + (i % 2 == 0 ? 0.001 : -0.001));
        const auto got = store.statistics(channel, {start, start + second * 1000});
        QCOMPARE(got.count, 20000U);
        QVERIFY(std::abs(got.mean - 1e7) < 1e-7);
        QVERIFY(std::abs(got.sigma - 0.001) < 1e-7);

        const int ramp = store.open();
        for (int i = 0; i < 20000; ++i)
            store.append(ramp, start + Duration(5000) * i, 3 + 0.25 * (i * 0.005));
        QVERIFY(near(store.statistics(ramp, {start, start + second * 1000}).slope, 0.25));
    }

    void columnsMatchTheSamples()
    {
        std::mt19937 random(7);
        for (const int count : {1, 2, 100, 4096, 4097, 20000}) {
            SampleStore store;
            const int channel = store.open();
            const ReferenceStore plain = fill(store, channel, random, count);
            std::vector<SampleColumn> columns;
            for (int i = 0; i < 60; ++i) {
                const TimeSpan span = randomSpan(plain, random);
                const int pixels = int(random() % 900) + 1;
                store.columns(channel, span, pixels, columns);
                verifyColumns(columns, plain, span, pixels);
                if (QTest::currentTestFailed())
                    return;
            }
        }
    }

    // While the picture moves on, a column that stays in it stays what it was.
    void aScrollingChartDoesNotFlicker()
    {
        SampleStore store;
        const int channel = store.open();
        std::mt19937 random(9);
        for (int i = 0; i < 100000; ++i)
            store.append(channel, Duration(5000) * i, double(random() % 1000));
        std::vector<SampleColumn> before;
        std::vector<SampleColumn> after;
        const Duration length = second * 60;
        for (int frame = 0; frame < 50; ++frame) {
            const Duration from = second * 100 + Duration(33333) * frame;
            store.columns(channel, {from, from + length}, 1000, before);
            // A microsecond more or less is what rounding in a chart comes to.
            store.columns(channel, {from + Duration(33333), from + Duration(33334) + length}, 1000,
                          after);
            int same = 0;
            for (std::size_t i = 1; i + 1 < before.size(); ++i)
                same += std::any_of(after.begin(), after.end(), [&](const SampleColumn& column) {
                    return column.from == before[i].from && column.to == before[i].to &&
                           column.min == before[i].min && column.max == before[i].max;
                });
            QVERIFY2(same >= int(before.size()) - 4, qPrintable(QString::number(same)));
        }
    }

    void unusualColumnQueries()
    {
        SampleStore store;
        const int channel = store.open();
        for (int i = 0; i < 100; ++i)
            store.append(channel, second * i, i);
        std::vector<SampleColumn> columns;
        store.columns(channel, {second * 5, second * 4}, 100, columns);
        QVERIFY(columns.empty());
        store.columns(channel, {second * 5, second * 6}, 0, columns);
        QVERIFY(columns.empty());
        store.columns(channel, {Duration::min(), Duration::max()}, 10, columns);
        QCOMPARE(columns.size(), 1U);
        QCOMPARE(columns.back().max, 99.0);
        // Between two samples: the line through the picture needs both of them.
        store.columns(channel, {Duration(5400000), Duration(5600000)}, 100, columns);
        QCOMPARE(columns.size(), 2U);
        QCOMPARE(columns[0].last, 5.0);
        QCOMPARE(columns[1].first, 6.0);
        // Before the first, after the last: one.
        store.columns(channel, {-second * 9, -second}, 100, columns);
        QCOMPARE(columns.size(), 1U);
        store.columns(channel, {second * 200, second * 300}, 100, columns);
        QCOMPARE(columns.size(), 1U);
        QCOMPARE(columns[0].first, 99.0);
    }

    void theValueAtATime()
    {
        SampleStore store;
        const int channel = store.open();
        store.append(channel, second, 1);
        store.append(channel, second * 2, 2);
        store.gap(channel);
        store.append(channel, second * 4, 4);
        QVERIFY(!store.at(channel, second - Duration(1)));
        QCOMPARE(store.at(channel, second)->value, 1.0);
        QCOMPARE(store.at(channel, second * 2 - Duration(1))->value, 1.0);
        QCOMPARE(store.at(channel, second * 2)->value, 2.0);
        QVERIFY(!store.at(channel, second * 2 + Duration(1)));
        QVERIFY(!store.at(channel, second * 3));
        QCOMPARE(store.at(channel, second * 4)->value, 4.0);
        QCOMPARE(store.at(channel, second * 9)->value, 4.0);
        store.gap(channel);
        QVERIFY(!store.at(channel, second * 9));
        QCOMPARE(store.at(channel, second * 4)->value, 4.0);
        QCOMPARE(store.latest(channel)->value, 4.0);
        QCOMPARE(store.at(channel, Duration::max()).has_value(), false);
    }

    void nanIsAGap()
    {
        SampleStore store;
        const int channel = store.open();
        store.append(channel, second, 1);
        store.append(channel, second * 2, std::nan(""));
        store.append(channel, second * 3, std::numeric_limits<double>::infinity());
        store.append(channel, second * 4, 4);
        QCOMPARE(store.count(), 2U);
        QVERIFY(!store.at(channel, second * 3));
        QCOMPARE(*store.range(channel, {Duration(0), second * 9}), std::pair(1.0, 4.0));
        std::vector<SampleColumn> columns;
        store.columns(channel, {Duration(0), second * 9}, 1000, columns);
        QCOMPARE(columns.size(), 2U);
        QVERIFY(!columns[0].gapBefore);
        QVERIFY(columns[1].gapBefore);
    }

    void timeIsMonotonic()
    {
        SampleStore store;
        const int one = store.open();
        const int two = store.open();
        const std::vector<SamplePoint> points{
            {second * 2, 2}, {second, 1}, {second * 2, 3}, {second * 3, 4}};
        store.append(one, points);
        store.append(two, second, 7); // its own time
        QCOMPARE(store.outOfOrder(), 1U);
        QCOMPARE(store.count(), 4U);
        QCOMPARE(store.points(one, {Duration(0), second * 9}),
                 (std::vector<SamplePoint>{{second * 2, 2}, {second * 2, 3}, {second * 3, 4}}));
        QCOMPARE(store.span(), (TimeSpan{second, second * 3}));
        QCOMPARE(store.span(one), (TimeSpan{second * 2, second * 3}));
    }

    void closingAndClearing()
    {
        SampleStore store;
        const int one = store.open();
        const int two = store.open();
        for (int i = 0; i < 10000; ++i) {
            store.append(one, second * i, i);
            store.append(two, second * i, i);
        }
        const std::size_t both = store.bytes();
        store.close(one);
        QVERIFY(store.bytes() < both * 6 / 10);
        QVERIFY(!store.span(one));
        store.append(one, second, 1);
        QVERIFY(!store.span(one));
        QCOMPARE(store.open(), 2);
        store.clear();
        QCOMPARE(store.bytes(), 0U);
        QCOMPARE(store.count(), 0U);
        QVERIFY(!store.span());
        store.append(two, second, 5); // the channel is still there, and time begins anew
        QCOMPARE(store.latest(two)->value, 5.0);
        store.close(2);
        store.close(two);
        QCOMPARE(store.bytes(), 0U);
        SampleStore moved = std::move(store);
        QCOMPARE(moved.open(), 3);
    }

    // When room runs out: every extreme of each 64 samples is still there at its time, and so are
    // both ends and the gaps.
    void thinningKeepsTheExtremes()
    {
        std::mt19937 random(11);
        SampleStore store(600'000);
        const int channel = store.open();
        ReferenceStore plain;
        for (int i = 0; i < 200000; ++i) {
            if (i % 10007 == 10006)
                plain.gap(store, channel);
            double value = double(random() % 1000);
            if (i % 777 == 0)
                value = 5000 + i;
            if (i % 888 == 1)
                value = -5000 - i;
            plain.add(store, channel, {Duration(5000) * i, value});
            QVERIFY(store.bytes() <= 600'000);
        }
        QVERIFY(store.decimated());
        QCOMPARE(store.count(), 200000U);
        const TimeSpan all{plain.points.front().at, plain.points.back().at};
        QCOMPARE(store.span(), all);
        const auto kept = store.points(channel, all);
        QVERIFY(kept.size() < plain.points.size() / 2);
        std::size_t next = 0;
        for (std::size_t i = 0; i < plain.points.size(); ++i) {
            const SamplePoint& point = plain.points[i];
            const bool there = next < kept.size() && kept[next] == point;
            if (std::abs(point.value) >= 5000 || plain.gapBefore[i])
                QVERIFY2(there, qPrintable(QString::number(i)));
            next += there ? 1 : 0;
        }
        QCOMPARE(next, kept.size()); // nothing is there that was not measured
        std::vector<SampleColumn> columns;
        store.columns(channel, all, 1'000'000, columns); // narrower than samples are apart
        QCOMPARE(std::count_if(columns.begin(), columns.end(),
                               [](const SampleColumn& column) { return column.gapBefore; }),
                 std::count(plain.gapBefore.begin(), plain.gapBefore.end(), true));
        for (int i = 0; i < 100; ++i) {
            const TimeSpan span = randomSpan(plain, random);
            const auto range = store.range(channel, span);
            const auto wanted = naiveStatistics(plain.within(span));
            // At its ends a stretch may cut a thinned 64: then extremes of less than the peaks.
            if (wanted.max >= 5000)
                QCOMPARE(range->second, wanted.max);
            if (wanted.min <= -5000)
                QCOMPARE(range->first, wanted.min);
        }
    }

    // Of thinned parts the whole is still known exactly; a cut through one is not, and says so.
    void inexactStatisticsAreMarked()
    {
        SampleStore store(400'000);
        const int channel = store.open();
        ReferenceStore plain;
        for (int i = 0; i < 100000; ++i)
            plain.add(store, channel, {Duration(5000) * i, std::sin(i * 0.01)});
        QVERIFY(store.decimated());
        const TimeSpan all{plain.points.front().at, plain.points.back().at};
        const SampleStatistics whole = store.statistics(channel, all);
        const SampleStatistics wanted = naiveStatistics(plain.points);
        QVERIFY(whole.exact);
        QCOMPARE(whole.count, wanted.count);
        QVERIFY(near(whole.mean, wanted.mean));
        QVERIFY(near(whole.sigma, wanted.sigma));
        QVERIFY(near(whole.slope, wanted.slope));
        QVERIFY(!store.statistics(channel, {second, all.to}).exact);
        QVERIFY(store.statistics(channel, {all.to - second * 10, all.to}).exact);
    }

    void theOldestIsThinnedFirstAndDroppedLast()
    {
        SampleStore store(200'000);
        const int old = store.open();
        const int young = store.open();
        const TimeSpan always{Duration(0), second * 10'000'000};
        for (int i = 0; i < 6000; ++i)
            store.append(old, second * i, i % 100);
        for (int i = 0; i < 6000; ++i)
            store.append(young, second * (6000 + i), i % 100);
        QVERIFY(!store.decimated());
        for (int i = 0; i < 4096; ++i)
            store.append(young, second * (12000 + i), i % 100);
        QVERIFY(store.decimated());
        QVERIFY(store.points(old, always).size() < 3000);
        QCOMPARE(store.points(young, always).size(), 10096U);
        QCOMPARE(store.span()->from, Duration(0));

        // So much that even extremes of it find no room.
        for (int i = 0; i < 2'000'000; ++i)
            store.append(young, second * (20000 + i), i % 100);
        QVERIFY(store.bytes() <= 200'000);
        QVERIFY(store.span(young)->from > second * 6000);
        QCOMPARE(store.latest(young)->at, second * 2'019'999);
        QVERIFY(!store.statistics(young, {second * 6000, second * 2'019'999}).exact);
        QVERIFY(store.latest(old)); // an unfinished chunk is not taken from anybody
    }

    // A servo that answers every other time leaves nothing to thin: the room is kept all the same.
    void gapsEverywhere()
    {
        SampleStore store(300'000);
        const int channel = store.open();
        for (int i = 0; i < 100000; ++i) {
            store.append(channel, Duration(5000) * i, i);
            store.gap(channel);
        }
        QVERIFY(store.bytes() <= 300'000);
        QCOMPARE(store.latest(channel)->value, 99999.0);
        QVERIFY(!store.at(channel, Duration(5000) * 99998 + Duration(1)));
    }

    /// A smaller budget counts at once, a larger one from then on.
    void aSmallerBudgetCountsAtOnce()
    {
        SampleStore store;
        const int channel = store.open();
        for (int i = 0; i < 200'000; ++i)
            store.append(channel, i * std::chrono::milliseconds(1), i % 1000);
        const std::size_t whole = store.bytes();
        QVERIFY(!store.decimated());
        store.setBudget(whole / 2);
        QVERIFY(store.bytes() <= whole / 2);
        QVERIFY(store.decimated());
        QCOMPARE(store.latest(channel)->value, 999.0);
    }
};

SERVODESK_GUILESS_TEST(TestSampleStore)
#include "tst_sample_store.moc"
