// SPDX-License-Identifier: GPL-3.0-or-later
// mbpoll, an independent Modbus master (libmodbus), against a simulated SMSMB servo on a
// pseudo-terminal: what it reads, what it can change, and how it is refused. Expected values are
// the factory settings of the vendor's table.
#include "support/cli_program.h"
#include "support/test_main.h"
#include "support/test_paths.h"

#include <QRegularExpression>
#include <QTemporaryDir>
#include <QTest>

using support::SimProgram;
using support::words;

namespace {
constexpr int timeoutMs = 60'000; ///< only a hung program ever needs it

struct MbpollResult {
    int exit = -1;
    QString out;
    QString err;
    std::map<int, int> registers; ///< what it printed, two's complement if it printed that too
};

QString settings(const QString& port, const char* arguments, int station)
{
    return QStringLiteral("-m rtu -b 115200 -P none -1 -0 -a %1 %2 %3")
        .arg(station)
        .arg(QString::fromLatin1(arguments), port);
}

/// `arguments` without those that name line, station and port; `values` are written.
MbpollResult mbpoll(const SimProgram& sim, const char* arguments, const QString& values = {},
                    int station = 1)
{
    QProcess process;
    process.start(
        QStringLiteral(MBPOLL),
        (settings(sim.port(), arguments, station) + u' ' + values).split(u' ', Qt::SkipEmptyParts));
    if (!process.waitForFinished(timeoutMs))
        return {};
    MbpollResult polled{process.exitCode(),
                        QString::fromLocal8Bit(process.readAllStandardOutput()),
                        QString::fromLocal8Bit(process.readAllStandardError()),
                        {}};
    static const QRegularExpression row(
        QStringLiteral("\\[(\\d+)\\]:\\s+(-?\\d+)(?: \\((-\\d+)\\))?"));
    for (auto rows = row.globalMatch(polled.out); rows.hasNext();) {
        const auto match = rows.next();
        polled.registers[match.captured(1).toInt()] =
            (match.captured(3).isEmpty() ? match.captured(2) : match.captured(3)).toInt();
    }
    return polled;
}

int registerOf(const SimProgram& sim, int number)
{
    const MbpollResult polled = mbpoll(sim, qPrintable(QStringLiteral("-t 4 -r %1").arg(number)));
    return polled.registers.count(number) != 0 ? polled.registers.at(number) : -1;
}

bool write(const SimProgram& sim, int number, const QString& values)
{
    return mbpoll(sim, qPrintable(QStringLiteral("-t 4 -r %1").arg(number)), values).exit == 0;
}
} // namespace

