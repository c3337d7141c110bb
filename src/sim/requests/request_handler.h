// SPDX-License-Identifier: GPL-3.0-or-later
// How a servo answers the requests of its protocol: the base of the Feetech, Modbus and LX
// handlers. A handler reads and writes through ServoFirmware and keeps only what its protocol
// stores between two requests. Owned by a VirtualServo; one thread.
#pragma once

#include "sim/servo/servo_firmware.h"

namespace sim {
class RequestHandler {
public:
    /// `firmware` must outlive the handler.
    explicit RequestHandler(ServoFirmware& firmware)
        : m_firmware(firmware)
    {}
    virtual ~RequestHandler() = default;
    Q_DISABLE_COPY_MOVE(RequestHandler)

    /// Carries the request out; nullopt: the servo stays silent.
    virtual std::optional<ServoReply> handle(const ServoRequest& request) = 0;
    virtual AddressMatch addressMatch(int id, std::uint8_t instruction) const;
    virtual void forgetStored() {} ///< what a power-off takes away

protected:
    ServoFirmware& firmware() { return m_firmware; }
    const ServoFirmware& firmware() const { return m_firmware; }
    RegisterStore& registers() { return m_firmware.registers(); }
    const RegisterStore& registers() const { return m_firmware.registers(); }
    const catalog::Profile& profile() const { return m_firmware.profile(); }
    const Settings& settings() const { return m_firmware.settings(); }
    base::ByteView read(int address, int count); ///< with fresh feedback

private:
    ServoFirmware& m_firmware;
};

std::unique_ptr<RequestHandler> makeRequestHandler(ServoFirmware& firmware);
} // namespace sim
