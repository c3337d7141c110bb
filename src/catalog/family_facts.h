// SPDX-License-Identifier: GPL-3.0-or-later
// What decides a Feetech servo's register map: firmware, byte order flag and the model list, and
// the byte where the map has its lock. Kept where they contradict each other. A value; travels as
// the detail of an error, so that the text layer can name every fact. Any thread.
#pragma once

#include <QString>

#include <optional>

namespace catalog {
struct FamilyFacts {
    QString firmware;       ///< "3.25"
    QString firmwareSeries; ///< the series with this firmware, "STS/SCS2"; empty: none
    int byteOrderFlag = -1; ///< 0 low byte first, 1 high byte first
    QString modelId;        ///< "9.3"
    QString modelName;      ///< in the model list; empty: not listed
    int modelFlag = -1;     ///< the flag that the model list expects
    int lockAddress = -1;   ///< −1: the lock is not the cause
    std::int64_t lock = -1; ///< the value at that address
    bool operator==(const FamilyFacts&) const = default;

    QString detail() const;
    /// Of an error with the code FamilyConflict; null if it has none.
    static std::optional<FamilyFacts> fromDetail(const QString& detail);
};
} // namespace catalog
