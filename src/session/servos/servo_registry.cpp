// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/servos/servo_registry.h"

#include "base/clock.h"
#include "session/polling/polling_service.h"

#include <algorithm>
#include <tuple>

namespace session {
bool isSameKind(const device::Servo& a, const device::Servo& b)
{
    return !a.profile || !b.profile || a.profile->identity == b.profile->identity;
}

ServoRegistry::ServoRegistry(const base::Clock& clock)
    : m_clock(clock)
{}

const ServoEntry* ServoRegistry::servo(ServoRef ref) const
{
    const auto it = m_servos.find(ref);
    return it != m_servos.end() ? &it->second : nullptr;
}

ServoEntry* ServoRegistry::entry(ServoRef ref)
{
    const auto it = m_servos.find(ref);
    return it != m_servos.end() ? &it->second : nullptr;
}

ServoRef ServoRegistry::findServo(base::Protocol protocol, int id) const
{
    ServoRef silent = 0; // at another baud rate, say
    for (const ServoRef ref : m_order) {
        const ServoEntry& known = m_servos.at(ref);
        if (known.servo.protocol != protocol || known.servo.id != id)
            continue;
        if (!known.silent)
            return ref;
        silent = silent == 0 ? ref : silent;
    }
    return silent;
}

void ServoRegistry::acknowledgeAlarms(ServoRef ref)
{
    ServoEntry* known = entry(ref);
    if (known == nullptr)
        return;
    known->alarms.acknowledge();
    Q_EMIT servoChanged(ref);
}

ServoRef ServoRegistry::add(const jobs::FoundServo& one)
{
    ServoEntry added;
    added.ref = ++m_lastRef;
    added.servo = one.servo;
    added.firstImage = one.servo.image;
    added.duplicateSuspected = one.duplicateSuspected;
    added.lateReplySeen = one.lateReplySeen;
    added.lastSeen = m_clock.now();
    const ServoRef ref = added.ref;
    insertServo(std::move(added));
    if (ServoEntry* known = entry(ref))
        markAlarms(*known);
    return ref;
}

void ServoRegistry::insertServo(ServoEntry added)
{
    const ServoRef ref = added.ref;
    m_servos.emplace(ref, std::move(added));
    const auto it = std::upper_bound(m_order.begin(), m_order.end(), ref,
                                     [this](ServoRef a, ServoRef b) { return sortsBefore(a, b); });
    m_order.insert(it, ref);
    Q_EMIT servoAdded(ref);
}

/// The order of the list.
bool ServoRegistry::sortsBefore(ServoRef a, ServoRef b) const
{
    const auto key = [this](ServoRef ref) {
        const device::Servo& servo = m_servos.at(ref).servo;
        return std::tuple(servo.id, servo.protocol, servo.baud, ref);
    };
    return key(a) < key(b);
}

void ServoRegistry::remove(ServoRef ref)
{
    m_order.erase(std::remove(m_order.begin(), m_order.end(), ref), m_order.end());
    m_servos.erase(ref);
    Q_EMIT servoRemoved(ref);
}

/// What the job has read, and beside it what regular reading has brought since the job began.
void ServoRegistry::merge(ServoEntry& into, const device::Servo& from, base::Duration since)
{
    if (!isSameKind(into.servo, from)) { // what was read is another servo's
        into.silent = into.answeredAgain = true;
        return;
    }
    device::Image image = from.image;
    image.mergeNewer(into.servo.image, since);
    const bool moved = into.servo.id != from.id || into.servo.baud != from.baud;
    const std::uint8_t read = into.servo.status;
    into.servo = from;
    if (into.statusAt >= since) // read beside the job: newer than what the job found at its start
        into.servo.status = read;
    into.servo.image = std::move(image);
    into.firstImage.mergeMissing(into.servo.image);
    if (into.servo.profile)
        into.turns.on(device::turnBasis(into.servo));
    markAlarms(into);
    if (moved) {
        const ServoEntry* entered = &into;
        Q_EMIT addressChanged(into.ref);
        sortOrder();
        Q_EMIT servoChanged(entered->ref);
    }
}

void ServoRegistry::sortOrder()
{
    std::sort(m_order.begin(), m_order.end(),
              [this](ServoRef a, ServoRef b) { return sortsBefore(a, b); });
    Q_EMIT orderChanged();
}

void ServoRegistry::changed(const ServoEntry& entry)
{
    const ServoRef ref = entry.ref; // receivers of the signal may change the list
    Q_EMIT servoChanged(ref);
    Q_EMIT tableChanged(ref);
}

void ServoRegistry::markAlarms(ServoEntry& entry)
{
    for (const recording::Mark& one : latchAlarms(entry, m_clock.now()))
        Q_EMIT alarmMarked(one);
}

void ServoRegistry::clear()
{
    m_servos.clear();
    m_order.clear();
    Q_EMIT servosCleared();
}
} // namespace session
