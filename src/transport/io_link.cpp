// SPDX-License-Identifier: GPL-3.0-or-later
#include "transport/io_link.h"

#include <QDeadlineTimer>

#include <thread>

namespace transport {
IoLink::IoLink(QIODevice& device, QString name)
    : m_device(device)
    , m_name(std::move(name))
{}

tl::unexpected<base::Error> IoLink::lostError(const QString& operation) const
{
    return base::fail(base::ErrorCode::LinkLost, operation, m_name);
}

// What arrived before the loss is still handed out.
bool IoLink::detectLoss()
{
    if (!m_lost && m_device.bytesAvailable() == 0 && hasFailed()) {
        m_lost = true;
        closeDevice();
    }
    return m_lost;
}

base::Result<void> IoLink::write(base::ByteView bytes)
{
    if (m_lost)
        return lostError(QStringLiteral("write"));
    const auto* data = reinterpret_cast<const char*>(bytes.data());
    const auto size = static_cast<qint64>(bytes.size());
    if (m_device.write(data, size) == size)
        flush();
    if (detectLoss())
        return lostError(QStringLiteral("write"));
    return {};
}

base::Result<std::size_t> IoLink::read(base::Bytes& buffer)
{
    if (!m_lost && m_device.bytesAvailable() == 0)
        waitForData(base::Duration{});
    if (detectLoss())
        return lostError(QStringLiteral("read"));
    const auto count = static_cast<std::size_t>(m_device.bytesAvailable());
    const std::size_t before = buffer.size();
    buffer.resize(before + count);
    const qint64 bytesRead =
        m_device.read(reinterpret_cast<char*>(buffer.data() + before), static_cast<qint64>(count));
    buffer.resize(before + static_cast<std::size_t>(std::max<qint64>(bytesRead, 0)));
    return buffer.size() - before;
}

base::Result<bool> IoLink::waitForReadyRead(base::Duration span)
{
    if (!m_lost && m_device.bytesAvailable() > 0)
        return true;
    const bool readable = !m_lost && waitForData(span);
    if (detectLoss())
        return lostError(QStringLiteral("read"));
    return readable;
}

// Qt counts in milliseconds. The rest is slept, followed by one read: rounding up to
// whole milliseconds would make a search slower by a tenth of a second.
bool IoLink::waitForData(base::Duration span)
{
    const auto wholeMs = std::chrono::floor<std::chrono::milliseconds>(span);
    if (wholeMs.count() > 0 && m_device.waitForReadyRead(static_cast<int>(wholeMs.count())))
        return true;
    if (detectLoss())
        return false;
    if (const base::Duration remainder = span - wholeMs; remainder.count() > 0)
        std::this_thread::sleep_for(remainder);
    return m_device.waitForReadyRead(0);
}
} // namespace transport
