// SPDX-License-Identifier: GPL-3.0-or-later
// What the window costs while nobody does anything: the share of a core that the program takes with
// six servos behind a pseudo-terminal, on every page; without a connection; and after an unplug.
// Wanted: 12 % on Operate, 5 % on the other pages, 1 % without a connection. Linux.
#include "support/cli_program.h"
#include "support/test_paths.h"

#include <QCoreApplication>
#include <QFile>
#include <QTemporaryDir>
#include <QTextStream>
#include <QThread>

#include <unistd.h>

namespace {
constexpr int settleSeconds = 6; ///< search and the first reading of a table
constexpr int measuredSeconds = 6;
constexpr double operateLimit = 12;
constexpr double pageLimit = 5;
constexpr double idleLimit = 1;

QTextStream out(stdout);

/// Seconds of processor time so far: fields 14 and 15 of /proc/PID/stat.
double processorTime(qint64 process)
{
    QFile file(QStringLiteral("/proc/%1/stat").arg(process));
    if (!file.open(QIODevice::ReadOnly))
        qFatal("servodesk has ended");
    const QByteArray text = file.readAll();
    const QList<QByteArray> fields = text.mid(text.lastIndexOf(')') + 2).split(' ');
    return (fields[11].toDouble() + fields[12].toDouble()) / double(sysconf(_SC_CLK_TCK));
}

bool measure(const QString& page, bool unplugs, double limit)
{
    const QTemporaryDir home;
    support::SimProgram sim(support::words("--preset demo"));
    QProcess program;
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert(QStringLiteral("SERVODESK_DATA_DIR"), home.path());
    environment.insert(QStringLiteral("XDG_CONFIG_HOME"), home.path());
    environment.insert(QStringLiteral("QT_QPA_PLATFORM"), QStringLiteral("offscreen"));
    program.setProcessEnvironment(environment);
    program.setProcessChannelMode(QProcess::ForwardedErrorChannel);
    QStringList arguments{QStringLiteral("--size"), QStringLiteral("1280x800")};
    if (!page.isEmpty())
        arguments << QStringLiteral("--port") << sim.port() << QStringLiteral("--select")
                  << QStringLiteral("1") << QStringLiteral("--page") << page;
    program.start(QStringLiteral(BIN_DIR "/servodesk"), arguments);
    if (sim.port().isEmpty() || !program.waitForStarted())
        qFatal("the programs did not start");
    QThread::sleep(settleSeconds);
    if (unplugs) {
        sim.end();
        QThread::sleep(2);
    }
    const double before = processorTime(program.processId());
    QThread::sleep(measuredSeconds);
    const double percent = 100 * (processorTime(program.processId()) - before) / measuredSeconds;
    program.kill();
    program.waitForFinished();
    out << (page.isEmpty() ? QStringLiteral("not connected") : page)
        << (unplugs ? ", unplugged" : "") << ": " << qSetRealNumberPrecision(3) << percent
        << " % of a core (wanted <= " << limit << ")" << Qt::endl;
    return percent <= limit;
}
} // namespace

int main(int argc, char* argv[])
{
    const QCoreApplication app(argc, argv);
    bool isMet = measure(QStringLiteral("operate"), false, operateLimit);
    for (const char* page :
         {"memory", "sweep", "step", "snapshots", "commission", "firmware", "history"})
        isMet = measure(QLatin1String(page), false, pageLimit) && isMet;
    isMet = measure({}, false, idleLimit) && isMet;
    isMet = measure(QStringLiteral("operate"), true, idleLimit) && isMet;
    return isMet ? 0 : 1;
}
