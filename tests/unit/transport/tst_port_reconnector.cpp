// SPDX-License-Identifier: GPL-3.0-or-later
// Which port is opened again after a plug was pulled: the same adapter, also under another name,
// and never another adapter that has taken the name.
#include "support/test_main.h"
#include "transport/port_reconnector.h"

#include <QRegularExpression>
#include <QTest>

using base::ErrorCode;
using transport::PortInfo;
using transport::PortReconnector;
using transport::PortSpec;

namespace {
class NullLink final : public transport::Link {
public:
    base::Result<void> write(base::ByteView) override { return {}; }
    base::Result<std::size_t> read(base::Bytes&) override { return std::size_t(0); }
    base::Result<bool> waitForReadyRead(base::Duration) override { return false; }
    base::Result<void> setBaud(int) override { return {}; }
    int baud() const override { return 0; }
    QString name() const override { return {}; }
};

PortInfo adapter(const char* path, const char* serial, int product = 0x7523)
{
    PortInfo port;
    port.path = QString::fromLatin1(path);
    port.serialNumber = QString::fromLatin1(serial);
    port.vendorId = 0x1a86;
    port.productId = product;
    return port;
}

struct PortKeeperFixture {
    std::vector<PortInfo> plugged;
    QStringList opened;
    PortReconnector keeper;

    explicit PortKeeperFixture(std::vector<PortInfo> ports, const char* name = "/dev/ttyUSB7")
        : plugged(std::move(ports))
        , keeper(
              PortSpec{QString::fromLatin1(name)},
              [this](const PortSpec& spec) -> base::Result<std::unique_ptr<transport::Link>> {
                  opened << spec.name;
                  return std::make_unique<NullLink>();
              },
              [this] { return plugged; })
    {}
    QString again(std::vector<PortInfo> ports)
    {
        plugged = std::move(ports);
        opened.clear();
        const auto link = keeper.open();
        return link ? opened.last() : base::errorName(link.error().code);
    }
};
} // namespace

class TestPortReconnector : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { QTest::failOnWarning(QRegularExpression(QStringLiteral(".*"))); }

    void theSameAdapterIsOpenedAgain()
    {
        PortKeeperFixture fixture({adapter("/dev/ttyUSB7", "A"), adapter("/dev/ttyUSB8", "B")});
        QVERIFY(fixture.keeper.open());
        QCOMPARE(fixture.again({adapter("/dev/ttyUSB7", "A")}), QStringLiteral("/dev/ttyUSB7"));
        QCOMPARE(fixture.again({adapter("/dev/ttyUSB8", "B"), adapter("/dev/ttyUSB9", "A")}),
                 QStringLiteral("/dev/ttyUSB9"));
    }

    void anotherAdapterIsNot()
    {
        const QString missing = base::errorName(ErrorCode::PortMissing);
        PortKeeperFixture fixture({adapter("/dev/ttyUSB7", "A")});
        QVERIFY(fixture.keeper.open());
        QCOMPARE(fixture.again({}), missing);
        QCOMPARE(fixture.again({adapter("/dev/ttyUSB7", "B")}), missing);
        QCOMPARE(fixture.again({adapter("/dev/ttyUSB7", "A", 0x55d3)}), missing);
        QVERIFY(fixture.opened.isEmpty());
    }

    /// Two of a kind without numbers: only the name tells them apart.
    void withoutASerialNumberTheNameIsUsed()
    {
        PortKeeperFixture fixture({adapter("/dev/ttyUSB7", "")});
        QVERIFY(fixture.keeper.open());
        QCOMPARE(fixture.again({adapter("/dev/ttyUSB8", "")}),
                 base::errorName(ErrorCode::PortMissing));
        QCOMPARE(fixture.again({adapter("/dev/ttyUSB7", "")}), QStringLiteral("/dev/ttyUSB7"));
    }

    void nonAdaptersAreMatchedByName()
    {
        PortKeeperFixture fixture({}, "tcp://bench:5000");
        QVERIFY(fixture.keeper.open());
        QCOMPARE(fixture.again({adapter("/dev/ttyUSB7", "A")}), QStringLiteral("tcp://bench:5000"));
    }
};

SERVODESK_GUILESS_TEST(TestPortReconnector)
#include "tst_port_reconnector.moc"
