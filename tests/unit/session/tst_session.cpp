// SPDX-License-Identifier: GPL-3.0-or-later
// The composition root: ports by name, the simulated bus behind them, and where things are kept.
#include "device/motion/stop_frames.h"
#include "device/writer.h"
#include "session/paths.h"
#include "session/session.h"
#include "support/test_main.h"

#include <QDir>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QTest>

using base::ErrorCode;
using session::PortRequest;
using session::Session;

class TestSession : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init();

    void dataFolderCanBeMoved();
    void refusesPortsItCannotOpen_data();
    void refusesPortsItCannotOpen();
    void opensSimulatedServos_data();
    void opensSimulatedServos();
    void retriesAndTimeoutReachTheBus();
    void powerCycleKeepsTheEprom();
    void stopFramesCoverBroadcastAndEachServo();
    void emergencyTakesTorqueOff();

private:
    QTemporaryDir m_folder;
};

namespace {
/// A connection and what a job needs on it.
struct ConnectionFixture {
    Session session;
    std::unique_ptr<session::Connection> connection;
    base::StopToken stop;
    device::Notices notices;

    explicit ConnectionFixture(const char* port)
    {
        PortRequest request;
        request.name = QString::fromLatin1(port);
        auto opened = session.connect(request);
        if (opened)
            connection = std::move(*opened);
    }
    device::Context context() { return connection->context(stop, notices); }
};
} // namespace

void TestSession::init()
{
    QTest::failOnWarning(QRegularExpression(QStringLiteral(".*")));
    qputenv("SERVODESK_DATA_DIR", m_folder.path().toLocal8Bit());
}

void TestSession::dataFolderCanBeMoved()
{
    QCOMPARE(session::dataFolder(), m_folder.path());
    Session session;
    QCOMPARE(session.journal().path(), m_folder.filePath(QStringLiteral("history.sqlite")));
    QVERIFY(session.warnings().empty());
}

void TestSession::refusesPortsItCannotOpen_data()
{
    QTest::addColumn<QString>("port");
    QTest::addColumn<int>("code");
    QTest::newRow("no such device")
        << QStringLiteral("/dev/ttyNOWHERE7") << int(ErrorCode::PortMissing);
    QTest::newRow("no such preset") << QStringLiteral("sim:nothing") << int(ErrorCode::BadArgument);
    QTest::newRow("no such model")
        << QStringLiteral("sim:toaster@1") << int(ErrorCode::BadArgument);
    QTest::newRow("no port number")
        << QStringLiteral("tcp://localhost") << int(ErrorCode::BadArgument);
    QTest::newRow("empty") << QString() << int(ErrorCode::BadArgument);
}

void TestSession::refusesPortsItCannotOpen()
{
    QFETCH(QString, port);
    QFETCH(int, code);
    Session session;
    PortRequest request;
    request.name = port;
    const auto connection = session.connect(request);
    QVERIFY(!connection.has_value());
    QCOMPARE(int(connection.error().code), code);
}

void TestSession::opensSimulatedServos_data()
{
    QTest::addColumn<QByteArray>("port");
    QTest::addColumn<int>("id");
    QTest::addColumn<QString>("model");
    QTest::newRow("preset") << QByteArray("sim:demo") << 3 << QStringLiteral("STS3250");
    QTest::newRow("list") << QByteArray("sim:sts3215@1,scs15@9") << 9 << QStringLiteral("SCS15");
}

void TestSession::opensSimulatedServos()
{
    QFETCH(QByteArray, port);
    QFETCH(int, id);
    QFETCH(QString, model);
    ConnectionFixture fixture(port.constData());
    QVERIFY(fixture.connection != nullptr);
    QVERIFY(fixture.connection->isSimulated());
    const auto servo = device::identify(fixture.context(), id);
    QVERIFY(servo.has_value());
    QCOMPARE(servo->profile->modelName, model);
    QCOMPARE(servo->port, QString::fromLatin1(port));
}

void TestSession::retriesAndTimeoutReachTheBus()
{
    Session session;
    PortRequest request;
    request.name = QStringLiteral("sim:sts3215@1");
    request.retries = 4;
    request.maxReplyLateness = std::chrono::milliseconds(2);
    const auto connection = session.connect(request);
    QVERIFY(connection.has_value());
    base::StopToken stop;
    device::Notices notices;
    const auto servo = device::identify((*connection)->context(stop, notices), 50);
    QVERIFY(!servo.has_value());
    QCOMPARE(servo.error().attempts, 5);
}

void TestSession::powerCycleKeepsTheEprom()
{
    ConnectionFixture fixture("sim:sts3215@1");
    const device::Context context = fixture.context();
    auto servo = device::identify(context, 1);
    QVERIFY(servo.has_value());
    QVERIFY(device::write(context, *servo, {{QStringLiteral("max_temperature"), 61}}, {}));
    QVERIFY(fixture.connection->powerCycle());
    auto again = device::identify(context, 1);
    QVERIFY(again.has_value());
    QVERIFY(device::readAll(context, *again).has_value());
    QCOMPARE(again->raw(QStringLiteral("max_temperature")), std::optional<std::int64_t>(61));
    QCOMPARE(again->raw(QStringLiteral("lock")), std::optional<std::int64_t>(1));
}

void TestSession::stopFramesCoverBroadcastAndEachServo()
{
    device::Servo servo;
    servo.id = 1;
    const auto frames = device::stopFrames({base::Protocol::Feetech}, {servo});
    QCOMPARE(frames.size(), std::size_t(2));
    // Write 0 to address 40: checksum is the low byte of NOT(ID + 4 + 3 + 40 + 0).
    QCOMPARE(base::toHex(frames[0].bytes), QStringLiteral("FF FF FE 04 03 28 00 D2"));
    QCOMPARE(base::toHex(frames[1].bytes), QStringLiteral("FF FF 01 04 03 28 00 CF"));
}

void TestSession::emergencyTakesTorqueOff()
{
    ConnectionFixture fixture("sim:sts3215@1,sts3215@2");
    const device::Context context = fixture.context();
    auto servo = device::identify(context, 1);
    QVERIFY(servo.has_value());
    fixture.connection->addStopTarget(*servo);
    bus::Transaction on;
    on.request = protocol::Request::write(2, 40, {1}, protocol::Repeat::Safe);
    QVERIFY(context.bus.transact(on).has_value());
    context.bus.emergency();
    auto other = device::identify(context, 2);
    if (!other) // the stop may have cut this very request off
        other = device::identify(context, 2);
    QVERIFY(other.has_value());
    QVERIFY(device::readAll(context, *other).has_value());
    QCOMPARE(other->raw(QStringLiteral("torque_switch")), std::optional<std::int64_t>(0));
}

SERVODESK_GUILESS_TEST(TestSession)
#include "tst_session.moc"
