// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/cli_program.h"

#include "history/history_journal.h"
#include "support/simulator_priority.h"

#include <QCoreApplication>
#include <QFile>
#include <QJsonDocument>

#include <csignal>

namespace support {
namespace {
constexpr int timeoutMs = 60'000; ///< only a hung program ever needs it

QString program(const char* name)
{
    // Tests are built beside bin.
    return QCoreApplication::applicationDirPath() + QStringLiteral("/../bin/") +
           QLatin1String(name);
}

/// Only simulated servos in the program itself keep its clock.
bool usesOtherPort(const QStringList& arguments)
{
    const auto option = arguments.lastIndexOf(QStringLiteral("--port"));
    return option >= 0 && !arguments.value(option + 1).startsWith(QLatin1String("sim:"));
}
} // namespace

QStringList words(const char* line)
{
    return QString::fromUtf8(line).split(QLatin1Char(' '), Qt::SkipEmptyParts);
}

QJsonObject ProgramResult::json() const
{
    return QJsonDocument::fromJson(out.toUtf8()).object();
}

QString ProgramResult::errorCode() const
{
    return json()[QLatin1String("error")][QLatin1String("code")].toString();
}

CliProgram::CliProgram()
    : m_environment(QProcessEnvironment::systemEnvironment())
{
    for (const char* name : {"LC_ALL", "LC_MESSAGES", "LANGUAGE"})
        m_environment.remove(QLatin1String(name));
    setEnvironment(QStringLiteral("LANG"), QStringLiteral("C.UTF-8"));
    setEnvironment(QStringLiteral("SERVODESK_DATA_DIR"), m_data.path());
    setEnvironment(QStringLiteral("XDG_CONFIG_HOME"), m_data.filePath(QStringLiteral("config")));
}

int CliProgram::openIntents() const
{
    const history::HistoryJournal journal(historyFile(), {});
    const auto open = journal.open();
    return open ? int(open->size()) : -1;
}

void CliProgram::setEnvironment(const QString& name, const QString& value)
{
    m_environment.insert(name, value);
}

void CliProgram::setServos(const QString& servos)
{
    const QString eproms = m_data.filePath(QStringLiteral("eproms"));
    QFile::remove(eproms); // of other servos
    setPort(QStringLiteral("sim:") + servos);
    setEnvironment(QStringLiteral("SERVODESK_SIM_STATE"), eproms);
}

void CliProgram::start(const QStringList& arguments, Time time)
{
    m_out.clear();
    m_err.clear();
    QStringList all = m_globals + arguments;
    if (!m_port.isEmpty())
        all << QStringLiteral("--port") << m_port;
    QProcessEnvironment environment = m_environment;
    const QString speed = QStringLiteral("SERVODESK_CLOCK_SPEED");
    if (time == Time::Real || usesOtherPort(all))
        environment.remove(speed);
    else
        environment.insert(speed, QStringLiteral("skip"));
    m_process.setProcessEnvironment(environment);
    m_process.start(program("servodesk-cli"), all);
    m_process.waitForStarted(timeoutMs);
}

void CliProgram::collect()
{
    m_out += m_process.readAllStandardOutput();
    m_err += m_process.readAllStandardError();
}

bool CliProgram::waitFor(const QByteArray& seen, const QByteArray& text)
{
    // In slices, because data on the other channel does not end the wait.
    constexpr int sliceMs = 50;
    for (int waited = 0; waited < timeoutMs; waited += sliceMs) {
        collect();
        if (seen.contains(text))
            return true;
        if (m_process.state() == QProcess::NotRunning)
            return false;
        m_process.waitForReadyRead(sliceMs);
    }
    return false;
}

bool CliProgram::waitForOutput(const QByteArray& text)
{
    return waitFor(m_out, text);
}

bool CliProgram::waitForError(const QByteArray& text)
{
    return waitFor(m_err, text);
}

void CliProgram::signal(int number)
{
    // 0 is the ID of no program, and would reach the test itself.
    if (m_process.processId() > 0)
        ::kill(static_cast<pid_t>(m_process.processId()), number);
}

ProgramResult CliProgram::finish()
{
    m_process.closeWriteChannel();
    const bool ended =
        m_process.state() == QProcess::NotRunning || m_process.waitForFinished(timeoutMs);
    collect();
    const bool normal = ended && m_process.exitStatus() == QProcess::NormalExit;
    return {normal ? m_process.exitCode() : -1, QString::fromUtf8(m_out), QString::fromUtf8(m_err)};
}

ProgramResult CliProgram::run(const QStringList& arguments)
{
    start(arguments, Time::Skipped);
    return finish();
}

SimProgram::SimProgram(const QStringList& arguments)
{
    raisePriority(m_process);
    m_process.start(program("servodesk-sim"), arguments);
    if (!m_process.waitForReadyRead(timeoutMs))
        return;
    const QString line = QString::fromUtf8(m_process.readLine()).trimmed();
    if (line.startsWith(QLatin1String("port: ")))
        m_port = line.mid(6);
}

void SimProgram::end()
{
    if (m_process.state() == QProcess::NotRunning)
        return;
    m_process.terminate();
    m_process.waitForFinished(timeoutMs);
}
} // namespace support
