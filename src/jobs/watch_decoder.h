// SPDX-License-Identifier: GPL-3.0-or-later
// From registers to a poll plan, and from polled blocks back to rows of physical values. Meanings
// are resolved once, from the settings read before the watch. Used by watch() only; its thread.
#pragma once

#include "jobs/watch.h"

#include <map>

namespace jobs {
class WatchDecoder {
public:
    static base::Result<WatchDecoder> make(const WatchSpec& spec);

    const std::vector<WatchColumn>& columns() const { return m_columns; }
    bus::PollPlan plan() const;

    /// The rows that are finished with this block, in time order.
    std::vector<WatchRow> add(const bus::Sample& sample);
    /// Rows that were still waiting for a block.
    std::vector<WatchRow> flush();

private:
    struct Field {
        const catalog::Register* reg = nullptr;
        catalog::Meaning meaning;
        std::size_t column = 0;
    };
    struct Source {
        catalog::ProfilePtr profile; ///< keeps the registers of the fields alive
        std::vector<Field> fields;
        std::vector<bus::PollSpan> spans; ///< as the bus will read them
        int group = 0;
        std::optional<int> pendingFrom; ///< address of the latest block of the pending row
        WatchRow row;
    };

    base::Result<void> addServo(const device::Servo& servo, const QStringList& keys);
    WatchRow emptyRow(int id) const;
    void close(Source& source);
    std::vector<WatchRow> release(base::Duration staleBefore);
    static void decode(const Source& source, const bus::Sample& sample, WatchRow& row);

    std::vector<WatchColumn> m_columns;
    std::map<int, Source> m_sources; ///< by ID
    std::vector<WatchRow> m_ready;   ///< finished, by time
    base::Duration m_period{};
};
} // namespace jobs
