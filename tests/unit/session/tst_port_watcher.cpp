// SPDX-License-Identifier: GPL-3.0-or-later
// The list of ports follows what is plugged in, and an adapter is known again wherever it appears.
#include "session/port_watcher.h"
#include "support/test_main.h"

#include <QDir>
#include <QFile>
#include <QRegularExpression>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include <mutex>

using session::PortInfo;
using session::PortWatcher;

namespace {
/// What is plugged in; the watch's thread looks, the test plugs.
class PortList {
public:
    void plug(const PortInfo& port)
    {
        const std::lock_guard lock(m_mutex);
        m_portList.ports.push_back(port);
    }
    void unplug(const QString& path)
    {
        const std::lock_guard lock(m_mutex);
        auto& ports = m_portList.ports;
        ports.erase(std::remove_if(ports.begin(), ports.end(),
                                   [&](const PortInfo& port) { return port.path == path; }),
                    ports.end());
    }
    PortWatcher::PortLister lister()
    {
        return [this] {
            const std::lock_guard lock(m_mutex);
            return m_portList;
        };
    }

private:
    std::mutex m_mutex;
    PortWatcher::PortList m_portList;
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

QStringList pathsOf(const PortWatcher& watch)
{
    QStringList paths;
    for (const PortInfo& port : watch.ports())
        paths << port.path.section(QLatin1Char('/'), -1);
    return paths;
}
} // namespace

class TestPortWatcher : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { QTest::failOnWarning(QRegularExpression(QStringLiteral(".*"))); }

