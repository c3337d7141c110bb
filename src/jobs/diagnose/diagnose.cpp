// SPDX-License-Identifier: GPL-3.0-or-later
#include "jobs/diagnose/diagnose.h"

#include "device/bootloader.h"
#include "device/transactions.h"
#include "jobs/diagnose/conclusion.h"
#include "jobs/diagnose/line_content.h"
#include "jobs/diagnose/servo_probe.h"

#include <QStringList>

#include <algorithm>
#include <cmath>

namespace jobs {
namespace {
using base::Cause;
using base::ErrorCode;
using base::Evidence;
using base::EvidenceKind;
using base::Protocol;
using base::Result;
using std::chrono::milliseconds;

/// A board that reports something once a second is heard.
constexpr base::Duration listenTime = milliseconds(1100);
constexpr base::Duration shortListenTime = milliseconds(60);
constexpr base::Duration rateSettleTime = milliseconds(5);
/// The first one after a change of rate may be lost, and more on a bad line.
constexpr int bootloaderTries = 5;
constexpr base::Duration bootloaderWait = milliseconds(100);
/// A servo with a whole firmware starts it within about 800 ms.
constexpr base::Duration bootTime = milliseconds(1000);
/// Rates below are no setting of a Feetech servo, so it is enough that nothing comes there.
constexpr int lowestSearchedRate = 38'400;
/// Of SMS Modbus and LX servos, and of most boards.
constexpr int otherProtocolRate = 115'200;

class Diagnoser {
public:
    Diagnoser(const device::Context& context, const DiagnosisSpec& spec, const ProgressFn& progress,
              const std::function<void(const Evidence&)>& onEvidence)
        : m_context(context)
        , m_bus(context.bus)
        , m_spec(spec)
        , m_progress(progress)
        , m_onEvidence(onEvidence)
        , m_homeRate(context.bus.baud())
    {}

    Result<DiagnosisReport> run()
    {
        const auto done = walk();
        const bool isAway = m_bus.baud() != m_homeRate;
        const auto restored =
            m_bus.baud() == m_homeRate ? Result<void>{} : m_bus.setBaud(m_homeRate);
        // Torque-off frames sent at another rate reached none of the known servos.
        if (!done && done.error().code == ErrorCode::Preempted && isAway)
            m_bus.emergency();
        if (!done && done.error().code != ErrorCode::Stopped)
            return tl::unexpected(done.error());
        if (!restored)
            return tl::unexpected(restored.error());
        m_seen.homeRate = m_homeRate;
        m_seen.protocols = m_spec.protocols;
        m_report.diagnosis = conclude(m_seen);
        m_report.diagnosis.evidence = std::move(m_evidence);
        m_report.diagnosis.stopped = !done;
        m_report.found = std::move(m_seen.found);
        return std::move(m_report);
    }

private:
    Result<void> walk()
    {
        const QString port = m_spec.adapter.isEmpty()
                                 ? m_bus.portName()
                                 : QStringLiteral("%1 (%2)").arg(m_bus.portName(), m_spec.adapter);
        add({.kind = EvidenceKind::PortOpened, .baud = m_homeRate, .text = port});
        if (!m_spec.otherPrograms.isEmpty())
            add({.kind = EvidenceKind::OtherProgram, .text = m_spec.otherPrograms});
        if (m_spec.latencyTimer)
            add({.kind = EvidenceKind::LatencyTimer, .time = milliseconds(*m_spec.latencyTimer)});
        m_seen.isShared = !m_spec.otherPrograms.isEmpty();
        m_seen.hasEcho = m_bus.hasEcho();
        add({.kind = m_seen.hasEcho ? EvidenceKind::Echo : EvidenceKind::NoEcho});
        m_ahead = longestWalk();
        return listenAt(m_homeRate, listenTime)
            .and_then([this] { return search({m_homeRate}, m_spec.protocols); })
            .and_then([this] { return searchOtherProtocols(); })
            .and_then([this] { return lookAtOtherRates(); })
            .and_then([this] { return askBootloader(); })
            .and_then([this] { return probeServos(); });
    }

    /// Those that were not selected, if some were.
    std::vector<Protocol> otherProtocols() const
    {
        std::vector<Protocol> others;
        const auto& chosen = m_spec.protocols;
        for (const Protocol protocol : base::allProtocols) {
            if (!chosen.empty() &&
                std::find(chosen.begin(), chosen.end(), protocol) == chosen.end())
                others.push_back(protocol);
        }
        return others;
    }

