// SPDX-License-Identifier: GPL-3.0-or-later
#include "transport/serial_link.h"

#include "transport/io_link.h"
#include "transport/port_inventory.h"
#include "transport/port_lease.h"
#include "transport/tty_speed.h"

#include <QFileInfo>
#include <QSerialPort>

#include <cerrno>
#include <cstdlib>

#ifdef Q_OS_UNIX
#include <poll.h>
#include <sys/file.h>
#endif

namespace transport {
namespace {
/// A UART whose rate is off by more than this no longer reads a byte safely.
constexpr double baudTolerance = 0.025;

QString openOperation()
{
    return QStringLiteral("open");
}

#ifdef Q_OS_UNIX
bool lockExclusively(int descriptor)
{
    return flock(descriptor, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK;
}

// QSerialPort does not wait for a hang-up without pending input.
bool isHungUp(int descriptor)
{
    pollfd state{descriptor, POLLIN, 0};
    return poll(&state, 1, 0) > 0 && (state.revents & (POLLHUP | POLLERR | POLLNVAL)) != 0;
}

std::optional<int> actualBaud(const QSerialPort& port)
{
    return ttySpeed(port.handle());
}
#else
bool lockExclusively(QSerialPort::Handle)
{
    return true; // the system itself opens a port only once
}

bool isHungUp(QSerialPort::Handle)
{
    return false;
}

std::optional<int> actualBaud(const QSerialPort&)
{
    return std::nullopt;
}
#endif

/// A reading that finds nothing, because another program has taken the bytes. The device is still
/// there: Linux hangs up one that is not.
bool isIgnorableError([[maybe_unused]] QSerialPort::SerialPortError error)
{
#ifdef Q_OS_LINUX
    return error == QSerialPort::ReadError || error == QSerialPort::ResourceError;
#else
    return false;
#endif
}

QSerialPort::Parity qtParity(Parity parity)
{
    switch (parity) {
    case Parity::Even:
        return QSerialPort::EvenParity;
    case Parity::Odd:
        return QSerialPort::OddParity;
    case Parity::None:
        break;
    }
    return QSerialPort::NoParity;
}

class SerialLink final : public IoLink {
public:
    SerialLink(std::unique_ptr<QSerialPort> port, QString path, PortLease lease)
        : IoLink(*port, std::move(path))
        , m_port(std::move(port))
        , m_lease(std::move(lease))
    {
        m_port->setReadBufferSize(readBufferSize);
    }

    base::Result<void> setBaud(int baud) override
    {
        if (isLost())
            return lostError(QStringLiteral("set-baud"));
        if (baud > 0 && m_port->setBaudRate(baud)) {
            const int actual = actualBaud(*m_port).value_or(baud);
            if (std::abs(actual - baud) <= baudTolerance * baud) {
                m_baud = baud;
                return {};
            }
        }
        m_port->clearError();
        if (m_baud > 0)
            m_port->setBaudRate(m_baud);
        return base::fail(base::ErrorCode::RateUnsupported, QStringLiteral("set-baud"),
                          QString::number(baud));
    }

    int baud() const override { return m_baud; }

private:
    void flush() override { m_port->flush(); }

    bool hasFailed() override
    {
        const auto error = m_port->error();
        m_port->clearError();
        return (error != QSerialPort::NoError && error != QSerialPort::TimeoutError &&
                !isIgnorableError(error)) ||
               isHungUp(m_port->handle());
    }

    void closeDevice() override
    {
        m_port->close();
        m_lease.release();
    }

    std::unique_ptr<QSerialPort> m_port;
    PortLease m_lease;
    int m_baud = 0;
};

base::Error openError(const QSerialPort& port, const QString& path)
{
    switch (port.error()) {
    case QSerialPort::DeviceNotFoundError:
        return {base::ErrorCode::PortMissing, openOperation(),
                adaptersClaimedByBrltty().isEmpty() ? path : path + QStringLiteral(", brltty")};
    case QSerialPort::PermissionError:
        // Qt reports a port in use this way as well.
        return accessDeniedError(path,
                                 QFileInfo(path).isReadable() && QFileInfo(path).isWritable());
    default:
        return {base::ErrorCode::PortFailed, openOperation(), port.errorString()};
    }
}
} // namespace

base::Error accessDeniedError(const QString& path, bool accessible)
{
    if (accessible)
        return {base::ErrorCode::PortBusy, openOperation(), portHolders(path)};
    return {base::ErrorCode::PortPermission, openOperation(), portGroup(path)};
}

base::Result<std::unique_ptr<Link>> openSerial(const PortSpec& spec)
{
    const QString path = canonicalPath(spec.name);
    auto lease = PortLease::acquire(path);
    if (!lease)
        return tl::unexpected(lease.error());
    auto port = std::make_unique<QSerialPort>();
    port->setPortName(path);
    // Before opening: a pseudo-terminal refuses a parity later.
    port->setParity(qtParity(spec.parity));
    if (!port->open(QIODevice::ReadWrite))
        return tl::unexpected(openError(*port, path));
    if (!lockExclusively(port->handle()))
        return base::fail(base::ErrorCode::PortBusy, openOperation(), portHolders(path));
    auto link = std::make_unique<SerialLink>(std::move(port), path, std::move(*lease));
    if (auto set = link->setBaud(spec.baud); !set)
        return tl::unexpected(set.error());
    return link;
}
} // namespace transport
