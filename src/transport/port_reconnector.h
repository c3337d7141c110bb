// SPDX-License-Identifier: GPL-3.0-or-later
// Opens a port, and the same one again after it was gone. A USB adapter is known by its numbers: it
// is found under another name, too, and another one that took its name is not opened. What has no
// numbers (a chip on the board, a pseudo-terminal, a TCP bridge) is known by its name. Copyable;
// used by the thread that owns the link.
#pragma once

#include "transport/port_inventory.h"
#include "transport/port_opener.h"

#include <functional>
#include <optional>

namespace transport {
class PortReconnector {
public:
    using PortLister = std::function<std::vector<PortInfo>()>;
    using Opener = std::function<base::Result<std::unique_ptr<Link>>(const PortSpec&)>;

    PortReconnector(PortSpec spec, Opener opener, PortLister lister = listPorts);

    /// As openPort(); PortMissing also where another adapter has taken the name.
    base::Result<std::unique_ptr<Link>> open();

private:
    base::Result<std::unique_ptr<Link>> reopen();

    PortSpec m_spec;
    Opener m_opener;
    PortLister m_listPorts;
    bool m_opened = false;
    std::optional<PortInfo> m_adapter; ///< none: known by its name only
};
} // namespace transport
