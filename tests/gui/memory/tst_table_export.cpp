// SPDX-License-Identifier: GPL-3.0-or-later
// The table as CSV, HTML and text: the contents of a cell arrive as data, whatever they look like.
#include "gui/servo_entry_builder.h"
#include "support/test_main.h"
#include "support/text.h"
#include "text/language.h"
#include "ui/memory/memory_output.h"
#include "ui/memory/memory_sheet.h"

#include <QDir>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QTest>

using support::contentOf;
using ui::TableSheet;

class TestTableExport : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init();

    void csvQuotes();
    void csvInjectionIsPrevented();
    void htmlIsSelfContainedAndEscaped();
    void tabbedTextHasOneLinePerRow();
    void exportHasEveryColumn();
    void unreadValuesStayEmpty();
    void fileNamesAreSanitized();
    void savesByFileSuffix();
    void reportsWriteErrors();
};

namespace {
TableSheet small()
{
    TableSheet sheet;
    sheet.title = QStringLiteral("A <b> & \"C\"");
    sheet.captionLines << QStringLiteral("port <x>");
    sheet.headers << QStringLiteral("n") << QStringLiteral("name");
    sheet.numeric = {true};
    sheet.rows.push_back({QStringLiteral("-5"), QStringLiteral("a, \"b\"\nc")});
    sheet.rows.push_back({QStringLiteral("7"), QStringLiteral("<script>卸载</script>")});
    return sheet;
}
} // namespace

void TestTableExport::init()
{
    QTest::failOnWarning(QRegularExpression(QStringLiteral(".*")));
    text::installTranslator(QStringLiteral("en"));
}

void TestTableExport::csvQuotes()
{
    const QByteArray csv = ui::toCsv(small());
    QVERIFY(csv.startsWith("\xEF\xBB\xBF"));
    QCOMPARE(QString::fromUtf8(csv.mid(3)),
             QStringLiteral("n,name\n-5,\"a, \"\"b\"\"\nc\"\n7,<script>卸载</script>\n"));
}

void TestTableExport::csvInjectionIsPrevented()
{
    TableSheet sheet;
    sheet.headers << QStringLiteral("a") << QStringLiteral("b") << QStringLiteral("c");
    sheet.rows.push_back({QStringLiteral("=1+1"), QStringLiteral("-12.5"), QStringLiteral("@x")});
    QVERIFY(ui::toCsv(sheet).contains("\n'=1+1,-12.5,'@x\n"));
}

void TestTableExport::htmlIsSelfContainedAndEscaped()
{
    const QString html = QString::fromUtf8(ui::toHtml(small()));
    QVERIFY(html.startsWith(QStringLiteral("<!DOCTYPE html>")));
    QVERIFY(html.contains(QStringLiteral("&lt;script&gt;卸载&lt;/script&gt;")));
    QVERIFY(!html.contains(QStringLiteral("<script")));
    QVERIFY(html.contains(QStringLiteral("<td class=\"n\">-5</td>")));
    QVERIFY(!html.contains(QStringLiteral("src=")));
    QVERIFY(!html.contains(QStringLiteral("href=")));
    QVERIFY(html.contains(QStringLiteral("port &lt;x&gt;")));
}

void TestTableExport::tabbedTextHasOneLinePerRow()
{
    QCOMPARE(ui::toTsv(small()),
             QStringLiteral("n\tname\n-5\ta, \"b\" c\n7\t<script>卸载</script>\n"));
}

void TestTableExport::exportHasEveryColumn()
{
    auto entry = guitest::entryOf(guitest::sts3215);
    guitest::put(entry, QStringLiteral("position_p"), 40);
    ui::MemoryModel model;
    model.setEntry(&entry, {});
    const int row = model.rowOf(QStringLiteral("position_p"));
    const QDateTime at(QDate(2026, 11, 21), QTime(9, 41, 7));
    const TableSheet sheet = ui::memorySheet(model, {row}, entry, at);
    QVERIFY(sheet.title.contains(QStringLiteral("STS3215")));
    QVERIFY(sheet.captionLines.join(u'\n').contains(QStringLiteral("3.10")));
    QVERIFY(sheet.captionLines.join(u'\n').contains(QStringLiteral("2026-11-21 09:41:07")));
    QCOMPARE(sheet.headers.size(), ui::memoryColumns + 1);
    QCOMPARE(sheet.rows.size(), std::size_t(1));
    const QStringList cells = sheet.rows.front();
    QCOMPARE(cells.size(), sheet.headers.size());
    QCOMPARE(cells.mid(0, 4),
             (QStringList{QStringLiteral("21"), QStringLiteral("position_p"),
                          QStringLiteral("Position loop P"), QStringLiteral("40")}));
}

void TestTableExport::unreadValuesStayEmpty()
{
    auto entry = guitest::entryOf(guitest::sts3215);
    guitest::put(entry, QStringLiteral("position_p"), 77);
    entry.unreadable.insert(QStringLiteral("position_p"));
    ui::MemoryModel model;
    model.setEntry(&entry, {});
    const TableSheet sheet = ui::memorySheet(model, {model.rowOf(QStringLiteral("position_p"))},
                                             entry, QDateTime::currentDateTime());
    QVERIFY(!ui::toCsv(sheet).contains("77"));
    QCOMPARE(sheet.rows.front().at(3), QString());
}

void TestTableExport::fileNamesAreSanitized()
{
    auto entry = guitest::entryOf(guitest::sts3215);
    auto hostile = std::make_shared<catalog::Profile>(*entry.servo.profile);
    hostile->modelName = QStringLiteral("../../etc/x y");
    entry.servo.profile = hostile;
    const QString name = ui::memoryFileName(entry, QDateTime(QDate(2026, 11, 21), QTime(1, 2)));
    QVERIFY(!name.contains(u'/'));
    QVERIFY(!name.contains(u' '));
    QVERIFY(name.endsWith(QStringLiteral("-id1-2026-11-21")));
}

void TestTableExport::savesByFileSuffix()
{
    QTemporaryDir folder;
    const QString csv = folder.filePath(QStringLiteral("t.csv"));
    const QString html = folder.filePath(QStringLiteral("t.HTML"));
    QVERIFY(ui::MemoryOutput::save(small(), csv));
    QVERIFY(ui::MemoryOutput::save(small(), html));
    QCOMPARE(contentOf(csv), ui::toCsv(small()));
    QCOMPARE(contentOf(html), ui::toHtml(small()));
}

void TestTableExport::reportsWriteErrors()
{
    QTemporaryDir folder;
    const auto missing =
        ui::MemoryOutput::save(small(), folder.filePath(QStringLiteral("no/such/t.csv")));
    QVERIFY(!missing);
    QCOMPARE(missing.error().code, base::ErrorCode::FileUnwritable);
    QVERIFY(missing.error().detail.contains(QStringLiteral("no/such")));
    QVERIFY(!ui::MemoryOutput::save(small(), QString()));
    // What was there before is whole when the new one cannot be written.
    const QString place = folder.filePath(QStringLiteral("t.csv"));
    QVERIFY(QDir(folder.path()).mkdir(QStringLiteral("t.csv")));
    QVERIFY(!ui::MemoryOutput::save(small(), place));
    QVERIFY(QFileInfo(place).isDir());
}

SERVODESK_TEST(TestTableExport)
#include "tst_table_export.moc"
