// SPDX-License-Identifier: GPL-3.0-or-later
#include "snapshot/snapshot_template.h"

#include <algorithm>

namespace snapshot {
namespace {
tl::unexpected<base::Error> refuse(base::ErrorCode code, const QString& key, const char* detail,
                                   base::Reason reason = base::Reason::None)
{
    base::Error error{code, QStringLiteral("template"), QLatin1String(detail)};
    error.registerKey = key;
    error.reason = reason;
    return tl::unexpected(error);
}
} // namespace

bool isIdentityKey(const QString& key)
{
    // The same in every map; tst_bundle checks all maps.
    return key == QLatin1String("id") || key == QLatin1String("baud_rate");
}

base::Result<Snapshot> makeTemplate(const Snapshot& from, const QStringList& keys, bool identity)
{
    if (keys.isEmpty())
        return refuse(base::ErrorCode::BadArgument, {}, "empty");
    Snapshot chosen = from;
    chosen.isTemplate = true;
    chosen.registers.clear();
    for (const QString& key : keys) {
        const SnapshotRegister* reg = from.find(key);
        if (reg == nullptr)
            return refuse(base::ErrorCode::UnknownRegister, key, "");
        if (reg->access != catalog::Access::ReadWrite)
            return refuse(base::ErrorCode::BadArgument, key, "read-only",
                          base::Reason::ReadOnlyRegister);
        if (isIdentityKey(key) && !identity)
            return refuse(base::ErrorCode::BadArgument, key, "identity",
                          base::Reason::IdentityRegister);
        if (!reg->raw)
            return refuse(base::ErrorCode::BadArgument, key, "no-value", base::Reason::NoValue);
        if (chosen.find(key) == nullptr)
            chosen.registers.push_back(*reg);
    }
    std::stable_sort(chosen.registers.begin(), chosen.registers.end(),
                     [](const auto& a, const auto& b) { return a.address < b.address; });
    return chosen;
}
} // namespace snapshot
