// SPDX-License-Identifier: GPL-3.0-or-later
// Exclusive use of a port: one canonical name per device, one user inside this process,
// and the program that holds it outside. A symbolic link opens the same port under another name,
// and root passes TIOCEXCL; hence names are made canonical before anything is opened. Any thread.
#pragma once

#include "base/error.h"

#include <QString>

namespace transport {
/// "/dev/serial/by-id/usb-…" → "/dev/ttyUSB0", "ttyUSB0" → "/dev/ttyUSB0". A name that leads
/// nowhere is returned as it is.
QString canonicalPath(const QString& name);

/// While it exists, no other code in this process can open the port. Movable value.
class PortLease {
public:
    /// PortBusy if this process has the port already.
    static base::Result<PortLease> acquire(const QString& canonical);

    PortLease() = default;
    PortLease(PortLease&& other) noexcept { m_path.swap(other.m_path); }
    PortLease& operator=(PortLease&& other) noexcept;
    ~PortLease() { release(); }
    void release();

private:
    explicit PortLease(QString path)
        : m_path(std::move(path))
    {}
    QString m_path;
};

/// "minicom (1234)" for the other processes that have the device open; empty if none can be seen:
/// those of other users are not. A program that is itself the far end of a pseudo-terminal is none.
QString portHolders(const QString& canonical);

/// Name of the group that owns the device file; empty where there is no such thing.
QString portGroup(const QString& canonical);
} // namespace transport
