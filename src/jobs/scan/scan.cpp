// SPDX-License-Identifier: GPL-3.0-or-later
#include "jobs/scan/scan.h"

#include "device/reader.h"
#include "jobs/scan/rate_scan.h"
#include "jobs/scan/scan_duplicate_ids.h"
#include "jobs/scan/scan_list.h"
#include "jobs/scan/scan_plan.h"
#include "jobs/scan/scan_progress.h"

#include <algorithm>
#include <list>

namespace jobs {
namespace {
using base::ErrorCode;
using base::Protocol;

constexpr base::Duration settleTime = std::chrono::milliseconds(5);

/// What says something about this servo and leaves the scan to go on.
bool isServoError(ErrorCode code)
{
    switch (code) {
    case ErrorCode::NoReply:
    case ErrorCode::Garbled:
    case ErrorCode::UnexpectedReply:
    case ErrorCode::LineBusy:
    case ErrorCode::Refused:
    case ErrorCode::UnknownModel:
        return true;
    default:
        return false;
    }
}

std::vector<catalog::Role> missingStateRoles(const device::Servo& servo)
{
    using catalog::Role;
    std::vector<Role> missingRoles;
    const auto addMissing = [&](std::initializer_list<Role> roles) {
        for (const Role role : roles) {
            if (servo.profile->byRole(role) != nullptr && !servo.raw(role))
                missingRoles.push_back(role);
        }
    };
    addMissing({Role::BaudRate, Role::Lock});
    if (!servo.repliesCarryStatus())
        addMissing({Role::Status});
    if (!servo.repliesCarryStatus() && servo.profile->byRole(Role::Status) == nullptr)
        addMissing({Role::PresentTemperature, Role::MaxTemperature, Role::PresentVoltage,
                    Role::MinVoltage, Role::MaxVoltage});
    return missingRoles;
}

class ScanRunner {
public:
    ScanRunner(const device::Context& context, const ScanSpec& spec, const ProgressFn& progress,
               const std::function<void(const FoundServo&)>& onFound)
        : m_context(context)
        , m_spec(spec)
        , m_onFound(onFound)
        , m_oldBaud(context.bus.baud())
        , m_progress(progress, context.bus.clock(), estimateScanTime(context, spec))
    {}

    base::Result<ScanReport> run()
    {
        const base::Duration start = m_context.bus.clock().now();
        m_report.port = m_context.bus.portName();
        const auto searched = searchFast().and_then([this] { return searchSlow(); });
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
        if (searched && m_report.found.empty() && !m_report.busyRates.empty())
            return base::fail(ErrorCode::LineBusy, QStringLiteral("scan"));
        finishList();
        m_report.slowPassAdvised = m_report.lateReplies > 1 && !m_spec.slowPass;
        m_report.elapsed = m_context.bus.clock().now() - start;
        m_progress.notify();
        return std::move(m_report);
    }

private:
    struct Search {
        int baud = 0;
        RateScan sweep;
    };

    /// Every rate: the questions to all, then what takes a second or where somebody has spoken up.
    base::Result<void> searchFast()
    {
        for (const int baud : ratesToScan(m_spec, m_oldBaud)) {
            const auto set = setBaud(baud);
            if (!set && set.error().code == ErrorCode::RateUnsupported) {
                m_report.unsupportedRates.push_back(baud);
                m_progress.skip(estimateRate(m_context, m_spec, baud));
                continue;
            }
            if (!set)
                return set;
            m_report.rates.push_back(baud);
            if (const auto done = ignoreBusyRate(searchRate()); !done)
                return done;
        }
        return {};
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
            return a.sweep.hasReply() && !b.sweep.hasReply();
        });
        for (auto it = searches.begin(); it != searches.end();) {
            const auto search = it++;
            const RateScan& sweep = search->sweep;
            if (scanProfileOf(sweep.protocol()).supportsBroadcast && !sweep.hasReply())
                m_slow.splice(m_slow.end(), searches, search);
            else if (const auto done = scanIds(*search); !done)
                return done;
        }
        return {};
    }

    /// The sweeps that were put off, language by language.
    base::Result<void> searchSlow()
    {
        m_slow.sort([](const Search& a, const Search& b) {
            return a.sweep.protocol() == Protocol::Lx && b.sweep.protocol() != Protocol::Lx;
        });
        for (Search& search : m_slow) {
            const auto done =
                setBaud(search.baud).and_then([&] { return ignoreBusyRate(scanIds(search)); });
            if (!done)
                return done;
        }
        return {};
    }

