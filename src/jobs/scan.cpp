// SPDX-License-Identifier: GPL-3.0-or-later
#include "jobs/scan.h"

#include "device/reader.h"
#include "jobs/scan_list.h"
#include "jobs/scan_meter.h"
#include "jobs/scan_plan.h"
#include "jobs/scan_sweep.h"
#include "jobs/scan_twins.h"

#include <algorithm>
#include <list>

namespace jobs {
namespace {
using base::ErrorCode;
using base::Protocol;

constexpr base::Duration settleTime = std::chrono::milliseconds(5);

/// What says something about this servo and leaves the scan to go on.
bool concernsServo(ErrorCode code)
{
    switch (code) {
    case ErrorCode::NoAnswer:
    case ErrorCode::Garbled:
    case ErrorCode::WrongAnswer:
    case ErrorCode::LineBusy:
    case ErrorCode::Refused:
    case ErrorCode::UnknownModel:
        return true;
    default:
        return false;
    }
}

std::vector<catalog::Role> stateRoles(const device::Servo& servo)
{
    using catalog::Role;
    std::vector<Role> wanted;
    const auto want = [&](std::initializer_list<Role> roles) {
        for (const Role role : roles) {
            if (servo.profile->byRole(role) != nullptr && !servo.raw(role))
                wanted.push_back(role);
        }
    };
    want({Role::BaudRate, Role::Lock});
    if (!servo.repliesCarryStatus())
        want({Role::Status});
    if (!servo.repliesCarryStatus() && servo.profile->byRole(Role::Status) == nullptr)
        want({Role::PresentTemperature, Role::MaxTemperature, Role::PresentVoltage,
              Role::MinVoltage, Role::MaxVoltage});
    return wanted;
}

class Scan {
public:
    Scan(const device::Context& context, const ScanSpec& spec, const ProgressFn& progress,
         const std::function<void(const Found&)>& onFound)
        : m_context(context)
        , m_spec(spec)
        , m_onFound(onFound)
        , m_oldBaud(context.bus.baud())
        , m_meter(progress, context.bus.clock(), scanEstimate(context, spec))
    {}

    base::Result<ScanReport> run()
    {
        const base::Duration start = m_context.bus.clock().now();
        m_report.port = m_context.bus.portName();
        const auto searched = searchQuickly().and_then([this] { return searchSlowly(); });
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
        if (searched && m_report.found.empty() && !m_report.ratesBusy.empty())
            return base::fail(ErrorCode::LineBusy, QStringLiteral("scan"));
        finishList();
        m_report.slowPassAdvised = m_report.lateReplies > 1 && !m_spec.slowPass;
        m_report.elapsed = m_context.bus.clock().now() - start;
        m_meter.tell();
        return std::move(m_report);
    }

private:
    struct Search {
        int baud = 0;
        RateSweep sweep;
    };

    /// Every rate: the questions to all, then what takes a second or where somebody has spoken up.
    base::Result<void> searchQuickly()
    {
        for (const int baud : ratesToSearch(m_spec, m_oldBaud)) {
            const auto set = setBaud(baud);
            if (!set && set.error().code == ErrorCode::RateUnsupported) {
                m_report.ratesRefused.push_back(baud);
                m_meter.skip(estimateAt(m_context, m_spec, baud));
                continue;
            }
            if (!set)
                return set;
            m_report.rates.push_back(baud);
            if (const auto done = orBusy(searchRate()); !done)
                return done;
        }
        return {};
    }

    base::Result<void> searchRate()
    {
        std::list<Search> searches;
        for (const Protocol protocol : languagesAt(m_context, m_spec, m_context.bus.baud())) {
            Search& search = searches.emplace_back(newSearch(protocol));
            if (const auto asked = askAll(search); !asked)
                return asked;
        }
        searches.sort([](const Search& a, const Search& b) {
            return a.sweep.heardSomebody() && !b.sweep.heardSomebody();
        });
        for (auto it = searches.begin(); it != searches.end();) {
            const auto search = it++;
            const RateSweep& sweep = search->sweep;
            if (mannerOf(sweep.protocol()).asksAll && !sweep.heardSomebody())
                m_slow.splice(m_slow.end(), searches, search);
            else if (const auto done = sweepIds(*search); !done)
                return done;
        }
        return {};
    }

    /// The sweeps that were put off, language by language.
    base::Result<void> searchSlowly()
    {
        m_slow.sort([](const Search& a, const Search& b) {
            return a.sweep.protocol() == Protocol::Lx && b.sweep.protocol() != Protocol::Lx;
        });
        for (Search& search : m_slow) {
            const auto done =
                setBaud(search.baud).and_then([&] { return orBusy(sweepIds(search)); });
            if (!done)
                return done;
        }
        return {};
    }

    /// Such a rate is left, and said; the others are searched.
    base::Result<void> orBusy(base::Result<void> searched)
    {
        if (searched || searched.error().code != ErrorCode::LineBusy)
            return searched;
        noteBusy();
        return {};
    }

    void noteBusy()
    {
        const int baud = m_context.bus.baud();
        auto& busy = m_report.ratesBusy;
        if (std::find(busy.begin(), busy.end(), baud) == busy.end())
            busy.push_back(baud);
    }

