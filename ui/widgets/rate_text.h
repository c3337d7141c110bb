// SPDX-License-Identifier: GPL-3.0-or-later
// How baud rates and time spans are written, the same in lists, fields and messages. Pure; main
// thread.
#pragma once

#include "base/clock.h"

#include <QString>

namespace ui {
/// "1 000 000": with narrow blanks, whatever the language.
QString rateText(int baud);
/// "1 M", "500 k", "115200": where there is little room.
QString shortRate(int baud);
/// "0.9 s", "12 s", "3 min": of a span or an estimate.
QString spanText(base::Duration span);
/// "now", "12 s ago", "3 min ago".
QString timeAgoText(base::Duration age);
} // namespace ui