class TestMbpoll : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { QTest::failOnWarning(QRegularExpression(QStringLiteral(".*"))); }

    void readsIdentityAndSettings()
    {
        const SimProgram sim(words("--servos smsmb@1"));
        const MbpollResult identity = mbpoll(sim, "-t 4 -r 0 -c 4");
        QVERIFY2(identity.exit == 0, qPrintable(identity.err));
        QCOMPARE(identity.registers.size(), std::size_t(4));
        const MbpollResult settings = mbpoll(sim, "-t 4 -r 10 -c 7");
        QCOMPARE(settings.registers,
                 (std::map<int, int>{
                     {10, 1}, {11, 2}, {12, 500}, {13, 0}, {14, 4095}, {15, 0}, {16, 0}}));
    }

    void readsFeedback()
    {
        const SimProgram sim(words("--servos smsmb@1"));
        const MbpollResult feedback = mbpoll(sim, "-t 4 -r 256 -c 8");
        QCOMPARE(feedback.registers.size(), std::size_t(8));
        QVERIFY(qAbs(feedback.registers.at(257) - 2048) < 350);
        QVERIFY(qAbs(feedback.registers.at(258)) <= 1);
        QVERIFY(feedback.registers.at(260) > 50 && feedback.registers.at(260) < 260);
        QVERIFY(feedback.registers.at(261) > 10 && feedback.registers.at(261) < 60);
        QCOMPARE(feedback.registers.at(262), 0);
    }

    void reportsItsId()
    {
        const SimProgram sim(words("--servos smsmb@7"));
        const MbpollResult report = mbpoll(sim, "-u", {}, 7);
        QVERIFY2(report.exit == 0, qPrintable(report.err));
        QVERIFY2(report.out.contains(QRegularExpression(QStringLiteral("Id\\s*:\\s*0x07"))),
                 qPrintable(report.out));
    }

    void movesToItsGoal()
    {
        const SimProgram sim(words("--servos smsmb@1"));
        QVERIFY2(write(sim, 128, QStringLiteral("3000 1 10 50")), "position, torque, ramp, speed");
        QTRY_VERIFY(qAbs(registerOf(sim, 257) - 3000) < 8);
        QVERIFY(write(sim, 128, QStringLiteral("2500")));
        QCOMPARE(registerOf(sim, 128), 2500);
        QTRY_VERIFY(qAbs(registerOf(sim, 257) - 2500) < 8);
        QVERIFY(write(sim, 129, QStringLiteral("0")));
        QCOMPARE(registerOf(sim, 129), 0);
    }

    void theLockDecidesPersistence_data()
    {
        QTest::addColumn<int>("lock");
        QTest::addColumn<int>("afterPowerOff");
        QTest::newRow("open: kept") << 0 << 3000;
        QTest::newRow("closed: lost at power-off") << 1 << 4095;
    }

    void theLockDecidesPersistence()
    {
        QFETCH(const int, lock);
        QFETCH(const int, afterPowerOff);
        const QTemporaryDir folder;
        const QStringList arguments = words("--servos smsmb@1 --eprom-ms 0 --state")
                                      << folder.filePath(QStringLiteral("eprom"));
        {
            SimProgram sim(arguments);
            QCOMPARE(registerOf(sim, 133), 1);
            QVERIFY(write(sim, 133, QString::number(lock)));
            QVERIFY(write(sim, 14, QStringLiteral("3000")));
            QVERIFY(write(sim, 133, QStringLiteral("1")));
            QCOMPARE(registerOf(sim, 14), 3000);
            sim.end();
        }
        const SimProgram sim(arguments);
        QCOMPARE(registerOf(sim, 14), afterPowerOff);
    }

    void isRefusedByName_data()
    {
        QTest::addColumn<QString>("arguments");
        QTest::addColumn<QString>("values");
        QTest::addColumn<QString>("reason");
        const auto row = [](const char* name, const char* arguments, const char* values,
                            const char* reason) {
            QTest::newRow(name) << QString::fromLatin1(arguments) << QString::fromLatin1(values)
                                << QString::fromLatin1(reason);
        };
        row("read past the table", "-t 4 -r 500", "", "Illegal data address");
        row("read in a gap", "-t 4 -r 100", "", "Illegal data address");
        row("read over the end of a block", "-t 4 -r 262 -c 4", "", "Illegal data address");
        row("write of feedback", "-t 4 -r 257", "0", "Illegal data address");
        row("write past the table", "-t 4 -r 500", "1 2", "Illegal data address");
        row("station 0", "-t 4 -r 10", "0", "Illegal data value");
        row("station 300", "-t 4 -r 10", "300", "Illegal data value");
        row("unknown rate", "-t 4 -r 11", "99", "Illegal data value");
        row("unknown mode", "-t 4 -r 16", "77", "Illegal data value");
        row("one wrong value in a block", "-t 4 -r 10", "1 99", "Illegal data value");
        row("factory block, locked", "-t 4 -r 396", "120", "Illegal data address");
        row("coils", "-t 0 -r 0", "", "Illegal function");
        row("input registers", "-t 3 -r 0", "", "Illegal function");
    }

    void isRefusedByName()
    {
        QFETCH(const QString, arguments);
        QFETCH(const QString, values);
        QFETCH(const QString, reason);
        const SimProgram sim(words("--servos smsmb@1"));
        const MbpollResult refused = mbpoll(sim, qPrintable(arguments), values);
        QVERIFY(refused.exit != 0 || values.isEmpty());
        QVERIFY2(refused.err.contains(reason), qPrintable(refused.out + refused.err));
        QVERIFY2(registerOf(sim, 10) == 1, "and it goes on answering");
        QCOMPARE(registerOf(sim, 11), 2);
        QCOMPARE(registerOf(sim, 16), 0);
    }

    void theFactoryBlockOpensWith128()
    {
        const SimProgram sim(words("--servos smsmb@1"));
        QVERIFY(write(sim, 133, QStringLiteral("128")));
        QVERIFY(write(sim, 396, QStringLiteral("120")));
        QCOMPARE(registerOf(sim, 396), 120);
    }

    void anotherStationIsSilent()
    {
        const SimProgram sim(words("--servos smsmb@1"));
        const MbpollResult silent = mbpoll(sim, "-t 4 -r 10 -o 0.1", {}, 2);
        QVERIFY2(silent.err.contains(QStringLiteral("timed out")), qPrintable(silent.err));
        QCOMPARE(registerOf(sim, 10), 1);
    }
};

SERVODESK_GUILESS_TEST(TestMbpoll)
#include "tst_mbpoll.moc"
