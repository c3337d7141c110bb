// SPDX-License-Identifier: GPL-3.0-or-later
// The writes that LeRobot issues to the six servos of an SO arm at set-up, calibration and
// configuration (huggingface/lerobot, snapshot of 23 Aug 2026: motors/feetech/feetech.py,
// motors/motors_bus.py, robots/so_follower/so_follower.py), as raw frames on the terminal of
// servodesk-sim, back to back: the next one leaves when the last one's status packet is there.
// Nothing of our own protocol code is used here.
#include "integration/raw_client.h"
#include "support/feetech_bytes.h"
#include "support/test_main.h"

#include <QRegularExpression>
#include <QTemporaryDir>
#include <QTest>

#include <map>

using raw::Client;
using raw::Simulator;
using support::feetechFrame;

namespace {
constexpr int timeout = 60; ///< ms, for each status packet
constexpr int servos = 6;
constexpr int gripper = 6;

enum Address : int {
    ModelNumber = 3,
    Id = 5,
    BaudRate = 6,
    ReturnDelay = 7,
    MinLimit = 9,
    MaxLimit = 11,
    MaxTorque = 16,
    Phase = 18,
    CoefficientP = 21,
    CoefficientD = 22,
    CoefficientI = 23,
    ProtectionCurrent = 28,
    HomingOffset = 31,
    OperatingMode = 33,
    OverloadTorque = 36,
    TorqueEnable = 40,
    Acceleration = 41,
    Lock = 55,
    PresentPosition = 56,
    MaximumAcceleration = 85,
};

QByteArray numbers(int value, int size)
{
    QByteArray bytes(1, char(value));
    if (size == 2)
        bytes.append(char(value >> 8));
    return bytes;
}

/// Sign and magnitude with bit 11, as LeRobot encodes Homing_Offset.
int withSignBit(int offset)
{
    return offset < 0 ? 0x800 | -offset : offset;
}

/// What a client of LeRobot's kind knows and counts.
class LeRobotClient {
public:
    explicit LeRobotClient(const QString& port)
        : m_client(port)
    {}

    int written() const { return m_written; }
    int lost() const { return m_lost; } ///< requests without their status packet
    int late() const { return m_late; } ///< requests whose reply took longer than the timeout
    const std::map<std::pair<int, int>, QByteArray>& last() const { return m_last; }

    void write(int id, int address, int value, int size = 1)
    {
        const QByteArray data = numbers(value, size);
        ++m_written;
        m_last[{id, address}] = data;
        exchanged(id, feetechFrame(id, 3, char(address) + data), 0);
    }
    void writeAll(int address, int value, int size = 1)
    {
        for (int id = 1; id <= servos; ++id)
            write(id, address, value, size);
    }
    QByteArray read(int id, int address, int size)
    {
        const QByteArray reply =
            exchanged(id, feetechFrame(id, 2, numbers(address, 1) + char(size)), size);
        return reply.isNull() ? reply : reply.mid(5, size);
    }
    int word(int id, int address)
    {
        const QByteArray bytes = read(id, address, 2);
        return bytes.isNull() ? -1
                              : static_cast<unsigned char>(bytes[0]) |
                                    static_cast<unsigned char>(bytes[1]) << 8;
    }
    /// LeRobot's search for the one servo on the bus.
    int broadcastPing()
    {
        m_client.send(feetechFrame(0xFE, 1, {}));
        const QByteArray reply = m_client.receive(6);
        return reply.size() == 6 ? static_cast<unsigned char>(reply[2]) : -1;
    }
    QByteArray syncRead(int address, int size)
    {
        QByteArray params = numbers(address, 1) + char(size);
        for (int id = 1; id <= servos; ++id)
            params.append(char(id));
        m_client.send(feetechFrame(0xFE, 0x82, params));
        return m_client.receive(servos * (6 + size));
    }
    void disableTorque(int id)
    {
        write(id, TorqueEnable, 0);
        write(id, Lock, 0);
    }

private:
    /// The status packet of this ID; null: none came, or not this one. A machine that is busy with
    /// other things may take longer than a servo would: that is counted as late, not as lost.
    QByteArray exchanged(int id, const QByteArray& request, int dataBytes)
    {
        m_client.send(request);
        if (!m_client.readable(timeout)) {
            ++m_late;
            if (!m_client.readable(10 * timeout)) {
                ++m_lost;
                return {};
            }
        }
        const QByteArray reply = m_client.receive(6 + dataBytes);
        const bool fits = reply.size() == 6 + dataBytes &&
                          reply == feetechFrame(id, reply[4], reply.mid(5, dataBytes));
        m_lost += fits ? 0 : 1;
        return fits ? reply : QByteArray();
    }

