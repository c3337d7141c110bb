// SPDX-License-Identifier: GPL-3.0-or-later
// From registers to a poll plan, and from polled blocks back to rows of physical values. Meanings
// are resolved once, from the settings read before the watch. Used by watch() only; its thread.
#pragma once

#include "device/notice.h"
#include "jobs/watch/poll_spans.h"
#include "jobs/watch/watch.h"

#include <map>
#include <set>

namespace jobs {
/// What a column shows: families may call one thing by different names, so its role counts too.
struct WatchKey {
    QString key; ///< the first servo's name for it
    catalog::Role role = catalog::Role::None;
};

class WatchDecoder {
public:
    static base::Result<WatchDecoder> make(const WatchSpec& spec);

    const std::vector<WatchColumn>& columns() const { return m_columns; }
    bus::PollPlan plan() const;

    /// The rows that are finished with this block, in time order.
    std::vector<WatchRow> add(const bus::Sample& sample);
    /// Rows that were still waiting for a block.
    std::vector<WatchRow> flush();

    /// Derived alarms that came up since the last call, each once a servo.
    device::Notices takeAlarms() { return std::exchange(m_alarms, {}); }

private:
    struct Field {
        const catalog::Register* reg = nullptr;
        catalog::ValueFormat meaning;
        std::size_t column = 0;
    };
    struct Source {
        device::Servo servo; ///< settings; where replies carry no status, the readings too
        std::vector<Field> fields;
        std::vector<bus::PollSpan> spans; ///< as the bus will read them
        int group = 0;
        PollRoundTracker round; ///< of the pending row
        WatchRow row;
        std::set<device::NoticeCode> reported;
    };

    base::Result<void> addServo(const device::Servo& servo, const std::vector<WatchKey>& keys,
                                int group);
    WatchRow emptyRow(const device::Servo& servo) const;
    void finishRow(Source& source);
    std::vector<WatchRow> takeReadyRows(base::Duration staleBefore);
    void decode(Source& source, const bus::Sample& sample);
    void deriveAlarms(Source& source, const bus::Sample& sample);

    std::vector<WatchColumn> m_columns;
    std::map<std::pair<base::Protocol, int>, Source> m_sources; ///< by language and ID
    std::vector<WatchRow> m_ready;                              ///< finished, by time
    device::Notices m_alarms;
    base::Duration m_period{};
};
} // namespace jobs
