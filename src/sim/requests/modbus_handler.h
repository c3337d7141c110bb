// SPDX-License-Identifier: GPL-3.0-or-later
// Modbus functions as reads and writes of the table, and their answers. Source: vendor's Modbus
// page, and the Modbus standard for what it leaves open: exception 2 for a register that does not
// exist or cannot be written (the factory block without 128 in 133 included), 3 for a count that
// does not fit or a value outside the register sheet, silence to station 0. Owned by a
// VirtualServo; one thread.
#pragma once

#include "sim/requests/request_handler.h"

namespace sim {
class ModbusHandler : public RequestHandler {
public:
    using RequestHandler::RequestHandler;

    std::optional<ServoReply> handle(const ServoRequest& request) override;

private:
    using ExceptionCode = std::optional<std::uint8_t>; ///< nullopt: the request is valid

    std::optional<ServoReply> execute(const ServoRequest& request);
    ExceptionCode exceptionFor(const ServoRequest& request) const;
    ExceptionCode readException(base::ByteView params) const;
    ExceptionCode writeException(const ServoRequest& request) const;
    bool isWithinLimits(int address, base::ByteView data) const;
};
} // namespace sim
