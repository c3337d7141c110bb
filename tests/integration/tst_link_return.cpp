// SPDX-License-Identifier: GPL-3.0-or-later
// A port of the system that goes away under the session and comes back under the same name, as a
// USB adapter does: servodesk-sim killed and started again behind one symbolic link.
#include "session/connection.h"
#include "session/session.h"
#include "support/own_data_folder.h"

#include <QFile>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QTest>

#include "raw_client.h"

using base::ErrorCode;

class TestLinkReturn : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { QTest::failOnWarning(QRegularExpression(QStringLiteral(".*"))); }

    void aPortThatComesBackIsUsedAgain();
    void withoutPatienceItIsLost();

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
    support::OwnDataFolder m_place; ///< before the session
    session::Session m_session;
};

void TestLinkReturn::aPortThatComesBackIsUsedAgain()
{
    auto simulator = std::make_unique<raw::Simulator>(arguments());
    const auto connection = connected();
    QVERIFY(connection);
    QVERIFY(ping(*connection));
    const bus::LinkPatience patience(connection->bus(), std::chrono::seconds(60));
    simulator->end(SIGKILL);
    QTRY_VERIFY(connection->bus().away());
    const auto deaf = ping(*connection);
    QVERIFY(!deaf);
    QCOMPARE(deaf.error().code, ErrorCode::NoAnswer);
    QFile::remove(link()); // nobody tidied up
    simulator = std::make_unique<raw::Simulator>(arguments());
    QTRY_VERIFY_WITH_TIMEOUT(ping(*connection).has_value(), 20'000);
    QVERIFY(!connection->bus().away());
    // And once more.
    simulator->end();
    QTRY_VERIFY(connection->bus().away());
    simulator = std::make_unique<raw::Simulator>(arguments());
    QTRY_VERIFY_WITH_TIMEOUT(ping(*connection).has_value(), 20'000);
}

void TestLinkReturn::withoutPatienceItIsLost()
{
    raw::Simulator simulator(arguments());
    const auto connection = connected();
    QVERIFY(connection);
    QVERIFY(ping(*connection));
    simulator.end();
    QTRY_VERIFY(connection->bus().lost());
    QVERIFY(!connection->bus().away());
}

QTEST_GUILESS_MAIN(TestLinkReturn)
#include "tst_link_return.moc"
