// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalog/profile.h"

#include <algorithm>

namespace catalog {
namespace {
QString pairText(int major, int minor)
{
    if (major < 0 || minor < 0)
        return QStringLiteral("?");
    return QStringLiteral("%1.%2").arg(major).arg(minor);
}

template <typename List, typename Predicate>
auto firstOf(const List& list, Predicate predicate) -> decltype(&*list.begin())
{
    const auto it = std::find_if(list.begin(), list.end(), predicate);
    return it == list.end() ? nullptr : &*it;
}
} // namespace

QString Identity::firmware() const
{
    return pairText(firmwareMajor, firmwareMinor);
}

QString Identity::modelId() const
{
    return pairText(modelMajor, modelMinor);
}

const Register* Profile::find(const QString& key) const
{
    return firstOf(registers, [&](const Register& reg) { return reg.key == key; });
}

const Register* Profile::byRole(Role role) const
{
    if (role == Role::None)
        return nullptr;
    return firstOf(registers, [&](const Register& reg) { return reg.role == role; });
}

const Register* Profile::at(int offset) const
{
    return firstOf(registers, [&](const Register& reg) {
        return reg.offset <= offset && offset < reg.offset + reg.size;
    });
}

const Mode* Profile::mode(const QString& key) const
{
    return firstOf(modes, [&](const Mode& mode) { return mode.key == key; });
}
} // namespace catalog
