// SPDX-License-Identifier: GPL-3.0-or-later
// Every writing command killed, or its cable cut, at a random moment; a few rounds of the campaign
// that tests/bench/bench_break_campaign runs hundreds of.
#include "support/campaign.h"

#include <QRegularExpression>
#include <QTest>

using support::Break;

class TestBreakCampaign : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { QTest::failOnWarning(QRegularExpression(QStringLiteral(".*"))); }

    void nothingIsLeftBroken_data()
    {
        QTest::addColumn<int>("how");
        QTest::newRow("killed in noise") << int(Break::KillInNoise);
        QTest::newRow("cable cut") << int(Break::Cut);
    }
    void nothingIsLeftBroken()
    {
        QFETCH(int, how);
        constexpr int commands = 14; // one round each
        int counted = 0;
        const auto tally = support::runCampaign(Break(how), commands, 20261123, QString(),
                                                [&counted](const QString& line) {
                                                    qInfo().noquote() << line;
                                                    ++counted;
                                                });
        QCOMPARE(counted, commands);
        QVERIFY2(tally.broken > commands / 2, qPrintable(QString::number(tally.broken)));
        QVERIFY(tally.changesOpen > 0);
        QVERIFY2(tally.clean(), qPrintable(tally.firstTrouble));
    }
};

QTEST_GUILESS_MAIN(TestBreakCampaign)
#include "tst_break_campaign.moc"
