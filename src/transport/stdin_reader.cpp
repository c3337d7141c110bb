// SPDX-License-Identifier: GPL-3.0-or-later
#include "transport/stdin_reader.h"

#include <QtGlobal>

#ifdef Q_OS_UNIX
#include <poll.h>
#include <termios.h>
#include <unistd.h>
#endif

namespace transport {
#ifdef Q_OS_UNIX
namespace {
bool isInBackground()
{
    return isatty(STDIN_FILENO) == 1 && tcgetpgrp(STDIN_FILENO) != getpgrp();
}
} // namespace
#endif

void StdinReader::discardTyped()
{
#ifdef Q_OS_UNIX
    if (isatty(STDIN_FILENO) != 1 || isInBackground())
        return;
    tcflush(STDIN_FILENO, TCIFLUSH);
    m_text.clear();
#endif
}

void StdinReader::readAvailable()
{
#ifdef Q_OS_UNIX
    if (isInBackground())
        return;
    pollfd input{STDIN_FILENO, POLLIN, 0};
    if (poll(&input, 1, 0) <= 0)
        return;
    char bytes[256];
    const auto count = read(STDIN_FILENO, bytes, sizeof bytes);
    if (count > 0) {
        m_text += QByteArray(bytes, static_cast<qsizetype>(count));
        return;
    }
#endif
    m_open = false;
    if (!m_text.isEmpty())
        m_text += '\n'; // the last line may lack its end
}

std::optional<QByteArray> StdinReader::readLine()
{
    if (m_open && !m_text.contains('\n'))
        readAvailable();
    const auto end = m_text.indexOf('\n');
    if (end < 0)
        return std::nullopt;
    const QByteArray line = m_text.left(end).simplified();
    m_text.remove(0, end + 1);
    return line;
}
} // namespace transport
