// SPDX-License-Identifier: GPL-3.0-or-later
// A table that is narrower than its contents still shows every column, except an optional one.
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

    void anOptionalColumnGivesWayToTheFirst()
    {
        QStandardItemModel model(1, 4);
        const QString texts[] = {QString(30, QLatin1Char('w')), QStringLiteral("address"),
                                 QString(40, QLatin1Char('w')), QStringLiteral("last")};
        for (int column = 0; column < 4; ++column)
            model.setItem(0, column, new QStandardItem(texts[column]));
        QTableView table;
        const QAbstractItemView& view = table;
        table.setModel(&model);
        table.verticalHeader()->hide();
        ui::FitColumns fit(&table, 1);
        int all = 0;
        for (int column = 0; column < 4; ++column)
            all += view.sizeHintForColumn(column);
        table.resize(all + 200, 200);
        table.show();
        QVERIFY(QTest::qWaitForWindowExposed(&table));
        QVERIFY(!table.isColumnHidden(1));
        const int lastWidth =
            std::max(view.sizeHintForColumn(3), table.horizontalHeader()->sectionSizeHint(3));
        const auto firstIsWhole = [&] { return table.columnWidth(0) >= view.sizeHintForColumn(0); };
        // Only the third is shortened, then the first would be.
        table.resize(all - 20, 200);
        QTRY_VERIFY(table.columnWidth(2) < view.sizeHintForColumn(2));
        QVERIFY(!table.isColumnHidden(1) && firstIsWhole());
        table.setCurrentIndex(model.index(0, 1));
        // The third is no wider than the first; with the optional one there is no room for both.
        table.resize(2 * view.sizeHintForColumn(0) + table.columnWidth(1) / 2 + lastWidth, 200);
        QTRY_VERIFY(table.isColumnHidden(1));
        QCOMPARE(table.currentIndex().column(), 0);
        QVERIFY(firstIsWhole());
        table.resize(all + 200, 200);
        QTRY_VERIFY(!table.isColumnHidden(1));
    }
};

SERVODESK_TEST(TestFitColumns)
#include "tst_fit_columns.moc"
