// SPDX-License-Identifier: GPL-3.0-or-later
// servodesk-cli against a Modbus slave of libmodbus on a pseudo-terminal: nothing of our simulator
// or protocol code answers here. The slave is a plain table; what it was asked to write is kept.
#include "support/cli_program.h"
#include "support/test_main.h"
#include "unit/transport/pty_pair.h"

#include <QJsonArray>
#include <QRegularExpression>
#include <QTest>

#include <map>
#include <memory>
#include <modbus/modbus.h>
#include <mutex>
#include <poll.h>
#include <termios.h>
#include <thread>

using support::CliProgram;
using support::ProgramResult;
using support::words;

namespace {
constexpr int registers = 407;
constexpr int maxAngleLimit = 14;
constexpr int goalPosition = 128;
constexpr int lockRegister = 133;
constexpr int station = 5;

struct WrittenRegister {
    int number = 0;
    int lock = 0; ///< at that time
};

class Slave {
public:
    Slave()
        : m_table(modbus_mapping_new(0, 0, registers, 0))
        , m_far(open(qPrintable(m_terminal.path), O_RDWR | O_NOCTTY | O_CLOEXEC))
    {
        // Held open, so that the terminal stays as it is between two programs.
        termios settings{};
        tcgetattr(m_far, &settings);
        cfmakeraw(&settings);
        tcsetattr(m_far, TCSANOW, &settings);
        const std::map<int, int> content{{0, 3},
                                         {1, 1},
                                         {2, 2022},
                                         {3, 617},
                                         {10, station},
                                         {11, 2},
                                         {12, 500},
                                         {maxAngleLimit, 4095},
                                         {lockRegister, 1},
                                         {goalPosition, 2048},
                                         {257, 0xFFF6},
                                         {260, 121},
                                         {261, 33}};
        for (const auto& [number, value] : content)
            m_table->tab_registers[number] = std::uint16_t(value);
        m_thread = std::jthread([this](const std::stop_token& stop) { serve(stop); });
    }
    ~Slave()
    {
        m_thread.request_stop();
        m_thread.join();
        close(m_far);
        modbus_mapping_free(m_table);
    }
    Slave(const Slave&) = delete;
    Slave& operator=(const Slave&) = delete;

