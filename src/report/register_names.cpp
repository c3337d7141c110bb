// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/register_names.h"

#include "catalog/catalog.h"
#include "report/bilingual.h"

namespace report {
RegisterNames::RegisterNames(const QString& model, const QString& firmware)
{
    static const catalog::Catalog builtIn = catalog::Catalog::load().catalog;
    const catalog::ModelEntry* known = builtIn.model(model);
    const QStringList version = firmware.split(QLatin1Char('.'));
    if (known != nullptr && version.size() == 2)
        m_profile = builtIn.profileFor(*known, version[0].toInt(), version[1].toInt());
}

catalog::Text RegisterNames::name(const QString& key) const
{
    const catalog::Register* reg = m_profile ? m_profile->find(key) : nullptr;
    return reg != nullptr && !reg->name.en.isEmpty() ? reg->name : inBoth(key);
}
} // namespace report
