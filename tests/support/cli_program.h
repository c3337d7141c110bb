// SPDX-License-Identifier: GPL-3.0-or-later
// The built programs as a user runs them: servodesk-cli with a data folder of its own, and
// servodesk-sim behind a pseudo-terminal. One thread.
#pragma once

#include <QJsonObject>
#include <QProcess>
#include <QStringList>
#include <QTemporaryDir>

#include <cstdint>

namespace support {
/// Blanks separate, as in a shell without quotes.
QStringList words(const char* line);

struct ProgramResult {
    int exit = -1;
    QString out;
    QString err;

    /// stdout as one JSON document; an object without members if it is anything else.
    QJsonObject json() const;
    QString errorCode() const; ///< of that document
};

class CliProgram {
public:
    CliProgram();

    void setPort(const QString& port) { m_port = port; }
    /// Options for every command, ahead of it.
    void setGlobals(const QStringList& options) { m_globals = options; }
    void setEnvironment(const QString& name, const QString& value);
    /// Simulated servos in the program, whose settings are kept from one command to the next, as if
    /// their supply were switched off in between.
    void setServos(const QString& servos);
    void setWorkingFolder(const QString& path) { m_process.setWorkingDirectory(path); }
    QString dataFolder() const { return m_data.path(); }
    QString historyFile() const { return dataFolder() + QStringLiteral("/history.sqlite"); }
    int
    openIntents() const; ///< writes that have begun but not ended; -1: the history is unreadable

    ProgramResult run(const QStringList& arguments);
    ProgramResult run(const char* line) { return run(words(line)); }
    ProgramResult json(const char* line) { return run(words(line) << QStringLiteral("--json")); }

    /// Skipped: nothing is waited for on a simulated bus (base::SkippingClock), as in run().
    enum class Time : std::uint8_t { Real, Skipped };
    /// Starts it and comes back; for Ctrl-C.
    void start(const QStringList& arguments, Time time = Time::Real);
    QProcess& process() { return m_process; }
    bool waitForOutput(const QByteArray& text); ///< on stdout
    bool waitForError(const QByteArray& text);  ///< on stderr
    void signal(int number);
    ProgramResult finish();

private:
    bool waitFor(const QByteArray& seen, const QByteArray& text);
    void collect();

    QTemporaryDir m_data;
    QStringList m_globals;
    QString m_port = QStringLiteral("sim:demo");
    QProcessEnvironment m_environment;
    QProcess m_process;
    QByteArray m_out;
    QByteArray m_err;
};

class SimProgram {
public:
    explicit SimProgram(const QStringList& arguments);
    ~SimProgram() { end(); }

    QString port() const { return m_port; } ///< empty if it did not start
    void end();

private:
    QProcess m_process;
    QString m_port;
};
} // namespace support
