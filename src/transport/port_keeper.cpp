// SPDX-License-Identifier: GPL-3.0-or-later
#include "transport/port_keeper.h"

#include "transport/port_lease.h"

#include <algorithm>

namespace transport {
namespace {
bool sameAdapter(const PortInfo& a, const PortInfo& b)
{
    return a.vendorId == b.vendorId && a.productId == b.productId &&
           a.serialNumber == b.serialNumber;
}
} // namespace

PortKeeper::PortKeeper(PortSpec spec, Opener opener, Lister lister)
    : m_spec(std::move(spec))
    , m_opener(std::move(opener))
    , m_lister(std::move(lister))
{}

base::Result<std::unique_ptr<Link>> PortKeeper::open()
{
    if (m_opened)
        return openAgain();
    auto link = m_opener(m_spec);
    if (!link)
        return link;
    m_opened = true;
    // Listing takes a while, and what has no device file has no adapter either.
    if (m_spec.name.contains(QLatin1Char(':')))
        return link;
    const QString path = canonicalPath(m_spec.name);
    const std::vector<PortInfo> ports = m_lister();
    const auto own = std::find_if(ports.begin(), ports.end(),
                                  [&](const PortInfo& port) { return port.path == path; });
    if (own != ports.end() && own->vendorId != 0)
        m_adapter = *own;
    return link;
}

base::Result<std::unique_ptr<Link>> PortKeeper::openAgain()
{
    if (!m_adapter)
        return m_opener(m_spec);
    std::vector<PortInfo> same = m_lister();
    same.erase(std::remove_if(same.begin(), same.end(),
                              [&](const PortInfo& port) { return !sameAdapter(port, *m_adapter); }),
               same.end());
    auto found = std::find_if(same.begin(), same.end(),
                              [&](const PortInfo& port) { return port.path == m_adapter->path; });
    // Cheap adapters carry no serial number: two of a kind can only be told apart by their names.
    const bool unmistakable = !m_adapter->serialNumber.isEmpty() && same.size() == 1;
    if (found == same.end() && unmistakable)
        found = same.begin();
    if (found == same.end())
        return base::fail(base::ErrorCode::PortMissing, QStringLiteral("open"), m_spec.name);
    PortSpec spec = m_spec;
    spec.name = found->path;
    return m_opener(spec);
}
} // namespace transport