    Client m_client;
    int m_written = 0;
    int m_lost = 0;
    int m_late = 0;
    std::map<std::pair<int, int>, QByteArray> m_last;
};

/// setup_motor() of a servo as it comes out of its box.
void setUp(LeRobotClient& arm, int target)
{
    const int found = arm.broadcastPing();
    arm.read(found, ModelNumber, 2);
    arm.disableTorque(found);
    arm.write(found, Id, target);
    arm.write(target, BaudRate, 0);
}

/// disable_torque(), set_half_turn_homings() and write_calibration(), the range as if the user had
/// moved every joint.
void calibrate(LeRobotClient& arm)
{
    for (int id = 1; id <= servos; ++id)
        arm.disableTorque(id);
    arm.writeAll(OperatingMode, 0);
    for (int id = 1; id <= servos; ++id) {
        arm.write(id, HomingOffset, 0, 2);
        arm.write(id, MinLimit, 0, 2);
        arm.write(id, MaxLimit, 4095, 2);
    }
    arm.syncRead(PresentPosition, 2);
    std::map<int, int> offsets;
    for (int id = 1; id <= servos; ++id) {
        offsets[id] = arm.word(id, PresentPosition) - 2047 + 10 * (id - 3);
        arm.write(id, HomingOffset, withSignBit(offsets[id]), 2);
    }
    arm.syncRead(PresentPosition, 2);
    for (int id = 1; id <= servos; ++id) {
        arm.write(id, HomingOffset, withSignBit(offsets[id]), 2);
        arm.write(id, MinLimit, 800 + id, 2);
        arm.write(id, MaxLimit, 3200 + id, 2);
    }
}

/// configure(): with torque disabled, and torque enabled again at its end.
void configure(LeRobotClient& arm)
{
    for (int id = 1; id <= servos; ++id)
        arm.disableTorque(id);
    for (int id = 1; id <= servos; ++id) {
        arm.write(id, ReturnDelay, 0);
        arm.write(id, MaximumAcceleration, 254);
        arm.write(id, Acceleration, 254);
        const QByteArray phase = arm.read(id, Phase, 1); // none: counted as lost
        arm.write(id, Phase, phase.isNull() ? 0 : phase[0] & ~0x10);
    }
    for (int id = 1; id <= servos; ++id) {
        arm.write(id, OperatingMode, 0);
        arm.write(id, CoefficientP, 16);
        arm.write(id, CoefficientI, 0);
        arm.write(id, CoefficientD, 32);
    }
    arm.write(gripper, MaxTorque, 500, 2);
    arm.write(gripper, ProtectionCurrent, 250, 2);
    arm.write(gripper, OverloadTorque, 25);
    for (int id = 1; id <= servos; ++id) {
        arm.write(id, TorqueEnable, 1);
        arm.write(id, Lock, 1);
    }
}

QStringList clientFor(const QString& words, const QString& state)
{
    QStringList list;
    for (int id = 1; id <= servos; ++id)
        list << QStringLiteral("sts3215@%1%2").arg(id).arg(words);
    return {QStringLiteral("--servos"), list.join(u','), QStringLiteral("--state"), state};
}

/// How many registers do not hold what was written to them last.
int wrong(LeRobotClient& arm, const LeRobotClient& writer, bool afterPowerUp)
{
    int count = 0;
    for (const auto& [place, data] : writer.last()) {
        const auto [id, address] = place;
        const bool kept = address < TorqueEnable; // 85: not stated
        if (!afterPowerUp || kept)
            count += arm.read(id, address, int(data.size())) == data ? 0 : 1;
    }
    return count;
}
} // namespace

class TestLerobotWrites : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { QTest::failOnWarning(QRegularExpression(QStringLiteral(".*"))); }

    void setUpOneByOne()
    {
        for (int target = servos; target >= 1; --target) {
            const Simulator simulator({QStringLiteral("--servos"), QStringLiteral("sts3215@1")});
            LeRobotClient arm(simulator.port());
            setUp(arm, target);
            QCOMPARE(arm.lost(), 0);
            QCOMPARE(arm.broadcastPing(), target);
            QCOMPARE(arm.read(target, BaudRate, 1), QByteArray(1, 0));
        }
    }

    void nothingIsLost()
    {
        const QTemporaryDir folder;
        const QStringList arguments = clientFor({}, folder.filePath(QStringLiteral("arm")));
        std::map<int, int> positions;
        Simulator simulator(arguments);
        LeRobotClient arm(simulator.port());
        calibrate(arm);
        for (int id = 1; id <= servos; ++id)
            positions[id] = arm.word(id, PresentPosition);
        configure(arm);
        QCOMPARE(arm.lost(), 0);
        // The machine may be busy with other things now and then; the servos never are for so long.
        QVERIFY2(arm.late() * 5 < arm.written(), qPrintable(QString::number(arm.late())));
        QCOMPARE(arm.written(), 6 * (2 + 1 + 3 + 1 + 3) + 6 * (2 + 4 + 4) + 3 + 6 * 2);
        QCOMPARE(wrong(arm, arm, false), 0);
        for (int id = 1; id <= servos; ++id) {
            // Torque is on and no goal was ever written: the arm stays where it is.
            QVERIFY(std::abs(arm.word(id, PresentPosition) - positions[id]) <= 8);
            QCOMPARE(arm.read(id, TorqueEnable, 1), QByteArray(1, 1));
        }
        QCOMPARE(simulator.end(), 0);
        const Simulator again(arguments);
        LeRobotClient next(again.port());
        QCOMPARE(wrong(next, arm, true), 0);
        configure(next);
        for (int id = 1; id <= servos; ++id)
            QVERIFY(std::abs(next.word(id, PresentPosition) - positions[id]) <= 8);
        QCOMPARE(next.lost(), 0);
    }

    // The same client does notice a servo that is deaf while it writes its EPROM.
    void aBusyServoWouldLoseThem()
    {
        const QTemporaryDir folder;
        const Simulator simulator(clientFor(QStringLiteral("+deaf=1+eprom-ms=400"),
                                            folder.filePath(QStringLiteral("arm"))));
        LeRobotClient arm(simulator.port());
        arm.disableTorque(1);
        arm.write(1, MinLimit, 100, 2);
        arm.write(1, MaxLimit, 3000, 2);
        QVERIFY(arm.lost() > 0 || wrong(arm, arm, false) > 0);
    }
};

SERVODESK_GUILESS_TEST(TestLerobotWrites)
#include "tst_lerobot_writes.moc"
