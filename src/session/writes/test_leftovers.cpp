// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/writes/test_leftovers.h"

#include <algorithm>
#include <utility>

namespace session {
namespace {
const catalog::Register* torqueSwitch(const device::Servo& servo)
{
    return servo.profile->byRole(catalog::Role::TorqueSwitch);
}

/// As read after `since`.
bool reads(const device::Servo& servo, const catalog::Register* reg, std::int64_t raw,
           base::Duration since)
{
    const auto at = reg != nullptr ? servo.image.readAt(reg->offset) : std::nullopt;
    return at && *at > since && servo.raw(*reg) == raw;
}
} // namespace

TestLeftovers::TestLeftovers(Workbench& workbench, const QString& user, QObject* parent)
    : QObject(parent)
    , m_workbench(workbench)
    , m_user(user)
{
    connect(&workbench.registry(), &ServoRegistry::tableChanged, this, &TestLeftovers::check);
    connect(&workbench.registry(), &ServoRegistry::servoAdded, this,
            &TestLeftovers::updateSubscription);
}

void TestLeftovers::clear()
{
    m_torque.clear();
    m_settings.clear();
    m_servos.clear();
    updateSubscription();
}

void TestLeftovers::setLeftovers(std::vector<jobs::UnreleasedTorque> torque,
                                 const device::Notices& notices)
{
    m_torque = std::move(torque);
    m_settings.clear();
    m_servos.clear();
    std::copy_if(notices.begin(), notices.end(), std::back_inserter(m_settings),
                 [](const device::Notice& notice) {
                     return notice.code == device::NoticeCode::SettingNotRestored;
                 });
    m_since = m_workbench.now();
    for (const jobs::UnreleasedTorque& one : m_torque)
        addServo(one.id);
    for (const device::Notice& one : m_settings)
        addServo(one.id);
    updateSubscription();
}

void TestLeftovers::addServo(int id)
{
    for (const ServoRef ref : m_workbench.registry().order()) {
        const device::Servo& servo = m_workbench.registry().servo(ref)->servo;
        if (servo.id == id && servo.profile &&
            (!m_workbench.link().canSetBaud() || servo.baud == m_workbench.link().baud()))
            m_servos[id] = servo.identity();
    }
}

/// The servo that was tested, not another one that answers under its ID.
bool TestLeftovers::concerns(const device::Servo& servo) const
{
    const auto left = m_servos.find(servo.id);
    if (left == m_servos.end() || !servo.profile)
        return false;
    const base::ServoIdentity identity = servo.identity();
    return identity.port == left->second.port && identity.isSameKind(left->second);
}

void TestLeftovers::updateSubscription()
{
    if (!std::exchange(m_subscribed, !empty()) && empty())
        return;
    Subscription wish;
    for (const ServoRef ref : m_workbench.registry().order()) {
        const device::Servo& servo = m_workbench.registry().servo(ref)->servo;
        if (!concerns(servo))
            continue;
        SubscriptionItem part{ref, {}, {}};
        for (const device::Notice& one : m_settings) {
            if (one.id == servo.id)
                part.slowKeys << one.key;
        }
        const bool torque = std::any_of(m_torque.begin(), m_torque.end(),
                                        [&](const auto& one) { return one.id == servo.id; });
        if (const auto* reg = torqueSwitch(servo); reg != nullptr && torque)
            part.slowKeys << reg->key;
        if (!part.slowKeys.isEmpty())
            wish.parts.push_back(part);
    }
    m_workbench.polling().subscribe(m_user, wish);
}

/// A servo without torque neither holds nor moves.
void TestLeftovers::check(ServoRef ref)
{
    const ServoEntry* known = empty() ? nullptr : m_workbench.registry().servo(ref);
    if (known == nullptr || !concerns(known->servo))
        return;
    const device::Servo& servo = known->servo;
    const auto off = [&](const jobs::UnreleasedTorque& one) {
        return one.id == servo.id && reads(servo, torqueSwitch(servo), 0, m_since);
    };
    const auto back = [&](const device::Notice& one) {
        return one.id == servo.id && reads(servo, servo.profile->find(one.key), one.a, m_since);
    };
    const std::size_t before = m_torque.size() + m_settings.size();
    m_torque.erase(std::remove_if(m_torque.begin(), m_torque.end(), off), m_torque.end());
    m_settings.erase(std::remove_if(m_settings.begin(), m_settings.end(), back), m_settings.end());
    if (m_torque.size() + m_settings.size() == before)
        return;
    updateSubscription();
    Q_EMIT changed();
}
} // namespace session