    Result<void> searchOtherProtocols()
    {
        const auto others = otherProtocols();
        const bool isNeeded = !others.empty() && m_seen.found.empty();
        const auto done = isNeeded ? search({m_homeRate}, others) : Result<void>{};
        if (!m_seen.found.empty())
            m_ahead = listeningTime() + otherRatesTime() + probeTime();
        return done;
    }

    base::Duration listeningTime() const
    {
        return m_bus.canSetBaud() ? 2 * shortListenTime * int(m_spec.bauds.size())
                                  : base::Duration{};
    }

    base::Duration searchTime(const std::vector<int>& bauds,
                              const std::vector<Protocol>& protocols) const
    {
        return estimateScanTime(m_context, specOf(bauds, protocols));
    }

    base::Duration otherRatesTime() const
    {
        base::Duration total{};
        for (const int baud : m_spec.bauds) {
            if (m_bus.canSetBaud() && baud != m_homeRate && baud >= lowestSearchedRate)
                total += searchTime({baud}, {Protocol::Feetech});
        }
        return total;
    }

    /// Zero where it cannot be asked. If it replies, it is asked once more, later.
    base::Duration bootloaderTime() const
    {
        const bool reachable = m_bus.canSetBaud() || m_homeRate == device::bootloaderBaud;
        return reachable ? bootloaderTries * bootloaderWait : base::Duration{};
    }

    base::Duration probeTime() const
    {
        constexpr base::Duration ofServo = milliseconds(100);
        return ofServo * int(m_seen.found.size());
    }

    /// Of the walk that finds nothing.
    base::Duration longestWalk() const
    {
        base::Duration total = listenTime + searchTime({m_homeRate}, m_spec.protocols);
        if (const auto others = otherProtocols(); !others.empty())
            total += searchTime({m_homeRate}, others);
        total += listeningTime() + searchTime({m_homeRate}, m_spec.protocols) + bootloaderTime();
        if (!m_bus.canSetBaud())
            return total;
        total += otherRatesTime();
        if (m_homeRate != otherProtocolRate)
            total += searchTime({otherProtocolRate}, {Protocol::Lx, Protocol::Modbus});
        return total;
    }

    /// `done` of a step of `planned`.
    void report(Progress progress, base::Duration planned)
    {
        if (!m_progress)
            return;
        const auto ofStep =
            base::Duration(std::llround(double(planned.count()) * progress.fraction));
        const base::Duration done = m_done + ofStep;
        progress.remaining = std::max(m_ahead - ofStep, base::Duration{});
        const base::Duration whole = done + *progress.remaining;
        progress.fraction =
            whole > base::Duration{} ? double(done.count()) / double(whole.count()) : 1;
        progress.found += int(m_seen.found.size());
        m_progress(progress);
    }

    void endStep(base::Duration planned)
    {
        m_done += planned;
        drop(planned);
    }

    /// What need not be done any more.
    void drop(base::Duration planned) { m_ahead = std::max(m_ahead - planned, base::Duration{}); }

    /// Every rate is listened to, which takes a moment. What is searched in full depends on it.
    Result<void> lookAtOtherRates()
    {
        if (!m_bus.canSetBaud()) {
            add({.kind = EvidenceKind::RateFixed, .baud = m_homeRate});
            return isComplete() ? Result<void>{} : searchHomeAgain();
        }
        std::vector<int> promising;
        std::vector<int> silent;
        for (const int baud : m_spec.bauds) {
            if (baud == m_homeRate)
                continue;
            const int before = m_seen.bytesReceivedAt(baud);
            // The first transaction after a change of rate may be lost.
            for (int i = 0; i < 2 && m_seen.bytesReceivedAt(baud) == before; ++i) {
                if (const auto listened = listenAt(baud, shortListenTime); !listened)
                    return listened;
            }
            if (m_seen.bytesReceivedAt(baud) > before) {
                promising.push_back(baud);
                continue;
            }
            const bool wasTried = m_seen.bytesAt.count(baud) > 0;
            if (wasTried && baud >= lowestSearchedRate && !isComplete())
                silent.push_back(baud);
            else if (baud >= lowestSearchedRate)
                drop(searchTime({baud}, {Protocol::Feetech}));
        }
        if (!m_refusedRates.isEmpty())
            add({.kind = EvidenceKind::RatesRefused,
                 .text = m_refusedRates.join(QStringLiteral(", "))});
        return search(promising, {Protocol::Feetech}).and_then([&] {
            return isComplete() ? Result<void>{} : searchEverything(silent);
        });
    }

    bool isComplete() const { return !m_seen.found.empty() || !m_seen.text.isEmpty(); }

