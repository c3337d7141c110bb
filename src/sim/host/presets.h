// SPDX-License-Identifier: GPL-3.0-or-later
// Simulated buses by name and by list, for "sim:NAME" and servodesk-sim. demo: six servos, mixed
// models, one rate, one alarmed. trouble: mixed rates, twin IDs, an open lock, an overload. modbus:
// one servo, station 1. lx: five servos, one with an offset, one too warm. sweep: a healthy, a worn
// and a badly damped servo, for testing servo tests. new-arm: six factory-new servos, all on ID 1.
// line, line-trouble: six servos fresh from their boxes, not plugged in yet
// (VirtualBus::connectNext).
#pragma once

#include "base/error.h"
#include "catalog/catalog.h"
#include "sim/bus/virtual_bus.h"

#include <QStringList>

namespace sim {
QStringList presetNames();

/// `baud` replaces every servo's rate, `epromTime` the time it takes to write its EPROM. Defects
/// behind the name are for all servos: "demo+deaf=1" (defect_list.h).
base::Result<std::unique_ptr<VirtualBus>>
makePreset(const QString& text, const catalog::Catalog& catalog, const WireConfig& wire = {},
           std::optional<int> baud = {}, std::optional<base::Duration> epromTime = {});

/// "sts3215@1,smsmb@2,lx16a@3"; "@ID:BAUD" sets one servo's rate, `baud` all others'. Two servos
/// may share an ID. Defects of one servo follow it:
/// "sts3215@1:500000+overshoot=5+speed=0.7" (names in defect_list.h, meaning in defects.h
/// and FirmwareBehavior). BadArgument names the item it could not use and why.
base::Result<std::unique_ptr<VirtualBus>>
makeServos(const QString& list, const catalog::Catalog& catalog, std::optional<int> baud,
           const WireConfig& wire = {}, std::optional<base::Duration> epromTime = {});

/// "drop=0.01,corrupt=0.01,late=0.05,late-ms=40,truncate=…,garbage=…,drop-request=…,mute=3,mute=4"
/// → plan; BadArgument names the unknown name.
base::Result<FaultPlan> parseFaults(const QString& text);
} // namespace sim
