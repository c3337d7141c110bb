// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/commission_names.h"

#include "record/history.h"

namespace session {
namespace {
base::Result<void> withoutServo(const base::Result<record::HistoryServo>& servo)
{
    return servo ? base::Result<void>() : tl::unexpected(servo.error());
}

struct Known {
    std::unique_ptr<record::History> history;
    std::optional<record::HistoryServo> servo; ///< who stands under that ID
};

base::Result<Known> look(const QString& path, const base::ServoIdentity& who)
{
    auto history = record::History::open(path);
    if (!history)
        return tl::unexpected(history.error());
    auto servo = (*history)->log().of(who);
    if (!servo)
        return tl::unexpected(servo.error());
    return Known{std::move(*history), std::move(*servo)};
}

/// `own`: its present name, if it has one, was given to this very servo.
base::Result<void> giveName(const record::HistoryLog& log, const base::ServoIdentity& who,
                            const QString& label, bool own)
{
    const auto known = log.of(who);
    if (!known)
        return tl::unexpected(known.error());
    if (*known && (*known)->label == label)
        return {};
    if (*known && !own)
        return withoutServo(log.another((*known)->number, label));
    const auto met = log.meet(who);
    if (!met)
        return tl::unexpected(met.error());
    const auto named = log.setLabel(met->number, label);
    const bool inUse = !named && named.error().code == base::ErrorCode::BadArgument;
    return inUse ? withoutServo(log.another(met->number, label)) : named;
}
} // namespace

base::Result<void> CommissionNames::meet(const device::Servo& servo)
{
    m_given.clear();
    const base::ServoIdentity who = servo.identity();
    const auto known = look(m_history, who);
    if (!known)
        return tl::unexpected(known.error());
    const auto& servoThere = known->servo;
    if (!servoThere || servoThere->label.isEmpty())
        return {};
    const auto parted = known->history->log().another(servoThere->number, QString());
    if (!parted)
        return tl::unexpected(parted.error());
    m_aside = Aside{who, servoThere->label};
    return {};
}

base::Result<void> CommissionNames::name(const device::Servo& servo, const QString& label,
                                         bool another)
{
    const base::ServoIdentity who = servo.identity();
    const auto known = look(m_history, who);
    if (!known)
        return tl::unexpected(known.error());
    const record::HistoryLog log = known->history->log();
    const bool given = known->servo && !m_given.isEmpty() && known->servo->label == m_given;
    if (const auto named = giveName(log, who, label, given || !another); !named)
        return named;
    m_given = label;
    const auto aside = std::exchange(m_aside, std::nullopt);
    const bool free = aside && !(aside->who.id == who.id && aside->who.sameKind(who));
    return free ? giveName(log, aside->who, aside->label, false) : base::Result<void>();
}
} // namespace session
