// SPDX-License-Identifier: GPL-3.0-or-later
// One run of the program: what the global options say, and what commands share — the session, the
// open port, notices, and how results are shown. Main thread. connect() and servo() open the port
// when first needed.
#pragma once

#include "cli/command.h"
#include "cli/output/console.h"
#include "session/session.h"

namespace cli {
struct Globals {
    QString port;
    std::optional<int> baud;                ///< none: the usual rate
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
    /// For a command that lists open changes itself; before connect().
    void listsOpenChanges() { m_listsOpenChanges = true; }
    /// Its canonical name; empty before connect() has chosen one.
    QString portName() const;
    /// Of this servo, on this port, since before this run.
    bool hasOpenChange(int id) const;
    /// What to type to finish or undo changes that are open on this port.
    QString recoverCommand() const;
    /// Says so if what has been read from it until now looks as if a second servo answered.
    void reportDuplicates(const device::Servo& servo);

    /// Connects first. Valid while the run lives.
    base::Result<device::Context> context();
    /// The servo that answers to `id`, identified; with --baud auto at whatever rate.
    base::Result<device::Servo> servo(int id);
    /// The same with its settings read, so that values have their right units.
    base::Result<device::Servo> servoWithSettings(int id);
    /// The one that the positional "ID" names.
    base::Result<device::Servo> servo(const Values& values);
    base::Result<device::Servo> servoWithSettings(const Values& values);

    /// Before anything is written to its memory: the whole table to a file and to the history, once
    /// a run. Says where; finish() says it in the document. What cannot be read is not written to.
    base::Result<void> backupTable(device::Servo& servo);
    /// For commands whose document is a file of its own: said on stderr in JSON mode too.
    base::Result<void> backupTableAndReport(device::Servo& servo);
    base::Result<void> backupTable(const device::Context& context, device::Servo& servo);
    /// Shows the result: the document with the notices in JSON mode, else the text and the notices.
    void finish(Json document, const QString& text);
    /// The notices since the last call, as lines.
    QString takeNotices();
    /// The document of a command that has failed: the error with the notices in JSON mode, else the
    /// notices as text and the error on stderr. What was saved first and is of no use is removed.
    void fail(const base::Error& error);
    /// Only used by commands that write their document piece by piece.
    Json takeNoticesAsJson();

    /// A change was made whose end the history could not take.
    bool hasUnrecordedChange() const;

    /// For commands whose port is not the user's choice (tour).
    void setDefaultPort(const QString& port);

private:
    /// What was saved is taken away again if no change was begun.
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
    Json::Array m_warnings;                       ///< said on stderr already; for the document
    std::vector<base::Intent> m_openChanges;      ///< on this port
    QString m_port;                               ///< as chosen
    std::vector<std::pair<int, QString>> m_saved; ///< ID and file
    std::unique_ptr<session::Session> m_session;
    std::unique_ptr<session::Connection> m_connection; ///< goes before the session
    bool m_rateFound = false;
    bool m_listsOpenChanges = false;
    bool m_notRecorded = false; ///< said by notices that were taken
};
} // namespace cli
