// SPDX-License-Identifier: GPL-3.0-or-later
// Commands that write, killed, or their cable cut, at a random moment: a round of a few commands
// here, of each one in the deep check, hundreds in tests/bench/bench_interruption_campaign.
#include "support/deep_check.h"
#include "support/interruption_campaign.h"
#include "support/test_main.h"

#include <QRegularExpression>
#include <QTest>

using support::Interruption;

class TestInterruptionCampaign : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { QTest::failOnWarning(QRegularExpression(QStringLiteral(".*"))); }

    void recoversFromEveryInterruption_data()
    {
        QTest::addColumn<int>("how");
        QTest::addColumn<QString>("command");
        const auto row = [](Interruption how, const char* command) {
            const char* way = how == Interruption::LinkCut ? "cable cut" : "killed in noise";
            QTest::addRow("%s, %s", command, way) << int(how) << QString::fromLatin1(command);
        };
        if (support::isDeepCheck()) {
            for (const Interruption how : {Interruption::KillDuringNoise, Interruption::LinkCut})
                QTest::addRow("all, %d", int(how)) << int(how) << QString();
            return;
        }
        row(Interruption::KillDuringNoise, "set-id");
        row(Interruption::KillDuringNoise, "snapshot restore");
        row(Interruption::LinkCut, "set-baud");
        row(Interruption::LinkCut, "bundle restore");
    }
    void recoversFromEveryInterruption()
    {
        QFETCH(int, how);
        QFETCH(QString, command);
        constexpr int all = 14; // one round each
        const int commands = command.isEmpty() ? all : 1;
        int counted = 0;
        const auto tally = support::runCampaign(Interruption(how), commands, 20261123, command,
                                                [&counted](const QString& line) {
                                                    qInfo().noquote() << line;
                                                    ++counted;
                                                });
        QCOMPARE(counted, commands);
        QVERIFY2(tally.broken > commands / 2, qPrintable(QString::number(tally.broken)));
        QVERIFY(tally.openChanges > 0 || commands == 1);
        QVERIFY2(tally.clean(), qPrintable(tally.firstFailure));
    }
};

SERVODESK_GUILESS_TEST(TestInterruptionCampaign)
#include "tst_interruption_campaign.moc"
