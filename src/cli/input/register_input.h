// SPDX-License-Identifier: GPL-3.0-or-later
// KEY=VALUE words into what is to be written, with our own words for what is wrong. Pure; main
// thread.
#pragma once

#include "device/writer.h"

#include <QStringList>

namespace cli {
/// Raw, physical with its unit, or a name. BadArgument says what this register takes.
base::Result<std::int64_t> parseRegisterValue(const device::Servo& servo,
                                              const catalog::Register& reg, const QString& text);

/// Needs the servo's settings read. UnknownRegister, BadArgument.
base::Result<std::vector<device::WriteItem>> parseWriteItems(const device::Servo& servo,
                                                             const QStringList& words);
} // namespace cli
