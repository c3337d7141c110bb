// SPDX-License-Identifier: GPL-3.0-or-later
// The register maps of the servos in the history, by which its raw values are shown with units. A
// servo whose map is no longer in the catalog has none. Not thread safe.
#pragma once

#include "catalog/catalog.h"
#include "history/history_rows.h"

#include <map>

namespace history {
class HistoryProfiles {
public:
    explicit HistoryProfiles(const catalog::Catalog& catalog)
        : m_catalog(catalog)
    {}

    void add(const std::vector<HistoryServo>& servos);
    /// The name in the sheet; the key where the map is not known.
    QString registerName(const HistoryWrite& row, bool chinese) const;
    /// "85 · 8.5 V": the raw value, and its physical value where that differs.
    QString valueText(const HistoryWrite& row, std::int64_t raw, bool chinese) const;

private:
    const catalog::Catalog& m_catalog;
    std::map<std::int64_t, catalog::ProfilePtr> m_profiles; ///< by number of the servo
};
} // namespace history