    /// Plugging changes the folder of device nodes; a permission that is set later does not.
    void portsAreListedWhenTheyMayHaveChanged()
    {
        using std::chrono::milliseconds;
        using std::chrono::seconds;
        const auto at = [](milliseconds time) { return session::ListingSchedule::Time(time); };
        const QDateTime before(QDate(2026, 1, 1), QTime(12, 0));
        const QDateTime after = before.addSecs(60);
        session::ListingSchedule schedule;
        QVERIFY(schedule.isDue(before, at(seconds(100))));
        QVERIFY(schedule.isDue(before, at(seconds(102)))); // permissions and links may follow
        QVERIFY(schedule.isDue(before, at(milliseconds(102'900))));
        QVERIFY(!schedule.isDue(before, at(milliseconds(103'400))));
        QVERIFY(!schedule.isDue(before, at(milliseconds(107'800))));
        QVERIFY(schedule.isDue(before, at(milliseconds(107'900))));
        QVERIFY(!schedule.isDue(before, at(milliseconds(108'400))));
        QVERIFY(schedule.isDue(after, at(milliseconds(108'900)))); // plugged in
        QVERIFY(schedule.isDue(after, at(milliseconds(109'400))));
        // Without such a folder nothing can be told.
        session::ListingSchedule always;
        for (int i = 0; i < 20; ++i)
            QVERIFY(always.isDue({}, at(milliseconds(500 * i))));
    }

    void adaptersComeFirst();
    void pluggingAndUnpluggingIsDetected();
    void anAdapterIsKnownAtAnotherPath();
    void withoutSerialNumberTheOnlyMatchIsUsed();
    void otherPortsAreKnownByName();
    void returnsAfterRemoval();
    void anotherOfItsTypeIsNoMatch();
    void backBeforeTheNextScan();
    void theSystemsPortsAreListed();
    void brailleServiceIsDetected_data();
    void brailleServiceIsDetected();
    void latencyTimerIsRead();
};

void TestPortWatcher::adaptersComeFirst()
{
    PortList portList;
    portList.plug(builtIn("/dev/ttyS0"));
    portList.plug(adapter("/dev/ttyUSB1", "B"));
    portList.plug(adapter("/dev/ttyUSB0", "A"));
    PortWatcher watch(nullptr, portList.lister());
    QVERIFY(!watch.isReady());
    QVERIFY(watch.ports().empty());
    QTRY_VERIFY(watch.isReady());
    QCOMPARE(pathsOf(watch), QStringList({QStringLiteral("ttyUSB0"), QStringLiteral("ttyUSB1"),
                                          QStringLiteral("ttyS0")}));
}

void TestPortWatcher::pluggingAndUnpluggingIsDetected()
{
    PortList portList;
    portList.plug(builtIn("/dev/ttyS0"));
    PortWatcher watch(nullptr, portList.lister());
    QSignalSpy spy(&watch, &PortWatcher::portsChanged);
    QTRY_COMPARE(spy.count(), 1); // the first look
    portList.plug(adapter("/dev/ttyUSB0", "A"));
    QTRY_COMPARE(watch.ports().size(), std::size_t(2));
    portList.unplug(QStringLiteral("/dev/ttyUSB0"));
    QTRY_COMPARE(watch.ports().size(), std::size_t(1));
    QCOMPARE(spy.count(), 3); // and not a time more: an equal list is no news
}

void TestPortWatcher::anAdapterIsKnownAtAnotherPath()
{
    PortList portList;
    portList.plug(adapter("/dev/ttyUSB0", "5A2F31"));
    portList.plug(adapter("/dev/ttyUSB1", "OTHER"));
    PortWatcher watch(nullptr, portList.lister());
    QTRY_VERIFY(watch.isReady());
    const QString key = watch.adapterKey(QStringLiteral("/dev/ttyUSB0"));
    QCOMPARE(watch.findAdapter(key), QStringLiteral("/dev/ttyUSB0"));
    portList.unplug(QStringLiteral("/dev/ttyUSB0"));
    QTRY_COMPARE(watch.findAdapter(key), QString());
    portList.plug(adapter("/dev/ttyUSB7", "5A2F31"));
    QTRY_COMPARE(watch.findAdapter(key), QStringLiteral("/dev/ttyUSB7"));
    QCOMPARE(watch.adapterKey(QStringLiteral("/dev/ttyUSB7")), key);
}

void TestPortWatcher::withoutSerialNumberTheOnlyMatchIsUsed()
{
    PortList portList;
    portList.plug(adapter("/dev/ttyUSB0", ""));
    PortWatcher watch(nullptr, portList.lister());
    QTRY_VERIFY(watch.isReady());
    const QString key = watch.adapterKey(QStringLiteral("/dev/ttyUSB0"));
    portList.plug(adapter("/dev/ttyUSB1", ""));
    portList.plug(adapter("/dev/ttyUSB2", "", 0x55d3)); // of another kind
    QTRY_COMPARE(watch.ports().size(), std::size_t(3));
    QCOMPARE(watch.findAdapter(key), QStringLiteral("/dev/ttyUSB0"));
    QVERIFY(watch.adapterKey(QStringLiteral("/dev/ttyUSB1")) != key);
    portList.unplug(QStringLiteral("/dev/ttyUSB0"));
    QTRY_COMPARE(watch.findAdapter(key), QStringLiteral("/dev/ttyUSB1"));
    portList.plug(adapter("/dev/ttyUSB5", ""));
    QTRY_COMPARE(watch.findAdapter(key), QString()); // which of the two nobody knows
}

void TestPortWatcher::otherPortsAreKnownByName()
{
    PortList portList;
    portList.plug(builtIn("/dev/ttyS0"));
    PortWatcher watch(nullptr, portList.lister());
    QTRY_VERIFY(watch.isReady());
    for (const char* name : {"/dev/ttyS0", "/dev/ttyUSB9", "tcp://bench:4000", "sim:demo"})
        QCOMPARE(watch.adapterKey(QString::fromLatin1(name)), QString::fromLatin1(name));
    QCOMPARE(watch.findAdapter(QStringLiteral("/dev/ttyS0")), QStringLiteral("/dev/ttyS0"));
    QCOMPARE(watch.findAdapter(QStringLiteral("sim:demo")), QString());
    QCOMPARE(watch.findAdapter(QString()), QString());
}

void TestPortWatcher::returnsAfterRemoval()
{
    PortList portList;
    const QString path = QStringLiteral("/dev/ttyUSB0");
    portList.plug(adapter("/dev/ttyUSB0", ""));
    PortWatcher watch(nullptr, portList.lister());
    QTRY_VERIFY(watch.isReady());
    session::ReplugWatcher replug;
    QVERIFY(!replug.isRunning());
    replug.start(watch, watch.adapterKey(path), path); // the list still shows it
    QCOMPARE(replug.detect(watch), QString());
    portList.unplug(path);
    QTRY_VERIFY(watch.ports().empty());
    QCOMPARE(replug.detect(watch), QString());
    portList.plug(adapter("/dev/ttyUSB1", ""));
    QTRY_COMPARE(replug.detect(watch), QStringLiteral("/dev/ttyUSB1"));
    replug.stop();
    QCOMPARE(replug.detect(watch), QString());
}

void TestPortWatcher::anotherOfItsTypeIsNoMatch()
{
    PortList portList;
    portList.plug(adapter("/dev/ttyUSB0", ""));
    portList.plug(adapter("/dev/ttyUSB1", ""));
    PortWatcher watch(nullptr, portList.lister());
    QTRY_VERIFY(watch.isReady());
    session::ReplugWatcher replug;
    const QString path = QStringLiteral("/dev/ttyUSB1");
    replug.start(watch, watch.adapterKey(path), path);
    portList.unplug(path);
    QTRY_COMPARE(watch.ports().size(), std::size_t(1));
    QCOMPARE(replug.detect(watch), QString()); // ttyUSB0 was there all the time
    portList.plug(adapter("/dev/ttyUSB1", ""));
    QTRY_COMPARE(replug.detect(watch), path);
}

void TestPortWatcher::backBeforeTheNextScan()
{
    PortList portList;
    const QString path = QStringLiteral("/dev/ttyUSB0");
    portList.plug(adapter("/dev/ttyUSB0", "A"));
    PortWatcher watch(nullptr, portList.lister());
    QTRY_VERIFY(watch.isReady());
    session::ReplugWatcher replug;
    replug.start(watch, watch.adapterKey(path), path);
    replug.forgetOldPath();
    QCOMPARE(replug.detect(watch), path);
}

void TestPortWatcher::theSystemsPortsAreListed()
{
    PortWatcher watch;
    QTRY_VERIFY(watch.isReady());
    for (const PortInfo& port : watch.ports())
        QVERIFY2(QFile::exists(port.path), qPrintable(port.path));
}

void TestPortWatcher::brailleServiceIsDetected_data()
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

void TestPortWatcher::brailleServiceIsDetected()
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
    QCOMPARE(transport::adaptersClaimedByBrltty(root.path()), taken);
}

void TestPortWatcher::latencyTimerIsRead()
{
    const QTemporaryDir root;
    const QString folder = root.filePath(QStringLiteral("sys/bus/usb-serial/devices/ttyUSB0"));
    QVERIFY(QDir().mkpath(folder));
    QFile timer(folder + QStringLiteral("/latency_timer"));
    QVERIFY(timer.open(QIODevice::WriteOnly));
    timer.write("16\n");
    timer.close();
    QCOMPARE(transport::latencyTimer(QStringLiteral("/dev/ttyUSB0"), root.path()),
             std::optional(16));
    QVERIFY(!transport::latencyTimer(QStringLiteral("/dev/ttyUSB1"), root.path()));
}

SERVODESK_GUILESS_TEST(TestPortWatcher)
#include "tst_port_watcher.moc"
