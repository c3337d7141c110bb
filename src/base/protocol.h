// SPDX-License-Identifier: GPL-3.0-or-later
// The languages servos speak. The same bus may carry several of them, one request at a time.
// Values; any thread.
#pragma once

#include <QString>

#include <array>
#include <cstdint>
#include <optional>

namespace base {
enum class Protocol : std::uint8_t {
    Feetech, ///< FT-SCS packets: SCS, STS, SMS, SMCL, HLS
    Modbus,  ///< Modbus-RTU: Feetech SMSMB
    Lx,      ///< Hiwonder LX bus servos
};
inline constexpr std::array allProtocols{Protocol::Feetech, Protocol::Modbus, Protocol::Lx};

QString protocolName(Protocol protocol); ///< "feetech", "modbus", "lx"
std::optional<Protocol> protocolFromName(const QString& name);
} // namespace base
