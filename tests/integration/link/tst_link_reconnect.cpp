// SPDX-License-Identifier: GPL-3.0-or-later
// A port of the system that goes away under the session and comes back under the same name, as a
// USB adapter does: servodesk-sim killed and started again behind one symbolic link.
#include "integration/raw_client.h"
#include "session/connection.h"
#include "session/session.h"
#include "support/temporary_data_folder.h"
#include "support/test_main.h"

#include <QFile>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QTest>

using base::ErrorCode;

class TestLinkReconnect : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { QTest::failOnWarning(QRegularExpression(QStringLiteral(".*"))); }

    void aReturningPortIsReopened();
    void withoutReconnectTimeoutItIsLost();

private:
    QStringList arguments() const
    {
        return {QStringLiteral("--servos"), QStringLiteral("sts3215@1"), QStringLiteral("--link"),
                link()};
    }
    QString link() const { return m_folder.filePath(QStringLiteral("adapter")); }
    std::unique_ptr<session::Connection> connected()
    {
        session::PortRequest request;
        request.name = link();
        request.baud = 1'000'000;
        auto connection = m_session.connect(request);
        return connection ? std::move(*connection) : nullptr;
    }
    static base::Result<bus::Outcome> ping(session::Connection& connection)
    {
        bus::Transaction transaction;
        transaction.request = protocol::Request::ping(1);
        return connection.bus().transact(transaction);
    }

    QTemporaryDir m_folder;
    support::TemporaryDataFolder m_place; ///< before the session
    session::Session m_session;
};

void TestLinkReconnect::aReturningPortIsReopened()
{
    auto simulator = std::make_unique<raw::Simulator>(arguments());
    const auto connection = connected();
    QVERIFY(connection);
    QVERIFY(ping(*connection));
    const bus::ReconnectScope reconnect(connection->bus(), std::chrono::seconds(60));
    simulator->end(SIGKILL);
    QTRY_VERIFY(connection->bus().isReconnecting());
    const auto pingResult = ping(*connection);
    QVERIFY(!pingResult);
    QCOMPARE(pingResult.error().code, ErrorCode::NoReply);
    QFile::remove(link()); // nobody tidied up
    simulator = std::make_unique<raw::Simulator>(arguments());
    QTRY_VERIFY(ping(*connection).has_value());
    QVERIFY(!connection->bus().isReconnecting());
    // And once more.
    simulator->end();
    QTRY_VERIFY(connection->bus().isReconnecting());
    simulator = std::make_unique<raw::Simulator>(arguments());
    QTRY_VERIFY(ping(*connection).has_value());
}

void TestLinkReconnect::withoutReconnectTimeoutItIsLost()
{
    raw::Simulator simulator(arguments());
    const auto connection = connected();
    QVERIFY(connection);
    QVERIFY(ping(*connection));
    simulator.end();
    QTRY_VERIFY(connection->bus().lost());
    QVERIFY(!connection->bus().isReconnecting());
}

SERVODESK_GUILESS_TEST(TestLinkReconnect)
#include "tst_link_reconnect.moc"
