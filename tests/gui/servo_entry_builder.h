// SPDX-License-Identifier: GPL-3.0-or-later
// A servo entry as the workbench would hold it, filled by hand: registers of a built-in model with
// the numbers a test gives them. No bus.
#pragma once

#include "catalog/catalog.h"
#include "session/servos/servo_entry.h"

#include <map>

namespace guitest {
inline const catalog::Identity sts3215{3, 10, 0, 9, 3};

inline const catalog::Catalog& models()
{
    static const catalog::Catalog catalog = catalog::Catalog::load().catalog;
    return catalog;
}

/// Puts a number where the servo would show it, read at `at`.
inline void put(session::ServoEntry& entry, const QString& key, std::int64_t raw,
                base::Duration at = {})
{
    const catalog::Profile& profile = *entry.servo.profile;
    const catalog::Register* reg = profile.find(key);
    entry.servo.image.store(
        reg->offset, catalog::encodeRaw(raw, *reg, entry.servo.meaning(*reg), profile.byteOrder),
        at);
}

/// Every register reads its default, or 0.
inline session::ServoEntry entryOf(const catalog::Identity& identity, int id = 1)
{
    session::ServoEntry entry;
    entry.ref = id;
    entry.servo.id = id;
    entry.servo.baud = 1'000'000;
    entry.servo.port = QStringLiteral("test");
    entry.servo.profile = models().resolve(identity);
    for (const catalog::Register& reg : entry.servo.profile->registers)
        put(entry, reg.key, reg.defaultRaw.value_or(0));
    entry.firstImage = entry.servo.image;
    entry.hasFullTable = true;
    return entry;
}
} // namespace guitest
