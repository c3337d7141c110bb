// SPDX-License-Identifier: GPL-3.0-or-later
// Notices, outcomes, locks and alarms in words, in the language of the installed translator. The
// stable English names (outcomeName, lockName) come in, sentences go out. Pure; any thread.
#pragma once

#include "base/notice.h"
#include "catalog/profile.h"

#include <QStringList>

namespace text {
/// One sentence, without the servo it is about.
QString describe(const base::Notice& notice);

/// Stable name for JSON: "torque-switched-off".
QString noticeName(base::NoticeCode code);

QString outcomeLabel(const QString& outcome); ///< "kept" → "kept" / "已保存"
QString lockLabel(const QString& lock);       ///< "closed" → "closed" / "已上锁"
QString areaLabel(catalog::Area area);
QString accessLabel(catalog::Access access);
QString lineLabel(catalog::Line line);

/// False for families without error byte and status register (LX): their alarms are not "none".
bool reportsAlarms(const catalog::Profile* profile);

/// Keys of the set error bits ("overload"); "bit4" where the family names none.
QStringList statusKeys(std::uint8_t status, const catalog::Profile* profile);
/// The same in words, "none" if no bit is set.
QString statusText(std::uint8_t status, const catalog::Profile* profile, bool chinese);
} // namespace text
