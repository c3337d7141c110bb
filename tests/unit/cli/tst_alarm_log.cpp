// SPDX-License-Identifier: GPL-3.0-or-later
// Alarms that come and go while servos are watched, as the history has them afterwards.
#include "cli/alarm_log.h"
#include "history/history.h"
#include "session/paths.h"
#include "support/temporary_data_folder.h"
#include "support/test_main.h"

#include <QFile>
#include <QRegularExpression>
#include <QTest>

namespace {
constexpr std::uint8_t voltage = 1 << 0;
constexpr std::uint8_t heat = 1 << 2;

device::Servo servo()
{
    catalog::Register status;
    status.role = catalog::Role::Status;
    status.values = {{0, QStringLiteral("voltage"), {}}, {2, QStringLiteral("overheat"), {}}};
    auto profile = std::make_shared<catalog::Profile>();
    profile->registers = {status};
    device::Servo servo;
    servo.id = 1;
    servo.profile = profile;
    return servo;
}

QDateTime after(qint64 ms)
{
    return QDateTime::fromMSecsSinceEpoch(1'800'000'000'000 + ms, Qt::UTC);
}

/// "overheat 0-200", oldest first; "overheat 0-" is not gone.
QStringList kept()
{
    const auto history = history::History::open(session::historyFile());
    const auto alarms = (*history)->log().alarms({});
    QStringList all;
    for (const history::HistoryAlarm& alarm : *alarms) {
        const auto ms = [](const QDateTime& at) {
            return at.isValid() ? QString::number(after(0).msecsTo(at)) : QString();
        };
        all.prepend(alarm.key + QLatin1Char(' ') + ms(alarm.at) + QLatin1Char('-') +
                    ms(alarm.clearedAt));
    }
    return all;
}
} // namespace

class TestAlarmLog : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { QTest::failOnWarning(QRegularExpression(QStringLiteral(".*"))); }
    void raisedAndCleared();
    void aFlickeringAlarmIsLoggedOncePerSecond();
    void theEndLogsTheRest();
    void servosWithoutAlarmsAreOmitted();
};

void TestAlarmLog::raisedAndCleared()
{
    const support::TemporaryDataFolder folder;
    cli::Console console(false);
    cli::AlarmLog log(console, {servo()});
    log.addStatus(1, 0, after(0));
    QVERIFY2(!QFile::exists(session::historyFile()), "nothing to write down");
    log.addStatus(1, voltage, after(100));
    QCOMPARE(kept(), QStringList({QStringLiteral("voltage 100-")}));
    log.addStatus(1, voltage | heat, after(2000));
    log.addStatus(1, heat, after(4000));
    QCOMPARE(kept(),
             QStringList({QStringLiteral("voltage 100-4000"), QStringLiteral("overheat 2000-")}));
}

void TestAlarmLog::aFlickeringAlarmIsLoggedOncePerSecond()
{
    const support::TemporaryDataFolder folder;
    cli::Console console(false);
    cli::AlarmLog log(console, {servo()});
    log.addStatus(1, voltage, after(0));
    for (int ms = 50; ms < 1000; ms += 50)
        log.addStatus(1, ms % 100 == 0 ? heat : 0, after(ms));
    QCOMPARE(kept(), QStringList({QStringLiteral("voltage 0-")}));
    log.addStatus(1, 0, after(1000));
    QCOMPARE(kept(),
             QStringList({QStringLiteral("voltage 0-1000"), QStringLiteral("overheat 100-1000")}));
}

void TestAlarmLog::theEndLogsTheRest()
{
    const support::TemporaryDataFolder folder;
    cli::Console console(false);
    cli::AlarmLog log(console, {servo()});
    log.addStatus(1, voltage, after(0));
    log.addStatus(1, heat, after(200));
    log.finish();
    QCOMPARE(kept(),
             QStringList({QStringLiteral("voltage 0-200"), QStringLiteral("overheat 200-")}));
}

void TestAlarmLog::servosWithoutAlarmsAreOmitted()
{
    const support::TemporaryDataFolder folder;
    device::Servo mute = servo();
    auto profile = std::make_shared<catalog::Profile>();
    profile->protocol = base::Protocol::Lx;
    mute.profile = profile;
    cli::Console console(false);
    cli::AlarmLog log(console, {mute});
    log.addStatus(1, voltage, after(0));
    log.finish();
    QVERIFY(!QFile::exists(session::historyFile()));
}

SERVODESK_GUILESS_TEST(TestAlarmLog)
#include "tst_alarm_log.moc"
