// SPDX-License-Identifier: GPL-3.0-or-later
// The program killed (kill -9) while it sends firmware: nothing is reported as done, the servo is
// known to be in its bootloader, and the rescue completes it. After the first block here (15 s: the
// program searches the bus twice at real rates), at every one in the deep check.
#include "integration/kill_cable.h"
#include "integration/raw_client.h"
#include "support/cli_program.h"
#include "support/deep_check.h"
#include "support/test_main.h"

#include <QFile>
#include <QRegularExpression>
#include <QTest>

using support::CliProgram;
using support::words;

namespace {
constexpr int imageBlocks = 24;
} // namespace

class TestCliFirmwareKill : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { QTest::failOnWarning(QRegularExpression(QStringLiteral(".*"))); }

    void killedBetweenBlocks_data()
    {
        QTest::addColumn<int>("block");
        QTest::addColumn<bool>("delivered");
        QTest::newRow("the first, delivered") << 1 << true;
        if (!support::isDeepCheck())
            return;
        for (int block = 2; block <= imageBlocks; ++block) {
            QTest::addRow("%d, lost", block) << block << false;
            if (block < imageBlocks) // the servo is updated by the last one
                QTest::addRow("%d, delivered", block) << block << true;
        }
    }
    void killedBetweenBlocks()
    {
        QFETCH(int, block);
        QFETCH(bool, delivered);
        CliProgram cli;
        const QString image = cli.dataFolder() + QStringLiteral("/SCServo21-GD32-TTL-250306.bin");
        QFile file(image);
        QVERIFY(file.open(QIODevice::WriteOnly));
        QCOMPARE(file.write(QByteArray(64 * imageBlocks, 'x')), 64 * imageBlocks);
        file.close();
        raw::Simulator sim(words("--preset line"));
        const auto command = [&sim](const char* line) {
            sim.sendLine(line);
            (void)sim.nextLine(); // done
        };
        command("next"); // ID 1
        support::KillCable cable(sim.port());
        cli.setPort(cable.port());
        cli.start({QStringLiteral("firmware"), QStringLiteral("update"), image, QStringLiteral("1"),
                   QStringLiteral("--json")});
        cable.killAt({.delivered = delivered, .block = block}, cli.process().processId());
        const auto killed = cli.finish();
        QVERIFY2(cable.killed(), qPrintable(killed.out + killed.err));
        QVERIFY(killed.out.isEmpty());
        cable.resetConnection();
        QCOMPARE(cli.run(words("info 1")).exit, 4);
        cable.resetConnection();
        cli.start({QStringLiteral("firmware"), QStringLiteral("rescue"), image,
                   QStringLiteral("--json")});
        const bool isWaiting = cli.waitForError("Waiting for a bootloader");
        command("unplug"); // its supply off and on
        command("plug 1");
        const auto rescued = cli.finish();
        QVERIFY(isWaiting);
        QVERIFY2(rescued.exit == 0, qPrintable(rescued.out + rescued.err));
        QCOMPARE(rescued.json()[QLatin1String("firmware")].toString(), QStringLiteral("3.11"));
        cable.resetConnection();
        QCOMPARE(cli.run(words("info 1")).exit, 0);
    }
};

SERVODESK_GUILESS_TEST(TestCliFirmwareKill)
#include "tst_cli_firmware_kill.moc"
