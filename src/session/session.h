// SPDX-License-Identifier: GPL-3.0-or-later
// The composition root: the one place that knows every concrete class. Owns the catalog, the
// journal and the clock; opens ports. Lives as long as the program; main thread.
#pragma once

#include "base/clock.h"
#include "catalog/catalog.h"
#include "history/history_journal.h"
#include "session/connection.h"
#include "transport/port_inventory.h"

namespace session {
class Session {
public:
    /// Loads the built-in models and the user's.
    Session();

    const catalog::Catalog& catalog() const { return m_loaded.catalog; }
    const std::vector<catalog::LoadWarning>& warnings() const { return m_loaded.warnings; }
    history::HistoryJournal& journal() { return m_journal; }
    base::Clock& clock() { return *m_clock; } ///< of all ports

    /// The connection borrows catalog, journal and clock; it must go first. Errors: PortMissing,
    /// PortBusy, PortPermission, PortFailed, RateUnsupported, BadArgument (sim: and tcp: names).
    base::Result<std::unique_ptr<Connection>> connect(const PortRequest& request);

private:
    catalog::Catalog::LoadResult m_loaded;
    history::HistoryJournal m_journal;
    std::unique_ptr<base::Clock> m_clock;
};

/// Ports that look like an adapter for servos: those with a USB vendor. May take tens of ms.
std::vector<transport::PortInfo> adapters();

/// "sim:demo", "sim:trouble": the simulated buses by name.
QStringList simulatedPorts();

/// All rates of the fact sheets, highest first.
const std::vector<int>& standardBaudRates();
} // namespace session