    QString port() const { return m_terminal.path; }
    int value(int number)
    {
        const std::lock_guard lock(m_mutex);
        return m_table->tab_registers[number];
    }
    void set(int number, int value)
    {
        const std::lock_guard lock(m_mutex);
        m_table->tab_registers[number] = std::uint16_t(value);
    }
    std::vector<WrittenRegister> written()
    {
        const std::lock_guard lock(m_mutex);
        return m_written;
    }
    /// The table ends before this register.
    void cutAt(int number)
    {
        const std::lock_guard lock(m_mutex);
        m_table->nb_registers = number;
    }

private:
    using Modbus = std::unique_ptr<modbus_t, decltype(&modbus_free)>;
    Modbus listener() const
    {
        Modbus modbus(modbus_new_rtu("/dev/null", 115'200, 'N', 8, 1), &modbus_free);
        modbus_set_slave(modbus.get(), station);
        modbus_set_socket(modbus.get(), m_terminal.master);
        modbus_set_indication_timeout(modbus.get(), 0, 50'000);
        return modbus;
    }

    void serve(const std::stop_token& stop)
    {
        std::uint8_t query[MODBUS_RTU_MAX_ADU_LENGTH];
        Modbus modbus = listener();
        while (!stop.stop_requested()) {
            const int size = modbus_receive(modbus.get(), query);
            // After a request to another station the library takes what comes next for that
            // station's reply; here nobody else is on the line.
            if (size == 0)
                modbus = listener();
            if (size <= 0)
                continue;
            const std::lock_guard lock(m_mutex);
            if (query[1] == MODBUS_FC_WRITE_SINGLE_REGISTER ||
                query[1] == MODBUS_FC_WRITE_MULTIPLE_REGISTERS)
                m_written.push_back(
                    {256 * query[2] + query[3], m_table->tab_registers[lockRegister]});
            modbus_reply(modbus.get(), query, size, m_table);
        }
    }

    PtyPair m_terminal;
    modbus_mapping_t* m_table;
    int m_far;
    std::mutex m_mutex; ///< guards the table and what follows
    std::vector<WrittenRegister> m_written;
    std::jthread m_thread;
};

struct Fixture {
    Slave slave;
    CliProgram cli;

    Fixture() { cli.setPort(slave.port()); }

    ProgramResult run(const QString& line)
    {
        return cli.run(words("--protocol modbus --baud 115200") << line.split(u' '));
    }
    ProgramResult json(const QString& line) { return run(line + QStringLiteral(" --json")); }
};
} // namespace

class TestLibmodbus : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { QTest::failOnWarning(QRegularExpression(QStringLiteral(".*"))); }

    void isFound()
    {
        Fixture fixture;
        const auto result = fixture.json(QStringLiteral("scan --ids 1-20"));
        QVERIFY2(result.exit == 0, qPrintable(result.err));
        const QJsonArray found = result.json()[QLatin1String("found")].toArray();
        QCOMPARE(found.size(), 1);
        QCOMPARE(found[0][QLatin1String("id")].toInt(), station);
        QCOMPARE(found[0][QLatin1String("protocol")].toString(), QStringLiteral("modbus"));
        QVERIFY2(fixture.slave.written().empty(), "a search writes nothing");
    }

    void isRead()
    {
        Fixture fixture;
        const auto result =
            fixture.run(QStringLiteral("read 5 present_position present_voltage max_angle_limit"));
        QVERIFY2(result.exit == 0, qPrintable(result.err));
        for (const char* value : {"-10", "12.1", "4095"})
            QVERIFY2(result.out.contains(QLatin1String(value)), qPrintable(result.out));
    }

    void isWritten_data()
    {
        QTest::addColumn<int>("maxAngle");
        QTest::addColumn<QString>("goal");
        QTest::addColumn<int>("word");
        QTest::newRow("within the turn") << 4095 << QStringLiteral("1000") << 1000;
        QTest::newRow("multi-turn, two's complement")
            << 0 << QStringLiteral("-300") << 0x10000 - 300;
    }

    void isWritten()
    {
        QFETCH(const int, maxAngle);
        QFETCH(const QString, goal);
        QFETCH(const int, word);
        Fixture fixture;
        fixture.slave.set(maxAngleLimit, maxAngle);
        const auto result = fixture.run(QStringLiteral("write 5 goal_position=") + goal);
        QVERIFY2(result.exit == 0, qPrintable(result.err));
        QCOMPARE(fixture.slave.value(goalPosition), word);
        QCOMPARE(fixture.slave.written().size(), std::size_t(1));
    }

    void anEpromRegisterIsWrittenWithTheLockOpen()
    {
        Fixture fixture;
        const auto result = fixture.run(QStringLiteral("write 5 max_angle_limit=3000"));
        QVERIFY2(result.exit == 0, qPrintable(result.err));
        QCOMPARE(fixture.slave.value(maxAngleLimit), 3000);
        QCOMPARE(fixture.slave.value(lockRegister), 1);
        int limits = 0;
        for (const WrittenRegister& write : fixture.slave.written()) {
            if (write.number != lockRegister) {
                QCOMPARE(write.number, maxAngleLimit);
                QCOMPARE(write.lock, 0);
                ++limits;
            }
        }
        QCOMPARE(limits, 1);
    }

    void refusalIsReportedByName()
    {
        Fixture fixture;
        fixture.slave.cutAt(384);
        const auto result = fixture.json(QStringLiteral("read 5 max_temperature"));
        QVERIFY(result.exit != 0);
        QVERIFY2(result.out.contains(QLatin1String("refused")),
                 qPrintable(result.out + result.err));
        QVERIFY2(result.out.contains(QLatin1String("exception 2")),
                 qPrintable(result.out + result.err));
    }

    // Stations 248 to 255 are reserved, also for finding out whether the adapter echoes.
    void noReservedStationIsAddressed()
    {
        const PtyPair line;
        QByteArray received;
        std::jthread reader([&](const std::stop_token& stop) {
            while (!stop.stop_requested()) {
                char chunk[512];
                pollfd state{line.master, POLLIN, 0};
                const ssize_t got =
                    poll(&state, 1, 20) > 0 ? read(line.master, chunk, sizeof chunk) : 0;
                received.append(chunk, std::max<ssize_t>(got, 0));
            }
        });
        CliProgram cli;
        cli.setPort(line.path);
        const ProgramResult result = cli.run(words("--protocol modbus --baud 115200 read 5 lock"));
        reader.request_stop();
        reader.join();
        QVERIFY(result.exit != 0); // nobody is there
        constexpr qsizetype readFrame = 8;
        QVERIFY(received.size() > readFrame && received.size() % readFrame == 0);
        for (qsizetype at = 0; at < received.size(); at += readFrame) {
            const int addressed = static_cast<unsigned char>(received[at]);
            QVERIFY2(addressed == 0 || addressed == station, received.mid(at, readFrame).toHex());
        }
    }

    void anotherStationIsSilent()
    {
        Fixture fixture;
        const auto result = fixture.json(QStringLiteral("read 6 present_position"));
        QVERIFY(result.exit != 0);
        QVERIFY2(result.out.contains(QLatin1String("no-answer")),
                 qPrintable(result.out + result.err));
    }
};

SERVODESK_GUILESS_TEST(TestLibmodbus)
#include "tst_libmodbus.moc"
