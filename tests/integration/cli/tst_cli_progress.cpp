// SPDX-License-Identifier: GPL-3.0-or-later
// What a long command shows while it runs: on a terminal one line that is rewritten, with how much
// is done and how long it still takes; elsewhere nothing.
#include "jobs/job.h"
#include "support/cli_program.h"
#include "support/test_main.h"
#include "support/test_paths.h"

#include <QFile>
#include <QProcess>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QTest>

class TestCliProgress : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { QTest::failOnWarning(QRegularExpression(QStringLiteral(".*"))); }

    void aTerminalShowsOneLine();
    void aFileShowsNothing();
    void theTimeLeftFollowsTheTimeSoFar();
};

/// `script` runs a command on a terminal of its own and prints what appears there.
void TestCliProgress::aTerminalShowsOneLine()
{
    QProcess program;
    program.start(
        QStringLiteral("script"),
        {QStringLiteral("-qec"),
         QStringLiteral(BIN_DIR
                        "/servodesk-cli --port sim:demo --protocol feetech scan --bauds 4800"),
         QStringLiteral("/dev/null")});
    QVERIFY(program.waitForFinished(-1));
    const QString screen = QString::fromUtf8(program.readAllStandardOutput());
    static const QRegularExpression line(QStringLiteral(
        "\r\x1b\\[KSearching: [0-9]+ %, about ([0-9]+ min )?[0-9]+ s left, Feetech at 4800 baud"));
    QVERIFY2(screen.count(line) > 1, qPrintable(screen));
    static const QRegularExpression twoLines(QStringLiteral("Searching[^\r]*\r\n"));
    QVERIFY2(!screen.contains(twoLines), qPrintable(screen));
}

void TestCliProgress::aFileShowsNothing()
{
    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("log"));
    QProcess program;
    program.setStandardErrorFile(path);
    program.start(QStringLiteral(BIN_DIR "/servodesk-cli"),
                  support::words("--port sim:demo --protocol feetech scan --bauds 4800"));
    QVERIFY(program.waitForFinished(-1));
    QFile log(path);
    QVERIFY(log.open(QIODevice::ReadOnly));
    const QString written = QString::fromUtf8(log.readAll());
    QVERIFY(written.contains(QLatin1String("SIMULATED")));
    QVERIFY2(!written.contains(QLatin1String("Searching")), qPrintable(written));
    QVERIFY(!written.contains(QLatin1Char('\x1b')));
}

void TestCliProgress::theTimeLeftFollowsTheTimeSoFar()
{
    using std::chrono::seconds;
    using Estimate = std::optional<base::Duration>;
    jobs::TimeLeft left;
    QCOMPARE(left.estimate({0.2}, seconds(100)), Estimate()); // nothing to go by
    QCOMPARE(left.estimate({0.4}, seconds(110)), Estimate(seconds(30)));
    QCOMPARE(left.estimate({0.5, seconds(7)}, seconds(120)), Estimate(seconds(7)));
    QCOMPARE(left.estimate({1}, seconds(140)), Estimate(seconds(0)));
}

SERVODESK_GUILESS_TEST(TestCliProgress)
#include "tst_cli_progress.moc"