    Result<void> searchEverything(const std::vector<int>& silent)
    {
        return search(silent, {Protocol::Feetech})
            .and_then([this]() -> Result<void> {
                const bool isDone = m_homeRate == otherProtocolRate;
                const bool isNeeded = m_seen.found.empty() && !isDone;
                return isNeeded ? search({otherProtocolRate}, {Protocol::Lx, Protocol::Modbus})
                                : Result<void>{};
            })
            .and_then([this] { return searchHomeAgain(); });
    }

    /// On a bad line a single servo may have missed the few requests to it.
    Result<void> searchHomeAgain()
    {
        const auto done =
            m_seen.found.empty() ? search({m_homeRate}, m_spec.protocols) : Result<void>{};
        if (done && m_seen.found.empty() && m_seen.totalBytes() == 0)
            add({.kind = EvidenceKind::NothingReceived, .count = int(m_seen.bytesAt.size())});
        return done;
    }

    /// Where no servo replies: one without complete firmware may.
    Result<void> askBootloader()
    {
        const base::Duration planned = bootloaderTime();
        if (isComplete() || !m_seen.busyRates.empty() || planned == base::Duration{}) {
            drop(planned);
            return {};
        }
        if (const auto set = setBaud(device::bootloaderBaud); !set)
            return set.error().code == ErrorCode::RateUnsupported ? Result<void>{} : set;
        return repliesInBootloader().and_then([this](bool replies) -> Result<void> {
            if (!replies)
                return {};
            if (!m_bus.pauseUntil(m_bus.clock().now() + bootTime, &m_context.stop))
                return base::fail(ErrorCode::Stopped, QStringLiteral("diagnose"));
            return repliesInBootloader().map([this](bool again) {
                m_seen.hasBootloader = again;
                if (again)
                    add({.kind = EvidenceKind::BootloaderReplied, .baud = device::bootloaderBaud});
            });
        });
    }

    Result<bool> repliesInBootloader()
    {
        Result<bool> replied = false;
        for (int i = 0; i < bootloaderTries && replied && !*replied; ++i) {
            if (m_context.stop.isRequested())
                return base::fail(ErrorCode::Stopped, QStringLiteral("diagnose"));
            report({.baud = device::bootloaderBaud}, bootloaderWait);
            replied = device::askBootloader(m_context, bootloaderWait)
                          .map([](device::BootloaderReply reply) {
                              return reply == device::BootloaderReply::Accepted ||
                                     reply == device::BootloaderReply::Refused;
                          });
            endStep(bootloaderWait);
        }
        return replied;
    }

    /// Whatever comes after a PING to all: the servos' replies, maybe on top of each other, or what
    /// comes without being asked for.
    Result<void> listenAt(int baud, base::Duration span)
    {
        if (m_context.stop.isRequested())
            return base::fail(ErrorCode::Stopped, QStringLiteral("diagnose"));
        if (const auto set = setBaud(baud); !set)
            return set.error().code == ErrorCode::RateUnsupported ? Result<void>{} : set;
        report({.baud = baud}, span);
        const auto received = device::listenAfterPing(m_context, span);
        if (!received)
            return tl::unexpected(received.error());
        endStep(span);
        note(baud, *received);
        return {};
    }

    void note(int baud, const base::Bytes& bytes)
    {
        m_seen.bytesAt[baud] += int(bytes.size());
        if (bytes.empty())
            return;
        const QString text = textIn(bytes);
        if (m_seen.text.isEmpty())
            m_seen.text = text;
        if (!text.isEmpty())
            add({.kind = EvidenceKind::TextReceived, .baud = baud, .text = text});
        else if (m_seen.busyRates.empty()) // else it looks like this at every rate
            add({.kind = EvidenceKind::BytesReceived,
                 .baud = baud,
                 .count = int(bytes.size()),
                 .text = sampleOf(bytes)});
    }

    Result<void> setBaud(int baud)
    {
        if (baud == m_bus.baud())
            return {};
        const auto set = m_bus.setBaud(baud);
        if (!set && set.error().code == ErrorCode::RateUnsupported &&
            !m_refusedRates.contains(QString::number(baud)))
            m_refusedRates << QString::number(baud);
        return set.and_then([this] { return m_bus.listen(rateSettleTime); });
    }

