// SPDX-License-Identifier: GPL-3.0-or-later
// Whether this computer's battery is low, from files as the Linux kernel presents its power
// supplies.
#include "session/battery.h"
#include "support/test_main.h"

#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>

class TestBattery : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void onlyABatteryThatRunsDownIsLow_data()
    {
        QTest::addColumn<QByteArray>("type");
        QTest::addColumn<QByteArray>("scope");
        QTest::addColumn<QByteArray>("status");
        QTest::addColumn<QByteArray>("capacity");
        QTest::addColumn<int>("percent"); // -1: not low
        const auto row = [](const char* name, const char* type, const char* scope,
                            const char* status, const char* capacity, int percent) {
            QTest::newRow(name) << QByteArray(type) << QByteArray(scope) << QByteArray(status)
                                << QByteArray(capacity) << percent;
        };
        row("low", "Battery\n", "", "Discharging\n", "19\n", 19);
        row("empty", "Battery\n", "System\n", "Discharging\n", "0\n", 0);
        row("enough", "Battery\n", "", "Discharging\n", "20\n", -1);
        row("charging", "Battery\n", "", "Charging\n", "5\n", -1);
        row("mouse", "Battery\n", "Device\n", "Discharging\n", "5\n", -1);
        row("charger", "Mains\n", "", "", "", -1);
        row("no capacity", "Battery\n", "", "Discharging\n", "", -1);
    }
    void onlyABatteryThatRunsDownIsLow()
    {
        QFETCH(int, percent);
        const QTemporaryDir folder;
        QVERIFY(QDir(folder.path()).mkdir(QStringLiteral("BAT0")));
        for (const char* name : {"type", "scope", "status", "capacity"}) {
            const QByteArray content =
                *static_cast<QByteArray*>(QTest::qData(name, QMetaType::QByteArray));
            if (content.isEmpty())
                continue;
            QFile file(folder.filePath(QStringLiteral("BAT0/") + QLatin1String(name)));
            QVERIFY(file.open(QIODevice::WriteOnly));
            QCOMPARE(file.write(content), content.size());
        }
        QCOMPARE(session::lowBatteryPercent(folder.path()).value_or(-1), percent);
    }

    void aComputerWithoutBatteryIsNotLow()
    {
        const QTemporaryDir folder;
        QVERIFY(!session::lowBatteryPercent(folder.path()));
        QVERIFY(!session::lowBatteryPercent(folder.filePath(QStringLiteral("missing"))));
    }
};

SERVODESK_GUILESS_TEST(TestBattery)
#include "tst_battery.moc"
