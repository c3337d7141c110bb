// SPDX-License-Identifier: GPL-3.0-or-later
// A pseudo-terminal that other programs open like a serial adapter: raw, with the rate its client
// has set, an optional symbolic link, and whether a client has it open. POSIX; without inotify a
// client counts as always connected. One thread, except wake().
#pragma once

#include "base/bytes.h"
#include "base/clock.h"
#include "base/error.h"

#include <QString>

#include <memory>

namespace sim {
class PtyDevice {
public:
    /// `baud` is the rate for a client that sets none. PortFailed with the system's message.
    static base::Result<std::unique_ptr<PtyDevice>> open(const QString& link, int baud);
    ~PtyDevice();
    PtyDevice(const PtyDevice&) = delete;
    PtyDevice& operator=(const PtyDevice&) = delete;

    QString path() const { return m_path; }
    int baud() const; ///< as the client has set it; 0: unknown

    /// Waits for bytes, for a client that connects or leaves, or for wake(), at most `span`.
    void wait(base::Duration span);
    void wake(); ///< any thread, also from a signal handler; stays in effect
    bool isWoken() const { return m_isWoken; }

    /// The bytes of the client that have not been read yet.
    base::Bytes read();
    /// In one piece. Lost if no client listens or it does not read, as on a closed port.
    void write(base::ByteView bytes);

private:
    PtyDevice() = default;
    base::Result<void> openTerminal(int baud);
    base::Result<void> makeLink(const QString& link);
    void watchClients();
    void countClients();
    void resetForNextClient();

    int m_master = -1;
    int m_slave = -1; ///< held open, so that the line stays up when a client leaves
    int m_watch = -1;
    int m_wakeRead = -1;
    int m_wakeWrite = -1;
    int m_clients = 0;
    bool m_isWoken = false;
    QString m_path;
    QString m_link;
};
} // namespace sim
