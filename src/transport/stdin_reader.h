// SPDX-License-Identifier: GPL-3.0-or-later
// Lines typed or piped into standard input, read without waiting. One owner,
// one thread. A program in the background of a terminal does not ask it (that would stop the
// program). Where the system has no poll() nothing is ever read.
#pragma once

#include <QByteArray>

#include <optional>

namespace transport {
class StdinReader {
public:
    /// The next whole line, without its end and the blanks around it; nullopt: none yet.
    std::optional<QByteArray> readLine();
    bool isOpen() const { return m_open; } ///< false: nothing more will come
    /// What was typed before a question came. What is piped was written as an answer and stays.
    void discardTyped();

private:
    void readAvailable();

    QByteArray m_text;
    bool m_open = true;
};
} // namespace transport
