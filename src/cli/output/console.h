// SPDX-License-Identifier: GPL-3.0-or-later
// Where the program writes: results to stdout, everything else to stderr. UTF-8 whatever the
// locale. What people read passes terminalSafe(), so that no file or device commands the terminal.
// Owned by main; main thread. A failure to write is remembered, not thrown: the command goes on and
// the exit code tells.
#pragma once

#include "cli/output/json.h"

#include <optional>

namespace cli {
class Console {
public:
    explicit Console(bool json)
        : m_json(json)
    {}

    bool isJson() const { return m_json; }

    /// Human result on stdout; nothing in JSON mode.
    void print(const QString& text);
    /// A document on stdout: its bytes as they are, but not on a terminal.
    void write(const QByteArray& bytes);
    /// Lines in place of those above them, on a terminal.
    void rewrite(int linesAbove, const QStringList& lines);
    /// A line on stderr.
    void printMessage(const QString& line);
    /// The same, but nothing in JSON mode, where the document says it.
    void printNote(const QString& line);

    /// The line that shows how far a task is, in place of the one before; on a terminal.
    void showStatus(const QString& line);

    bool isStdoutTerminal() const; ///< stdout is a terminal
    bool isStderrTerminal() const; ///< stderr is a terminal
    int terminalWidth() const;     ///< of stdout's terminal; 0 if not known

    /// errno of the first failure to write on stdout.
    std::optional<int> writeError() const { return m_failure; }

private:
    void writeBytes(const QByteArray& bytes);

    bool m_json = false;
    std::optional<int> m_failure;
};
} // namespace cli
