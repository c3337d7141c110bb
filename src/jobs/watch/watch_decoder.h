// SPDX-License-Identifier: GPL-3.0-or-later
// From registers to a poll plan, and from polled blocks back to rows of physical values. Meanings
// are resolved once, from the settings read before the watch. Used by watch() only; its thread.
#pragma once

#include "device/notice.h"
#include "jobs/watch/poll_reader.h"
#include "jobs/watch/watch.h"

#include <map>
#include <set>

namespace jobs {
/// What a column shows. Families may use different names for one thing: its role counts too.
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

    /// Derived alarms that came up since the last call, each once per servo.
    device::Notices takeAlarms() { return std::exchange(m_alarms, {}); }

private:
    struct Source {
        device::Servo servo; ///< settings and readings
        PollReader reader;
        std::map<const catalog::Register*, std::size_t> columns;
        int group = 0;
        std::set<device::NoticeCode> reported;
    };

    base::Result<void> addServo(const device::Servo& servo, const std::vector<WatchKey>& keys,
                                int group);
    void addRow(const Source& source, const PollReading& reading);
    std::vector<WatchRow> takeReadyRows(base::Duration staleBefore);
    void deriveAlarms(Source& source);

    std::vector<WatchColumn> m_columns;
    std::map<std::pair<base::Protocol, int>, Source> m_sources; ///< by protocol and ID
    std::vector<WatchRow> m_ready;                              ///< finished, by time
    device::Notices m_alarms;
    base::Duration m_period{};
};
} // namespace jobs
