// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/console.h"

#include <QtGlobal>

#include <cerrno>
#include <cstdio>

#ifdef Q_OS_UNIX
#include <sys/ioctl.h>
#include <unistd.h>
#endif

namespace cli {
namespace {
bool isTerminal(int descriptor)
{
#ifdef Q_OS_UNIX
    return isatty(descriptor) == 1;
#else
    Q_UNUSED(descriptor)
    return false;
#endif
}
} // namespace

void Console::print(const QString& text)
{
    if (!m_json)
        write(text.toUtf8());
}

void Console::write(const QByteArray& bytes)
{
    if (m_failure)
        return;
    const auto size = static_cast<std::size_t>(bytes.size());
    if (std::fwrite(bytes.constData(), 1, size, stdout) != size || std::fflush(stdout) != 0)
        m_failure = errno;
}

void Console::say(const QString& line)
{
    // What was typed is repeated in complaints; a terminal must not take it for commands.
    QByteArray bytes = line.toUtf8() + '\n';
    for (char& byte : bytes) {
        const auto code = static_cast<unsigned char>(byte);
        if ((code < 0x20 && byte != '\n') || code == 0x7f)
            byte = '?';
    }
    std::fwrite(bytes.constData(), 1, static_cast<std::size_t>(bytes.size()), stderr);
}

void Console::remark(const QString& line)
{
    if (!m_json)
        say(line);
}

bool Console::resultTerminal() const
{
    return isTerminal(1);
}

bool Console::remarkTerminal() const
{
    return isTerminal(2);
}

int Console::terminalWidth() const
{
#ifdef Q_OS_UNIX
    winsize size{};
    if (ioctl(1, TIOCGWINSZ, &size) == 0)
        return size.ws_col;
#endif
    return 0;
}
} // namespace cli
