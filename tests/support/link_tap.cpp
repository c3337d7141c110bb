// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/link_tap.h"

namespace support {
namespace {
class TapLink final : public transport::Link {
public:
    TapLink(std::unique_ptr<transport::Link> link, LinkTap& tap)
        : m_link(std::move(link))
        , m_tap(tap)
    {}

    base::Result<void> write(base::ByteView bytes) override
    {
        m_tap.written.emplace_back(bytes.begin(), bytes.end());
        if (m_tap.onWrite)
            m_tap.onWrite(m_tap.written.back());
        const auto own =
            m_tap.replyOverride ? m_tap.replyOverride(m_tap.written.back()) : std::nullopt;
        if (!own)
            return m_link->write(bytes);
        m_own.insert(m_own.end(), own->begin(), own->end());
        return {};
    }
    base::Result<std::size_t> read(base::Bytes& buffer) override
    {
        const std::size_t count = m_own.size();
        buffer.insert(buffer.end(), m_own.begin(), m_own.end());
        m_own.clear();
        return m_link->read(buffer).map([count](std::size_t more) { return count + more; });
    }
    base::Result<bool> waitForReadyRead(base::Duration span) override
    {
        if (m_tap.onWait)
            m_tap.onWait();
        return m_own.empty() ? m_link->waitForReadyRead(span) : base::Result<bool>(true);
    }
    base::Result<void> setBaud(int baud) override
    {
        if (m_tap.refusedRates.count(baud) > 0)
            return base::fail(base::ErrorCode::RateUnsupported, QStringLiteral("set-baud"),
                              QString::number(baud));
        return m_link->setBaud(baud);
    }
    int baud() const override { return m_link->baud(); }
    bool canSetBaud() const override { return !m_tap.rateIsFixed && m_link->canSetBaud(); }
    QString name() const override { return m_link->name(); }

private:
    std::unique_ptr<transport::Link> m_link;
    LinkTap& m_tap;
    base::Bytes m_own; ///< of the other device, on their way to the host
};
} // namespace

std::unique_ptr<transport::Link> tapped(std::unique_ptr<transport::Link> link, LinkTap& tap)
{
    return std::make_unique<TapLink>(std::move(link), tap);
}
} // namespace support
