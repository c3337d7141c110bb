// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalog/family_facts.h"

#include <QStringList>

namespace catalog {
namespace {
const QLatin1Char separator('|');
constexpr int fieldCount = 8;
} // namespace

QString FamilyFacts::detail() const
{
    return QStringList{firmware,
                       firmwareSeries,
                       QString::number(byteOrderFlag),
                       modelId,
                       modelName,
                       QString::number(modelFlag),
                       QString::number(lockAddress),
                       QString::number(lock)}
        .join(separator);
}

std::optional<FamilyFacts> FamilyFacts::fromDetail(const QString& detail)
{
    const QStringList fields = detail.split(separator);
    if (fields.size() != fieldCount)
        return std::nullopt;
    FamilyFacts facts;
    facts.firmware = fields[0];
    facts.firmwareSeries = fields[1];
    facts.byteOrderFlag = fields[2].toInt();
    facts.modelId = fields[3];
    facts.modelName = fields[4];
    facts.modelFlag = fields[5].toInt();
    facts.lockAddress = fields[6].toInt();
    facts.lock = fields[7].toLongLong();
    return facts;
}
} // namespace catalog
