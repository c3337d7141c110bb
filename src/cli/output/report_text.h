// SPDX-License-Identifier: GPL-3.0-or-later
// Servos, registers, writes and errors as tables and as JSON, for several commands. Pure; main
// thread (translated texts).
#pragma once

#include "cli/output/json.h"
#include "cli/output/table.h"
#include "device/writer.h"

namespace cli {
/// "STS3215 (9.3), firmware 3.10"
QString servoTitle(const device::Servo& servo);

/// The value of a register with its unit; "–" if it was not read.
QString formatValueText(const device::Servo& servo, const catalog::Register& reg);

/// Physical value as a number; an enum's key (a number if it is one), a list of bit keys; null if
/// not read.
Json jsonValue(const device::Servo& servo, const catalog::Register& reg);
QString formatUnit(const device::Servo& servo, const catalog::Register& reg);

/// Keys of the alarms; null if the family reports no alarms.
Json jsonAlarms(std::uint8_t status, const catalog::Profile* profile);
/// {"key","address","raw","value","unit","area","access"}
Json jsonRegister(const device::Servo& servo, const catalog::Register& reg);
Table registerTable(const device::Servo& servo,
                    const std::vector<const catalog::Register*>& registers);

/// {"id","writes":[…],"lock"}
Json jsonWrites(const device::WriteReport& report);
QString writeText(const device::Servo& servo, const device::WriteReport& report);

/// {"code","message","cause","remedy", …}
Json jsonError(const base::Error& error);
/// Message, likely cause and remedy on three lines.
QString errorText(const base::Error& error);
} // namespace cli
