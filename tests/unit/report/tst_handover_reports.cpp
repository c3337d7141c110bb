// SPDX-License-Identifier: GPL-3.0-or-later
// Reports that are handed over with a servo: the snapshot of any family on one page, read by
// another program (poppler), in words and in both languages; and a commissioning batch, as a page
// and as a table for spreadsheets.
#include "catalog/value.h"
#include "report/commission_report.h"
#include "report/snapshot_report.h"
#include "snapshot/factory_snapshot.h"
#include "support/font_config.h"
#include "support/program_output.h"
#include "support/test_main.h"
#include "support/test_paths.h"

#include <QGuiApplication>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QXmlStreamReader>
#include <QtTest>

namespace {
using support::outputOf;
QString q(const char* text)
{
    return QString::fromUtf8(text);
}

int pagesOf(const QString& path)
{
    static const QRegularExpression count(q("Pages: +(\\d+)"));
    return count.match(outputOf(q("pdfinfo"), {path})).captured(1).toInt();
}

/// Blanks as single spaces, because the pages have columns.
QString paperText(const QString& path)
{
    return outputOf(q("pdftotext"), {q("-layout"), path, q("-")}).simplified();
}

QString fileText(const QString& path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString();
}

/// Every register has a value.
snapshot::Snapshot wholeTable(const catalog::Profile& profile)
{
    snapshot::Snapshot table = snapshot::factorySnapshot(profile);
    table.servo.id = 12;
    table.at = QDateTime({2026, 11, 28}, {9, 30}, Qt::UTC);
    table.port = q("/dev/ttyUSB0");
    table.label = q("左髋");
    table.note = q("<b>before the repair</b>");
    table.program = q("servodesk test");
    for (snapshot::SnapshotRegister& row : table.registers)
        row.raw = row.raw.value_or(1);
    return table;
}

results::CommissionBatch batchOf(int servos)
{
    results::CommissionBatch batch;
    batch.program = q("servodesk test");
    for (int i = 0; i < servos; ++i) {
        results::CommissionRow row;
        row.at = QDateTime({2026, 11, 28}, {9, i % 60}, Qt::UTC);
        row.servo = {1, q("STS3215"), q("9.3"), q("3.10"), q("sts-sms"), q("feetech")};
        row.oldBaud = 1'000'000;
        row.newId = 11 + i;
        row.newBaud = 500'000;
        row.templateName = q("joint.servo.json");
        row.written = 2;
        row.volts = 7.4;
        row.celsius = 26;
        row.label = q("关节 %1").arg(i + 1);
        batch.rows.push_back(row);
    }
    batch.rows.back().verdict = results::CommissionVerdict::Failed;
    batch.rows.back().issues = {{q("row-refused"), q("max_temperature")}};
    results::PendingCommission open;
    open.servo = batch.rows.front().servo;
    open.newId = 99;
    open.isIdSent = true;
    batch.pending.push_back(open);
    return batch;
}
} // namespace

class TestHandoverReports : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { QTest::failOnWarning(QRegularExpression(q(".*"))); }

    void aSnapshotIsOnePage_data();
    void aSnapshotIsOnePage();
    void aSnapshotIsAPage();
    void unknownModelsKeepNumbers();
    void templatesKeepTheirValues();
    void aBatchIsHandedOver();
    void aSimulatedBatchSaysSo();
    void aBatchOpensInASpreadsheet();

private:
    QString path(const char* name) const { return m_folder.filePath(q(name)); }

    const catalog::Catalog m_catalog = catalog::Catalog::load().catalog;
    QTemporaryDir m_folder;
};

