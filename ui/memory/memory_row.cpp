// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/memory/memory_row.h"

#include "device/persistence.h"

#include <array>

namespace ui {
using catalog::Area;
using catalog::Role;
using device::WriteOutcome;

namespace {
constexpr std::array ageSteps{0, 1, 2, 3, 5, 10, 15, 20, 30, 45};

/// After this time in seconds a value is out of date. Settings change only when they are written.
int staleAfter(Area area)
{
    switch (area) {
    case Area::Feedback:
        return 3;
    case Area::Sram:
        return 30;
    case Area::Eprom:
    case Area::Factory:
        break;
    }
    return 300;
}

RowState stateOf(WriteOutcome outcome)
{
    switch (outcome) {
    case WriteOutcome::Kept:
        return RowState::Kept;
    case WriteOutcome::Temporary:
        return RowState::Temporary;
    case WriteOutcome::Mismatch:
        return RowState::Mismatch;
    case WriteOutcome::Refused:
        return RowState::Refused;
    case WriteOutcome::NotSent:
        return RowState::NotSent;
    case WriteOutcome::NoReply:
        return RowState::NoReply;
    case WriteOutcome::Unknown:
        break;
    }
    return RowState::Unknown;
}

/// Refused before the first byte: the servo was not changed.
bool isRefusedBeforeSending(base::ErrorCode code)
{
    using base::ErrorCode;
    switch (code) {
    case ErrorCode::OutOfRange:
    case ErrorCode::ReadOnly:
    case ErrorCode::NeedsConsent:
    case ErrorCode::UnknownRegister:
    case ErrorCode::BadArgument:
    case ErrorCode::IdInUse:
    case ErrorCode::FileUnwritable:
    case ErrorCode::DiskFull:
        return true;
    default:
        return false;
    }
}

RowState readState(const session::ServoEntry& entry, const MemoryRow& row)
{
    if (entry.unreadable.count(row.reg->key) > 0)
        return RowState::Unreadable;
    return row.raw ? RowState::Read : RowState::NotRead;
}

/// The result of the last write while it still applies to the displayed value.
RowState writeState(const session::ServoEntry& entry, const MemoryRow& row,
                    const session::RegisterWriteState& write)
{
    if (row.pending > 0)
        return RowState::Pending;
    if (!write.outcome)
        return write.error ? RowState::NotWritten : readState(entry, row);
    if (write.error && isRefusedBeforeSending(write.error->code))
        return RowState::NotWritten;
    const RowState state = stateOf(*write.outcome);
    const bool isDone = state == RowState::Kept || state == RowState::Temporary;
    if (!isDone)
        return state;
    if (entry.unreadable.count(row.reg->key) > 0)
        return RowState::Unreadable;
    const auto readAt = entry.servo.image.readAt(row.reg->offset);
    const bool readSince = row.raw && readAt && *readAt > write.at;
    if (!readSince || *row.raw == write.requested)
        return state;
    // Goals, torque and similar values change by themselves; settings do not.
    return device::isPersistent(*row.reg) ? RowState::Superseded : RowState::Read;
}

bool sameError(const std::optional<base::Error>& a, const std::optional<base::Error>& b)
{
    if (!a || !b)
        return a.has_value() == b.has_value();
    return a->code == b->code && a->operation == b->operation && a->detail == b->detail;
}

bool sameMeaning(const catalog::ValueFormat& a, const catalog::ValueFormat& b)
{
    return a.encoding == b.encoding && a.scale == b.scale && a.unit == b.unit && a.min == b.min &&
           a.max == b.max && a.name.en == b.name.en && a.assumed == b.assumed;
}
} // namespace

RowAge rowAge(std::optional<base::Duration> readAt, base::Duration now)
{
    if (!readAt)
        return {};
    const auto whole = std::max<std::int64_t>(
        0, std::chrono::duration_cast<std::chrono::seconds>(now - *readAt).count());
    constexpr std::int64_t minute = 60;
    constexpr std::int64_t longest = 99 * minute * minute;
    if (whole >= minute)
        return {static_cast<int>(std::min(whole, longest) / minute * minute)};
    int shown = 0;
    for (const int step : ageSteps)
        shown = whole >= step ? step : shown;
    return {shown};
}

std::optional<bool> MemoryRow::differsFromDefault() const
{
    if (!raw || !reg->defaultRaw)
        return std::nullopt;
    return *raw != *reg->defaultRaw;
}

bool MemoryRow::sameAs(const MemoryRow& other) const
{
    return reg == other.reg && raw == other.raw && firstRaw == other.firstRaw &&
           requestedRaw == other.requestedRaw && pending == other.pending && state == other.state &&
           age == other.age && isStale == other.isStale && hasSensor == other.hasSensor &&
           isWritable == other.isWritable && sameError(error, other.error) &&
           sameMeaning(meaning, other.meaning);
}

MemoryRow memoryRow(const session::ServoEntry& entry, const catalog::Register& reg,
                    const RowContext& clock)
{
    MemoryRow row;
    row.reg = &reg;
    row.meaning = entry.servo.meaning(reg);
    row.raw = entry.displayedRaw(reg);
    row.firstRaw = entry.firstRaw(reg);
    row.hasSensor = entry.servo.measures(reg);
    row.isWritable = entry.servo.profile->writable && reg.writable();
    row.state = readState(entry, row);
    if (const auto found = entry.writes.find(reg.key); found != entry.writes.end()) {
        row.pending = found->second.pending;
        row.requestedRaw = found->second.requested;
        row.error = found->second.error;
        row.state = writeState(entry, row, found->second);
    }
    const auto readAt = entry.servo.image.readAt(reg.offset);
    row.age = rowAge(row.raw ? readAt : std::nullopt, clock.now);
    row.isStale = row.raw && (!clock.isLinkOpen || entry.silent ||
                              clock.now - *readAt >= std::chrono::seconds(staleAfter(reg.area)));
    return row;
}
} // namespace ui
