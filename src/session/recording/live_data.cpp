// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/recording/live_data.h"

#include <algorithm>
#include <utility>

namespace session {
using base::Duration;
using catalog::Role;
using namespace std::chrono_literals;

namespace {
constexpr std::size_t maxMarks = 20000;
/// Without a reading for this time, although they came more often before: a gap, not a line.
constexpr Duration minGap = 400ms;
constexpr int gapIntervals = 5;
constexpr Duration maxInterval = 2s;

const catalog::Register* goalRegister(const catalog::Profile& profile)
{
    const catalog::Register* active = profile.byRole(Role::ActiveGoal);
    return active != nullptr ? active : profile.byRole(Role::GoalPosition);
}
} // namespace

QString goalKey(const catalog::Profile& profile)
{
    const catalog::Register* goal = goalRegister(profile);
    return goal != nullptr ? goal->key : QString();
}

SubscriptionItem subscriptionTo(const LiveChannel& channel)
{
    QStringList keys{channel.key};
    if (channel.key == errorKey) {
        const catalog::Register* present = channel.profile->byRole(Role::PresentPosition);
        keys =
            QStringList{goalKey(*channel.profile), present != nullptr ? present->key : QString()};
        keys.removeAll(QString());
    }
    return {channel.servo, keys, {}};
}

struct LiveData::Slot {
    QString key;
    const catalog::Register* reg = nullptr; ///< of the source's profile; null: the error
    QString unit;
    recording::ChannelId id = -1;
    Duration lastAt{};
    Duration interval{}; ///< as it usually comes; 0: not known yet
};

struct LiveData::Source {
    catalog::ProfilePtr profile;
    std::vector<Slot> slots;
    bool fresh = false;    ///< units were looked at in this batch
    bool hasError = false; ///< goal − position means something in this mode
    bool missing = false;  ///< the latest reading was not answered
};

LiveData::LiveData(Workbench& workbench, QObject* parent)
    : QObject(parent)
    , m_workbench(workbench)
    , m_recording(workbench, *this)
{
    connect(&workbench.polling(), &PollController::readingsReceived, this,
            [this](const std::vector<Reading>& batch) { process(batch); });
    connect(&workbench.polling(), &PollController::markAdded, this, &LiveData::addMark);
    connect(&workbench.registry(), &ServoRegistry::servosCleared, this, &LiveData::resetServos);
}

LiveData::~LiveData() = default;

const LiveChannel* LiveData::find(ServoRef servo, const QString& key) const
{
    const auto found =
        std::find_if(m_channels.rbegin(), m_channels.rend(), [&](const LiveChannel& channel) {
            return channel.servo == servo && channel.key == key;
        });
    return found != m_channels.rend() ? &*found : nullptr;
}

void LiveData::clear()
{
    m_store.clear();
    m_marks.clear();
    Q_EMIT samplesAdded();
}

void LiveData::resetServos()
{
    m_recording.stop(); // its curves are gone
    for (const LiveChannel& channel : m_channels)
        m_store.close(channel.id);
    m_store.clear();
    m_channels.clear();
    m_sources.clear();
    m_marks.clear();
    m_trigger.disarm();
    Q_EMIT channelsChanged();
    Q_EMIT triggerChanged();
    Q_EMIT samplesAdded();
}

void LiveData::setPeriod(Duration period)
{
    m_period = period;
    m_recording.setPeriod(period);
    updateSubscription();
}

/// What the trigger waits for is read on every page and for every selection.
void LiveData::updateSubscription()
{
    const bool waits = m_trigger.state() == recording::Trigger::State::Armed;
    Subscription subscription;
    subscription.period = m_period;
    for (const LiveChannel& channel : m_channels) {
        if (waits && m_trigger.spec().channel == channel.id)
            subscription.parts.push_back(subscriptionTo(channel));
    }
    m_workbench.polling().subscribe(QStringLiteral("trigger"), subscription);
}

void LiveData::armTrigger(const recording::TriggerSpec& spec)
{
    m_trigger.arm(spec);
    updateSubscription();
    Q_EMIT triggerChanged();
}

void LiveData::disarmTrigger()
{
    m_trigger.disarm();
    updateSubscription();
    Q_EMIT triggerChanged();
}

void LiveData::process(const std::vector<Reading>& batch)
{
    const auto stateBefore = m_trigger.state();
    for (const Reading& reading : batch)
        process(reading);
    for (const auto& [ref, source] : m_sources)
        source->fresh = false;
    m_trigger.advanceTo(m_workbench.now());
    m_recording.flush();
    if (std::exchange(m_newChannels, false))
        Q_EMIT channelsChanged();
    if (m_trigger.state() != stateBefore) {
        updateSubscription();
        Q_EMIT triggerChanged();
    }
    if (!batch.empty())
        Q_EMIT samplesAdded();
}

LiveData::Source& LiveData::sourceOf(const Reading& reading)
{
    auto& place = m_sources[reading.servo];
    if (!place || place->profile != reading.profile) { // new, another servo, or better known
        place = std::make_unique<Source>();
        place->profile = reading.profile;
    }
    return *place;
}

/// Units and modes may have changed since the last batch.
void LiveData::refresh(Source& source, const ServoEntry& entry)
{
    if (source.fresh || entry.servo.profile != source.profile)
        return;
    source.fresh = true;
    const catalog::Mode* mode = entry.servo.mode();
    source.hasError = mode != nullptr && mode->command == Role::GoalPosition &&
                      mode->key != QLatin1StringView("step");
    for (Slot& slot : source.slots) {
        const QString unit = slot.reg != nullptr ? entry.servo.meaning(*slot.reg).unit : slot.unit;
        if (unit == slot.unit)
            continue;
        slot.unit = unit;
        slot.id = -1; // a curve of its own from here on
    }
}

LiveData::Slot& LiveData::slotFor(Source& source, ServoRef servo, const catalog::Register* reg,
                                  const QString& key, const QString& unit)
{
    auto slot = std::find_if(source.slots.begin(), source.slots.end(),
                             [&](const Slot& one) { return one.key == key; });
    if (slot == source.slots.end()) {
        source.slots.push_back({key, reg, unit});
        slot = std::prev(source.slots.end());
    }
    if (slot->id >= 0)
        return *slot;
    const auto known =
        std::find_if(m_channels.begin(), m_channels.end(), [&](const LiveChannel& channel) {
            return channel.servo == servo && channel.key == key && channel.unit == slot->unit &&
                   channel.profile == source.profile;
        });
    slot->id = known != m_channels.end() ? known->id : m_store.open();
    if (known != m_channels.end()) { // taken up again: nothing is known of the time between
        m_store.gap(slot->id);
        m_trigger.gap(slot->id);
    } else {
        m_channels.push_back({slot->id, servo, source.profile, key, slot->unit});
        m_newChannels = true;
    }
    return *slot;
}

void LiveData::append(Slot& slot, Duration at, double value)
{
    const Duration since = at - slot.lastAt;
    const bool before = slot.lastAt.count() > 0;
    if (before && since > std::max(minGap, gapIntervals * slot.interval)) {
        m_store.gap(slot.id);
        m_trigger.gap(slot.id);
    }
    if (before) { // learned from a gap too: it may come more slowly from now on
        const Duration seen = std::min(since, maxInterval);
        slot.interval = slot.interval.count() > 0 ? (slot.interval * 3 + seen) / 4 : seen;
    }
    slot.lastAt = at;
    m_store.append(slot.id, at, value);
    m_trigger.sample(slot.id, at, value);
    m_recording.addValue(slot.id, value);
}

void LiveData::processValues(Source& source, const Reading& reading, const ServoEntry& entry)
{
    std::optional<double> goal;
    std::optional<double> position;
    const catalog::Register* goalReg = goalRegister(*source.profile);
    for (const jobs::PollValue& value : reading.values) {
        const QString unit = entry.servo.meaning(*value.reg).unit;
        Slot& slot = slotFor(source, reading.servo, value.reg, value.reg->key, unit);
        append(slot, reading.at, value.physical);
        if (value.reg == goalReg)
            goal = value.physical;
        if (value.reg->role == Role::PresentPosition)
            position = value.physical;
    }
    if (!source.hasError || !goal || !position)
        return;
    const QString unit = entry.servo.meaning(*goalReg).unit;
    append(slotFor(source, reading.servo, nullptr, errorKey, unit), reading.at, *goal - *position);
}

void LiveData::process(const Reading& reading)
{
    Source& source = sourceOf(reading);
    const ServoEntry* entry = m_workbench.registry().servo(reading.servo);
    m_recording.beginRow(reading.servo);
    if (reading.answered && entry != nullptr && entry->servo.profile == source.profile) {
        refresh(source, *entry);
        processValues(source, reading, *entry);
    } else if (!source.missing) {
        for (const Slot& slot : source.slots) {
            m_store.gap(slot.id);
            m_trigger.gap(slot.id);
        }
    }
    source.missing = !reading.answered;
    m_recording.endRow(reading);
}

void LiveData::addMark(const recording::Mark& mark)
{
    if (m_marks.size() >= maxMarks)
        m_marks.erase(m_marks.begin(), m_marks.begin() + maxMarks / 4);
    // A write is reported after its end; readings may have come since.
    const auto place = std::upper_bound(
        m_marks.begin(), m_marks.end(), mark,
        [](const recording::Mark& a, const recording::Mark& b) { return a.at < b.at; });
    m_marks.insert(place, mark);
    const auto before = m_trigger.state();
    m_trigger.mark(mark);
    m_recording.addMark(mark);
    if (m_trigger.state() != before)
        Q_EMIT triggerChanged();
    Q_EMIT samplesAdded();
}
} // namespace session
