// SPDX-License-Identifier: GPL-3.0-or-later
#include "text/progress_text.h"

#include "text/translate.h"

#include <algorithm>
#include <cmath>

namespace text {
namespace {
constexpr std::int64_t minute = 60;
constexpr std::int64_t hour = 60 * minute;
constexpr double whole = 100;
} // namespace

QString durationText(base::Duration span)
{
    const auto seconds = std::llround(std::chrono::duration<double>(span).count());
    if (seconds < minute)
        return translate("text", "%1 s").arg(seconds);
    if (seconds < hour)
        return translate("text", "%1 min %2 s").arg(seconds / minute).arg(seconds % minute);
    return translate("text", "%1 h %2 min").arg(seconds / hour).arg(seconds % hour / minute);
}

QString progressText(double fraction, std::optional<base::Duration> remaining)
{
    const QString percent =
        translate("text", "%1 %").arg(int(std::clamp(fraction, 0.0, 1.0) * whole));
    if (!remaining)
        return percent;
    const base::Duration least = std::chrono::seconds(1);
    return translate("text", "%1, about %2 left")
        .arg(percent, durationText(std::max(*remaining, least)));
}
} // namespace text