/// One model of each register map.
void TestHandoverReports::aSnapshotIsOnePage_data()
{
    QTest::addColumn<QString>("model");
    QTest::addColumn<int>("major");
    QTest::addColumn<int>("minor");
    QSet<QString> seen;
    for (const catalog::ModelEntry& model : m_catalog.models()) {
        for (const auto& [major, minor] : {std::pair(3, 10), {3, 25}, {3, 50}, {0, 5}, {1, 10}}) {
            const auto profile = m_catalog.profileFor(model, major, minor);
            if (!profile->writable || seen.contains(profile->mapKey))
                continue;
            seen.insert(profile->mapKey);
            QTest::newRow(qPrintable(profile->mapKey)) << model.name << major << minor;
        }
    }
    QCOMPARE(seen.size(), m_catalog.mapKeys().size() - 1); // but that of unknown servos
}

void TestHandoverReports::aSnapshotIsOnePage()
{
    QFETCH(const QString, model);
    QFETCH(const int, major);
    QFETCH(const int, minor);
    const auto profile = m_catalog.profileFor(*m_catalog.model(model), major, minor);
    const snapshot::Snapshot table = wholeTable(*profile);
    for (const bool chinese : {false, true}) {
        QVERIFY(report::saveSnapshotReport(table, m_catalog, chinese, path("table.pdf")));
        QCOMPARE(pagesOf(path("table.pdf")), 1);
        const QString text = paperText(path("table.pdf"));
        QVERIFY2(text.contains(table.servo.model) && text.contains(q("左髋")), qPrintable(text));
        QCOMPARE(text.contains(q("Servo snapshot")), !chinese);
        QVERIFY(!text.contains(q("present_position")));
    }
}

/// Well-formed, in both languages, with values in words and what the user typed as text.
void TestHandoverReports::aSnapshotIsAPage()
{
    const auto profile = m_catalog.profileFor(*m_catalog.model(q("STS3215")), 3, 10);
    snapshot::Snapshot table = wholeTable(*profile);
    for (snapshot::SnapshotRegister& row : table.registers) {
        if (row.key == q("operating_mode"))
            row.raw = 1;
        if (row.key == q("max_voltage"))
            row.raw = 85;
    }
    QVERIFY(report::saveSnapshotReport(table, m_catalog, false, path("table.html")));
    const QString page = fileText(path("table.html"));
    QXmlStreamReader reader(page);
    while (!reader.atEnd())
        reader.readNext();
    QVERIFY2(!reader.hasError(), qPrintable(reader.errorString()));
    const catalog::Register* mode = profile->byRole(catalog::Role::OperatingMode);
    const catalog::ValueFormat format = catalog::valueFormat(
        *mode, *profile, [](const QString&) { return std::optional<std::int64_t>(); });
    for (const bool chinese : {false, true}) {
        const QString words = catalog::formatValue(1, *mode, format, chinese);
        QVERIFY2(page.contains(QLatin1Char('>') + words + QLatin1Char('<')), qPrintable(words));
    }
    QVERIFY(page.contains(q(">8.5 V<")));
    QVERIFY(page.contains(q("&lt;b&gt;before the repair&lt;/b&gt;")));
    QVERIFY(page.contains(q("舵机快照")) && page.contains(q("Servo snapshot")));
    for (const snapshot::SnapshotRegister& row : table.registers)
        QVERIFY2(!page.contains(QLatin1Char('>') + row.key + QLatin1Char('<')),
                 qPrintable(row.key));
}

void TestHandoverReports::unknownModelsKeepNumbers()
{
    snapshot::Snapshot table;
    table.servo = {3, q("XY-9"), q("77.7"), q("9.9"), q("no-map"), q("feetech")};
    table.registers = {{q("strange"), 5, 1234, 12.34, q("V")}, {q("silent"), 6}};
    QVERIFY(report::saveSnapshotReport(table, m_catalog, false, path("unknown.pdf")));
    const QString text = paperText(path("unknown.pdf"));
    QVERIFY2(text.contains(q("strange 12.34 V 1234")), qPrintable(text));
    QVERIFY2(text.contains(q("silent – –")), qPrintable(text));
}

