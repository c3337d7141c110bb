// SPDX-License-Identifier: GPL-3.0-or-later
#include "transport/tty_speed.h"

#include <QtGlobal>

#ifdef Q_OS_LINUX
// <asm/termbits.h> has termios2 and cannot be combined with <termios.h>.
#include <asm/ioctls.h>
#include <asm/termbits.h>
#include <sys/ioctl.h>
#elif defined(Q_OS_UNIX)
#include <termios.h>
#endif

namespace transport {
#ifdef Q_OS_LINUX
std::optional<int> ttySpeed(int descriptor)
{
    termios2 settings{};
    if (ioctl(descriptor, TCGETS2, &settings) != 0)
        return std::nullopt;
    return static_cast<int>(settings.c_ospeed);
}

bool setTtySpeed(int descriptor, int baud)
{
    termios2 settings{};
    if (ioctl(descriptor, TCGETS2, &settings) != 0)
        return false;
    settings.c_cflag &= ~static_cast<tcflag_t>(CBAUD | (CBAUD << IBSHIFT));
    settings.c_cflag |= BOTHER | (BOTHER << IBSHIFT);
    settings.c_ispeed = settings.c_ospeed = static_cast<speed_t>(baud);
    return ioctl(descriptor, TCSETS2, &settings) == 0;
}
#elif defined(Q_OS_UNIX)
// BSD and macOS keep the plain number in speed_t.
std::optional<int> ttySpeed(int descriptor)
{
    termios settings{};
    if (tcgetattr(descriptor, &settings) != 0)
        return std::nullopt;
    return static_cast<int>(cfgetospeed(&settings));
}

bool setTtySpeed(int descriptor, int baud)
{
    termios settings{};
    return tcgetattr(descriptor, &settings) == 0 &&
           cfsetspeed(&settings, static_cast<speed_t>(baud)) == 0 &&
           tcsetattr(descriptor, TCSANOW, &settings) == 0;
}
#else
std::optional<int> ttySpeed(int)
{
    return std::nullopt;
}

bool setTtySpeed(int, int)
{
    return false;
}
#endif
} // namespace transport
