// SPDX-License-Identifier: GPL-3.0-or-later
#include "jobs/scan/scan.h"

#include "device/transactions.h"
#include "jobs/scan/found_servos.h"
#include "jobs/scan/scan_list.h"
#include "jobs/scan/scan_plan.h"

#include <algorithm>
#include <list>

namespace jobs {
namespace {
using base::ErrorCode;
using base::Protocol;

constexpr base::Duration settleTime = std::chrono::milliseconds(5);
constexpr int collisionTries = 4;
constexpr base::Duration collisionWait = std::chrono::milliseconds(60); ///< adapters may be slow

class ScanRunner {
public:
    ScanRunner(const device::Context& context, const ScanSpec& spec, const ProgressFn& progress,
               const FoundServos::OnFound& onFound)
        : m_context(context)
        , m_spec(spec)
        , m_oldBaud(context.bus.baud())
        , m_progress(progress, context.bus.clock(), estimateScanTime(context, spec))
        , m_found(context, spec, onFound, m_progress)
    {}

    base::Result<ScanReport> run()
    {
        const base::Duration start = m_context.bus.clock().now();
        m_report.port = m_context.bus.portName();
        const auto searched = searchFast().and_then([this] { return searchSlow(); });
        const bool atForeignRate = m_context.bus.baud() != m_oldBaud;
        const auto restored = restoreBaud();
        // Torque-off frames sent at the rate just being searched reached none of the known servos.
        if (!searched && searched.error().code == ErrorCode::Preempted && atForeignRate)
            m_context.bus.emergency();
        if (!searched && searched.error().code != ErrorCode::Stopped)
            return tl::unexpected(searched.error());
        if (!restored)
            return tl::unexpected(restored.error());
        m_report.stopped = !searched;
        if (searched && m_found.isEmpty() && !m_report.busyRates.empty())
            return base::fail(ErrorCode::LineBusy, QStringLiteral("scan"));
        m_report.found = m_found.takeSorted(m_report.rates);
        m_report.slowPassAdvised = m_report.lateReplies > 1 && !m_spec.slowPass;
        m_report.elapsed = m_context.bus.clock().now() - start;
        m_progress.notify();
        return std::move(m_report);
    }

private:
    struct Search {
        int baud = 0;
        RateScan scan;
    };

    /// Every rate: the broadcasts, then the searches that are short or whose broadcast was
    /// answered.
    base::Result<void> searchFast()
    {
        for (const int baud : ratesToScan(m_spec, m_oldBaud)) {
            if (m_spec.untilFound && isRateFound() && !isNeighborOfFound(baud))
                continue;
            const auto set = setBaud(baud);
            if (!set && set.error().code == ErrorCode::RateUnsupported) {
                m_report.unsupportedRates.push_back(baud);
                m_progress.skip(estimateRate(m_context, m_spec, baud));
                continue;
            }
            if (!set)
                return set;
            m_report.rates.push_back(baud);
            const auto done =
                ignoreBusyRate(searchRate().and_then([&] { return judgeRate(baud); }));
            if (!done)
                return done;
        }
        return {};
    }

    bool isRateFound() const { return !m_foundRates.empty(); }

    /// A servo also replies at a rate a few percent off its own, which may come later.
    bool isNeighborOfFound(int baud) const
    {
        return std::any_of(m_foundRates.begin(), m_foundRates.end(),
                           [baud](int found) { return areNeighborRates(found, baud); });
    }

    /// Whether the servos have this rate. Several with one ID cannot be identified.
    base::Result<void> judgeRate(int baud)
    {
        if (!m_spec.untilFound)
            return {};
        bool isFound = m_found.hasIdentifiedAt(baud);
        for (const FoundServo& one : m_found.unidentifiedAt(baud)) {
            const auto proven = isFound ? true : onlyThisIdReplies(one);
            if (!proven)
                return tl::unexpected(proven.error());
            isFound = *proven;
        }
        if (isFound)
            m_foundRates.push_back(baud);
        return {};
    }

    /// Unlike noise, colliding replies follow each PING to their ID, and none to another.
    base::Result<bool> onlyThisIdReplies(const FoundServo& one)
    {
        const auto ids = idsToScan(m_spec, one.servo.protocol);
        const int otherId = one.servo.id == ids.last ? ids.first : ids.last;
        for (int i = 0; i < collisionTries; ++i) {
            for (const int id : {one.servo.id, otherId}) {
                const auto reply =
                    device::pingOnce(m_context, one.servo.protocol, id, collisionWait);
                if (!reply && base::endsJob(reply.error().code))
                    return tl::unexpected(reply.error());
                const bool isSilent = !reply && reply.error().code == ErrorCode::NoReply;
                if (isSilent != (id == otherId))
                    return false;
            }
        }
        return true;
    }

    base::Result<void> searchRate()
    {
        std::list<Search> searches;
        for (const Protocol protocol : protocolsToScan(m_context, m_spec, m_context.bus.baud())) {
            Search& search = searches.emplace_back(makeSearch(protocol));
            if (const auto pinged = pingBroadcast(search); !pinged)
                return pinged;
        }
        searches.sort([](const Search& a, const Search& b) {
            return a.scan.hasReply() && !b.scan.hasReply();
        });
        for (auto it = searches.begin(); it != searches.end();) {
            const auto search = it++;
            const RateScan& rateScan = search->scan;
            if (scanProfileOf(rateScan.protocol()).supportsBroadcast && !rateScan.hasReply())
                m_slow.splice(m_slow.end(), searches, search);
            else if (const auto done = scanIds(*search); !done)
                return done;
        }
        return {};
    }

