// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/output/utf8_locale.h"

#include <QByteArray>

#ifdef Q_OS_UNIX
#include <clocale>
#include <langinfo.h>
#endif

namespace cli {
void useUtf8()
{
#ifdef Q_OS_UNIX
    std::setlocale(LC_ALL, "");
    if (qstricmp(nl_langinfo(CODESET), "UTF-8") == 0)
        return;
    // LC_ALL would override the character set, so its value moves to LANG.
    const QByteArray all = qgetenv("LC_ALL");
    if (!all.isEmpty()) {
        qputenv("LANG", all);
        qunsetenv("LC_ALL");
    }
    qputenv("LC_CTYPE", "C.UTF-8");
#endif
}
} // namespace cli
