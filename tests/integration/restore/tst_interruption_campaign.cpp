// SPDX-License-Identifier: GPL-3.0-or-later
// Every writing command killed, or its cable cut, at a random moment; a few rounds of the campaign
// that tests/bench/bench_interruption_campaign runs hundreds of.
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
        QTest::newRow("killed in noise") << int(Interruption::KillDuringNoise);
        QTest::newRow("cable cut") << int(Interruption::LinkCut);
    }
    void recoversFromEveryInterruption()
    {
        QFETCH(int, how);
        constexpr int commands = 14; // one round each
        int counted = 0;
        const auto tally = support::runCampaign(Interruption(how), commands, 20261123, QString(),
                                                [&counted](const QString& line) {
                                                    qInfo().noquote() << line;
                                                    ++counted;
                                                });
        QCOMPARE(counted, commands);
        QVERIFY2(tally.broken > commands / 2, qPrintable(QString::number(tally.broken)));
        QVERIFY(tally.openChanges > 0);
        QVERIFY2(tally.clean(), qPrintable(tally.firstFailure));
    }
};

SERVODESK_GUILESS_TEST(TestInterruptionCampaign)
#include "tst_interruption_campaign.moc"
