// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/host/pty_device.h"

#include <QtGlobal>

#ifdef Q_OS_UNIX

#include "transport/tty_speed.h"

#include <QFile>
#include <QFileInfo>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <poll.h>
#include <sys/ioctl.h>
#include <termios.h>
#include <unistd.h>

#ifdef Q_OS_LINUX
#include <sys/inotify.h>
#endif

namespace sim {
namespace {
tl::unexpected<base::Error> systemError(const QString& what)
{
    return base::fail(base::ErrorCode::PortFailed, QStringLiteral("open"),
                      QStringLiteral("%1: %2").arg(what, QString::fromLocal8Bit(strerror(errno))));
}

void closeAll(std::initializer_list<int> descriptors)
{
    for (const int descriptor : descriptors) {
        if (descriptor >= 0)
            close(descriptor);
    }
}

bool setFlags(int descriptor)
{
    return fcntl(descriptor, F_SETFL, O_NONBLOCK) == 0 &&
           fcntl(descriptor, F_SETFD, FD_CLOEXEC) == 0;
}
} // namespace

base::Result<std::unique_ptr<PtyDevice>> PtyDevice::open(const QString& link, int baud)
{
    std::unique_ptr<PtyDevice> device(new PtyDevice);
    if (auto opened = device->openTerminal(baud); !opened)
        return tl::unexpected(opened.error());
    if (auto made = device->makeLink(link); !made)
        return tl::unexpected(made.error());
    device->watchClients();
    return device;
}

base::Result<void> PtyDevice::openTerminal(int baud)
{
    int descriptors[2] = {-1, -1};
    if (pipe(descriptors) != 0)
        return systemError(QStringLiteral("pipe"));
    m_wakeRead = descriptors[0];
    m_wakeWrite = descriptors[1];
    m_master = posix_openpt(O_RDWR | O_NOCTTY);
    if (m_master < 0 || grantpt(m_master) != 0 || unlockpt(m_master) != 0)
        return systemError(QStringLiteral("pseudo-terminal"));
    const char* name = ptsname(m_master);
    m_slave = name != nullptr ? ::open(name, O_RDWR | O_NOCTTY | O_CLOEXEC) : -1;
    termios settings{};
    if (m_slave < 0 || tcgetattr(m_slave, &settings) != 0)
        return systemError(QStringLiteral("pseudo-terminal"));
    cfmakeraw(&settings);
    if (tcsetattr(m_slave, TCSANOW, &settings) != 0 || !setFlags(m_master) ||
        !setFlags(m_wakeRead) || !setFlags(m_wakeWrite))
        return systemError(QStringLiteral("pseudo-terminal"));
    transport::setTtySpeed(m_slave, baud);
    m_path = QString::fromLocal8Bit(name);
    return {};
}

// Made under another name and renamed, so that the link always has a target. Only a link is ever
// replaced.
base::Result<void> PtyDevice::makeLink(const QString& link)
{
    if (link.isEmpty())
        return {};
    const QFileInfo present(link);
    if (present.exists() && !present.isSymLink())
        return base::fail(base::ErrorCode::PortFailed, QStringLiteral("link"),
                          QStringLiteral("%1: exists and is no symbolic link").arg(link));
    const QByteArray target = QFile::encodeName(m_path);
    const QByteArray name = QFile::encodeName(link);
    const QByteArray temporaryLink = name + '.' + QByteArray::number(qint64{getpid()});
    if (symlink(target.constData(), temporaryLink.constData()) != 0)
        return systemError(link);
    if (rename(temporaryLink.constData(), name.constData()) != 0) {
        const auto failure = systemError(link);
        unlink(temporaryLink.constData());
        return failure;
    }
    m_link = link;
    return {};
}

void PtyDevice::watchClients()
{
#ifdef Q_OS_LINUX
    m_watch = inotify_init1(IN_NONBLOCK | IN_CLOEXEC);
    const QByteArray name = QFile::encodeName(m_path);
    if (m_watch >= 0 && inotify_add_watch(m_watch, name.constData(), IN_OPEN | IN_CLOSE) < 0) {
        close(m_watch);
        m_watch = -1;
    }
#endif
}

PtyDevice::~PtyDevice()
{
    if (!m_link.isEmpty() && QFileInfo(m_link).symLinkTarget() == m_path)
        QFile::remove(m_link);
    closeAll({m_watch, m_slave, m_master, m_wakeRead, m_wakeWrite});
}

int PtyDevice::baud() const
{
    return transport::ttySpeed(m_slave).value_or(0);
}

void PtyDevice::wait(base::Duration span)
{
    pollfd states[] = {{m_master, POLLIN, 0}, {m_watch, POLLIN, 0}, {m_wakeRead, POLLIN, 0}};
    const auto nanos = std::chrono::nanoseconds(std::max(span, base::Duration{})).count();
    const timespec limit{static_cast<time_t>(nanos / 1'000'000'000),
                         static_cast<long>(nanos % 1'000'000'000)};
#ifdef Q_OS_LINUX
    const int ready = ppoll(states, std::size(states), &limit, nullptr);
#else
    const int ready = poll(states, std::size(states), static_cast<int>(nanos / 1'000'000));
#endif
    if (ready <= 0)
        return;
    m_isWoken = m_isWoken || states[2].revents != 0;
    if (states[1].revents != 0)
        countClients();
}

void PtyDevice::countClients()
{
#ifdef Q_OS_LINUX
    alignas(inotify_event) char events[4096];
    for (;;) {
        const ssize_t size = ::read(m_watch, events, sizeof events);
        if (size <= 0)
            return;
        for (ssize_t at = 0; at < size;) {
            const auto* event = reinterpret_cast<const inotify_event*>(events + at);
            m_clients += (event->mask & IN_OPEN) != 0 ? 1 : -1;
            if (m_clients <= 0)
                resetForNextClient();
            at += static_cast<ssize_t>(sizeof(inotify_event) + event->len);
        }
    }
#endif
}

// As a real port does when it is closed: unread bytes are dropped and the next client may open it,
// even if this one died while it held the port exclusively.
void PtyDevice::resetForNextClient()
{
    m_clients = 0;
    tcflush(m_slave, TCIFLUSH);
    ioctl(m_slave, TIOCNXCL);
}

void PtyDevice::wake()
{
    const char byte = 0;
    [[maybe_unused]] const auto written = ::write(m_wakeWrite, &byte, 1);
}

base::Bytes PtyDevice::read()
{
    base::Bytes bytes(4096);
    const ssize_t count = ::read(m_master, bytes.data(), bytes.size());
    bytes.resize(count > 0 ? static_cast<std::size_t>(count) : 0);
    return bytes;
}

void PtyDevice::write(base::ByteView bytes)
{
    // A client may have connected, and another one may have left, since wait() last counted.
    // Without counting again, a reply for the new client would be withheld or dropped with the old
    // one's.
    countClients();
    if (m_watch >= 0 && m_clients == 0)
        return;
    [[maybe_unused]] const auto written = ::write(m_master, bytes.data(), bytes.size());
}
} // namespace sim

#else

namespace sim {
base::Result<std::unique_ptr<PtyDevice>> PtyDevice::open(const QString&, int)
{
    return base::fail(base::ErrorCode::NotSupported, QStringLiteral("open"),
                      QStringLiteral("this system has no pseudo-terminals"));
}
PtyDevice::~PtyDevice() = default;
int PtyDevice::baud() const
{
    return 0;
}
void PtyDevice::wait(base::Duration) {}
void PtyDevice::wake() {}
base::Bytes PtyDevice::read()
{
    return {};
}
void PtyDevice::write(base::ByteView) {}
} // namespace sim

#endif
