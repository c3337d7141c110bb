// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/commission/commission_labels.h"

#include "history/history.h"

namespace session {
namespace {
base::Result<void> withoutServo(const base::Result<history::HistoryServo>& servo)
{
    return servo ? base::Result<void>() : tl::unexpected(servo.error());
}

struct Known {
    std::unique_ptr<history::History> history;
    std::optional<history::HistoryServo> servo; ///< that has this ID in the history
};

base::Result<Known> look(const QString& path, const base::ServoIdentity& identity)
{
    auto history = history::History::open(path);
    if (!history)
        return tl::unexpected(history.error());
    auto servo = (*history)->log().of(identity);
    if (!servo)
        return tl::unexpected(servo.error());
    return Known{std::move(*history), std::move(*servo)};
}

/// `own`: its present name, if it has one, was given to this servo.
base::Result<void> giveName(const history::HistoryLog& log, const base::ServoIdentity& identity,
                            const QString& label, bool own)
{
    const auto known = log.of(identity);
    if (!known)
        return tl::unexpected(known.error());
    if (*known && (*known)->label == label)
        return {};
    if (*known && !own)
        return withoutServo(log.assignToOther((*known)->number, label));
    const auto servo = log.findOrAdd(identity);
    if (!servo)
        return tl::unexpected(servo.error());
    const auto named = log.setLabel(servo->number, label);
    const bool inUse = !named && named.error().code == base::ErrorCode::BadArgument;
    return inUse ? withoutServo(log.assignToOther(servo->number, label)) : named;
}
} // namespace

base::Result<void> CommissionLabels::servoFound(const device::Servo& servo)
{
    m_assigned.clear();
    const base::ServoIdentity identity = servo.identity();
    const auto known = look(m_history, identity);
    if (!known)
        return tl::unexpected(known.error());
    const auto& servoThere = known->servo;
    if (!servoThere || servoThere->label.isEmpty())
        return {};
    const auto parted = known->history->log().assignToOther(servoThere->number, QString());
    if (!parted)
        return tl::unexpected(parted.error());
    m_parked = ParkedLabel{identity, servoThere->label};
    return {};
}

base::Result<void> CommissionLabels::setLabel(const device::Servo& servo, const QString& label,
                                              bool assignToOther)
{
    const base::ServoIdentity identity = servo.identity();
    const auto known = look(m_history, identity);
    if (!known)
        return tl::unexpected(known.error());
    const history::HistoryLog log = known->history->log();
    const bool given = known->servo && !m_assigned.isEmpty() && known->servo->label == m_assigned;
    if (const auto named = giveName(log, identity, label, given || !assignToOther); !named)
        return named;
    m_assigned = label;
    const auto parked = std::exchange(m_parked, std::nullopt);
    const bool free =
        parked && !(parked->identity.id == identity.id && parked->identity.isSameKind(identity));
    return free ? giveName(log, parked->identity, parked->label, false) : base::Result<void>();
}
} // namespace session
