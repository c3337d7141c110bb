// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/ordered_write.h"

#include "device/motion/motion.h"
#include "device/write_access.h"
#include "jobs/change/change.h"

#include <algorithm>

namespace session {
namespace {
using catalog::Role;
using device::Context;
using device::Servo;
using device::WriteItem;
using device::WriteReport;

/// The name this number has in the register's list; empty if it has none.
QString nameOf(const catalog::Register& reg, std::int64_t raw)
{
    for (const catalog::NamedValue& value : reg.values) {
        if (value.value == raw && reg.encoding == catalog::Encoding::Enum)
            return value.key;
    }
    return {};
}

enum class Way : std::uint8_t { Torque, Center, Plain, Rate, Id }; ///< in the order of writing

/// Of a fault reset register: "the present position becomes the middle" (Modbus sheet).
constexpr std::int64_t centerBit = 4;

Way wayOf(const catalog::Register* reg, std::int64_t raw)
{
    if (reg == nullptr)
        return Way::Plain; // refused there, with the reason
    switch (reg->role) {
    case Role::Id:
        return Way::Id;
    case Role::BaudRate:
        return Way::Rate;
    case Role::TorqueSwitch:
        return nameOf(*reg, raw) == QLatin1String("center") ? Way::Center : Way::Torque;
    case Role::FaultReset:
        return (raw & centerBit) != 0 ? Way::Center : Way::Plain;
    default:
        return Way::Plain;
    }
}

base::Result<WriteReport> switchTorque(const Context& context, Servo& servo, const WriteItem& item)
{
    const catalog::Register& reg = *servo.profile->find(item.key);
    const QString name = nameOf(reg, item.raw);
    const auto torque = name == QLatin1String("damp") ? device::Torque::Damp
                        : item.raw == 0               ? device::Torque::Off
                                                      : device::Torque::On;
    const auto before = servo.raw(reg);
    if (const auto done = device::setTorque(context, servo, torque); !done)
        return tl::unexpected(done.error());
    WriteReport report;
    report.id = servo.id;
    report.writes.push_back({item.key, reg.address, before, item.raw, servo.raw(reg),
                             device::WriteOutcome::Temporary, std::nullopt});
    return report;
}

/// Shown as what it does: the correction that stands in the offset register afterwards.
base::Result<WriteReport> centerHere(const Context& context, Servo& servo)
{
    const auto centered = jobs::center(context, servo);
    if (!centered)
        return tl::unexpected(centered.error());
    WriteReport report;
    report.id = servo.id;
    report.lock = centered->lock;
    const catalog::Register* offset = servo.profile->byRole(Role::PositionOffset);
    if (offset != nullptr && centered->offsetAfter) {
        report.writes.push_back({offset->key, offset->address, centered->offsetBefore,
                                 *centered->offsetAfter, centered->offsetAfter,
                                 device::WriteOutcome::Kept, std::nullopt});
    }
    return report;
}

base::Result<WriteReport> changeRate(const Context& context, Servo& servo, const WriteItem& item)
{
    bool known = false;
    const int rate = nameOf(*servo.profile->find(item.key), item.raw).toInt(&known);
    if (!known) {
        return tl::unexpected(base::Error{base::ErrorCode::OutOfRange, QStringLiteral("write"),
                                          QString::number(item.raw), servo.id, item.key});
    }
    return jobs::changeBaud(context, servo, rate);
}

void append(std::optional<WriteReport>& sum, const WriteReport& part)
{
    if (!sum) {
        sum = part;
        return;
    }
    sum->id = part.id;
    if (part.lock != device::LockState::None)
        sum->lock = part.lock;
    for (const device::WriteResult& write : part.writes)
        sum->writes.push_back(write);
}
} // namespace

namespace {
const QString writeBack = QStringLiteral("write-back");

std::optional<std::int64_t> valueFor(const std::vector<WriteItem>& items, const QString& key)
{
    const auto item = std::find_if(items.begin(), items.end(),
                                   [&](const WriteItem& one) { return one.key == key; });
    return item != items.end() ? std::optional(item->raw) : std::nullopt;
}
} // namespace

bool isChangedSince(const base::Error& error)
{
    return error.code == base::ErrorCode::Mismatch && error.operation == writeBack;
}

base::Result<void> requireUnchanged(const Context& context, Servo& servo,
                                    const std::vector<WriteItem>& expected,
                                    const std::vector<WriteItem>& items)
{
    if (expected.empty())
        return {};
    const auto may = device::beginWriting(context, servo, QStringLiteral("write"));
    if (!may)
        return may;
    QStringList keys;
    for (const WriteItem& item : expected)
        keys << item.key;
    if (const auto read = device::readKeys(context, servo, keys); !read)
        return read;
    for (const WriteItem& item : expected) {
        const auto found = servo.raw(item.key);
        const auto target = valueFor(items, item.key);
        if (!found || found == item.raw || found == target)
            continue;
        const QString values =
            QStringLiteral("%1 %2 %3").arg(*found).arg(item.raw).arg(target.value_or(item.raw));
        return tl::unexpected(
            base::Error{base::ErrorCode::Mismatch, writeBack, values, servo.id, item.key});
    }
    return {};
}

base::Result<void> writeInOrder(const Context& context, Servo& servo,
                                const std::vector<WriteItem>& items,
                                const device::WriteOptions& options,
                                std::optional<WriteReport>& report)
{
    std::vector<WriteItem> ordered = items;
    const auto way = [&](const WriteItem& item) {
        return wayOf(servo.profile->find(item.key), item.raw);
    };
    std::stable_sort(ordered.begin(), ordered.end(),
                     [&](const WriteItem& a, const WriteItem& b) { return way(a) < way(b); });
    for (std::size_t i = 0; i < ordered.size();) {
        if (context.stop.isRequested())
            return base::fail(base::ErrorCode::Stopped, QStringLiteral("write"), {}, servo.id);
        std::size_t end = i + 1;
        std::vector<WriteItem> plain{ordered[i]};
        const Way how = way(ordered[i]);
        while (how == Way::Plain && end < ordered.size() && way(ordered[end]) == Way::Plain)
            plain.push_back(ordered[end++]);
        const auto part = how == Way::Torque   ? switchTorque(context, servo, ordered[i])
                          : how == Way::Center ? centerHere(context, servo)
                          : how == Way::Rate   ? changeRate(context, servo, ordered[i])
                          : how == Way::Id
                              ? jobs::changeId(context, servo, static_cast<int>(ordered[i].raw))
                              : device::write(context, servo, plain, options);
        if (!part)
            return tl::unexpected(part.error());
        append(report, *part);
        i = end;
    }
    return {};
}
} // namespace session
