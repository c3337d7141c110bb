// SPDX-License-Identifier: GPL-3.0-or-later
// Every example of the help runs as it is printed: on simulated servos with a new data folder, and
// in the order of the list, so that later ones find what earlier ones have saved.
#include "cli/examples.h"
#include "history/history_file.h"
#include "support/cli_program.h"
#include "support/test_main.h"

#include <QTest>

using support::CliProgram;
using support::ProgramResult;

class TestCliExamples : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void everyExampleRuns();

private:
    void makeSnapshotsOlder();

    QTemporaryDir m_folder;
    CliProgram m_cli;
};

namespace {
/// The servos that an example needs, where those of the demo do not serve.
QString portFor(const QString& line)
{
    if (line.startsWith(QLatin1String("commission")))
        return QStringLiteral("sim:line");
    if (line.startsWith(QLatin1String("restore-defaults")))
        return QStringLiteral("sim:sts3215@1");
    if (line.startsWith(QLatin1String("firmware rescue")))
        return QStringLiteral("sim:sts3215@1+firmware-lost=1");
    if (line.startsWith(QLatin1String("firmware update")))
        return line.contains(QLatin1String("other-servos"))
                   ? QStringLiteral("sim:sts3215@1,sts3215@2")
                   : QStringLiteral("sim:sts3215@1");
    if (line.startsWith(QLatin1String("arm")))
        return QStringLiteral("sim:so101");
    if (line.contains(QLatin1String("tour")))
        return {}; // names its own
    return QStringLiteral("sim:demo");
}
} // namespace

void TestCliExamples::everyExampleRuns()
{
    m_cli.setWorkingFolder(m_folder.path());
    QFile image(m_folder.filePath(QStringLiteral("SCServo21-GD32-TTL-250306.bin")));
    QVERIFY(image.open(QIODevice::WriteOnly));
    image.write(QByteArray(1000, 'x'));
    image.close();
    for (const cli::Examples& one : cli::allExamples()) {
        if (qstrcmp(one.command, "history sync") == 0)
            continue; // needs a server: tst_history_sender runs it
        if (qstrcmp(one.command, "history table") == 0)
            makeSnapshotsOlder();
        for (const char* example : {one.first, one.second}) {
            const QString line = QString::fromLatin1(example);
            m_cli.setPort(portFor(line));
            const ProgramResult result = m_cli.run(QProcess::splitCommand(line));
            QVERIFY2(result.exit == 0, qPrintable(line + u'\n' + result.out + result.err));
            QVERIFY2(!result.out.isEmpty(), example);
        }
    }
    for (const char* name :
         {"arm.csv", "arm.pdf", "arm.html", "knee.pdf", "sweep.html", "sweep.pdf", "sweep.csv",
          "compared.html", "step.html", "gains.html", "knee.servo.json", "arm.bundle.json",
          "gains.servo.json", "then.servo.json", "alarms.csv", "so101.json", "my-arm.json"})
        QVERIFY2(QFile::exists(m_folder.filePath(QLatin1String(name))), name);
}

/// The examples ask for hours ago.
void TestCliExamples::makeSnapshotsOlder()
{
    const auto file = history::HistoryFile::open(m_cli.historyFile(), std::chrono::seconds(10));
    QVERIFY(file);
    QVERIFY((*file)->run(QStringLiteral("UPDATE snapshots SET at = at - 24 * 3600 * 1000"), {}));
}

SERVODESK_GUILESS_TEST(TestCliExamples)
#include "tst_cli_examples.moc"
