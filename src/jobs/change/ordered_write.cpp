// SPDX-License-Identifier: GPL-3.0-or-later
#include "jobs/change/ordered_write.h"

#include "device/consent.h"
#include "device/motion/motion.h"
#include "device/write_access.h"
#include "device/write_meaning.h"
#include "jobs/change/change.h"

#include <algorithm>

namespace jobs {
namespace {
using catalog::Role;
using device::Context;
using device::Servo;
using device::WriteItem;
using device::WriteProcedure;
using device::WriteReport;

base::Result<WriteReport> switchTorque(const Context& context, Servo& servo, const WriteItem& item)
{
    const catalog::Register& reg = *servo.profile->find(item.key);
    const QString name = device::valueName(reg, item.raw);
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

/// Reported as its effect: the correction that the offset register holds afterwards.
base::Result<WriteReport> centerHere(const Context& context, Servo& servo)
{
    const auto centered = center(context, servo);
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
    const int rate = device::valueName(*servo.profile->find(item.key), item.raw).toInt(&known);
    if (!known) {
        return tl::unexpected(base::Error{base::ErrorCode::OutOfRange, QStringLiteral("write"),
                                          QString::number(item.raw), servo.id, item.key});
    }
    return changeBaud(context, servo, rate);
}

base::Result<WriteReport> writeSpecial(const Context& context, Servo& servo, const WriteItem& item,
                                       WriteProcedure procedure)
{
    switch (procedure) {
    case WriteProcedure::Torque:
        return switchTorque(context, servo, item);
    case WriteProcedure::Center:
        return centerHere(context, servo);
    case WriteProcedure::BaudRate:
        return changeRate(context, servo, item);
    default:
        return changeId(context, servo, static_cast<int>(item.raw));
    }
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

const QString writeBack = QStringLiteral("write-back");

std::optional<std::int64_t> valueFor(const std::vector<WriteItem>& items, const QString& key)
{
    const auto item = std::find_if(items.begin(), items.end(),
                                   [&](const WriteItem& one) { return one.key == key; });
    return item != items.end() ? std::optional(item->raw) : std::nullopt;
}

device::WriteMeaning meaningOf(const Servo& servo, const WriteItem& item)
{
    const catalog::Register* reg = servo.profile->find(item.key);
    // The safe write refuses a register that does not exist, with the reason.
    return reg != nullptr ? device::classify(*reg, item.raw) : device::WriteMeaning{};
}

/// Before the first byte of the mixture, by what has been read; the special procedures do not ask,
/// and the safe write asks again with fresh limits.
base::Result<void> requireConsents(const Servo& servo, const std::vector<WriteItem>& items,
                                   device::Consent consent)
{
    device::RegisterValues values;
    for (const WriteItem& item : items) {
        if (const catalog::Register* reg = servo.profile->find(item.key))
            values.push_back({reg, item.raw});
    }
    return device::requireConsent(servo, values, consent);
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
                                const device::WriteOptions& options, SpecialRegisters special,
                                std::optional<WriteReport>& report)
{
    if (special == SpecialRegisters::Refuse) {
        const auto written = device::write(context, servo, items, options);
        if (!written)
            return tl::unexpected(written.error());
        report = *written;
        return {};
    }
    if (const auto allowed = requireConsents(servo, items, options.consent); !allowed)
        return allowed;
    std::vector<WriteItem> ordered = items;
    std::stable_sort(ordered.begin(), ordered.end(), [&](const WriteItem& a, const WriteItem& b) {
        return meaningOf(servo, a).procedure < meaningOf(servo, b).procedure;
    });
    for (auto first = ordered.cbegin(); first != ordered.cend();) {
        if (context.stop.isRequested())
            return base::fail(base::ErrorCode::Stopped, QStringLiteral("write"), {}, servo.id);
        const device::WriteMeaning meaning = meaningOf(servo, *first);
        const bool isPlain = meaning.isRegisterWrite();
        const auto last = isPlain
                              ? std::find_if(first, ordered.cend(),
                                             [&](const WriteItem& item) {
                                                 return !meaningOf(servo, item).isRegisterWrite();
                                             })
                              : first + 1;
        const auto part = isPlain ? device::write(context, servo, {first, last}, options)
                                  : writeSpecial(context, servo, *first, meaning.procedure);
        if (!part)
            return tl::unexpected(part.error());
        append(report, *part);
        first = last;
    }
    return {};
}
} // namespace jobs
