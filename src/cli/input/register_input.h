// SPDX-License-Identifier: GPL-3.0-or-later
// Parses KEY=VALUE arguments into writes, with translated messages. Pure; main thread.
#pragma once

#include "device/writer.h"

#include <QStringList>

namespace cli {
/// A raw value, a physical value with its unit, or a name. BadArgument says what the register
/// accepts.
base::Result<std::int64_t> parseRegisterValue(const device::Servo& servo,
                                              const catalog::Register& reg, const QString& text);

/// The settings of the servo must have been read. UnknownRegister, BadArgument.
base::Result<std::vector<device::WriteItem>> parseWriteItems(const device::Servo& servo,
                                                             const QStringList& words);
} // namespace cli
