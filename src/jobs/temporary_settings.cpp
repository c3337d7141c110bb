// SPDX-License-Identifier: GPL-3.0-or-later
#include "jobs/temporary_settings.h"

#include "device/motion/motion.h"
#include "device/motion/move_limits.h"
#include "jobs/link_reconnect.h"
#include "jobs/motion_check.h"

#include <algorithm>
#include <map>

namespace jobs {
using base::ErrorCode;
using catalog::Role;
using device::NoticeCode;

namespace {
constexpr int maxRestoreRounds = 3;
constexpr base::Duration retryDelay = std::chrono::milliseconds(50);

/// The one intent covers all writes in between: two open intents about one register would
/// contradict each other. The values that a mode switch saves for the way back are kept only as
/// long as the switch lasts.
class ShadowJournal final : public base::Journal {
public:
    explicit ShadowJournal(base::Journal& outer)
        : m_outer(outer)
    {}
    base::Result<QString> begin(const base::Intent&) override { return QString(); }
    base::Result<void> end(const QString&, const base::IntentResult&) override { return {}; }
    base::Result<std::vector<base::JournalEntry>> entries() const override
    {
        return m_outer.entries();
    }
    base::Result<void> saveServoValues(const base::ServoIdentity&, const QString& name,
                                       const std::vector<std::int64_t>& values) override
    {
        m_savedValues[name] = values;
        return {};
    }
    base::Result<std::optional<std::vector<std::int64_t>>>
    servoValues(const base::ServoIdentity& servo, const QString& name) const override
    {
        const auto own = m_savedValues.find(name);
        if (own != m_savedValues.end())
            return std::optional(own->second);
        return m_outer.servoValues(servo, name);
    }

private:
    base::Journal& m_outer;
    std::map<QString, std::vector<std::int64_t>> m_savedValues;
};

base::Result<void> toResult(const device::WriteReport& report)
{
    if (report.isSuccessful())
        return {};
    for (const device::WriteResult& result : report.writes) {
        if (result.error)
            return tl::unexpected(*result.error);
    }
    return base::fail(ErrorCode::LockOpen, QStringLiteral("write"), {}, report.id);
}

base::Intent makeTrialIntent(const device::Servo& servo,
                             const std::vector<base::JournalItem>& items)
{
    base::Intent intent;
    intent.kind = base::IntentKind::Trial;
    intent.temporary = true;
    intent.servo = servo.identity();
    intent.items = items;
    return intent;
}

/// Ends an intent of which nothing was written.
base::IntentResult notSentEnd(const std::vector<base::JournalItem>& items)
{
    base::IntentResult end{QStringLiteral("failed"), {}};
    for (const base::JournalItem& item : items)
        end.items.push_back({item.key, {}, QStringLiteral("not-sent")});
    return end;
}

std::vector<device::WriteItem> previousValues(const std::vector<base::JournalItem>& items)
{
    std::vector<device::WriteItem> old;
    for (const base::JournalItem& item : items)
        old.push_back({item.key, item.oldRaw});
    return old;
}
} // namespace

TemporarySettings::TemporarySettings(const device::Context& context, device::Servo& servo,
                                     bool mode)
    : m_context(context)
    , m_servo(servo)
    , m_mode(mode)
    , m_emergencyCount(context.bus.emergencyCount())
{}

TemporarySettings::~TemporarySettings()
{
    (void)revert();
}

TemporarySettings::CreateResult
TemporarySettings::create(const device::Context& context, device::Servo& servo,
                          const std::vector<device::WriteItem>& items, bool mode)
{
    std::unique_ptr<TemporarySettings> made(new TemporarySettings(context, servo, mode));
    if (const auto begun = made->begin(items); !begun)
        return tl::unexpected(begun.error());
    return made;
}

TemporarySettings::CreateResult TemporarySettings::set(const device::Context& context,
                                                       device::Servo& servo,
                                                       const std::vector<device::WriteItem>& items)
{
    return create(context, servo, items, false);
}

TemporarySettings::CreateResult TemporarySettings::positionMode(const device::Context& context,
                                                                device::Servo& servo)
{
    if (const auto fresh = device::readSettings(context, servo); !fresh)
        return tl::unexpected(fresh.error());
    if (isInPositionMode(servo))
        return std::unique_ptr<TemporarySettings>();
    const QString wanted = QStringLiteral("position");
    if (servo.profile->mode(wanted) == nullptr) {
        return tl::unexpected(base::Error{ErrorCode::NotSupported, QStringLiteral("mode"),
                                          QStringLiteral("not-position"), servo.id});
    }
    const auto plan = device::planMode(context, servo, wanted);
    if (!plan)
        return tl::unexpected(plan.error());
    std::vector<device::WriteItem> items;
    for (const device::ModePlan::Write& write : plan->writes)
        items.push_back({write.key, write.newRaw});
    auto made = create(context, servo, items, true);
    if (made && plan->limitsSetToDefault)
        context.note(NoticeCode::LimitsSetToDefault, servo.id, {}, items[0].raw, items[1].raw);
    return made;
}

base::Result<void> TemporarySettings::begin(const std::vector<device::WriteItem>& items)
{
    QStringList keys;
    for (const device::WriteItem& item : items)
        keys << item.key;
    if (const auto known = device::readKeys(m_context, m_servo, keys); !known)
        return known;
    for (const device::WriteItem& item : items) {
        const catalog::Register& reg = *m_servo.profile->find(item.key);
        const auto old = m_servo.raw(reg);
        if (!old) {
            return tl::unexpected(base::Error{ErrorCode::NotSupported, QStringLiteral("write"),
                                              QStringLiteral("not-readable"), m_servo.id, reg.key});
        }
        if (*old != item.raw)
            m_items.push_back({reg.key, reg.address, *old, item.raw});
    }
    if (m_items.empty())
        return {};
    const auto uuid = m_context.journal.begin(makeTrialIntent(m_servo, m_items));
    if (!uuid)
        return tl::unexpected(uuid.error());
    m_uuid = *uuid;
    std::vector<device::WriteItem> changes;
    for (const base::JournalItem& item : m_items)
        changes.push_back({item.key, item.newRaw});
    bool begun = true;
    const auto written = write(m_context, changes, false, begun);
    if (written)
        return {};
    if (begun)
        (void)revert();
    else
        (void)m_context.journal.end(std::exchange(m_uuid, {}), notSentEnd(m_items));
    return written;
}

/// `begun` becomes false when nothing was written.
base::Result<void> TemporarySettings::write(const device::Context& context,
                                            const std::vector<device::WriteItem>& items,
                                            bool allowPreviousValues, bool& begun)
{
    ShadowJournal journal(context.journal);
    device::Notices notices;
    const device::Context inner{context.bus, context.catalog,  journal,      context.stop,
                                notices,     context.priority, context.hold, context.epoch};
    device::WriteOptions options;
    options.temporary = true;
    options.consent = device::Consent::byTask(m_mode);
    options.kind = base::IntentKind::Trial;
    options.allowPreviousValues = allowPreviousValues;
    const auto report = device::write(inner, m_servo, items, options);
    begun = report.has_value();
    for (const device::Notice& notice : notices) {
        // Nothing is saved beyond the test.
        if (notice.code != NoticeCode::LimitsSaved)
            context.notices.push_back(notice);
    }
    if (!report)
        return tl::unexpected(report.error());
    return toResult(*report);
}

base::Result<void> TemporarySettings::tryRevert()
{
    // The user's stop has ended the job, but not the restoring that makes its end safe.
    const base::StopToken neverStop;
    waitForReconnection(m_context.bus);
    const std::uint64_t now = m_context.bus.emergencyCount();
    const bool emergency = now != m_emergencyCount || m_context.epoch.value_or(now) != now;
    if (emergency && m_mode)
        return base::fail(ErrorCode::Preempted, QStringLiteral("write"), {}, m_servo.id);
    device::Context last{m_context.bus,     m_context.catalog,  m_context.journal, neverStop,
                         m_context.notices, m_context.priority, m_context.hold,    m_context.epoch};
    // Gains move nothing, but without restoring they would act as soon as torque comes on again.
    if (emergency)
        last.epoch = now;
    base::Result<void> back;
    for (int round = 0; round < maxRestoreRounds; ++round) {
        bool begun = true;
        back = write(last, previousValues(m_items), true, begun);
        if (back || back.error().code == ErrorCode::LinkLost)
            return back;
        m_context.bus.clock().sleepFor(retryDelay);
    }
    return back;
}

void TemporarySettings::forget()
{
    if (!m_uuid.isEmpty())
        m_context.record(std::exchange(m_uuid, {}), m_servo.id, {QStringLiteral("undone"), {}});
}

base::Result<void> TemporarySettings::revert()
{
    if (m_uuid.isEmpty())
        return {};
    const QString uuid = std::exchange(m_uuid, {});
    const auto back = tryRevert();
    if (!back) {
        for (const base::JournalItem& item : m_items)
            m_context.note(NoticeCode::SettingNotRestored, m_servo.id, item.key, item.oldRaw);
        return back;
    }
    if (m_mode)
        m_context.note(NoticeCode::TorqueStaysOff, m_servo.id);
    m_context.record(uuid, m_servo.id, {QStringLiteral("undone"), {}});
    return {};
}
} // namespace jobs
