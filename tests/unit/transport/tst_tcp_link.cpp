// SPDX-License-Identifier: GPL-3.0-or-later
// The TCP link against a plain socket, as a serial bridge on the network offers it.
#include "base/clock.h"
#include "support/test_main.h"
#include "transport/port_opener.h"

#include <QRegularExpression>
#include <QTest>

#include <arpa/inet.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <string>
#include <sys/socket.h>
#include <unistd.h>

using namespace std::chrono_literals;
using base::ErrorCode;

namespace {
/// A listening socket on this computer; the kernel completes the connection, no thread needed.
class TcpServer {
public:
    TcpServer()
    {
        m_listener = socket(AF_INET, SOCK_STREAM, 0);
        sockaddr_in address{};
        address.sin_family = AF_INET;
        address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
        socklen_t size = sizeof address;
        if (bind(m_listener, reinterpret_cast<sockaddr*>(&address), size) != 0 ||
            listen(m_listener, 1) != 0 ||
            getsockname(m_listener, reinterpret_cast<sockaddr*>(&address), &size) != 0)
            qFatal("no listening socket");
        m_port = ntohs(address.sin_port);
    }
    ~TcpServer()
    {
        dropConnection();
        stopListening();
    }

    QString url() const { return QStringLiteral("tcp://127.0.0.1:%1").arg(m_port); }
    void accept() { m_peer = ::accept(m_listener, nullptr, nullptr); }
    void stopListening()
    {
        if (m_listener >= 0)
            close(m_listener);
        m_listener = -1;
    }
    void dropConnection()
    {
        if (m_peer >= 0)
            close(m_peer);
        m_peer = -1;
    }
    void sendBytes(const std::string& bytes) const
    {
        if (send(m_peer, bytes.data(), bytes.size(), 0) != static_cast<ssize_t>(bytes.size()))
            qFatal("send");
    }
    std::string receive(std::size_t count) const
    {
        std::string all(count, '\0');
        const ssize_t got = recv(m_peer, all.data(), count, MSG_WAITALL);
        all.resize(got > 0 ? static_cast<std::size_t>(got) : 0);
        return all;
    }

private:
    int m_listener = -1;
    int m_peer = -1;
    int m_port = 0;
};
} // namespace

class TestTcpLink : public QObject {
    Q_OBJECT

    base::SystemClock m_clock;

    auto open(const QString& url) { return transport::openPort({url, 115'200}, m_clock); }

private Q_SLOTS:
    void init() { QTest::failOnWarning(QRegularExpression(QStringLiteral(".*"))); }

    void carriesEveryByteBothWays()
    {
        TcpServer server;
        auto link = open(server.url());
        QVERIFY(link);
        server.accept();
        base::Bytes all(256);
        for (std::size_t i = 0; i < all.size(); ++i)
            all[i] = static_cast<std::uint8_t>(i);
        const std::string text(all.begin(), all.end());
        QVERIFY((*link)->write(all));
        QCOMPARE(server.receive(256), text);
        server.sendBytes(text);
        base::Bytes back;
        while (back.size() < all.size() && (*link)->waitForReadyRead(5s).value_or(false))
            QVERIFY((*link)->read(back));
        QCOMPARE(back, all);
        QVERIFY(!(*link)->waitForReadyRead(0us).value());
    }

    void leavesTheRateToTheBridge()
    {
        TcpServer server;
        auto link = open(server.url());
        QVERIFY(link);
        QVERIFY(!(*link)->canSetBaud());
        QCOMPARE((*link)->baud(), 115'200);
        QVERIFY((*link)->setBaud(1'000'000));
        QCOMPARE((*link)->baud(), 1'000'000);
        QCOMPARE((*link)->name(), server.url());
    }

    void detectsTheLostConnection_data()
    {
        QTest::addColumn<base::Duration>("span");
        QTest::newRow("looking") << base::Duration{};
        QTest::newRow("waiting") << base::Duration{3600s};
    }
    void detectsTheLostConnection()
    {
        QFETCH(base::Duration, span);
        TcpServer server;
        auto link = open(server.url());
        QVERIFY(link);
        server.accept();
        server.sendBytes("ab");
        QVERIFY((*link)->waitForReadyRead(5s).value());
        server.dropConnection();
        base::Bytes buffer;
        QCOMPARE((*link)->read(buffer).value(), std::size_t{2});
        QCOMPARE((*link)->waitForReadyRead(span).error().code, ErrorCode::LinkLost);
        QCOMPARE((*link)->write(base::Bytes{1}).error().code, ErrorCode::LinkLost);
        QCOMPARE((*link)->read(buffer).error().code, ErrorCode::LinkLost);
        QCOMPARE((*link)->setBaud(9600).error().code, ErrorCode::LinkLost);
    }

    void refusesABadAddress_data()
    {
        QTest::addColumn<QString>("url");
        QTest::newRow("no port") << QStringLiteral("tcp://bridge");
        QTest::newRow("port 0") << QStringLiteral("tcp://bridge:0");
        QTest::newRow("port too high") << QStringLiteral("tcp://bridge:65536");
        QTest::newRow("no host") << QStringLiteral("tcp://:2000");
        QTest::newRow("other scheme") << QStringLiteral("udp://bridge:2000");
        QTest::newRow("with a path") << QStringLiteral("tcp://bridge:2000/servo");
        QTest::newRow("with a user") << QStringLiteral("tcp://me@bridge:2000");
        QTest::newRow("blank inside") << QStringLiteral("tcp://br idge:2000");
    }
    void refusesABadAddress()
    {
        QFETCH(QString, url);
        const auto link = open(url);
        QVERIFY(!link);
        QCOMPARE(link.error().code, ErrorCode::BadArgument);
        QVERIFY(link.error().detail.contains(url));
    }

    void reportsARefusedConnection()
    {
        TcpServer server;
        server.stopListening();
        const auto link = open(server.url());
        QVERIFY(!link);
        QCOMPARE(link.error().code, ErrorCode::PortFailed);
        QVERIFY(!link.error().detail.isEmpty());
    }

    void refusesAnEmptyName() { QCOMPARE(open(QString()).error().code, ErrorCode::BadArgument); }
};

SERVODESK_GUILESS_TEST(TestTcpLink)
#include "tst_tcp_link.moc"
