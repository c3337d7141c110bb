// SPDX-License-Identifier: GPL-3.0-or-later
#include "jobs/scan.h"

#include "device/reader.h"
#include "jobs/scan_sweep.h"
#include "jobs/scan_twins.h"

#include <algorithm>
#include <cstdlib>

namespace jobs {
namespace {
using base::ErrorCode;

constexpr base::Duration settleTime = std::chrono::milliseconds(5);
constexpr base::Duration progressInterval = std::chrono::milliseconds(50);
// A receiver takes a rate that is up to this far off, so 250000 is also heard at 256000.
constexpr double rateTolerance = 0.04;

std::vector<int> ratesToSearch(const ScanSpec& spec, int presentBaud)
{
    std::vector<int> rates;
    for (const int baud : spec.bauds) {
        if (std::find(rates.begin(), rates.end(), baud) == rates.end())
            rates.push_back(baud);
    }
    if (rates.empty())
        rates.push_back(presentBaud);
    return rates;
}

/// Progress by planned time: what is left of the plan is the estimate.
class Meter {
public:
    Meter(const ProgressFn& report, base::Clock& clock, base::Duration total)
        : m_report(report)
        , m_clock(clock)
        , m_total(total)
    {}

    /// `heard`: servos at the present rate that are not counted as found yet.
    void add(base::Duration planned, int heard)
    {
        m_now.found = m_found + heard;
        m_done = std::min(m_total, m_done + planned);
        if (m_clock.now() - m_reportedAt >= progressInterval)
            tell();
    }

    void startRate(int baud)
    {
        m_now.baud = baud;
        tell();
    }
    void skip(base::Duration planned) { m_total -= planned; }
    void countFound() { m_now.found = ++m_found; }

    void tell()
    {
        if (!m_report)
            return;
        m_reportedAt = m_clock.now();
        m_now.fraction = m_total.count() > 0 ? double(m_done.count()) / double(m_total.count()) : 1;
        m_now.remaining = m_total - m_done;
        m_report(m_now);
    }

private:
    const ProgressFn& m_report;
    base::Clock& m_clock;
    base::Duration m_total;
    base::Duration m_done{};
    base::Duration m_reportedAt{};
    int m_found = 0;
    Progress m_now;
};

class Scan {
public:
    Scan(const device::Context& context, const ScanSpec& spec, const ProgressFn& progress,
         const std::function<void(const Found&)>& onFound)
        : m_context(context)
        , m_spec(spec)
        , m_onFound(onFound)
        , m_oldBaud(context.bus.baud())
        , m_meter(progress, context.bus.clock(), scanEstimate(spec, m_oldBaud))
    {}

    base::Result<ScanReport> run()
    {
        const base::Duration start = m_context.bus.clock().now();
        const auto rates = ratesToSearch(m_spec, m_oldBaud);
        m_report.port = m_context.bus.portName();
        const auto searched = searchRates(rates);
        const bool atForeignRate = m_context.bus.baud() != m_oldBaud;
        const auto restored = restoreBaud();
        // Torque-off frames sent at a rate just being searched reached nobody the user knows.
        if (!searched && searched.error().code == ErrorCode::Preempted && atForeignRate)
            m_context.bus.emergency();
        if (!searched && searched.error().code != ErrorCode::Stopped)
            return tl::unexpected(searched.error());
        if (!restored)
            return tl::unexpected(restored.error());
        m_report.stopped = !searched;
        dropNeighbourRates();
        m_report.slowPassAdvised = m_report.lateReplies > 1 && !m_spec.slowPass;
        m_report.elapsed = m_context.bus.clock().now() - start;
        m_meter.tell();
        return std::move(m_report);
    }

private:
    base::Result<void> searchRates(const std::vector<int>& rates)
    {
        for (const int baud : rates) {
            const auto set = setBaud(baud);
            if (!set && set.error().code == ErrorCode::RateUnsupported) {
                m_report.ratesRefused.push_back(baud);
                m_meter.skip(sweepEstimate(m_spec, baud));
                continue;
            }
            if (!set)
                return set;
            m_report.rates.push_back(baud);
            m_meter.startRate(baud);
            if (const auto done = searchRate(); !done)
                return done;
        }
        return {};
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
        if (!m_context.bus.hasBaud())
            return base::fail(ErrorCode::RateUnsupported, QStringLiteral("scan"),
                              QString::number(baud));
        return m_context.bus.setBaud(baud).and_then(
            [this] { return m_context.bus.listen(settleTime); });
    }

