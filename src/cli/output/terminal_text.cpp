// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/output/terminal_text.h"

#include <algorithm>

namespace cli {
bool isTerminalControl(QChar c)
{
    const char16_t code = c.unicode();
    const bool control = code < 0x20 || (code >= 0x7f && code < 0xa0);
    const bool direction = code == 0x061c || code == 0x200e || code == 0x200f ||
                           (code >= 0x202a && code <= 0x202e) || (code >= 0x2066 && code <= 0x2069);
    return control || direction || code == 0x2028 || code == 0x2029;
}

QString terminalSafe(const QString& text)
{
    QString shown = text;
    for (QChar& c : shown) {
        if (isTerminalControl(c) && c != QLatin1Char('\n') && c != QLatin1Char('\t'))
            c = QChar::ReplacementCharacter;
    }
    return shown;
}
} // namespace cli