    Search newSearch(Protocol protocol)
    {
        const int baud = m_context.bus.baud();
        return {baud, RateSweep(
                          m_context, m_spec, protocol,
                          [this, baud, protocol](base::Duration planned, int heard) {
                              m_meter.add(planned, heard - countedAt(baud, protocol));
                          },
                          [this, baud](const RateSweep& sweep, int id) {
                              return addFound(id, baud, sweep);
                          })};
    }

    int countedAt(int baud, Protocol protocol) const
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
        if (!m_context.bus.hasBaud())
            return base::fail(ErrorCode::RateUnsupported, QStringLiteral("scan"),
                              QString::number(baud));
        return m_context.bus.setBaud(baud).and_then(
            [this] { return m_context.bus.listen(settleTime); });
    }

    base::Result<void> askAll(Search& search)
    {
        m_meter.startSearch(search.baud, search.sweep.protocol());
        const auto alone = search.sweep.askAll();
        if (!alone)
            return tl::unexpected(alone.error());
        return *alone ? addFound(**alone, search.baud, search.sweep) : base::Result<void>{};
    }

    base::Result<void> sweepIds(Search& search)
    {
        m_meter.startSearch(search.baud, search.sweep.protocol());
        const auto swept = search.sweep.run();
        m_report.lateReplies += search.sweep.lateReplies();
        if (search.sweep.lineBusy())
            noteBusy();
        m_report.garbledHeard = m_report.garbledHeard || search.sweep.garbledUnexplained();
        const bool stopped = !swept && swept.error().code == ErrorCode::Stopped;
        if (!swept && !stopped)
            return swept;
        for (const auto& [id, contact] : search.sweep.contacts()) {
            const auto added =
                contact.present() ? addFound(id, search.baud, search.sweep) : base::Result<void>{};
            if (!added)
                return added;
        }
        if (m_context.stop.requested())
            return base::fail(ErrorCode::Stopped, QStringLiteral("scan"));
        return {};
    }

    base::Result<void> addFound(int id, int baud, const RateSweep& sweep)
    {
        const Contact& contact = sweep.contacts().at(id);
        if (Found* known = listed(id, baud, sweep.protocol())) {
            const bool news =
                (contact.twins() && !known->twinsSuspected) || (contact.late && !known->heardLate);
            known->twinsSuspected = known->twinsSuspected || contact.twins();
            known->heardLate = known->heardLate || contact.late;
            if (news && m_onFound)
                m_onFound(*known);
            return {};
        }
        Found found;
        found.servo.protocol = sweep.protocol();
        found.servo.id = id;
        found.servo.baud = baud;
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

    /// Who has been told already.
    Found* listed(int id, int baud, Protocol protocol)
    {
        const auto known =
            std::find_if(m_report.found.begin(), m_report.found.end(), [&](const Found& found) {
                return found.servo.id == id && found.servo.baud == baud &&
                       found.servo.protocol == protocol;
            });
        return known == m_report.found.end() ? nullptr : &*known;
    }

    base::Result<void> identify(Found& found)
    {
        auto servo = device::identify(m_context, found.servo.id, found.servo.protocol);
        if (!servo) {
            const ErrorCode code = servo.error().code;
            const bool broken = code == ErrorCode::Garbled || code == ErrorCode::WrongAnswer;
            found.twinsSuspected = found.twinsSuspected || broken;
            return concernsServo(code) ? base::Result<void>{} : tl::unexpected(servo.error());
        }
        found.servo = std::move(*servo);
        const auto twins = suspectTwins(m_context, found.servo);
        if (!twins)
            return tl::unexpected(twins.error());
        found.twinsSuspected = found.twinsSuspected || *twins;
        return readState(found.servo);
    }

    /// What the list shows beside the name and the identity has not told: an open lock, and alarms
    /// where they do not come with every reply.
    base::Result<void> readState(device::Servo& servo)
    {
        if (m_context.stop.requested())
            return {};
        const auto read = device::readRoles(m_context, servo, stateRoles(servo));
        return read || concernsServo(read.error().code) ? base::Result<void>{} : read;
    }

    void finishList()
    {
        dropNeighbourRates(m_report.found);
        sortFound(m_report.found, m_report.rates);
        if (familiesMixed(m_report.found))
            m_context.note(device::NoticeCode::FamiliesMixed, -1);
    }

    const device::Context& m_context;
    const ScanSpec& m_spec;
    const std::function<void(const Found&)>& m_onFound;
    int m_oldBaud;
    ScanMeter m_meter;
    std::list<Search> m_slow; ///< put off
    ScanReport m_report;
};
} // namespace

base::Result<ScanReport> scan(const device::Context& context, const ScanSpec& spec,
                              const ProgressFn& progress,
                              const std::function<void(const Found&)>& onFound)
{
    if (const auto good = checkSpec(context, spec); !good)
        return tl::unexpected(good.error());
    // Servos may have been plugged in since they were last written to.
    context.bus.verifiedIds().clear();
    // At a foreign rate nobody else may speak; at its own the bus keeps its feedback.
    const int baud = context.bus.baud();
    if (ratesToSearch(spec, baud) == std::vector{baud})
        return Scan(context, spec, progress, onFound).run();
    const device::Owned owned = device::own(context, {});
    return Scan(owned.context, spec, progress, onFound).run();
}
} // namespace jobs