    /// The searches that were put off, protocol by protocol.
    base::Result<void> searchSlow()
    {
        if (m_spec.untilFound)
            return isRateFound() ? base::Result<void>{} : searchLxElsewhere();
        m_slow.sort([](const Search& a, const Search& b) {
            return a.scan.protocol() == Protocol::Lx && b.scan.protocol() != Protocol::Lx;
        });
        for (Search& search : m_slow) {
            const auto done =
                setBaud(search.baud).and_then([&] { return ignoreBusyRate(scanIds(search)); });
            if (!done)
                return done;
        }
        return {};
    }

    /// An LX servo has one rate, but after garbled traffic some replied at another one (LX sheet).
    base::Result<void> searchLxElsewhere()
    {
        const auto& refused = m_report.unsupportedRates;
        for (const int baud : ratesForLxAtTheEnd(m_context, m_spec)) {
            if (std::find(refused.begin(), refused.end(), baud) != refused.end())
                continue;
            if (const auto set = setBaud(baud); !set)
                return set;
            Search search = makeSearch(Protocol::Lx);
            const auto ping = [&] {
                const auto pinged = pingBroadcast(search);
                return pinged && !m_found.hasIdentified() && search.scan.hasReply()
                           ? scanIds(search)
                           : pinged;
            };
            const auto done = ignoreBusyRate(ping());
            if (!done || m_found.hasIdentified())
                return done;
        }
        return {};
    }

    /// A busy rate is reported, and the others are searched.
    base::Result<void> ignoreBusyRate(base::Result<void> searched)
    {
        if (searched || searched.error().code != ErrorCode::LineBusy)
            return searched;
        addBusyRate();
        return {};
    }

    void addBusyRate()
    {
        const int baud = m_context.bus.baud();
        auto& busy = m_report.busyRates;
        if (std::find(busy.begin(), busy.end(), baud) == busy.end())
            busy.push_back(baud);
    }

    Search makeSearch(Protocol protocol)
    {
        const int baud = m_context.bus.baud();
        return {baud, RateScan(
                          m_context, m_spec, protocol,
                          [this, baud, protocol](base::Duration planned, int foundCount) {
                              m_progress.add(planned, foundCount - m_found.countAt(baud, protocol));
                          },
                          [this, baud](const RateScan& rateScan, int id) {
                              return m_found.add(id, baud, rateScan);
                          })};
    }

    base::Result<void> restoreBaud()
    {
        if (m_context.bus.baud() == m_oldBaud)
            return {};
        return m_context.bus.setBaud(m_oldBaud);
    }

    base::Result<void> setBaud(int baud)
    {
        if (baud == m_context.bus.baud())
            return {};
        if (!m_context.bus.canSetBaud())
            return base::fail(ErrorCode::RateUnsupported, QStringLiteral("scan"),
                              QString::number(baud));
        return m_context.bus.setBaud(baud).and_then(
            [this] { return m_context.bus.listen(settleTime); });
    }

    base::Result<void> pingBroadcast(Search& search)
    {
        m_progress.startSearch(search.baud, search.scan.protocol());
        const auto onlyServo = search.scan.pingBroadcast();
        if (!onlyServo)
            return tl::unexpected(onlyServo.error());
        return *onlyServo ? m_found.add(**onlyServo, search.baud, search.scan)
                          : base::Result<void>{};
    }

    base::Result<void> scanIds(Search& search)
    {
        m_progress.startSearch(search.baud, search.scan.protocol());
        const auto scanned = search.scan.run();
        m_report.lateReplies += search.scan.lateReplies();
        if (search.scan.isLineBusy())
            addBusyRate();
        m_report.hasGarbledReplies =
            m_report.hasGarbledReplies || search.scan.hasUnexplainedGarbled();
        const bool stopped = !scanned && scanned.error().code == ErrorCode::Stopped;
        if (!scanned && !stopped)
            return scanned;
        for (const auto& [id, response] : search.scan.responsesById()) {
            const auto added = response.isPresent() ? m_found.add(id, search.baud, search.scan)
                                                    : base::Result<void>{};
            if (!added)
                return added;
        }
        if (m_context.stop.isRequested())
            return base::fail(ErrorCode::Stopped, QStringLiteral("scan"));
        return {};
    }

    const device::Context& m_context;
    const ScanSpec& m_spec;
    int m_oldBaud;
    ScanProgress m_progress;
    FoundServos m_found;
    std::vector<int> m_foundRates; ///< the servos have these
    std::list<Search> m_slow;      ///< put off
    ScanReport m_report;
};
} // namespace

base::Result<ScanReport> scan(const device::Context& context, const ScanSpec& spec,
                              const ProgressFn& progress,
                              const std::function<void(const FoundServo&)>& onFound)
{
    if (const auto good = checkSpec(context, spec); !good)
        return tl::unexpected(good.error());
    // Servos may have been plugged in since they were last written to.
    context.bus.verifiedIds().clear();
    // At another rate the scan needs the bus for itself; at its own rate the bus keeps polling.
    const int baud = context.bus.baud();
    if (ratesToScan(spec, baud) == std::vector{baud})
        return ScanRunner(context, spec, progress, onFound).run();
    const device::Owned owned = device::own(context, {});
    return ScanRunner(owned.context, spec, progress, onFound).run();
}
} // namespace jobs
