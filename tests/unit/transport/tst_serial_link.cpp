// SPDX-License-Identifier: GPL-3.0-or-later
// The serial link against a real kernel terminal: a pseudo-terminal whose far end the test holds.
#include "base/clock.h"
#include "support/test_main.h"
#include "transport/port_lease.h"
#include "transport/port_opener.h"
#include "transport/serial_link.h"

#include <QFile>
#include <QFileInfo>
#include <QProcess>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QTest>

#include "pty_pair.h"
#include <asm/ioctls.h>
#include <asm/termbits.h>
#include <atomic>
#include <sys/file.h>
#include <sys/ioctl.h>
#include <thread>

using namespace std::chrono_literals;
using base::ErrorCode;
using transport::Parity;

class TestSerialLink : public QObject {
    Q_OBJECT

    base::SystemClock m_clock;

    auto open(const QString& name, int baud = 1'000'000, Parity parity = Parity::None)
    {
        return transport::openPort({name, baud, parity}, m_clock);
    }

    static base::Bytes readAll(transport::Link& link, std::size_t count)
    {
        base::Bytes all;
        while (all.size() < count && link.waitForReadyRead(5s).value_or(false) && link.read(all)) {
        }
        return all;
    }

private Q_SLOTS:
    void init() { QTest::failOnWarning(QRegularExpression(QStringLiteral(".*"))); }

    void carriesEveryByteBothWays()
    {
        PtyPair pty;
        auto link = open(pty.path);
        QVERIFY(link);
        base::Bytes all(256);
        for (std::size_t i = 0; i < all.size(); ++i)
            all[i] = static_cast<std::uint8_t>(i);
        const std::string text(all.begin(), all.end());
        QVERIFY((*link)->write(all));
        QCOMPARE(pty.receive(256), text);
        pty.send(text);
        QCOMPARE(readAll(**link, 256), all);
    }

    /// It opened the port before, without locking it: answers are missing, but the adapter is
    /// there.
    void aSecondReaderLosesNothing()
    {
        PtyPair pty;
        auto link = open(pty.path);
        QVERIFY(link);
        const int other = ::open(qPrintable(pty.path), O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC);
        QVERIFY(other >= 0);
        std::atomic<bool> ended = false;
        std::thread secondReader([&] {
            char chunk[64];
            while (!ended)
                (void)!::read(other, chunk, sizeof chunk);
        });
        base::Bytes all;
        bool lost = false;
        for (int i = 0; i < 5000 && !lost; ++i) {
            pty.send("\x02");
            lost = !(*link)->waitForReadyRead(0us) || !(*link)->read(all);
        }
        ended = true;
        secondReader.join();
        ::close(other);
        QVERIFY(!lost);
        pty.send("\x03");
        QVERIFY((*link)->waitForReadyRead(5s).value());
        pty.dropConnection();
        QTRY_VERIFY(!(*link)->read(all));
    }

    void readAppends()
    {
        PtyPair pty;
        auto link = open(pty.path);
        QVERIFY(link);
        pty.send("\x02");
        QVERIFY((*link)->waitForReadyRead(5s).value());
        base::Bytes buffer{1};
        QCOMPARE((*link)->read(buffer).value(), std::size_t{1});
        QCOMPARE(buffer, (base::Bytes{1, 2}));
        QCOMPARE((*link)->read(buffer).value(), std::size_t{0});
        QVERIFY(!(*link)->waitForReadyRead(0us).value());
        QVERIFY(!(*link)->waitForReadyRead(1500us).value());
    }

    void opensAtEveryKnownRate_data()
    {
        QTest::addColumn<int>("rate");
        for (const int rate : transport::standardBaudRates())
            QTest::addRow("%d", rate) << rate;
    }
    void opensAtEveryKnownRate()
    {
        QFETCH(int, rate);
        PtyPair pty;
        auto link = open(pty.path, rate);
        QVERIFY(link);
        QCOMPARE((*link)->baud(), rate);
        QCOMPARE(terminalRate(pty), rate);
        QVERIFY((*link)->canSetBaud());
    }

