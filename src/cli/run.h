// SPDX-License-Identifier: GPL-3.0-or-later
// One run of the program: the global options, and what commands share: the session, the port,
// notices, and the printing of results. Created by runProgram(); main thread. connect() and servo()
// open the port when it is first needed.
#pragma once

#include "cli/command.h"
#include "cli/output/console.h"
#include "session/session.h"

namespace cli {
struct Globals {
    QString port;
    std::optional<int> baud;                ///< none: the default
    bool autoBaud = false;                  ///< --baud auto
    std::optional<base::Protocol> protocol; ///< none: auto
    std::optional<base::Duration> maxReplyLateness;
    std::optional<base::Duration> frameSilence; ///< between Modbus frames
    std::optional<int> retries;
};

class Run {
public:
    Run(Globals globals, Console& console, const base::StopToken& stop);

    Console& console() { return m_console; }
    const Globals& globals() const { return m_globals; }
    const base::StopToken& stop() const { return m_stop; }
    session::Session& session();

    base::Result<session::Connection*> connect();
    /// What the global options ask of this port.
    session::PortRequest requestFor(const QString& port) const;
    /// For a command that lists unfinished changes itself; to be called before connect().
    void listsOpenChanges() { m_listsOpenChanges = true; }
    /// The canonical name of the port; empty before connect().
    QString portName() const;
    /// Whether an earlier run left a change to this servo on this port unfinished.
    bool hasOpenChange(int id) const;
    /// The command that finishes or undoes unfinished changes on this port.
    QString recoverCommand() const;
    /// Warns if the replies so far show that a second servo has the same ID.
    void reportDuplicates(const device::Servo& servo);

    /// Connects first. Valid while this object exists.
    base::Result<device::Context> context();
    /// Identifies the servo with this ID; with --baud auto at any baud rate.
    base::Result<device::Servo> servo(int id);
    /// The same with its settings read, which determine the units of values.
    base::Result<device::Servo> servoWithSettings(int id);
    /// The servo of the positional "ID".
    base::Result<device::Servo> servo(const Values& values);
    base::Result<device::Servo> servoWithSettings(const Values& values);

    /// To be called before the first write to a servo: saves the whole table to a file and to the
    /// history, once per run. Prints the file name; finish() adds it to the document. If the table
    /// cannot be read, nothing may be written.
    base::Result<void> backupTable(device::Servo& servo);
    /// For commands whose document is a separate file: prints the file name in JSON mode too.
    base::Result<void> backupTableAndReport(device::Servo& servo);
    base::Result<void> backupTable(const device::Context& context, device::Servo& servo);
    /// Prints the result: in JSON mode the document with the notices, else the text and the
    /// notices.
    void finish(Json document, const QString& text);
    /// The notices since the last call, as lines.
    QString takeNotices();
    /// Prints the error: in JSON mode a document with the notices, else the notices on stdout and
    /// the error on stderr. Removes saved tables if nothing was written.
    void fail(const base::Error& error);
    /// For commands that write their document in parts.
    Json takeNoticesAsJson();

    /// Whether the history could not record the end of a change.
    bool hasUnrecordedChange() const;

    /// For commands that need no --port (tour).
    void setDefaultPort(const QString& port);

private:
    /// Removes the saved tables if no write was begun.
    void removeUnusedSnapshots();
    void addSaved(Json& document) const;
    void removeRepeatedNotices();
    base::Result<QString> choosePort();
    void warn(const char* code, int id, const QString& text);
    void warnOfOpenChanges();
    base::Result<device::Servo> findRate(const device::Context& context, int id);

    Globals m_globals;
    Console& m_console;
    const base::StopToken& m_stop;
    device::Notices m_notices;
    Json::Array m_warnings;                       ///< for the document; already printed on stderr
    std::vector<base::Intent> m_openChanges;      ///< on this port
    QString m_port;                               ///< as chosen
    std::vector<std::pair<int, QString>> m_saved; ///< ID and file
    std::unique_ptr<session::Session> m_session;
    std::unique_ptr<session::Connection> m_connection; ///< destroyed before the session
    bool m_rateFound = false;
    bool m_listsOpenChanges = false;
    bool m_notRecorded = false; ///< a notice has reported it
};
} // namespace cli
