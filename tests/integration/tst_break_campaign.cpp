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
        QTest::addColumn<bool>("noisy");
        QTest::newRow("killed, in noise") << int(Break::Kill) << true;
        QTest::newRow("TCP link dropped") << int(Break::CutTcp) << false;
    }
    void nothingIsLeftBroken()
    {
        QFETCH(int, how);
        QFETCH(bool, noisy);
        const auto tally = support::runCampaign(
            Break(how), 1, noisy, 20261123, [](const QString& line) { qInfo().noquote() << line; });
        QVERIFY(tally.rounds >= 9);
        QVERIFY2(tally.clean(), qPrintable(tally.firstTrouble));
    }
};

QTEST_GUILESS_MAIN(TestBreakCampaign)
#include "tst_break_campaign.moc"
