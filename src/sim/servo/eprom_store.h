// SPDX-License-Identifier: GPL-3.0-or-later
// The EPROMs of a simulated bus in a file, so that ending and starting the simulator is a power
// cycle. JSON, one entry per servo in the order of the bus. A file that is damaged, of another kind
// or for other models is refused as a whole and never overwritten; writing replaces the file at
// once or not at all. One thread.
#pragma once

#include "base/error.h"
#include "sim/bus/virtual_bus.h"

#include <vector>

namespace sim {
class EpromStore {
public:
    /// Loads the file into the servos, or makes it if there is none. FileFormat, FileUnreadable,
    /// FileUnwritable; the servos are untouched then. `bus` must outlive the store.
    static base::Result<EpromStore> open(const QString& path, VirtualBus& bus);

    /// Writes the file if an EPROM has changed since. FileUnwritable.
    base::Result<void> saveChanges();

private:
    EpromStore(QString path, VirtualBus& bus)
        : m_path(std::move(path))
        , m_bus(&bus)
    {}
    base::Result<void> load();

    QString m_path;
    VirtualBus* m_bus;
    std::vector<base::Bytes> m_saved;
};
} // namespace sim
