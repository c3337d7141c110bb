// SPDX-License-Identifier: GPL-3.0-or-later
// The data behind the trend charts: keeps every reading in a sample store, with the marks of
// events, watches for a trigger, and feeds a recording. Goes on while other pages are shown. Owned
// by Workbench; main thread, never waits. Samples live until the list of servos is cleared or
// clear() is called.
#pragma once

#include "recording/sample_store.h"
#include "recording/trigger.h"
#include "session/recording/live_recording.h"

#include <map>

namespace session {
/// The key of the channel that is goal − position, worked out here for each reading with both.
inline const QString errorKey = QStringLiteral("error");
QString goalKey(const catalog::Profile& profile); ///< what a chart shows as the goal; empty: none

/// One curve that can be shown. Where a register changes its unit (mode, phase), it goes on as
/// another channel: no curve mixes units.
struct LiveChannel {
    recording::ChannelId id = -1;
    ServoRef servo = 0;
    catalog::ProfilePtr profile;
    QString key;  ///< register key, or errorKey
    QString unit; ///< as the catalog has it: "deg", "rpm", empty
};

/// What is read for it: its register, or the two that the error is worked out from.
SubscriptionItem subscriptionTo(const LiveChannel& channel);

class LiveData final : public QObject {
    Q_OBJECT

public:
    explicit LiveData(Workbench& workbench, QObject* parent = nullptr);
    ~LiveData() override;

    const recording::SampleStore& store() const { return m_store; }
    const std::vector<recording::Mark>& marks() const { return m_marks; }
    const std::vector<LiveChannel>& channels() const { return m_channels; }
    const LiveChannel* find(ServoRef servo, const QString& key) const; ///< the latest one of it
    void clear();
    /// How much memory the readings may take; the oldest lose detail first.
    void setBudget(std::size_t bytes) { m_store.setBudget(bytes); }

    /// How often what is recorded, and what the trigger waits for, is read; 0: as fast as the wire
    /// allows.
    void setPeriod(base::Duration period);

    void armTrigger(const recording::TriggerSpec& spec);
    void disarmTrigger();
    const recording::Trigger& trigger() const { return m_trigger; }

    LiveRecording& recording() { return m_recording; }

Q_SIGNALS:
    void samplesAdded();    ///< new samples or marks; at most once a batch
    void channelsChanged(); ///< more of them, or none
    void triggerChanged();  ///< armed, fired, complete

private:
    struct Source; ///< the curves of one servo
    struct Slot;   ///< one of them

    void process(const std::vector<Reading>& batch);
    void process(const Reading& reading);
    void processValues(Source& source, const Reading& reading, const ServoEntry& entry);
    Source& sourceOf(const Reading& reading);
    static void refresh(Source& source, const ServoEntry& entry);
    Slot& slotFor(Source& source, ServoRef servo, const catalog::Register* reg, const QString& key,
                  const QString& unit);
    void append(Slot& slot, base::Duration at, double value);
    void addMark(const recording::Mark& mark);
    void resetServos();
    void updateSubscription();

    Workbench& m_workbench;
    recording::SampleStore m_store;
    std::vector<recording::Mark> m_marks;
    std::vector<LiveChannel> m_channels;
    std::map<ServoRef, std::unique_ptr<Source>> m_sources;
    base::Duration m_period{};
    bool m_newChannels = false;
    recording::Trigger m_trigger;
    LiveRecording m_recording; ///< last: it reads the channels
};
} // namespace session
