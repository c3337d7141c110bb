// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/test_main.h"
#include "ui/widgets/stretch_first_column.h"

#include <QHeaderView>
#include <QTableWidget>
#include <QTest>

namespace {
constexpr int columns = 4;

int sum(const QTableWidget& table)
{
    int all = 0;
    for (int column = 0; column < columns; ++column)
        all += table.columnWidth(column);
    return all;
}
} // namespace

class TestStretchFirstColumn : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init()
    {
        for (int column = 0; column < columns; ++column)
            m_table.setItem(0, column,
                            new QTableWidgetItem(QStringLiteral("a name of many words")));
        m_table.resize(1200, 200);
        m_table.show();
        QVERIFY(QTest::qWaitForWindowExposed(&m_table));
    }

    void theFirstColumnStretches()
    {
        QTRY_COMPARE(sum(m_table), m_table.viewport()->width());
        QVERIFY(m_table.columnWidth(0) > m_table.columnWidth(1));
    }

    void theLastColumnStaysInSight()
    {
        int others = 0;
        for (int column = 1; column < columns; ++column)
            others += m_table.columnWidth(column);
        m_table.resize(1200 - m_table.viewport()->width() + others + needed() * 3 / 4, 200);
        QTRY_COMPARE(sum(m_table), m_table.viewport()->width());
        QVERIFY(m_table.columnWidth(0) < needed());
    }

    void aNarrowTableScrollsInstead()
    {
        m_table.resize(260, 200);
        QTRY_VERIFY(m_table.columnWidth(0) >= needed());
        QTRY_VERIFY(sum(m_table) > m_table.viewport()->width());
        m_table.resize(1200, 200);
        QTRY_COMPARE(sum(m_table), m_table.viewport()->width());
    }

    void growingColumnsDoNotElideIt()
    {
        m_table.resize(620, 200);
        m_table.item(0, 2)->setText(QString(60, QLatin1Char('x')));
        QTRY_VERIFY(sum(m_table) > m_table.viewport()->width());
        QVERIFY(m_table.columnWidth(0) >= needed());
    }

private:
    int needed() const
    {
        return static_cast<const QAbstractItemView&>(m_table).sizeHintForColumn(0);
    }

    QTableWidget m_table{1, columns};
    ui::StretchFirstColumn* m_roomy = new ui::StretchFirstColumn(&m_table);
};

SERVODESK_TEST(TestStretchFirstColumn)
#include "tst_stretch_first_column.moc"
