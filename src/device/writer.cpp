// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/writer.h"

#include "device/mode.h"
#include "device/talk.h"

#include <algorithm>

namespace device {
using base::ErrorCode;
using catalog::Role;
using catalog::TorqueOff;

QString outcomeName(WriteOutcome outcome)
{
    switch (outcome) {
    case WriteOutcome::Kept:
        return QStringLiteral("kept");
    case WriteOutcome::Temporary:
        return QStringLiteral("temporary");
    case WriteOutcome::Mismatch:
        return QStringLiteral("mismatch");
    case WriteOutcome::Refused:
        return QStringLiteral("refused");
    case WriteOutcome::NoAnswer:
        return QStringLiteral("no-answer");
    case WriteOutcome::Unknown:
        return QStringLiteral("unknown");
    }
    return {};
}

QString lockName(LockState lock)
{
    switch (lock) {
    case LockState::Closed:
        return QStringLiteral("closed");
    case LockState::Open:
        return QStringLiteral("open");
    case LockState::Unknown:
        return QStringLiteral("unknown");
    case LockState::None:
        return QStringLiteral("none");
    }
    return {};
}

bool WriteReport::allGood() const
{
    const bool written = std::all_of(writes.begin(), writes.end(), [](const WriteResult& result) {
        return !result.error &&
               (result.outcome == WriteOutcome::Kept || result.outcome == WriteOutcome::Temporary);
    });
    return written && lock != LockState::Open && lock != LockState::Unknown;
}

namespace {
/// One write from the first byte to the last. Lives on the stack of write().
class WriteRun {
public:
    WriteRun(const Context& context, Servo& servo, std::vector<CheckedItem> items,
             const WriteOptions& options)
        : m_context(context)
        , m_servo(servo)
        , m_items(std::move(items))
        , m_options(options)
    {
        m_report.id = servo.id;
        for (const CheckedItem& item : m_items) {
            m_report.writes.push_back({item.reg->key,
                                       item.reg->address,
                                       servo.raw(*item.reg),
                                       item.raw,
                                       std::nullopt,
                                       WriteOutcome::Unknown,
                                       {}});
        }
    }

    bool concernsEprom() const
    {
        return std::any_of(m_items.begin(), m_items.end(),
                           [](const CheckedItem& item) { return item.reg->eprom(); });
    }

    /// The change of mode these items mean, if any; known after the settings have been read.
    void setModeChange(std::optional<ModeChange> change) { m_change = change; }

    WriteReport go();
    bool finished() const;

private:
    bool needsTorqueOff() const;
    base::Result<void> prepare();
    void writeAll();
    void writeGroup(std::size_t first, std::size_t last);
    base::Result<void> sendGroup(std::size_t first, std::size_t last);
    void judge(std::size_t index, const base::Result<void>& sent);
    void denyKept();
    void refuseRest(std::size_t first, const base::Error& why);