/// Its unit is decided by a register that the template does not have.
void TestHandoverReports::templatesKeepTheirValues()
{
    const auto profile = m_catalog.profileFor(*m_catalog.model(q("STS3215")), 3, 10);
    snapshot::Snapshot table = wholeTable(*profile);
    snapshot::SnapshotRegister speed = *table.find(q("goal_speed"));
    speed.raw = 100;
    speed.value = 1.25;
    speed.unit = q("rpm");
    table.registers = {speed};
    table.isTemplate = true;
    QVERIFY(report::saveSnapshotReport(table, m_catalog, false, path("template.pdf")));
    const QString text = paperText(path("template.pdf"));
    QVERIFY2(text.contains(q("1.25 rpm 100")), qPrintable(text));
}

void TestHandoverReports::aBatchIsHandedOver()
{
    const results::CommissionBatch batch = batchOf(12);
    for (const bool chinese : {false, true}) {
        QVERIFY(report::saveCommissionReport(batch, q("arm.csv"), chinese, path("batch.pdf")));
        QCOMPARE(pagesOf(path("batch.pdf")), 1);
        const QString text = paperText(path("batch.pdf"));
        for (const char* fact : {"arm.csv", "关节 1", "11 · 500 k", "22 · 500 k", "7.4 V", "26 °C"})
            QVERIFY2(text.contains(q(fact)), qPrintable(q(fact) + text));
        QCOMPARE(text.contains(q("write to max_temperature was refused")), !chinese);
        QCOMPARE(text.contains(q("may have one of these IDs: 1, 99")), !chinese);
    }
    QVERIFY(report::saveCommissionReport(batchOf(300), q("arm.csv"), false, path("batch.pdf")));
    QVERIFY(pagesOf(path("batch.pdf")) > 3);
    QVERIFY(paperText(path("batch.pdf")).contains(q("关节 300")));
}

void TestHandoverReports::aSimulatedBatchSaysSo()
{
    results::CommissionBatch batch = batchOf(2);
    batch.pending.clear();
    const auto text = [&] {
        const QByteArray kept = results::encodeCommissionBatch(batch); // as from an earlier day
        const auto read = results::decodeCommissionBatch(kept);
        if (!read || !report::saveCommissionReport(*read, q("arm.csv"), false, path("batch.pdf")))
            return q("no report");
        return paperText(path("batch.pdf"));
    };
    QVERIFY(!text().contains(q("SIMULATED")));
    batch.rows.front().simulated = true;
    QVERIFY2(text().contains(q("Some of these servos were SIMULATED")), qPrintable(text()));
    batch.rows.back().simulated = true;
    QVERIFY(text().contains(q("SIMULATED: not real servos")));
    batch.pending = {{QDateTime({2026, 11, 28}, {9, 0}, Qt::UTC), batch.rows.front().servo}};
    batch.pending.front().oldBaud = 1'000'000;
    batch.pending.front().newId = 99;
    batch.pending.front().newBaud = 1'000'000;
    QVERIFY(text().contains(q("Some of these servos were SIMULATED")));
    batch.pending.front().simulated = true;
    QVERIFY(text().contains(q("SIMULATED: not real servos")));
    batch.pending.clear();
    QVERIFY(results::encodeCommissionCsv(batch).endsWith(",1\n"));
    batch.rows = {batchOf(1).rows.front()};
    const QByteArray older =
        results::encodeCommissionBatch(batch).replace(", \"simulated\": false", "");
    QVERIFY(!older.contains("simulated"));
    QVERIFY(results::decodeCommissionBatch(older).has_value());
}

/// Excel takes a file without a byte order mark for another encoding.
void TestHandoverReports::aBatchOpensInASpreadsheet()
{
    const QByteArray csv = results::encodeCommissionCsv(batchOf(2));
    QVERIFY(csv.startsWith("\xEF\xBB\xBFtime,verdict,"));
    QVERIFY(csv.contains("关节 2"));
}

static int runTestHandoverReports(int argc, char** argv)
{
    qputenv("QT_QPA_PLATFORM", "offscreen");
    return support::runWithFonts<QGuiApplication, TestHandoverReports>(argc, argv, CJK_FONTS);
}
SERVODESK_TEST_RUN(runTestHandoverReports)
#include "tst_handover_reports.moc"
