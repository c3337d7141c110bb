// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/servo/virtual_servo.h"

#include "catalog/value.h"
#include "sim/servo/servo_state.h"

#include <numbers>

namespace sim {
VirtualServo::VirtualServo(catalog::ProfilePtr profile, ServoConfig config)
    : m_state(std::make_unique<State>(std::move(profile), config))
{}

VirtualServo::~VirtualServo() = default;
VirtualServo::VirtualServo(VirtualServo&&) noexcept = default;

const catalog::Profile& VirtualServo::profile() const
{
    return *m_state->profile;
}

int VirtualServo::id() const
{
    return m_state->settings.id;
}

int VirtualServo::baud() const
{
    return m_state->baud;
}

AddressMatch VirtualServo::addressMatch(int id, std::uint8_t instruction) const
{
    return m_state->addressMatch(id, instruction);
}

bool VirtualServo::isDeaf() const
{
    return !m_state->isRunning() || m_state->deafLeft.count() > 0;
}

base::Duration VirtualServo::writeTime() const
{
    return m_state->writeTime();
}

base::Duration VirtualServo::replyDelay() const
{
    return m_state->replyDelay();
}

std::optional<ServoReply> VirtualServo::handle(const ServoRequest& request)
{
    return m_state->handle(request);
}

void VirtualServo::step(base::Duration dt)
{
    m_state->advance(dt);
}

void VirtualServo::powerOff()
{
    m_state->powered = false;
    m_state->switchOff();
}

void VirtualServo::powerOn()
{
    if (!m_state->powered) {
        m_state->powered = true;
        m_state->switchOn();
    }
}

bool VirtualServo::powered() const
{
    return m_state->powered;
}

base::Bytes VirtualServo::epromImage() const
{
    return m_state->memory.image();
}

bool VirtualServo::setEpromImage(base::ByteView image)
{
    if (!m_state->memory.setImage(image)) {
        return false;
    }
    if (m_state->powered) {
        m_state->switchOff();
        m_state->switchOn();
    }
    return true;
}

std::int64_t VirtualServo::raw(const QString& key) const
{
    const catalog::Register* reg = m_state->profile->find(key);
    if (reg == nullptr) {
        return 0;
    }
    m_state->updateFeedback();
    const auto meaning = catalog::valueFormat(*reg, *m_state->profile,
                                              [this](const QString& other) { return raw(other); });
    return catalog::decodeRaw(m_state->memory.view(reg->offset, reg->size), *reg, meaning,
                              m_state->profile->byteOrder);
}

void VirtualServo::poke(const QString& key, std::int64_t raw)
{
    const catalog::Register* reg = m_state->profile->find(key);
    if (reg == nullptr) {
        return;
    }
    const auto meaning = catalog::valueFormat(
        *reg, *m_state->profile, [this](const QString& other) { return this->raw(other); });
    m_state->write(reg->offset,
                   catalog::encodeRaw(raw, *reg, meaning, m_state->profile->byteOrder));
}

double VirtualServo::shaftDegrees() const
{
    return m_state->mechanics.angle() * 180.0 / std::numbers::pi;
}

bool VirtualServo::ledOn() const
{
    return m_state->led();
}

Load& VirtualServo::load()
{
    return m_state->config.load;
}

Environment& VirtualServo::environment()
{
    return m_state->config.environment;
}

Defects& VirtualServo::defects()
{
    return m_state->config.defects;
}

FirmwareBehavior& VirtualServo::behavior()
{
    return m_state->config.behavior;
}

void VirtualServo::injectStatus(std::uint8_t bits)
{
    m_state->protection.inject(bits);
}

void VirtualServo::setTemperature(double celsius)
{
    m_state->celsius = celsius;
}
} // namespace sim
