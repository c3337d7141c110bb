// SPDX-License-Identifier: GPL-3.0-or-later
#include "transport/io_link.h"

#include <QDeadlineTimer>

#include <thread>

namespace transport {
IoLink::IoLink(QIODevice& device, QString name)
    : m_device(device)
    , m_name(std::move(name))
{}

tl::unexpected<base::Error> IoLink::lost(const QString& operation) const
{
    return base::fail(base::ErrorCode::LinkLost, operation, m_name);
}

// What arrived before the loss is still handed out.
bool IoLink::noticeLoss()
{
    if (!m_lost && m_device.bytesAvailable() == 0 && broken()) {
        m_lost = true;
        shut();
    }
    return m_lost;
}

base::Result<void> IoLink::write(base::ByteView bytes)
{
    if (m_lost)
        return lost(QStringLiteral("write"));
    const auto* data = reinterpret_cast<const char*>(bytes.data());
    const auto size = static_cast<qint64>(bytes.size());
    if (m_device.write(data, size) == size)
        flush();
    if (noticeLoss())
        return lost(QStringLiteral("write"));
    return {};
}

base::Result<std::size_t> IoLink::read(base::Bytes& buffer)
{
    if (!m_lost && m_device.bytesAvailable() == 0)
        waitOnce(base::Duration{});
    if (noticeLoss())
        return lost(QStringLiteral("read"));
    const auto count = static_cast<std::size_t>(m_device.bytesAvailable());
    const std::size_t before = buffer.size();
    buffer.resize(before + count);
    const qint64 got =
        m_device.read(reinterpret_cast<char*>(buffer.data() + before), static_cast<qint64>(count));
    buffer.resize(before + static_cast<std::size_t>(std::max<qint64>(got, 0)));
    return buffer.size() - before;
}

base::Result<bool> IoLink::waitReadable(base::Duration span)
{
    if (!m_lost && m_device.bytesAvailable() > 0)
        return true;
    const bool readable = !m_lost && waitOnce(span);
    if (noticeLoss())
        return lost(QStringLiteral("read"));
    return readable;
}

// Qt counts in milliseconds. The rest is slept, then looked at once: waiting out a started
// millisecond would cost a search a tenth of a second.
bool IoLink::waitOnce(base::Duration span)
{
    const auto whole = std::chrono::floor<std::chrono::milliseconds>(span);
    if (whole.count() > 0 && m_device.waitForReadyRead(static_cast<int>(whole.count())))
        return true;
    if (noticeLoss())
        return false;
    if (const base::Duration rest = span - whole; rest.count() > 0)
        std::this_thread::sleep_for(rest);
    return m_device.waitForReadyRead(0);
}
} // namespace transport
