// SPDX-License-Identifier: GPL-3.0-or-later
// The list of ports follows what is plugged in, and an adapter is known again wherever it appears.
#include "session/port_watch.h"

#include <QDir>
#include <QFile>
#include <QRegularExpression>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include <mutex>

using session::PortInfo;
using session::PortWatch;

namespace {
/// What is plugged in; the watch's thread looks, the test plugs.
class Desk {
public:
    void plug(const PortInfo& port)
    {
        const std::lock_guard lock(m_mutex);
        m_look.ports.push_back(port);
    }
    void unplug(const QString& path)
    {
        const std::lock_guard lock(m_mutex);
        auto& ports = m_look.ports;
        ports.erase(std::remove_if(ports.begin(), ports.end(),
                                   [&](const PortInfo& port) { return port.path == path; }),
                    ports.end());
    }
    PortWatch::Lister lister()
    {
        return [this] {
            const std::lock_guard lock(m_mutex);
            return m_look;
        };
    }

private:
    std::mutex m_mutex;
    PortWatch::Look m_look;
};

PortInfo adapter(const char* path, const char* serial, int product = 0x7523)
{
    PortInfo port;
    port.path = QString::fromLatin1(path);
    port.description = QStringLiteral("USB Serial");
    port.serialNumber = QString::fromLatin1(serial);
    port.vendorId = 0x1a86;
    port.productId = product;
    return port;
}

PortInfo builtIn(const char* path)
{
    PortInfo port;
    port.path = QString::fromLatin1(path);
    return port;
}

QStringList pathsOf(const PortWatch& watch)
{
    QStringList paths;
    for (const PortInfo& port : watch.ports())
        paths << port.path.section(QLatin1Char('/'), -1);
    return paths;
}
} // namespace

class TestPortWatch : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { QTest::failOnWarning(QRegularExpression(QStringLiteral(".*"))); }

    void adaptersComeFirst();
    void pluggingAndUnpluggingIsNoticed();
    void anAdapterIsKnownAtAnotherPath();
    void withoutSerialNumberTheOnlyOneOfItsKindIsIt();
    void otherPortsAreKnownByName();
    void itIsBackWhenItWasGone();
    void anotherOfItsKindIsNotIt();
    void backBeforeAnybodyLooked();
    void theSystemsPortsAreListed();
    void brailleServiceIsSeen_data();
    void brailleServiceIsSeen();
};

void TestPortWatch::adaptersComeFirst()
{
    Desk desk;
    desk.plug(builtIn("/dev/ttyS0"));
    desk.plug(adapter("/dev/ttyUSB1", "B"));
    desk.plug(adapter("/dev/ttyUSB0", "A"));
    PortWatch watch(nullptr, desk.lister());
    QVERIFY(!watch.hasLooked());
    QVERIFY(watch.ports().empty());
    QTRY_VERIFY(watch.hasLooked());
    QCOMPARE(pathsOf(watch), QStringList({QStringLiteral("ttyUSB0"), QStringLiteral("ttyUSB1"),
                                          QStringLiteral("ttyS0")}));
}

void TestPortWatch::pluggingAndUnpluggingIsNoticed()
{
    Desk desk;
    desk.plug(builtIn("/dev/ttyS0"));
    PortWatch watch(nullptr, desk.lister());
    QSignalSpy spy(&watch, &PortWatch::portsChanged);
    QTRY_COMPARE(spy.count(), 1); // the first look
    desk.plug(adapter("/dev/ttyUSB0", "A"));
    QTRY_COMPARE_WITH_TIMEOUT(watch.ports().size(), std::size_t(2), 1000);
    desk.unplug(QStringLiteral("/dev/ttyUSB0"));
    QTRY_COMPARE_WITH_TIMEOUT(watch.ports().size(), std::size_t(1), 1000);
    QCOMPARE(spy.count(), 3); // and not a time more: an equal list is no news
}

