// SPDX-License-Identifier: GPL-3.0-or-later
// JSON, tables and exit codes of the command line.
#include "cli/exit_code.h"
#include "cli/output/json.h"
#include "cli/output/table.h"
#include "support/test_main.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QRegularExpression>
#include <QSet>
#include <QTest>

#include <limits>

using base::ErrorCode;
using cli::Json;

class TestCliOutput : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { QTest::failOnWarning(QRegularExpression(QStringLiteral(".*"))); }

    void jsonScalars_data();
    void jsonScalars();
    void jsonKeepsTheOrder();
    void jsonElementsAreOnLines();
    void jsonRoundTrips();
    void widths_data();
    void widths();
    void columnsLineUpInChinese();
    void everyErrorHasAnExitCode();
    void exitCodes_data();
    void exitCodes();
    void reportExitCodes_data();
    void reportExitCodes();
};

void TestCliOutput::jsonScalars_data()
{
    QTest::addColumn<QByteArray>("written");
    QTest::addColumn<QByteArray>("expected");
    const auto row = [](const char* name, const Json& json, const char* expected) {
        QTest::newRow(name) << json.compact() << QByteArray(expected);
    };
    row("null", {}, "null");
    row("true", true, "true");
    row("negative", -30719, "-30719");
    row("64 bits", std::numeric_limits<std::int64_t>::min(), "-9223372036854775808");
    row("tenths without dust", 74 * 0.1, "7.4");
    row("a step", 360.0 / 4096, "0.087890625");
    row("whole double", 180.0, "180");
    row("negative zero", -0.0, "0");
    row("no number", std::numeric_limits<double>::quiet_NaN(), "null");
    row("missing", std::optional<std::int64_t>(), "null");
    row("text", QStringLiteral("a\"b\\c"), R"("a\"b\\c")");
    row("control characters", QStringLiteral("\n\x1b"), R"("\u000a\u001b")");
    row("Chinese", QStringLiteral("舵机"), "\"舵机\"");
    row("beyond 16 bits", QString::fromUtf8("😀"), "\"😀\"");
    row("empty list", Json::Array{}, "[]");
    row("empty object", Json::object(), "{}");
}

void TestCliOutput::jsonScalars()
{
    QFETCH(QByteArray, written);
    QFETCH(QByteArray, expected);
    QCOMPARE(written, expected);
}

void TestCliOutput::jsonKeepsTheOrder()
{
    const Json json = Json::object().add("z", 1).add("a", QStringList{QStringLiteral("x")});
    QCOMPARE(json.compact(), QByteArray(R"({"z": 1, "a": ["x"]})"));
}

void TestCliOutput::jsonElementsAreOnLines()
{
    Json::Array rows{Json::object().add("id", 1), Json::object().add("id", 2)};
    QCOMPARE(Json::object().add("rows", rows).text(),
             QByteArray("{\n  \"rows\": [\n    {\"id\": 1},\n    {\"id\": 2}\n  ]\n}\n"));
}

void TestCliOutput::jsonRoundTrips()
{
    const QString text = QString::fromUtf8("\t\"{[,]}\"\u007f\u2028 %1 舵");
    const Json json =
        Json::object().add("list", Json::Array{Json(text), Json(0.1), Json(), Json(false)});
    const QJsonArray list =
        QJsonDocument::fromJson(json.text()).object()[QLatin1String("list")].toArray();
    QCOMPARE(list.size(), 4);
    QCOMPARE(list[0].toString(), text);
    QCOMPARE(list[1].toDouble(), 0.1);
    QVERIFY(list[2].isNull());
    QCOMPARE(list[3].toBool(true), false);
}

void TestCliOutput::widths_data()
{
    QTest::addColumn<QString>("text");
    QTest::addColumn<int>("width");
    QTest::newRow("plain") << QStringLiteral("abc") << 3;
    QTest::newRow("Chinese") << QStringLiteral("舵机 1") << 6;
    QTest::newRow("full-width punctuation") << QStringLiteral("（）：") << 6;
    QTest::newRow("degree and dash") << QStringLiteral("90°–") << 4;
    QTest::newRow("combining accent") << QString::fromUtf8("e\u0301") << 1;
    QTest::newRow("emoji") << QString::fromUtf8("😀") << 2;
    QTest::newRow("empty") << QString() << 0;
}

