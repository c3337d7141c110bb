// SPDX-License-Identifier: GPL-3.0-or-later
// The built command line and hostile files: their content never controls the terminal, and only
// regular files are read.
#include "support/cli_program.h"
#include "support/port_endpoints.h"
#include "support/test_main.h"

#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QRegularExpression>
#include <QTest>

#include <algorithm>
#include <sys/stat.h>

using support::CliProgram;
using support::ProgramResult;
using support::words;

namespace {
/// Clears the screen, sets the title (as C0 and as C1), reverses the text, begins a new row.
const QString hostile = QStringLiteral(
    "a\033[2J\033]0;owned\007b\u009b2Jc\u202ed\u200ee\u061c\rfaked\n1  STS3215  all is well");

/// Without control characters except line feeds.
bool isHarmless(const QString& text)
{
    return std::all_of(text.begin(), text.end(), [](QChar c) {
        const char16_t code = c.unicode();
        return code == '\n' || (code >= 0x20 && !(code >= 0x7f && code < 0xa0) && code != 0x202e &&
                                code != 0x200e && code != 0x061c);
    });
}

QString hostileSnapshot(CliProgram& cli)
{
    const QString path = cli.dataFolder() + QStringLiteral("/hostile.servo.json");
    if (cli.run(words("snapshot save 1") << path).exit != 0)
        return {};
    QFile file(path);
    if (!file.open(QIODevice::ReadWrite))
        return {};
    QJsonObject snapshot = QJsonDocument::fromJson(file.readAll()).object();
    snapshot[QStringLiteral("label")] = hostile;
    snapshot[QStringLiteral("note")] = hostile;
    QJsonObject servo = snapshot[QStringLiteral("servo")].toObject();
    servo[QStringLiteral("model")] = hostile;
    snapshot[QStringLiteral("servo")] = servo;
    file.resize(0);
    file.write(QJsonDocument(snapshot).toJson());
    return path;
}
/// The output if stdout is a terminal.
QByteArray runOnTerminal(CliProgram& cli, const QStringList& line)
{
    const support::Terminal terminal = support::makeTerminal(O_NONBLOCK);
    cli.process().setChildProcessModifier([&terminal] { dup2(terminal.slave, STDOUT_FILENO); });
    cli.start(line);
    QByteArray seen;
    const auto take = [&] {
        char chunk[4096];
        for (ssize_t got = 0; (got = read(terminal.master, chunk, sizeof chunk)) > 0;)
            seen.append(chunk, got);
    };
    while (cli.process().state() != QProcess::NotRunning && !cli.process().waitForFinished(10))
        take();
    take();
    close(terminal.slave);
    close(terminal.master);
    return seen;
}
} // namespace

class TestCliTerminal : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { QTest::failOnWarning(QRegularExpression(QStringLiteral(".*"))); }

    void fileNamesAreEscaped();
    void documentContentIsEscaped();
    void argumentsAreEscaped();
    void nonFilesAreNotRead_data();
    void nonFilesAreNotRead();
};

void TestCliTerminal::fileNamesAreEscaped()
{
    CliProgram cli;
    const QString path = hostileSnapshot(cli);
    QVERIFY(!path.isEmpty());
    const ProgramResult text =
        cli.run(QStringList{QStringLiteral("snapshot"), QStringLiteral("show"), path});
    QCOMPARE(text.exit, 0);
    QVERIFY(text.out.contains(QStringLiteral("owned")));
    QVERIFY2(isHarmless(text.out + text.err), qPrintable(text.out));

    const ProgramResult json = cli.run(QStringList{
        QStringLiteral("snapshot"), QStringLiteral("show"), path, QStringLiteral("--json")});
    QVERIFY2(isHarmless(json.out), qPrintable(json.out));
    QCOMPARE(json.json()[QLatin1String("label")].toString(), hostile); // and nothing is lost

    const ProgramResult diff = cli.run(
        QStringList{QStringLiteral("snapshot"), QStringLiteral("diff"), path, QStringLiteral("1")});
    QVERIFY2(isHarmless(diff.out + diff.err), qPrintable(diff.out + diff.err));
}

/// Documents are written unchanged to a file, but not to a terminal.
void TestCliTerminal::documentContentIsEscaped()
{
    CliProgram cli;
    const QString path = hostileSnapshot(cli);
    QVERIFY(!path.isEmpty());
    const QStringList line{QStringLiteral("snapshot"), QStringLiteral("show"), path,
                           QStringLiteral("--csv")};
    const ProgramResult piped = cli.run(line);
    QVERIFY(!isHarmless(QString(piped.out).remove(u'\r')));

    const QByteArray seen = runOnTerminal(cli, line);
    QVERIFY2(seen.contains("owned"), seen.constData());
    QVERIFY2(isHarmless(QString::fromUtf8(seen)), seen.constData());
}

void TestCliTerminal::argumentsAreEscaped()
{
    CliProgram cli;
    const ProgramResult result =
        cli.run(QStringList{QStringLiteral("read"), QStringLiteral("1"), hostile});
    QCOMPARE(result.exit, 2);
    QVERIFY2(isHarmless(result.err), qPrintable(result.err));
}

void TestCliTerminal::nonFilesAreNotRead_data()
{
    QTest::addColumn<QString>("command");
    for (const char* command :
         {"snapshot show %1", "snapshot diff %1 %1", "snapshot restore 1 %1", "template apply %1 1",
          "bundle restore %1", "sweep 1 --points %1",
          "sweep 1 --from 1000 --to 2000 --delay 500 --limits %1", "sweep-compare %1 %1"})
        QTest::newRow(command) << QString::fromLatin1(command);
}

void TestCliTerminal::nonFilesAreNotRead()
{
    QFETCH(const QString, command);
    CliProgram cli;
    const QString pipe = cli.dataFolder() + QStringLiteral("/pipe");
    QCOMPARE(mkfifo(qPrintable(pipe), 0600), 0);
    const QString huge = cli.dataFolder() + QStringLiteral("/huge");
    QFile file(huge);
    QVERIFY(file.open(QIODevice::WriteOnly) && file.resize(qint64(1) << 36)); // sparse
    for (const QString& path : {pipe, QStringLiteral("/dev/zero"), cli.dataFolder(), huge}) {
        const ProgramResult result = cli.run(command.arg(path).split(QLatin1Char(' ')));
        QVERIFY2(result.exit == 5, qPrintable(path + result.out + result.err));
    }
}

SERVODESK_GUILESS_TEST(TestCliTerminal)
#include "tst_cli_terminal.moc"
