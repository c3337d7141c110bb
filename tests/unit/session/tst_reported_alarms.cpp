// SPDX-License-Identifier: GPL-3.0-or-later
// What the history is told of the alarms of a servo: each start and each end once.
#include "session/history/reported_alarms.h"
#include "support/test_main.h"

#include <QRegularExpression>
#include <QTest>

using session::ActiveAlarm;

namespace {
const ActiveAlarm overloadAlarm{QStringLiteral("overload"), 5, false};
const ActiveAlarm heat{QStringLiteral("temperature"), -1, true};

QDateTime after(int seconds)
{
    return QDateTime::fromMSecsSinceEpoch(1'800'000'000'000 + 1000 * seconds, Qt::UTC);
}

struct ReportedAlarmsFixture {
    session::AlarmLatch latch;
    session::ReportedAlarms reported;
    void see(const std::vector<ActiveAlarm>& alarms, int second)
    {
        latch.update(alarms, {}, after(second));
    }
    /// "+overload 1": it came in second 1; "-": it ended.
    QStringList changes(int second)
    {
        QStringList all;
        for (const session::AlarmChange& change : reported.update(latch.alarms(), after(second)))
            all << QLatin1Char(change.raised ? '+' : '-') + change.key + QLatin1Char(' ') +
                       QString::number(after(0).secsTo(change.at));
        return all;
    }
};

QStringList list(const char* changes)
{
    return QString::fromLatin1(changes).split(QStringLiteral(", "), Qt::SkipEmptyParts);
}
} // namespace

class TestReportedAlarms : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { QTest::failOnWarning(QRegularExpression(QStringLiteral(".*"))); }

    void eachStartAndEndIsReportedOnce()
    {
        ReportedAlarmsFixture fixture;
        QCOMPARE(fixture.changes(0), QStringList());
        fixture.see({overloadAlarm}, 1);
        QCOMPARE(fixture.changes(2), list("+overload 1"));
        QCOMPARE(fixture.changes(3), QStringList());
        fixture.see({heat}, 4);
        QCOMPARE(fixture.changes(5), list("-overload 5, +temperature 4"));
        QVERIFY(fixture.reported.update(fixture.latch.alarms(), after(6)).empty());
    }

    /// It came and went between two calls, and again while it was reported as active.
    void aShortAlarmIsNotMissed()
    {
        ReportedAlarmsFixture fixture;
        fixture.see({overloadAlarm}, 1);
        fixture.see({}, 2);
        QCOMPARE(fixture.changes(3), list("+overload 1, -overload 3"));
        fixture.see({overloadAlarm}, 4);
        QCOMPARE(fixture.changes(5), list("+overload 4"));
        fixture.see({}, 6);
        fixture.see({overloadAlarm}, 7);
        QCOMPARE(fixture.changes(8), list("-overload 7, +overload 7"));
    }

    void anAcknowledgedAlarmEnds()
    {
        ReportedAlarmsFixture fixture;
        fixture.see({overloadAlarm}, 1);
        QCOMPARE(fixture.changes(2), list("+overload 1"));
        fixture.latch.acknowledge();
        QCOMPARE(fixture.changes(3), QStringList());
        fixture.see({}, 4);
        QVERIFY(fixture.latch.alarms().empty());
        QCOMPARE(fixture.changes(5), list("-overload 5"));
        fixture.see({overloadAlarm}, 6);
        QCOMPARE(fixture.changes(7), list("+overload 6"));
    }
};

SERVODESK_GUILESS_TEST(TestReportedAlarms)
#include "tst_reported_alarms.moc"