void TestCliOutput::widths()
{
    QFETCH(QString, text);
    QFETCH(int, width);
    QCOMPARE(cli::displayWidth(text), width);
    QCOMPARE(cli::displayWidth(cli::padded(text, 10)), 10);
    QCOMPARE(cli::displayWidth(cli::padded(text, 10, true)), 10);
}

void TestCliOutput::columnsLineUpInChinese()
{
    cli::Table table({QStringLiteral("ID"), QStringLiteral("名称"), QStringLiteral("v")});
    table.alignRight({0});
    table.add({QStringLiteral("1"), QStringLiteral("位置"), QStringLiteral("x")});
    table.add({QStringLiteral("12"), QStringLiteral("ab"), QStringLiteral("y")});
    QCOMPARE(table.text(), QStringLiteral("ID  名称  v\n 1  位置  x\n12  ab    y\n"));
}

void TestCliOutput::everyErrorHasAnExitCode()
{
    QSet<int> used;
    for (int code = 0; code <= int(ErrorCode::DiskFull); ++code) {
        const int exit = cli::exitCode(ErrorCode(code));
        QVERIFY(exit >= 1 && exit <= 5);
        used.insert(exit);
    }
    QCOMPARE(used.size(), 5);
}

void TestCliOutput::exitCodes_data()
{
    QTest::addColumn<int>("code");
    QTest::addColumn<int>("exit");
    const auto row = [](ErrorCode code, int exit) {
        QTest::newRow(qPrintable(base::errorName(code))) << int(code) << exit;
    };
    row(ErrorCode::Refused, 1);
    row(ErrorCode::Mismatch, 1);
    row(ErrorCode::LockOpen, 1);
    row(ErrorCode::IdInUse, 1);
    row(ErrorCode::BadArgument, 2);
    row(ErrorCode::NeedsConsent, 2);
    row(ErrorCode::PortMissing, 3);
    row(ErrorCode::LinkLost, 3);
    row(ErrorCode::NoReply, 4);
    row(ErrorCode::Garbled, 4);
    row(ErrorCode::FileMissing, 5);
    row(ErrorCode::DiskFull, 5);
}

void TestCliOutput::exitCodes()
{
    QFETCH(int, code);
    QFETCH(int, exit);
    QCOMPARE(int(cli::exitCode(ErrorCode(code))), exit);
}

void TestCliOutput::reportExitCodes_data()
{
    using device::LockState;
    using device::WriteOutcome;
    QTest::addColumn<device::WriteReport>("report");
    QTest::addColumn<int>("exit");
    const auto row = [](const char* name, std::vector<WriteOutcome> outcomes, LockState lock,
                        int exit, std::optional<ErrorCode> error = {}) {
        device::WriteReport report;
        report.lock = lock;
        for (const WriteOutcome outcome : outcomes) {
            device::WriteResult result;
            result.outcome = outcome;
            if (error)
                result.error = base::Error{*error};
            report.writes.push_back(result);
        }
        QTest::newRow(name) << report << exit;
    };
    row("kept", {WriteOutcome::Kept}, LockState::Closed, 0);
    row("temporary", {WriteOutcome::Temporary}, LockState::None, 0);
    row("kept, but open", {WriteOutcome::Kept}, LockState::Open, 1);
    row("kept, lock unknown", {WriteOutcome::Kept}, LockState::Unknown, 1);
    row("one refused", {WriteOutcome::Kept, WriteOutcome::Refused}, LockState::Closed, 1);
    row("mismatch", {WriteOutcome::Mismatch}, LockState::Closed, 1);
    row("silent", {WriteOutcome::NoReply}, LockState::Unknown, 4);
    row("silent half-way", {WriteOutcome::Kept, WriteOutcome::NoReply}, LockState::Unknown, 1);
    row("unplugged", {WriteOutcome::Unknown}, LockState::Unknown, 3, ErrorCode::LinkLost);
}

void TestCliOutput::reportExitCodes()
{
    QFETCH(device::WriteReport, report);
    QFETCH(int, exit);
    QCOMPARE(int(cli::exitCode(report)), exit);
}

SERVODESK_GUILESS_TEST(TestCliOutput)
#include "tst_cli_output.moc"
