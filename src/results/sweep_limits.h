// SPDX-License-Identifier: GPL-3.0-or-later
// The limits that a good servo of a model keeps: an editable JSON file (resources/limits has the
// built-in ones), one line per figure. Immutable values; any thread. FileMissing, FileUnreadable,
// FileFormat (detail names line or metric and what is wrong), FileUnwritable, DiskFull.
#pragma once

#include "base/error.h"

#include <QStringList>

#include <optional>
#include <vector>

namespace results {
struct SweepLimit {
    QString metric; ///< SweepMetric::key
    QString unit;   ///< must be the metric's
    std::optional<double> warn{};
    std::optional<double> fail{};
    bool atLeast = false; ///< the value must be this or more (voltage); else this or less
    bool operator==(const SweepLimit&) const = default;
};

struct SweepLimits {
    QString name;       ///< "STS3215, shop"
    QStringList models; ///< names ("STS3215") or series ("STS") these are for; empty: any
    std::optional<double> tolerance{}; ///< of a reached target, steps; else the family's own
    std::vector<SweepLimit> lines{};
    bool operator==(const SweepLimits&) const = default;
};

QByteArray encodeSweepLimits(const SweepLimits& limits);
base::Result<SweepLimits> decodeSweepLimits(const QByteArray& text);
base::Result<SweepLimits> loadSweepLimits(const QString& path);
base::Result<void> saveSweepLimits(const SweepLimits& limits, const QString& path);

/// The built-in ones: for the model itself, else for its series, else for any.
SweepLimits builtInSweepLimits(const QString& model, const QString& series);
/// Those with the name of built-in limits from which they differ are called "STS3215, custom".
SweepLimits withNameOfItsOwn(SweepLimits limits, const QString& model);
inline constexpr QLatin1StringView customSuffix(", custom");

/// All metrics in the order of a report, with its unit. A limits file may name no other.
struct SweepMetricKind {
    QString key;
    QString unit;
    bool atLeast = false; ///< more is better
};
const std::vector<SweepMetricKind>& sweepMetricKinds();
} // namespace results