    base::Result<void> searchRate()
    {
        RateSweep sweep(m_context, m_spec,
                        [this](base::Duration planned, int heard) { m_meter.add(planned, heard); });
        const auto swept = sweep.run();
        m_report.lateReplies += sweep.lateReplies();
        m_report.garbledHeard = m_report.garbledHeard || sweep.garbledUnexplained();
        const bool stopped = !swept && swept.error().code == ErrorCode::Stopped;
        if (!swept && !stopped)
            return swept;
        for (const auto& [id, contact] : sweep.contacts()) {
            const auto added = contact.present() ? addFound(id, contact) : base::Result<void>{};
            if (!added)
                return added;
        }
        if (m_context.stop.requested())
            return base::fail(ErrorCode::Stopped, QStringLiteral("scan"));
        return {};
    }

    base::Result<void> addFound(int id, const Contact& contact)
    {
        Found found;
        found.servo.id = id;
        found.servo.baud = m_context.bus.baud();
        found.servo.port = m_context.bus.portName();
        found.servo.status = contact.status;
        found.heardLate = contact.late;
        found.twinsSuspected = contact.twins();
        // Who has answered is listed, also when the stop comes before the name is known.
        if (m_spec.identify && contact.replies > 0 && !m_context.stop.requested()) {
            const auto done = identify(found);
            if (!done && done.error().code != ErrorCode::Stopped)
                return done;
        }
        m_meter.countFound();
        m_report.found.push_back(found);
        if (m_onFound)
            m_onFound(found);
        return {};
    }

    base::Result<void> identify(Found& found)
    {
        auto servo = device::identify(m_context, found.servo.id);
        if (!servo) {
            const ErrorCode code = servo.error().code;
            const bool broken = code == ErrorCode::Garbled || code == ErrorCode::WrongAnswer;
            found.twinsSuspected = found.twinsSuspected || broken;
            if (broken || code == ErrorCode::NoAnswer)
                return {};
            return tl::unexpected(servo.error());
        }
        found.servo = std::move(*servo);
        const auto twins = suspectTwins(m_context, found.servo);
        if (!twins)
            return tl::unexpected(twins.error());
        found.twinsSuspected = found.twinsSuspected || *twins;
        return {};
    }

    /// The rate its own baud register names, 0 if that is not known.
    static int ownRate(const device::Servo& servo)
    {
        const catalog::Register* reg =
            servo.profile ? servo.profile->byRole(catalog::Role::BaudRate) : nullptr;
        const auto code = servo.raw(catalog::Role::BaudRate);
        if (reg == nullptr || !code)
            return 0;
        for (const catalog::NamedValue& value : reg->values) {
            if (value.value == *code)
                return value.key.toInt();
        }
        return 0;
    }

    /// One servo heard at two rates a few per cent apart is listed once, at its own.
    void dropNeighbourRates()
    {
        const auto heardElsewhere = [this](const Found& weak) {
            return std::any_of(
                m_report.found.begin(), m_report.found.end(), [&](const Found& strong) {
                    const int baud = strong.servo.baud;
                    const bool neighbours =
                        baud != weak.servo.baud &&
                        std::abs(baud - weak.servo.baud) <= rateTolerance * baud;
                    return neighbours && strong.servo.id == weak.servo.id &&
                           ownRate(strong.servo) == baud && ownRate(weak.servo) != weak.servo.baud;
                });
        };
        std::vector<Found> kept;
        std::copy_if(m_report.found.begin(), m_report.found.end(), std::back_inserter(kept),
                     [&](const Found& found) { return !heardElsewhere(found); });
        m_report.found = std::move(kept);
    }

    const device::Context& m_context;
    const ScanSpec& m_spec;
    const std::function<void(const Found&)>& m_onFound;
    int m_oldBaud;
    Meter m_meter;
    ScanReport m_report;
};
} // namespace

base::Duration scanEstimate(const ScanSpec& spec, int presentBaud)
{
    base::Duration total{};
    for (const int baud : ratesToSearch(spec, presentBaud))
        total += sweepEstimate(spec, baud);
    return total;
}

base::Result<ScanReport> scan(const device::Context& context, const ScanSpec& spec,
                              const ProgressFn& progress,
                              const std::function<void(const Found&)>& onFound)
{
    const bool idsGood =
        spec.firstId >= 0 && spec.firstId <= spec.lastId && spec.lastId <= protocol::maxId;
    const bool ratesGood =
        std::all_of(spec.bauds.begin(), spec.bauds.end(), [](int baud) { return baud > 0; });
    if (!idsGood || !ratesGood)
        return base::fail(ErrorCode::BadArgument, QStringLiteral("scan"),
                          QStringLiteral("IDs 0 to 253, rates above 0"));
    // At a foreign rate nobody else may speak; at its own the bus keeps its feedback.
    const int baud = context.bus.baud();
    if (ratesToSearch(spec, baud) == std::vector{baud})
        return Scan(context, spec, progress, onFound).run();
    const device::Owned owned = device::own(context, {});
    return Scan(owned.context, spec, progress, onFound).run();
}
} // namespace jobs
