// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/output/console.h"

#include "cli/output/terminal_text.h"

#include <QtGlobal>

#include <cerrno>
#include <cstdio>

#ifdef Q_OS_UNIX
#include <sys/ioctl.h>
#include <sys/stat.h>
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

const QString clearLine = QStringLiteral("\r\033[K");

void put(const QString& text)
{
    const QByteArray bytes = text.toUtf8();
    std::fwrite(bytes.constData(), 1, static_cast<std::size_t>(bytes.size()), stderr);
    std::fflush(stderr);
}
} // namespace

void Console::print(const QString& text)
{
    if (!m_json)
        writeBytes(terminalSafe(text).toUtf8());
}

void Console::write(const QByteArray& bytes)
{
    writeBytes(isStdoutTerminal() ? terminalSafe(QString::fromUtf8(bytes)).toUtf8() : bytes);
}

void Console::rewrite(int linesAbove, const QStringList& lines)
{
    QString screen = linesAbove > 0 ? QStringLiteral("\033[%1A").arg(linesAbove) : QString();
    for (const QString& line : lines)
        screen += clearLine + terminalSafe(line) + QLatin1Char('\n');
    if (!m_json)
        writeBytes(screen.toUtf8());
}

void Console::writeBytes(const QByteArray& bytes)
{
    if (m_failure)
        return;
    const auto size = static_cast<std::size_t>(bytes.size());
    if (std::fwrite(bytes.constData(), 1, size, stdout) != size || std::fflush(stdout) != 0)
        m_failure = errno;
}

void Console::printMessage(const QString& line)
{
    put((isStderrTerminal() ? clearLine : QString()) + terminalSafe(line) + QLatin1Char('\n'));
}

void Console::showStatus(const QString& line)
{
    if (isStderrTerminal())
        put(clearLine + terminalSafe(line));
}

void Console::printNote(const QString& line)
{
    if (!m_json)
        printMessage(line);
}

bool Console::isStdoutTerminal() const
{
    return isTerminal(1);
}

bool Console::isStderrTerminal() const
{
    return isTerminal(2);
}

bool Console::isStderrFile() const
{
#ifdef Q_OS_UNIX
    struct stat about {};
    return fstat(2, &about) == 0 && S_ISREG(about.st_mode);
#else
    return false;
#endif
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