void TestPortWatch::anAdapterIsKnownAtAnotherPath()
{
    Desk desk;
    desk.plug(adapter("/dev/ttyUSB0", "5A2F31"));
    desk.plug(adapter("/dev/ttyUSB1", "OTHER"));
    PortWatch watch(nullptr, desk.lister());
    QTRY_VERIFY(watch.hasLooked());
    const QString key = watch.adapterKey(QStringLiteral("/dev/ttyUSB0"));
    QCOMPARE(watch.portOf(key), QStringLiteral("/dev/ttyUSB0"));
    desk.unplug(QStringLiteral("/dev/ttyUSB0"));
    QTRY_COMPARE(watch.portOf(key), QString());
    desk.plug(adapter("/dev/ttyUSB7", "5A2F31"));
    QTRY_COMPARE(watch.portOf(key), QStringLiteral("/dev/ttyUSB7"));
    QCOMPARE(watch.adapterKey(QStringLiteral("/dev/ttyUSB7")), key);
}

void TestPortWatch::withoutSerialNumberTheOnlyOneOfItsKindIsIt()
{
    Desk desk;
    desk.plug(adapter("/dev/ttyUSB0", ""));
    PortWatch watch(nullptr, desk.lister());
    QTRY_VERIFY(watch.hasLooked());
    const QString key = watch.adapterKey(QStringLiteral("/dev/ttyUSB0"));
    desk.plug(adapter("/dev/ttyUSB1", ""));
    desk.plug(adapter("/dev/ttyUSB2", "", 0x55d3)); // of another kind
    QTRY_COMPARE(watch.ports().size(), std::size_t(3));
    QCOMPARE(watch.portOf(key), QStringLiteral("/dev/ttyUSB0"));
    QVERIFY(watch.adapterKey(QStringLiteral("/dev/ttyUSB1")) != key);
    desk.unplug(QStringLiteral("/dev/ttyUSB0"));
    QTRY_COMPARE(watch.portOf(key), QStringLiteral("/dev/ttyUSB1"));
    desk.plug(adapter("/dev/ttyUSB5", ""));
    QTRY_COMPARE(watch.portOf(key), QString()); // which of the two nobody knows
}

void TestPortWatch::otherPortsAreKnownByName()
{
    Desk desk;
    desk.plug(builtIn("/dev/ttyS0"));
    PortWatch watch(nullptr, desk.lister());
    QTRY_VERIFY(watch.hasLooked());
    for (const char* name : {"/dev/ttyS0", "/dev/ttyUSB9", "tcp://bench:4000", "sim:demo"})
        QCOMPARE(watch.adapterKey(QString::fromLatin1(name)), QString::fromLatin1(name));
    QCOMPARE(watch.portOf(QStringLiteral("/dev/ttyS0")), QStringLiteral("/dev/ttyS0"));
    QCOMPARE(watch.portOf(QStringLiteral("sim:demo")), QString());
    QCOMPARE(watch.portOf(QString()), QString());
}

void TestPortWatch::itIsBackWhenItWasGone()
{
    Desk desk;
    const QString path = QStringLiteral("/dev/ttyUSB0");
    desk.plug(adapter("/dev/ttyUSB0", ""));
    PortWatch watch(nullptr, desk.lister());
    QTRY_VERIFY(watch.hasLooked());
    session::ReplugWatch replug;
    QVERIFY(!replug.running());
    replug.start(watch, watch.adapterKey(path), path); // the list still shows it
    QCOMPARE(replug.look(watch), QString());
    desk.unplug(path);
    QTRY_VERIFY(watch.ports().empty());
    QCOMPARE(replug.look(watch), QString());
    desk.plug(adapter("/dev/ttyUSB1", ""));
    QTRY_COMPARE(replug.look(watch), QStringLiteral("/dev/ttyUSB1"));
    replug.stop();
    QCOMPARE(replug.look(watch), QString());
}

