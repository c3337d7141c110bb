// SPDX-License-Identifier: GPL-3.0-or-later
#include "history/history_profiles.h"

#include "catalog/value.h"
#include "snapshot/factory_snapshot.h"

namespace history {
void HistoryProfiles::add(const std::vector<HistoryServo>& servos)
{
    for (const HistoryServo& servo : servos) {
        snapshot::Snapshot like;
        const base::ServoIdentity& is = servo.identity;
        like.servo = {is.id,
                      is.model,
                      QStringLiteral("%1.%2").arg(is.modelMajor).arg(is.modelMinor),
                      QStringLiteral("%1.%2").arg(is.firmwareMajor).arg(is.firmwareMinor),
                      is.map,
                      base::protocolName(is.protocol)};
        // The history does not keep the byte order, which distinguishes some maps.
        snapshot::SnapshotRegister order;
        order.key = QStringLiteral("byte_order");
        for (const std::int64_t flag : {0, 1}) {
            order.raw = flag;
            like.registers = {order};
            if (const auto profile = snapshot::profileOf(like, m_catalog)) {
                m_profiles[servo.number] = profile;
                break;
            }
        }
    }
}

QString HistoryProfiles::registerName(const HistoryWrite& row, bool chinese) const
{
    const auto known = m_profiles.find(row.servo);
    const catalog::Register* reg =
        known != m_profiles.end() ? known->second->find(row.key) : nullptr;
    return reg != nullptr ? reg->name.in(chinese) : row.key;
}

QString HistoryProfiles::valueText(const HistoryWrite& row, std::int64_t raw, bool chinese) const
{
    const QString number = QString::number(qint64(raw));
    const auto known = m_profiles.find(row.servo);
    const catalog::Register* reg =
        known != m_profiles.end() ? known->second->find(row.key) : nullptr;
    if (reg == nullptr)
        return number;
    const QString words = catalog::formatValue(
        raw, *reg, catalog::valueFormat(*reg, *known->second, catalog::noLookup), chinese);
    return words == number ? number : number + QStringLiteral(" · ") + words;
}
} // namespace history
