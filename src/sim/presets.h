// SPDX-License-Identifier: GPL-3.0-or-later
// Simulated buses by name and by list, for "sim:NAME" and servodesk-sim. demo: six servos, mixed
// models, one rate, one alarmed. trouble: mixed rates, twin IDs, an open lock, an overload.
#pragma once

#include "sim/virtual_bus.h"

#include "base/error.h"
#include "catalog/catalog.h"

#include <QStringList>

namespace sim
{
QStringList presetNames();
base::Result<std::unique_ptr<VirtualBus>> makePreset(const QString& name,
                                                     const catalog::Catalog& catalog,
                                                     const WireConfig& wire = {});

/// "sts3215@1,sts3250@2,scs15@3" (optionally "@ID:BAUD"). `baud` overrides the factory rate of all.
base::Result<std::unique_ptr<VirtualBus>> makeServos(const QString& list,
                                                     const catalog::Catalog& catalog,
                                                     std::optional<int> baud,
                                                     const WireConfig& wire = {});

/// "drop=0.01,corrupt=0.01,late=0.05,mute=3" → plan; BadArgument names the word it did not know.
base::Result<FaultPlan> parseFaults(const QString& text);
}
