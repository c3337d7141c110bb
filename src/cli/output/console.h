// SPDX-License-Identifier: GPL-3.0-or-later
// The output of the program: results on stdout, everything else on stderr, in UTF-8 with every
// locale. Text passes through terminalSafe(), so that no file or device can send commands to the
// terminal. Owned by main; main thread. A failed write ends nothing; writeError() reports it for
// the exit code.
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

    /// A text on stdout; nothing in JSON mode.
    void print(const QString& text);
    /// A document on stdout: unchanged bytes, but made safe on a terminal.
    void write(const QByteArray& bytes);
    /// Replaces the lines above, on a terminal.
    void rewrite(int linesAbove, const QStringList& lines);
    /// A line on stderr.
    void printMessage(const QString& line);
    /// The same, but nothing in JSON mode, where the document contains it.
    void printNote(const QString& line);

    /// Replaces the line that shows the progress of a task; only on a terminal.
    void showStatus(const QString& line);

    bool isStdoutTerminal() const;
    bool isStderrTerminal() const;
    bool isStderrFile() const; ///< on a disk, not a pipe
    int terminalWidth() const; ///< of the terminal of stdout; 0 if unknown

    /// errno of the first failure to write on stdout.
    std::optional<int> writeError() const { return m_failure; }

private:
    void writeBytes(const QByteArray& bytes);

    bool m_json = false;
    std::optional<int> m_failure;
};
} // namespace cli