    void changesTheRate()
    {
        PtyPair pty;
        auto link = open(pty.path, 115'200);
        QVERIFY(link);
        for (const int rate : transport::standardBaudRates()) {
            QVERIFY((*link)->setBaud(rate));
            QCOMPARE(terminalRate(pty), rate);
        }
    }

    void refusesAnInvalidRate_data()
    {
        QTest::addColumn<int>("rate");
        QTest::newRow("zero") << 0;
        QTest::newRow("negative") << -9600;
    }
    void refusesAnInvalidRate()
    {
        QFETCH(int, rate);
        PtyPair pty;
        auto link = open(pty.path, 57'600);
        QVERIFY(link);
        const auto set = (*link)->setBaud(rate);
        QVERIFY(!set);
        QCOMPARE(set.error().code, ErrorCode::RateUnsupported);
        QCOMPARE((*link)->baud(), 57'600);
        QCOMPARE(terminalRate(pty), 57'600);
        pty.send("x");
        QCOMPARE(readAll(**link, 1).size(), std::size_t{1});
    }

    void opensWithParity()
    {
        PtyPair pty;
        for (const Parity parity : {Parity::None, Parity::Even, Parity::Odd})
            QVERIFY(open(pty.path, 115'200, parity));
    }

    void isBusyForASecondUser_data()
    {
        QTest::addColumn<bool>("throughLink");
        QTest::newRow("same name") << false;
        QTest::newRow("symbolic link") << true;
    }
    void isBusyForASecondUser()
    {
        QFETCH(bool, throughLink);
        PtyPair pty;
        QTemporaryDir folder;
        const QString alias = folder.filePath(QStringLiteral("servo"));
        QVERIFY(QFile::link(pty.path, alias));
        auto first = open(pty.path);
        QVERIFY(first);
        const auto second = open(throughLink ? alias : pty.path);
        QVERIFY(!second);
        QCOMPARE(second.error().code, ErrorCode::PortBusy);
        QVERIFY(
            second.error().detail.contains(QString::number(QCoreApplication::applicationPid())));
        first->reset();
        QVERIFY(open(alias));
    }

    void namesTheOtherProgramThatHoldsThePort()
    {
        PtyPair pty;
        QProcess other;
        other.setStandardInputFile(pty.path);
        other.start(QStringLiteral("sleep"), {QStringLiteral("1000")});
        QVERIFY(other.waitForStarted());
        const int slave = ::open(qPrintable(pty.path), O_RDWR | O_NOCTTY | O_CLOEXEC);
        QVERIFY(slave >= 0);
        QCOMPARE(flock(slave, LOCK_EX), 0);
        const auto link = open(pty.path);
        QVERIFY(!link);
        QCOMPARE(link.error().code, ErrorCode::PortBusy);
        QVERIFY2(link.error().detail.contains(QString::number(other.processId())),
                 qPrintable(link.error().detail));
        close(slave);
        other.kill();
        QVERIFY(other.waitForFinished());
        QVERIFY(open(pty.path));
    }

    void locksOutProgramsThatUseFlock()
    {
        PtyPair pty;
        auto link = open(pty.path);
        QVERIFY(link);
        QProcess other;
        other.start(QStringLiteral("flock"),
                    {QStringLiteral("--nonblock"), pty.path, QStringLiteral("true")});
        QVERIFY(other.waitForFinished());
        QVERIFY(other.exitCode() != 0);
    }

    void reportsAMissingPort()
    {
        const auto link = open(QStringLiteral("/dev/ttyNoSuchPort"));
        QVERIFY(!link);
        QCOMPARE(link.error().code, ErrorCode::PortMissing);
        QVERIFY(link.error().detail.contains(QStringLiteral("ttyNoSuchPort")));
    }

    void refusesAFileThatIsNoPort()
    {
        QTemporaryDir folder;
        QFile file(folder.filePath(QStringLiteral("text")));
        QVERIFY(file.open(QIODevice::WriteOnly));
        const auto link = open(file.fileName());
        QVERIFY(!link);
        QCOMPARE(link.error().code, ErrorCode::PortFailed);
        QVERIFY(!link.error().detail.isEmpty());
    }

    // A superuser may open everything, so the refusal itself cannot be provoked everywhere.
    void namesTheGroupThatMayOpenThePort()
    {
        PtyPair pty;
        const auto error = transport::accessDeniedError(pty.path, false);
        QCOMPARE(error.code, ErrorCode::PortPermission);
        QCOMPARE(error.detail, QFileInfo(pty.path).group());
        QVERIFY(!error.detail.isEmpty());
        QCOMPARE(transport::accessDeniedError(pty.path, true).code, ErrorCode::PortBusy);
    }

    void detectsTheHangUp_data()
    {
        QTest::addColumn<bool>("byWriting");
        QTest::newRow("looking") << false;
        QTest::newRow("writing") << true;
    }
    void detectsTheHangUp()
    {
        QFETCH(bool, byWriting);
        PtyPair pty;
        auto link = open(pty.path);
        QVERIFY(link);
        QVERIFY(!(*link)->waitForReadyRead(0us).value());
        pty.dropConnection();
        if (byWriting)
            QCOMPARE((*link)->write(base::Bytes{1}).error().code, ErrorCode::LinkLost);
        else
            QCOMPARE((*link)->waitForReadyRead(0us).error().code, ErrorCode::LinkLost);
        base::Bytes buffer;
        QCOMPARE((*link)->read(buffer).error().code, ErrorCode::LinkLost);
        QCOMPARE((*link)->waitForReadyRead(10s).error().code, ErrorCode::LinkLost);
        QCOMPARE((*link)->setBaud(9600).error().code, ErrorCode::LinkLost);
        QCOMPARE((*link)->write(base::Bytes{1}).error().code, ErrorCode::LinkLost);
    }

    void endsAWaitWhenThePortHangsUp()
    {
        PtyPair pty;
        auto link = open(pty.path);
        QVERIFY(link);
        pty.send("ab");
        QVERIFY((*link)->waitForReadyRead(5s).value());
        pty.dropConnection();
        base::Bytes buffer;
        QCOMPARE((*link)->read(buffer).value(), std::size_t{2});
        QCOMPARE((*link)->waitForReadyRead(3600s).error().code, ErrorCode::LinkLost);
    }

    void normalizesNames()
    {
        PtyPair pty;
        QTemporaryDir folder;
        const QString alias = folder.filePath(QStringLiteral("servo"));
        QVERIFY(QFile::link(pty.path, alias));
        QCOMPARE(transport::canonicalPath(alias), pty.path);
        QCOMPARE(transport::canonicalPath(pty.path), pty.path);
        QCOMPARE(transport::canonicalPath(QStringLiteral("null")), QStringLiteral("/dev/null"));
        QCOMPARE(transport::canonicalPath(QStringLiteral("/no/such")), QStringLiteral("/no/such"));
        auto link = open(alias);
        QVERIFY(link);
        QCOMPARE((*link)->name(), pty.path);
    }

private:
    // Straight from the kernel; the master shares the settings of the port under test.
    static int terminalRate(const PtyPair& pty)
    {
        termios2 settings{};
        return ioctl(pty.master, TCGETS2, &settings) == 0 ? static_cast<int>(settings.c_ospeed)
                                                          : -1;
    }
};

SERVODESK_GUILESS_TEST(TestSerialLink)
#include "tst_serial_link.moc"