    const Context& m_context;
    Servo& m_servo;
    std::vector<CheckedItem> m_items;
    const WriteOptions& m_options;
    std::optional<ModeChange> m_change;
    bool m_kept = false; ///< the EPROM is open, so what is written stays
    bool m_unsettled = false;
    WriteReport m_report;
};

bool WriteRun::needsTorqueOff() const
{
    if (m_change)
        return true;
    return std::any_of(m_items.begin(), m_items.end(), [](const CheckedItem& item) {
        return item.reg->torqueOff == TorqueOff::Needed;
    });
}

/// Torque and, for a temporary write, a lock that somebody left open.
base::Result<void> WriteRun::prepare()
{
    if (needsTorqueOff()) {
        if (const auto off = torqueOff(m_context, m_servo); !off)
            return off;
    }
    const catalog::Register* lock = m_servo.profile->byRole(Role::Lock);
    if (!m_options.temporary || !concernsEprom() || lock == nullptr)
        return {};
    const auto flag = readRegister(m_context, m_servo, *lock);
    if (!flag)
        return tl::unexpected(flag.error());
    if (*flag != 0)
        return {};
    m_context.note(NoticeCode::LockFoundOpen, m_servo.id, lock->key);
    if (closeLock(m_context, m_servo) != LockState::Closed) {
        return tl::unexpected(
            base::Error{ErrorCode::LockOpen, QStringLiteral("write"), {}, m_servo.id, lock->key});
    }
    m_context.note(NoticeCode::LockClosed, m_servo.id, lock->key);
    return {};
}

void WriteRun::refuseRest(std::size_t first, const base::Error& why)
{
    for (std::size_t i = first; i < m_report.writes.size(); ++i) {
        WriteResult& result = m_report.writes[i];
        result.outcome = WriteOutcome::Refused;
        result.readBack = result.oldRaw;
        result.error = why;
    }
}

WriteReport WriteRun::go()
{
    if (const auto ready = prepare(); !ready) {
        refuseRest(0, ready.error());
        return m_report;
    }
    if (!concernsEprom() || m_options.temporary) {
        writeAll();
        if (concernsEprom())
            m_report.lock = LockState::Closed;
        return m_report;
    }
    auto eprom = UnlockedEprom::open(m_context, m_servo);
    if (!eprom) {
        refuseRest(0, eprom.error());
        m_report.lock = closeLock(m_context, m_servo);
        return m_report;
    }
    m_kept = true;
    writeAll();
    m_report.lock = eprom->close();
    if (m_report.lock == LockState::Closed && !eprom->stayedOpen())
        denyKept();
    return m_report;
}

/// The lock had closed by itself before the end, so nobody knows what the EPROM took.
void WriteRun::denyKept()
{
    for (WriteResult& result : m_report.writes) {
        if (result.outcome != WriteOutcome::Kept)
            continue;
        result.outcome = WriteOutcome::Temporary;
        result.error = base::Error{ErrorCode::Refused, QStringLiteral("keep"),
                                   QStringLiteral("restarted"), m_servo.id, result.key};
    }
}

void WriteRun::writeAll()
{
    std::size_t first = 0;
    while (first < m_items.size()) {
        // Neighbours go in one frame: both angle limits change at once, never one alone.
        std::size_t last = first + 1;
        while (last < m_items.size() &&
               m_items[last].reg->writeOffset ==
                   m_items[last - 1].reg->writeOffset + m_items[last - 1].reg->size)
            ++last;
        if (m_context.stop.requested()) {
            m_context.note(NoticeCode::BelowStop, m_servo.id, m_items[first].reg->key);
            refuseRest(first, {ErrorCode::Stopped, QStringLiteral("write"), {}, m_servo.id});
            return;
        }
        writeGroup(first, last);
        first = last;
    }
    if (m_change) {
        const auto settled = settleMode(m_context, m_servo, *m_change);
        m_unsettled = !settled;
        if (!settled)
            m_report.writes.back().error = settled.error();
    }
}

base::Result<void> WriteRun::sendGroup(std::size_t first, std::size_t last)
{
    base::Bytes data;
    for (std::size_t i = first; i < last; ++i) {
        const base::Bytes bytes = wireBytes(m_servo, *m_items[i].reg, m_items[i].raw);
        data.insert(data.end(), bytes.begin(), bytes.end());
    }
    const bool motion = std::any_of(m_items.begin() + static_cast<std::ptrdiff_t>(first),
                                    m_items.begin() + static_cast<std::ptrdiff_t>(last),
                                    [](const CheckedItem& item) { return item.reg->motion; });
    const auto repeat = motion ? protocol::Repeat::Never : protocol::Repeat::Safe;
    return writeBlock(m_context, m_servo, m_items[first].reg->writeOffset, std::move(data), repeat);
}

void WriteRun::writeGroup(std::size_t first, std::size_t last)
{
    constexpr int tries = 2;
    const auto showsOld = [this](std::size_t i) {
        const WriteResult& result = m_report.writes[i];
        return result.readBack && result.readBack == result.oldRaw &&
               result.oldRaw != result.newRaw;
    };
    for (int attempt = 0; attempt < tries; ++attempt) {
        const auto sent = sendGroup(first, last);
        if (m_items[first].reg->eprom())
            m_context.bus.clock().sleepFor(epromWriteTime);
        for (std::size_t i = first; i < last; ++i)
            judge(i, sent);
        // Reading proved that nothing happened, so sending again repeats nothing. A servo that
        // acknowledged and kept the old value has refused: asking twice changes nothing.
        const bool untouched = !sent || !m_servo.answersWrites();
        if (!untouched || !showsOld(first) || m_items[first].reg->motion)
            return;
        if (attempt + 1 < tries)
            m_context.note(NoticeCode::AnswerLostSentAgain, m_servo.id, m_items[first].reg->key);
    }
}

void WriteRun::judge(std::size_t index, const base::Result<void>& sent)
{
    const CheckedItem& item = m_items[index];
    WriteResult& result = m_report.writes[index];
    const auto back = readRegister(m_context, m_servo, *item.reg);
    if (!back) {
        result.outcome = back.error().code == ErrorCode::LinkLost ? WriteOutcome::Unknown
                                                                  : WriteOutcome::NoAnswer;
        result.error = back.error();
        return;
    }
    result.readBack = *back;
    result.error.reset();
    if (*back == item.raw) {
        result.outcome = item.reg->eprom() && m_kept ? WriteOutcome::Kept : WriteOutcome::Temporary;
        if (!sent)
            m_context.note(NoticeCode::AnswerLostButDone, m_servo.id, item.reg->key);
        return;
    }
    result.outcome = result.oldRaw == *back ? WriteOutcome::Refused : WriteOutcome::Mismatch;
    result.error = base::Error{
        result.outcome == WriteOutcome::Refused ? ErrorCode::Refused : ErrorCode::Mismatch,
        QStringLiteral("write"), QString::number(*back), m_servo.id, item.reg->key};
}

/// False while the wire still owes an answer: the intent then stays open in the journal.
bool WriteRun::finished() const
{
    const bool certain =
        std::none_of(m_report.writes.begin(), m_report.writes.end(), [](const WriteResult& result) {
            return result.outcome == WriteOutcome::Unknown ||
                   result.outcome == WriteOutcome::NoAnswer;
        });
    return certain && !m_unsettled && m_report.lock != LockState::Open &&
           m_report.lock != LockState::Unknown;
}

base::Intent intentFor(const Servo& servo, const std::vector<CheckedItem>& items,
                       const WriteOptions& options, bool unlocks)
{
    base::Intent intent;
    intent.kind = options.kind;
    intent.temporary = options.temporary;
    intent.lockOpened = unlocks;
    intent.servo = servo.identity();
    for (const CheckedItem& item : items) {
        intent.items.push_back(
            {item.reg->key, item.reg->address, servo.raw(*item.reg).value_or(0), item.raw});
    }
    return intent;
}
} // namespace

base::Result<WriteReport> write(const Context& outer, Servo& servo,
                                const std::vector<WriteItem>& items, const WriteOptions& options)
{
    auto checked = checkItems(servo, items, options);
    if (!checked)
        return tl::unexpected(checked.error());
    const Owned owned = own(outer, {servo.id});
    const Context& context = owned.context;
    if (const auto fresh = readSettings(context, servo); !fresh)
        return tl::unexpected(fresh.error());
    if (const auto valid = checkValues(context, servo, *checked); !valid)
        return tl::unexpected(valid.error());
    const auto change = modeChange(servo, *checked);
    if (change) {
        if (const auto kept = rememberWayBack(context, servo, *change, *checked); !kept)
            return tl::unexpected(kept.error());
    }
    if (context.stop.requested())
        return base::fail(ErrorCode::Stopped, QStringLiteral("write"), {}, servo.id);

    WriteRun run(context, servo, *checked, options);
    run.setModeChange(change);
    const bool unlocks = run.concernsEprom() && !options.temporary;
    const auto uuid = context.journal.begin(intentFor(servo, *checked, options, unlocks));
    if (!uuid)
        return tl::unexpected(uuid.error());
    WriteReport report = run.go();
    if (run.finished()) {
        const QString outcome =
            report.allGood() ? QStringLiteral("done") : QStringLiteral("failed");
        if (const auto ended = context.journal.end(*uuid, {outcome, {}}); !ended)
            return tl::unexpected(ended.error());
    }
    return report;
}
} // namespace device
