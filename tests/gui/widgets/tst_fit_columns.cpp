// SPDX-License-Identifier: GPL-3.0-or-later
// A table that is narrower than its contents still shows every column.
#include "support/test_main.h"
#include "ui/widgets/fit_columns.h"

#include <QHeaderView>
#include <QStandardItemModel>
#include <QTableView>
#include <QtTest>

class TestFitColumns : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { QTest::failOnWarning(QRegularExpression(QStringLiteral(".*"))); }

    void widestColumnsShrinkFirst()
    {
        QStandardItemModel model(1, 5);
        const QString texts[] = {QStringLiteral("short"), QString(80, QLatin1Char('w')),
                                 QString(40, QLatin1Char('w')), QStringLiteral("kept"),
                                 QStringLiteral("last")};
        for (int column = 0; column < 5; ++column)
            model.setItem(0, column, new QStandardItem(texts[column]));
        QTableView table;
        const QAbstractItemView& view = table; // a table's own is not for everybody
        table.setModel(&model);
        ui::FitColumns fit(&table);
        table.resize(600, 200);
        table.show();
        QVERIFY(QTest::qWaitForWindowExposed(&table));
        const auto inSight = [&] {
            return table.columnViewportPosition(4) + view.sizeHintForColumn(4) <=
                   table.viewport()->width();
        };
        QVERIFY(inSight());
        for (const int column : {0, 3})
            QVERIFY(table.columnWidth(column) >= view.sizeHintForColumn(column));
        QVERIFY(table.columnWidth(1) < view.sizeHintForColumn(1));
        table.resize(2400, 200); // room for all
        QTRY_VERIFY(table.columnWidth(1) >= view.sizeHintForColumn(1));
        table.resize(420, 200);
        QTRY_VERIFY(inSight());
    }
};

SERVODESK_TEST(TestFitColumns)
#include "tst_fit_columns.moc"
