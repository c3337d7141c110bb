// SPDX-License-Identifier: GPL-3.0-or-later
// Parses arguments of the command line. Errors are BadArgument; the translated detail says what was
// expected. Pure; any thread.
#pragma once

#include "base/clock.h"
#include "base/error.h"
#include "catalog/profile.h"

#include <QStringList>

#include <utility>
#include <vector>

namespace cli {
tl::unexpected<base::Error> badArgument(const QString& detail);

base::Result<int> parseId(const QString& argument);
/// "1", "1-6", "1,3,5"; each ID once, in the order given.
base::Result<std::vector<int>> parseIds(const QStringList& words);

struct IdRange {
    int first = 0;
    int last = 253;
};
base::Result<IdRange> parseIdRange(const QString& argument);

base::Result<int> parseInt(const QString& argument, int min, int max);
base::Result<double> parsePositive(const QString& argument);
/// "feetech", "modbus", "lx"; nullopt: "auto".
base::Result<std::optional<base::Protocol>> parseProtocol(const QString& argument);

/// "all" or "N,N…".
base::Result<std::vector<int>> parseBauds(const QString& argument);

/// "KEY=VALUE"
base::Result<std::pair<QString, QString>> parseAssignment(const QString& argument);

/// The register, or UnknownRegister whose detail names the nearest keys.
base::Result<const catalog::Register*> findRegister(const catalog::Profile& profile,
                                                    const QString& key, int id);

/// Up to three of `known` that differ from `argument` only by a typing error, nearest first.
QStringList nearest(const QString& argument, const QStringList& known);
} // namespace cli
