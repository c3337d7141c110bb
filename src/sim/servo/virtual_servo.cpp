// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/servo/virtual_servo.h"

#include "sim/requests/request_handler.h"

#include <numbers>

namespace sim {
struct VirtualServo::State {
    State(catalog::ProfilePtr profile, const ServoConfig& config)
        : firmware(std::move(profile), config)
        , handler(makeRequestHandler(firmware))
    {}
    void switchOff()
    {
        handler->forgetStored();
        firmware.switchOff();
    }

    ServoFirmware firmware;
    std::unique_ptr<RequestHandler> handler;
};

VirtualServo::VirtualServo(catalog::ProfilePtr profile, ServoConfig config)
    : m_state(std::make_unique<State>(std::move(profile), config))
{}

VirtualServo::~VirtualServo() = default;
VirtualServo::VirtualServo(VirtualServo&&) noexcept = default;

const catalog::Profile& VirtualServo::profile() const
{
    return m_state->firmware.profile();
}

int VirtualServo::id() const
{
    return m_state->firmware.settings().id;
}

int VirtualServo::baud() const
{
    return m_state->firmware.baud();
}

AddressMatch VirtualServo::addressMatch(int id, std::uint8_t instruction) const
{
    return m_state->handler->addressMatch(id, instruction);
}

bool VirtualServo::isDeaf() const
{
    return m_state->firmware.power().isDeaf() || isInBootloader();
}

bool VirtualServo::isInBootloader() const
{
    return m_state->firmware.isInBootloader();
}

bool VirtualServo::hearsFirmware() const
{
    return m_state->firmware.hearsFirmware();
}

std::optional<Bootloader::Reply> VirtualServo::receiveInBootloader(std::uint8_t byte)
{
    return m_state->firmware.receiveInBootloader(byte);
}

base::Duration VirtualServo::writeTime() const
{
    const ServoConfig& config = m_state->firmware.config();
    return m_state->firmware.registers().epromWritten() && !config.behavior.deafWhileWriting
               ? config.epromTime
               : base::Duration();
}

base::Duration VirtualServo::replyDelay() const
{
    return m_state->firmware.replyDelay();
}

ReplyTiming& VirtualServo::timing()
{
    return m_state->firmware.config().timing;
}

std::optional<ServoReply> VirtualServo::handle(const ServoRequest& request)
{
    ServoFirmware& firmware = m_state->firmware;
    firmware.registers().clearEpromWritten();
    if (isDeaf()) {
        return std::nullopt;
    }
    // A servo that becomes deaf answers first; the shortest reply has six bytes of ten bits. The
    // request may change both times.
    const base::Duration replyTime = replyDelay() + base::Duration(60'000'000 / baud());
    const std::optional<ServoReply> reply = m_state->handler->handle(request);
    if (firmware.registers().epromWritten() && firmware.config().behavior.deafWhileWriting) {
        firmware.power().startDeafTime(firmware.config().epromTime +
                                       (reply ? replyTime : base::Duration()));
    }
    return reply;
}

void VirtualServo::step(base::Duration dt)
{
    m_state->firmware.advance(dt);
}

void VirtualServo::powerOff()
{
    m_state->firmware.power().setOn(false);
    m_state->switchOff();
}

void VirtualServo::powerOn()
{
    if (!powered()) {
        m_state->firmware.power().setOn(true);
        m_state->firmware.switchOn();
    }
}

bool VirtualServo::powered() const
{
    return m_state->firmware.power().isOn();
}

base::Bytes VirtualServo::epromImage() const
{
    return m_state->firmware.registers().epromImage();
}

bool VirtualServo::setEpromImage(base::ByteView image)
{
    if (!m_state->firmware.registers().setEpromImage(image)) {
        return false;
    }
    if (powered()) {
        m_state->switchOff();
        m_state->firmware.switchOn();
    }
    return true;
}

std::int64_t VirtualServo::raw(const QString& key) const
{
    const catalog::Register* reg = profile().find(key);
    if (reg == nullptr) {
        return 0;
    }
    m_state->firmware.updateFeedback();
    return m_state->firmware.registers().raw(*reg);
}

void VirtualServo::poke(const QString& key, std::int64_t raw)
{
    if (const catalog::Register* reg = profile().find(key)) {
        m_state->firmware.write(reg->offset, m_state->firmware.registers().encode(*reg, raw));
    }
}

double VirtualServo::shaftDegrees() const
{
    return m_state->firmware.drive().mechanics().angle() * 180.0 / std::numbers::pi;
}

bool VirtualServo::ledOn() const
{
    return m_state->firmware.ledOn();
}

Load& VirtualServo::load()
{
    return m_state->firmware.config().load;
}

Environment& VirtualServo::environment()
{
    return m_state->firmware.config().environment;
}

Defects& VirtualServo::defects()
{
    return m_state->firmware.config().defects;
}

FirmwareBehavior& VirtualServo::behavior()
{
    return m_state->firmware.config().behavior;
}

void VirtualServo::injectStatus(std::uint8_t bits)
{
    m_state->firmware.protection().inject(bits);
}

void VirtualServo::setTemperature(double celsius)
{
    m_state->firmware.health().setCelsius(celsius);
}
} // namespace sim
