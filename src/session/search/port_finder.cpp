// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/search/port_finder.h"

#include <algorithm>

namespace session {
namespace {
/// Those that servos have from the factory, or are often set to, before the others.
std::vector<int> likelyRatesFirst()
{
    std::vector<int> rates{1'000'000, 115'200, 500'000, 250'000, 57'600, 38'400};
    for (const int rate : standardBaudRates()) {
        if (std::find(rates.begin(), rates.end(), rate) == rates.end())
            rates.push_back(rate);
    }
    return rates;
}

/// Broken replies at another rate are no servos where some were identified.
void keepOneRate(jobs::ScanReport& report)
{
    auto& found = report.found;
    if (found.empty())
        return;
    const auto identified = std::find_if(
        found.begin(), found.end(), [](const auto& one) { return one.servo.profile != nullptr; });
    if (identified != found.end())
        report.hasGarbledReplies = false;
    const int baud = (identified == found.end() ? found.begin() : identified)->servo.baud;
    found.erase(std::remove_if(found.begin(), found.end(),
                               [baud](const auto& one) { return one.servo.baud != baud; }),
                found.end());
}
} // namespace

std::map<base::Protocol, std::vector<int>> idsByProtocol(const std::vector<jobs::FoundServo>& found)
{
    std::map<base::Protocol, std::vector<int>> ids;
    for (const jobs::FoundServo& one : found)
        ids[one.servo.protocol].push_back(one.servo.id);
    return ids;
}

base::Result<jobs::ScanReport> findServos(Session& session, PortRequest request,
                                          const base::StopToken& stop,
                                          const jobs::ProgressFn& progress)
{
    jobs::ScanSpec spec;
    spec.bauds = request.baud ? std::vector{*request.baud} : likelyRatesFirst();
    if (request.protocol)
        spec.protocols = {*request.protocol};
    spec.untilFound = true;
    auto connection = session.connect(request);
    if (!connection && !request.baud &&
        connection.error().code == base::ErrorCode::RateUnsupported) {
        request.baud = 115'200; // a computer's own port has no faster one
        connection = session.connect(request);
    }
    if (!connection)
        return tl::unexpected(connection.error());
    device::Notices notices;
    auto report = jobs::scan((*connection)->context(stop, notices), spec, progress);
    if (report)
        keepOneRate(*report);
    return report;
}

PortFinder::PortFinder(Session& session, QObject* parent)
    : QObject(parent)
    , m_session(session)
    , m_thread(std::make_unique<base::JobThread>())
{}

PortFinder::~PortFinder()
{
    stop();
    m_thread.reset();
}

void PortFinder::start(const QStringList& ports)
{
    if (isRunning())
        return;
    m_results.clear();
    for (const QString& port : ports)
        m_results.push_back({.port = port});
    m_current = 0;
    m_stop = std::make_unique<base::StopToken>();
    searchNext();
}

void PortFinder::stop()
{
    if (m_stop)
        m_stop->request();
}

void PortFinder::searchNext()
{
    if (m_stop->isRequested()) {
        for (std::size_t i = m_current; i < m_results.size(); ++i)
            m_results[i].state = PortResult::State::Stopped;
        m_current = m_results.size();
    }
    if (m_current == m_results.size()) {
        m_stop.reset();
    } else {
        m_results[m_current].state = PortResult::State::Searching;
        m_thread->start([this, port = m_results[m_current].port] { search(port, *m_stop); });
    }
    Q_EMIT changed();
}

/// On the thread of the search.
void PortFinder::search(const QString& port, const base::StopToken& stop)
{
    PortRequest request;
    request.name = port;
    auto report = findServos(m_session, request, stop, [this](const jobs::Progress& progress) {
        m_mainQueue.post([this, progress] { Q_EMIT progressed(progress); });
    });
    m_mainQueue.post([this, report = std::move(report)] { searched(report); });
}

void PortFinder::searched(const base::Result<jobs::ScanReport>& report)
{
    PortResult& result = m_results[m_current++];
    result.state = PortResult::State::Searched;
    if (!report) {
        result.error = report.error();
    } else {
        result.found = report->found;
        if (report->stopped)
            result.state = PortResult::State::Stopped;
    }
    searchNext();
}
} // namespace session
