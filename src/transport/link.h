// SPDX-License-Identifier: GPL-3.0-or-later
// A byte link to one bus: serial port, TCP bridge, simulated bus, memory. No framing. Owned and
// used by one thread only (the bus thread), because QSerialPort insists. The first read, write or
// resource error closes the link at once and every later call answers LinkLost.
#pragma once

#include "base/bytes.h"
#include "base/clock.h"
#include "base/error.h"

#include <QString>

#include <memory>

namespace transport {
enum class Parity : std::uint8_t { None, Even, Odd };

/// How to open a port. `name` is a device path, "tcp://host:port" or "sim:NAME".
struct PortSpec {
    QString name;
    int baud = 1'000'000;
    Parity parity = Parity::None;
};

class Link {
public:
    virtual ~Link() = default;

    /// Hands the bytes to the system. Does not wait until they have left the wire.
    virtual base::Result<void> write(base::ByteView bytes) = 0;

    /// Appends what has arrived to `buffer`, without waiting. Number of bytes, or LinkLost.
    virtual base::Result<std::size_t> read(base::Bytes& buffer) = 0;

    /// Waits until something can be read, at most `span` (0: only looks). True: there is.
    virtual base::Result<bool> waitForReadyRead(base::Duration span) = 0;

    /// RateUnsupported when the adapter cannot; the old rate then stays.
    virtual base::Result<void> setBaud(int baud) = 0;
    virtual int baud() const = 0;

    /// False for links whose rate is set elsewhere (a TCP bridge without RFC 2217).
    virtual bool canSetBaud() const { return true; }

    virtual QString name() const = 0; ///< canonical
};
} // namespace transport