    /// Such a rate is left, and said; the others are searched.
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
                              m_progress.add(planned, foundCount - foundCountAt(baud, protocol));
                          },
                          [this, baud](const RateScan& sweep, int id) {
                              return addFound(id, baud, sweep);
                          })};
    }

    int foundCountAt(int baud, Protocol protocol) const
    {
        return int(std::count_if(m_report.found.begin(), m_report.found.end(), [&](const auto& f) {
            return f.servo.baud == baud && f.servo.protocol == protocol;
        }));
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
        m_progress.startSearch(search.baud, search.sweep.protocol());
        const auto onlyServo = search.sweep.pingBroadcast();
        if (!onlyServo)
            return tl::unexpected(onlyServo.error());
        return *onlyServo ? addFound(**onlyServo, search.baud, search.sweep) : base::Result<void>{};
    }

    base::Result<void> scanIds(Search& search)
    {
        m_progress.startSearch(search.baud, search.sweep.protocol());
        const auto swept = search.sweep.run();
        m_report.lateReplies += search.sweep.lateReplies();
        if (search.sweep.isLineBusy())
            addBusyRate();
        m_report.hasGarbledReplies =
            m_report.hasGarbledReplies || search.sweep.hasUnexplainedGarbled();
        const bool stopped = !swept && swept.error().code == ErrorCode::Stopped;
        if (!swept && !stopped)
            return swept;
        for (const auto& [id, response] : search.sweep.responsesById()) {
            const auto added = response.isPresent() ? addFound(id, search.baud, search.sweep)
                                                    : base::Result<void>{};
            if (!added)
                return added;
        }
        if (m_context.stop.isRequested())
            return base::fail(ErrorCode::Stopped, QStringLiteral("scan"));
        return {};
    }

    base::Result<void> addFound(int id, int baud, const RateScan& sweep)
    {
        const IdResponse& response = sweep.responsesById().at(id);
        if (FoundServo* known = findListed(id, baud, sweep.protocol())) {
            const bool hasNews = (response.hasDuplicateId() && !known->duplicateSuspected) ||
                                 (response.late && !known->lateReplySeen);
            known->duplicateSuspected = known->duplicateSuspected || response.hasDuplicateId();
            known->lateReplySeen = known->lateReplySeen || response.late;
            if (hasNews && m_onFound)
                m_onFound(*known);
            return {};
        }
        FoundServo found;
        found.servo.protocol = sweep.protocol();
        found.servo.id = id;
        found.servo.baud = baud;
        found.servo.port = m_context.bus.portName();
        found.servo.status = response.status;
        found.lateReplySeen = response.late;
        found.duplicateSuspected = response.hasDuplicateId();
        // Who has answered is listed, also when the stop comes before the name is known.
        if (m_spec.identify && response.replies > 0 && !m_context.stop.isRequested()) {
            const auto done = identify(found);
            if (!done && done.error().code != ErrorCode::Stopped)
                return done;
        }
        m_progress.countFound();
        m_report.found.push_back(found);
        if (m_onFound)
            m_onFound(found);
        return {};
    }

    /// Who has been told already.
    FoundServo* findListed(int id, int baud, Protocol protocol)
    {
        const auto known = std::find_if(
            m_report.found.begin(), m_report.found.end(), [&](const FoundServo& found) {
                return found.servo.id == id && found.servo.baud == baud &&
                       found.servo.protocol == protocol;
            });
        return known == m_report.found.end() ? nullptr : &*known;
    }

    base::Result<void> identify(FoundServo& found)
    {
        auto servo = device::identify(m_context, found.servo.id, found.servo.protocol);
        if (!servo) {
            const ErrorCode code = servo.error().code;
            const bool broken = code == ErrorCode::Garbled || code == ErrorCode::UnexpectedReply;
            found.duplicateSuspected = found.duplicateSuspected || broken;
            return isServoError(code) ? base::Result<void>{} : tl::unexpected(servo.error());
        }
        found.servo = std::move(*servo);
        const auto hasDuplicateId = suspectDuplicateId(m_context, found.servo);
        if (!hasDuplicateId)
            return tl::unexpected(hasDuplicateId.error());
        found.duplicateSuspected = found.duplicateSuspected || *hasDuplicateId;
        return readState(found.servo);
    }

    /// What the list shows beside the name and the identity has not told: an open lock, and alarms
    /// where they do not come with every reply.
    base::Result<void> readState(device::Servo& servo)
    {
        if (m_context.stop.isRequested())
            return {};
        const auto read = device::readRoles(m_context, servo, missingStateRoles(servo));
        return read || isServoError(read.error().code) ? base::Result<void>{} : read;
    }

    void finishList()
    {
        dropNeighborRates(m_report.found);
        sortFound(m_report.found, m_report.rates);
        if (familiesMixed(m_report.found))
            m_context.note(device::NoticeCode::MixedFamilies, -1);
    }

    const device::Context& m_context;
    const ScanSpec& m_spec;
    const std::function<void(const FoundServo&)>& m_onFound;
    int m_oldBaud;
    ScanProgress m_progress;
    std::list<Search> m_slow; ///< put off
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
    // At a foreign rate nobody else may speak; at its own the bus keeps its feedback.
    const int baud = context.bus.baud();
    if (ratesToScan(spec, baud) == std::vector{baud})
        return ScanRunner(context, spec, progress, onFound).run();
    const device::Owned owned = device::own(context, {});
    return ScanRunner(owned.context, spec, progress, onFound).run();
}
} // namespace jobs
