// SPDX-License-Identifier: GPL-3.0-or-later
#include "jobs/watch/watch.h"

#include "jobs/watch/watch_decoder.h"

#include <algorithm>

namespace jobs {
namespace {
constexpr base::Duration drainInterval = std::chrono::milliseconds(50);
constexpr base::Duration quietTime = std::chrono::milliseconds(150);
/// A line that is busy for longer does not fall silent by being watched.
constexpr base::Duration busyTimeout = std::chrono::seconds(3);

using OnRow = std::function<base::Result<void>(const WatchRow&)>;

class WatchRunner {
public:
    WatchRunner(const device::Context& context, const WatchSpec& spec, WatchDecoder decoder,
                const OnRow& onRow)
        : m_context(context)
        , m_spec(spec)
        , m_decoder(std::move(decoder))
        , m_onRow(onRow)
    {}

    base::Result<WatchReport> run()
    {
        // A servo that did not answer a request of another protocol is left alone for a while.
        // After that the first round reads all servos.
        const bool several = m_context.catalog.protocolsAt(m_context.bus.baud()).size() > 1;
        const auto listened = m_context.bus.listen(
            several ? std::max(quietTime, m_context.bus.maxReplyLateness()) : base::Duration{});
        if (!listened)
            return tl::unexpected(listened.error());
        const base::Duration start = m_context.bus.clock().now();
        m_poll = m_context.bus.startPoll(m_decoder.plan());
        const auto watched = drainUntilEnd(start);
        m_context.bus.stopPoll(m_poll);
        if (!watched)
            return tl::unexpected(watched.error());
        m_report.columns = m_decoder.columns();
        m_report.elapsed = m_context.bus.clock().now() - start;
        return std::move(m_report);
    }

private:
    base::Result<void> drainUntilEnd(base::Duration start)
    {
        base::Clock& clock = m_context.bus.clock();
        const bool endless = m_spec.length.count() == 0;
        const base::Duration end = start + m_spec.length;
        while (!m_report.stopped && (endless || clock.now() < end)) {
            const base::Duration next = clock.now() + drainInterval;
            const auto until = endless ? next : std::min(next, end);
            m_report.stopped = !m_context.bus.pauseUntil(until, &m_context.stop);
            if (const auto drained = drain(); !drained)
                return drained;
        }
        return deliver(m_decoder.flush());
    }

    base::Result<void> drain()
    {
        const auto samples = m_context.bus.takeSamples(m_poll);
        for (const bus::Sample& sample : samples) {
            m_report.missed += sample.answered ? 0 : 1;
            if (sample.answered || sample.error != base::ErrorCode::LineBusy)
                m_busySince.reset();
            else if (sample.at - m_busySince.value_or(sample.at) > busyTimeout)
                return base::fail(base::ErrorCode::LineBusy, QStringLiteral("watch"));
            else
                m_busySince = m_busySince.value_or(sample.at);
            if (const auto delivered = deliver(m_decoder.add(sample)); !delivered)
                return delivered;
        }
        for (device::Notice& alarm : m_decoder.takeAlarms())
            m_context.notices.push_back(std::move(alarm));
        // A lost link yields no samples; it shows when one listens.
        if (samples.empty()) {
            const auto listened = m_context.bus.listen({});
            if (!listened && listened.error().code == base::ErrorCode::LinkLost)
                return listened;
        }
        return {};
    }

    base::Result<void> deliver(const std::vector<WatchRow>& rows)
    {
        for (const WatchRow& row : rows) {
            m_report.rows += row.answered ? 1 : 0;
            if (const auto accepted = m_onRow(row); !accepted)
                return accepted;
        }
        return {};
    }

    const device::Context& m_context;
    const WatchSpec& m_spec;
    WatchDecoder m_decoder;
    const OnRow& m_onRow;
    bus::PollId m_poll = 0;
    std::optional<base::Duration> m_busySince; ///< since then only that has been heard
    WatchReport m_report;
};
} // namespace

base::Result<WatchReport> watch(const device::Context& context, const WatchSpec& spec,
                                const std::function<base::Result<void>(const WatchRow&)>& onRow)
{
    auto decoder = WatchDecoder::make(spec);
    if (!decoder)
        return tl::unexpected(decoder.error());
    return WatchRunner(context, spec, std::move(*decoder), onRow).run();
}
} // namespace jobs