void TestPortWatch::anotherOfItsKindIsNotIt()
{
    Desk desk;
    desk.plug(adapter("/dev/ttyUSB0", ""));
    desk.plug(adapter("/dev/ttyUSB1", ""));
    PortWatch watch(nullptr, desk.lister());
    QTRY_VERIFY(watch.hasLooked());
    session::ReplugWatch replug;
    const QString path = QStringLiteral("/dev/ttyUSB1");
    replug.start(watch, watch.adapterKey(path), path);
    desk.unplug(path);
    QTRY_COMPARE(watch.ports().size(), std::size_t(1));
    QCOMPARE(replug.look(watch), QString()); // ttyUSB0 was there all the time
    desk.plug(adapter("/dev/ttyUSB1", ""));
    QTRY_COMPARE(replug.look(watch), path);
}

void TestPortWatch::backBeforeAnybodyLooked()
{
    Desk desk;
    const QString path = QStringLiteral("/dev/ttyUSB0");
    desk.plug(adapter("/dev/ttyUSB0", "A"));
    PortWatch watch(nullptr, desk.lister());
    QTRY_VERIFY(watch.hasLooked());
    session::ReplugWatch replug;
    replug.start(watch, watch.adapterKey(path), path);
    replug.settle();
    QCOMPARE(replug.look(watch), path);
}

void TestPortWatch::theSystemsPortsAreListed()
{
    PortWatch watch;
    QTRY_VERIFY(watch.hasLooked());
    for (const PortInfo& port : watch.ports())
        QVERIFY2(QFile::exists(port.path), qPrintable(port.path));
}

void TestPortWatch::brailleServiceIsSeen_data()
{
    QTest::addColumn<QByteArray>("process");
    QTest::addColumn<QByteArray>("product");
    QTest::addColumn<QString>("driver");
    QTest::addColumn<QStringList>("taken");
    const QStringList chip{QStringLiteral("1a86:7523")};
    const QString program = QStringLiteral("usbfs");
    QTest::newRow("taken") << QByteArray("brltty\n") << QByteArray("7523\n") << program << chip;
    QTest::newRow("by somebody else")
        << QByteArray("minicom\n") << QByteArray("7523\n") << program << QStringList();
    QTest::newRow("has its driver") << QByteArray("brltty\n") << QByteArray("7523\n")
                                    << QStringLiteral("ch341") << QStringList();
    QTest::newRow("no converter") << QByteArray("brltty\n") << QByteArray("1234\n") << program
                                  << QStringList();
}

void TestPortWatch::brailleServiceIsSeen()
{
    QFETCH(const QByteArray, process);
    QFETCH(const QByteArray, product);
    QFETCH(const QString, driver);
    QFETCH(const QStringList, taken);
    const QTemporaryDir root;
    const auto put = [&](const char* path, const QByteArray& content) {
        const QString file = root.filePath(QString::fromLatin1(path));
        QVERIFY(QDir().mkpath(QFileInfo(file).path()));
        QFile out(file);
        QVERIFY(out.open(QIODevice::WriteOnly));
        out.write(content);
    };
    put("proc/77/comm", process);
    put("proc/self/comm", "brltty\n"); // no process of its own
    put("sys/bus/usb/devices/1-1/idVendor", "1a86\n");
    put("sys/bus/usb/devices/1-1/idProduct", product);
    const QString interface = root.filePath(QStringLiteral("sys/bus/usb/devices/1-1:1.0"));
    QVERIFY(QDir().mkpath(interface));
    QVERIFY(QDir().mkpath(root.filePath(QStringLiteral("drivers/") + driver)));
    QVERIFY(QFile::link(root.filePath(QStringLiteral("drivers/") + driver),
                        interface + QStringLiteral("/driver")));
    QCOMPARE(transport::takenByBraille(root.path()), taken);
}

QTEST_GUILESS_MAIN(TestPortWatch)
#include "tst_port_watch.moc"
