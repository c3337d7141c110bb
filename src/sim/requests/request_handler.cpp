// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/requests/request_handler.h"

#include "sim/requests/feetech_handler.h"
#include "sim/requests/lx_handler.h"
#include "sim/requests/modbus_handler.h"

namespace sim {
AddressMatch RequestHandler::addressMatch(int id, std::uint8_t) const
{
    return id == settings().id ? AddressMatch::Yes : AddressMatch::No;
}

base::ByteView RequestHandler::read(int address, int count)
{
    m_firmware.updateFeedback();
    return registers().memory().view(address, count);
}

std::unique_ptr<RequestHandler> makeRequestHandler(ServoFirmware& firmware)
{
    switch (firmware.profile().protocol) {
    case base::Protocol::Feetech:
        break;
    case base::Protocol::Modbus:
        return std::make_unique<ModbusHandler>(firmware);
    case base::Protocol::Lx:
        return std::make_unique<LxHandler>(firmware);
    }
    return std::make_unique<FeetechHandler>(firmware);
}
} // namespace sim
