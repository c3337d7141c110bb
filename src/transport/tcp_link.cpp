// SPDX-License-Identifier: GPL-3.0-or-later
#include "transport/tcp_link.h"

#include "transport/io_link.h"

#include <QTcpSocket>
#include <QUrl>

namespace transport {
namespace {
constexpr int connectTimeoutMs = 3000;

class TcpLink final : public IoLink {
public:
    TcpLink(std::unique_ptr<QTcpSocket> socket, QString name, int baud)
        : IoLink(*socket, std::move(name))
        , m_socket(std::move(socket))
        , m_baud(baud)
    {
        m_socket->setReadBufferSize(readBufferSize);
    }

    // Only remembered: deadlines are computed from it.
    base::Result<void> setBaud(int baud) override
    {
        if (isLost())
            return lostError(QStringLiteral("set-baud"));
        m_baud = baud;
        return {};
    }

    int baud() const override { return m_baud; }
    bool canSetBaud() const override { return false; }

private:
    void flush() override { m_socket->flush(); }
    bool hasFailed() override { return m_socket->state() != QAbstractSocket::ConnectedState; }
    void closeDevice() override { m_socket->abort(); }

    std::unique_ptr<QTcpSocket> m_socket;
    int m_baud;
};

base::Result<QUrl> parseUrl(const QString& name)
{
    const QUrl url(name, QUrl::StrictMode);
    const bool isPlain =
        url.path().isEmpty() && !url.hasQuery() && !url.hasFragment() && url.userInfo().isEmpty();
    if (url.scheme() != QLatin1String("tcp") || url.host().isEmpty() || url.port() <= 0 || !isPlain)
        return base::fail(base::ErrorCode::BadArgument, QStringLiteral("open"),
                          QStringLiteral("%1: expected tcp://host:port").arg(name));
    return url;
}
} // namespace

base::Result<std::unique_ptr<Link>> openTcp(const PortSpec& spec)
{
    const auto url = parseUrl(spec.name);
    if (!url)
        return tl::unexpected(url.error());
    auto socket = std::make_unique<QTcpSocket>();
    socket->connectToHost(url->host(), static_cast<quint16>(url->port()));
    if (!socket->waitForConnected(connectTimeoutMs)) {
        if (socket->error() == QAbstractSocket::HostNotFoundError)
            return base::fail(base::ErrorCode::PortMissing, QStringLiteral("open"), url->host());
        return base::fail(base::ErrorCode::PortFailed, QStringLiteral("open"),
                          socket->errorString());
    }
    socket->setSocketOption(QAbstractSocket::LowDelayOption, 1);
    socket->setSocketOption(QAbstractSocket::KeepAliveOption, 1);
    return std::make_unique<TcpLink>(std::move(socket), url->toString(), spec.baud);
}
} // namespace transport
