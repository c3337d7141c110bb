// SPDX-License-Identifier: GPL-3.0-or-later
#include "transport/port_reconnector.h"

#include "transport/port_lease.h"

#include <algorithm>

namespace transport {
namespace {
bool isSameAdapter(const PortInfo& a, const PortInfo& b)
{
    return a.vendorId == b.vendorId && a.productId == b.productId &&
           a.serialNumber == b.serialNumber;
}
} // namespace

PortReconnector::PortReconnector(PortSpec spec, Opener opener, PortLister lister)
    : m_spec(std::move(spec))
    , m_opener(std::move(opener))
    , m_listPorts(std::move(lister))
{}

base::Result<std::unique_ptr<Link>> PortReconnector::open()
{
    if (m_opened)
        return reopen();
    auto link = m_opener(m_spec);
    if (!link)
        return link;
    m_opened = true;
    // Listing takes time, and a port without a device file has no adapter.
    if (m_spec.name.contains(QLatin1Char(':')))
        return link;
    const QString path = canonicalPath(m_spec.name);
    const std::vector<PortInfo> ports = m_listPorts();
    const auto opened = std::find_if(ports.begin(), ports.end(),
                                     [&](const PortInfo& port) { return port.path == path; });
    if (opened != ports.end() && opened->vendorId != 0)
        m_adapter = *opened;
    return link;
}

base::Result<std::unique_ptr<Link>> PortReconnector::reopen()
{
    if (!m_adapter)
        return m_opener(m_spec);
    std::vector<PortInfo> candidates = m_listPorts();
    candidates.erase(
        std::remove_if(candidates.begin(), candidates.end(),
                       [&](const PortInfo& port) { return !isSameAdapter(port, *m_adapter); }),
        candidates.end());
    auto found = std::find_if(candidates.begin(), candidates.end(),
                              [&](const PortInfo& port) { return port.path == m_adapter->path; });
    // Cheap adapters have no serial number: only their names distinguish two of a kind.
    const bool uniqueMatch = !m_adapter->serialNumber.isEmpty() && candidates.size() == 1;
    if (found == candidates.end() && uniqueMatch)
        found = candidates.begin();
    if (found == candidates.end())
        return base::fail(base::ErrorCode::PortMissing, QStringLiteral("open"), m_spec.name);
    PortSpec spec = m_spec;
    spec.name = found->path;
    return m_opener(spec);
}
} // namespace transport