    Result<void> search(const std::vector<int>& bauds, const std::vector<Protocol>& protocols)
    {
        if (bauds.empty())
            return {};
        const ScanSpec spec = specOf(bauds, protocols);
        const base::Duration planned = estimateScanTime(m_context, spec);
        const auto scanned = scan(m_context, spec, [this, planned](const Progress& progress) {
            report(progress, planned);
        });
        endStep(planned);
        if (!scanned && scanned.error().code == ErrorCode::LineBusy) {
            m_seen.busyRates.insert(m_seen.busyRates.end(), bauds.begin(), bauds.end());
            add({.kind = EvidenceKind::LineNeverIdle, .baud = bauds.front()});
            return {};
        }
        if (!scanned)
            return tl::unexpected(scanned.error());
        m_seen.hasGarbledReplies = m_seen.hasGarbledReplies || scanned->hasGarbledReplies;
        m_seen.busyRates.insert(m_seen.busyRates.end(), scanned->busyRates.begin(),
                                scanned->busyRates.end());
        for (const int baud : scanned->busyRates)
            add({.kind = EvidenceKind::LineNeverIdle, .baud = baud});
        addFound(*scanned);
        return scanned->stopped ? base::fail(ErrorCode::Stopped, QStringLiteral("diagnose"))
                                : Result<void>{};
    }

    static ScanSpec specOf(const std::vector<int>& bauds, const std::vector<Protocol>& protocols)
    {
        ScanSpec spec;
        spec.bauds = bauds;
        spec.protocols = protocols;
        return spec;
    }

    /// One line of evidence for each rate and protocol.
    void addFound(const ScanReport& report)
    {
        std::vector<Evidence> lines;
        for (const FoundServo& found : report.found) {
            const device::Servo& servo = found.servo;
            auto line = std::find_if(lines.begin(), lines.end(), [&](const Evidence& one) {
                return one.baud == servo.baud && one.protocol == servo.protocol;
            });
            if (line == lines.end())
                line = lines.insert(line, {.kind = EvidenceKind::ServosFound,
                                           .baud = servo.baud,
                                           .protocol = servo.protocol});
            line->ids.push_back(servo.id);
            m_seen.found.push_back(found);
        }
        for (Evidence& line : lines)
            add(std::move(line));
    }

    Result<void> probeServos()
    {
        m_ahead = probeTime();
        for (const FoundServo& found : m_seen.found) {
            if (m_context.stop.isRequested())
                return base::fail(ErrorCode::Stopped, QStringLiteral("diagnose"));
            if (const auto set = setBaud(found.servo.baud); !set)
                return set;
            report({.baud = found.servo.baud}, {});
            const auto probe = probeServo(m_context, found, int(m_seen.found.size()));
            if (!probe)
                return tl::unexpected(probe.error());
            for (const Evidence& one : evidenceOf(*probe))
                add(one);
            m_seen.probes.push_back(*probe);
            endStep(probeTime() / int(m_seen.found.size()));
        }
        addSummary();
        return {};
    }

    void addSummary()
    {
        const auto& probes = m_seen.probes;
        const auto slowest =
            std::max_element(probes.begin(), probes.end(), [](const auto& a, const auto& b) {
                return a.replyTime < b.replyTime;
            });
        if (slowest == probes.end())
            return;
        if (slowest->asked > slowest->lost + slowest->damaged)
            add({.kind = EvidenceKind::ReplyTime, .id = slowest->id, .time = slowest->replyTime});
        Evidence all{.kind = EvidenceKind::AllReplied};
        bool isFlawless = true;
        for (const ServoProbe& probe : probes) {
            all.count += probe.asked;
            isFlawless = isFlawless && probe.lost + probe.damaged == 0;
        }
        if (isFlawless)
            add(all);
    }

    void add(Evidence evidence)
    {
        if (m_onEvidence)
            m_onEvidence(evidence);
        m_evidence.push_back(std::move(evidence));
    }

    const device::Context& m_context;
    bus::Bus& m_bus;
    const DiagnosisSpec& m_spec;
    const ProgressFn& m_progress;
    const std::function<void(const Evidence&)>& m_onEvidence;
    int m_homeRate;
    Observations m_seen;
    QStringList m_refusedRates;
    std::vector<Evidence> m_evidence;
    base::Duration m_done{};  ///< planned time of the steps that are over
    base::Duration m_ahead{}; ///< of those that may come, the present one included
    DiagnosisReport m_report;
};
} // namespace

Result<DiagnosisReport> diagnose(const device::Context& context, const DiagnosisSpec& spec,
                                 const ProgressFn& progress,
                                 const std::function<void(const Evidence&)>& onEvidence)
{
    const device::Owned owned = device::own(context, {});
    return Diagnoser(owned.context, spec, progress, onEvidence).run();
}
} // namespace jobs
