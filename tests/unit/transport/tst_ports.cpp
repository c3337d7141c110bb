// SPDX-License-Identifier: GPL-3.0-or-later
// The list of ports and of rates.
#include "support/test_main.h"
#include "transport/port_inventory.h"
#include "transport/port_opener.h"

#include <QFile>
#include <QRegularExpression>
#include <QTest>

#include <algorithm>

class TestPorts : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { QTest::failOnWarning(QRegularExpression(QStringLiteral(".*"))); }

    void ratesAreThoseOfTheServosHighestFirst()
    {
        const std::vector<int>& rates = transport::standardBaudRates();
        QVERIFY(std::is_sorted(rates.begin(), rates.end(), std::greater<>()));
        // The baud codes 0 to 11 of the Feetech families, and the odd one of their own tool.
        for (const int rate : {1000000, 500000, 250000, 128000, 115200, 76800, 57600, 38400, 19200,
                               14400, 9600, 4800, 256000})
            QVERIFY2(std::count(rates.begin(), rates.end(), rate) == 1,
                     qPrintable(QString::number(rate)));
        QCOMPARE(rates.size(), std::size_t{14});
    }

    // What is listed exists, once, in order, and has hardware behind it.
    void listsOnlyPortsThatExist()
    {
        const auto ports = transport::listPorts();
        for (std::size_t i = 0; i < ports.size(); ++i) {
            QVERIFY(QFile::exists(ports[i].path));
            QVERIFY(i == 0 || ports[i - 1].path < ports[i].path);
            const QString name = ports[i].path.section(QLatin1Char('/'), -1);
            QFile type(QStringLiteral("/sys/class/tty/%1/type").arg(name));
            if (type.open(QIODevice::ReadOnly))
                QVERIFY(type.readAll().trimmed() != "0");
        }
    }
};

SERVODESK_GUILESS_TEST(TestPorts)
#include "tst_ports.moc"
