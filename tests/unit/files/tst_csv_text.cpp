// SPDX-License-Identifier: GPL-3.0-or-later
#include "files/csv_text.h"
#include "support/test_main.h"

#include <QtTest>

class TestCsvText : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void aLineHasAllItsCells_data()
    {
        QTest::addColumn<QStringList>("cells");
        QTest::addColumn<QByteArray>("line");
        QTest::newRow("empty first")
            << QStringList{QString(), QStringLiteral("b")} << QByteArray(",b\n");
        QTest::newRow("all empty")
            << QStringList{QString(), QString(), QString()} << QByteArray(",,\n");
        QTest::newRow("commas and quotes")
            << QStringList{QStringLiteral("a,b"), QStringLiteral("say \"so\"")}
            << QByteArray("\"a,b\",\"say \"\"so\"\"\"\n");
        QTest::newRow("no formula") << QStringList{QStringLiteral("=1+1"), QStringLiteral("-5")}
                                    << QByteArray("'=1+1,-5\n");
    }
    void aLineHasAllItsCells()
    {
        QFETCH(QStringList, cells);
        QTEST(files::csvLine(cells), "line");
    }
};

SERVODESK_GUILESS_TEST(TestCsvText)
#include "tst_csv_text.moc"
