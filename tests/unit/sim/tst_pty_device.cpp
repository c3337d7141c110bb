// SPDX-License-Identifier: GPL-3.0-or-later
// The simulator's terminal when clients connect and leave between two of its reads: which bytes
// reach which client.
#include "integration/raw_client.h"
#include "sim/host/pty_device.h"
#include "support/test_main.h"

#include <QTest>

#include <optional>

namespace {
constexpr base::Duration noWait{};
const QByteArray request("ask");
const base::Bytes reply{'h', 'e', 'r', 'e'};

QByteArray text(const base::Bytes& bytes)
{
    return {reinterpret_cast<const char*>(bytes.data()), qsizetype(bytes.size())};
}
} // namespace

class TestPtyDevice : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init()
    {
        auto opened = sim::PtyDevice::open({}, 1'000'000);
        QVERIFY(opened);
        m_device = std::move(*opened);
        m_client.emplace(m_device->path());
        QVERIFY(m_client->isOpen());
    }
    void cleanup()
    {
        m_client.reset();
        m_device.reset();
    }

    void answersClientsConnectedSinceTheLastPoll()
    {
        m_client->send(request);
        QCOMPARE(text(m_device->read()), request);
        m_device->write(reply);
        QCOMPARE(m_client->receive(4), text(reply));
    }

    void keepsTheReplyForAQuickSuccessor()
    {
        m_device->wait(noWait);
        m_client.emplace(m_device->path());
        m_client->send(request);
        QCOMPARE(text(m_device->read()), request);
        m_device->write(reply);
        m_device->wait(noWait);
        QCOMPARE(m_client->receive(4), text(reply));
    }

    void dropsTheReplyToADisconnectedClient()
    {
        m_device->wait(noWait);
        m_client->send(request);
        QCOMPARE(text(m_device->read()), request);
        m_client.reset();
        m_device->write(reply);
        m_client.emplace(m_device->path());
        QVERIFY(!m_client->readable(0));
    }

private:
    std::unique_ptr<sim::PtyDevice> m_device;
    std::optional<raw::Client> m_client;
};

SERVODESK_GUILESS_TEST(TestPtyDevice)
#include "tst_pty_device.moc"
