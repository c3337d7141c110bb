// SPDX-License-Identifier: GPL-3.0-or-later
// The texts of notices, outcomes, locks and alarms, by their stable English names (outcomeName,
// lockName), in the language of the interface. Pure; any thread.
#pragma once

#include "base/notice.h"
#include "catalog/profile.h"

#include <QStringList>

namespace text {
/// One sentence, without naming the servo.
QString describe(const base::Notice& notice);

/// Stable name for JSON: "torque-switched-off".
QString noticeName(base::NoticeCode code);

QString outcomeLabel(const QString& outcome); ///< "kept" → "kept" / "已保存"
QString lockLabel(const QString& lock);       ///< "closed" → "closed" / "已上锁"
QString areaLabel(catalog::Area area);
QString accessLabel(catalog::Access access);
QString lineLabel(catalog::Line line);

/// False for families without error byte and status register (LX): their alarms are unknown.
bool reportsAlarms(const catalog::Profile* profile);

/// Keys of the set error bits ("overload"); "bit4" for a bit without a name.
QStringList statusKeys(std::uint8_t status, const catalog::Profile* profile);
/// The same as text, "none" if no bit is set.
QString statusText(std::uint8_t status, const catalog::Profile* profile);
} // namespace text
