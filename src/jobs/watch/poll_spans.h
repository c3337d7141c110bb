// SPDX-License-Identifier: GPL-3.0-or-later
// From registers to what a poll plan reads, for everybody who watches servos: a job in the command
// line, the window's feed. Pure; any thread.
#pragma once

#include "bus/poll.h"
#include "catalog/profile.h"

#include <map>
#include <optional>

namespace jobs {
/// So many rounds of `period` fit into `pace`. Where rounds follow each other without a pause,
/// `unpaced` is the answer.
int everyNth(base::Duration period, base::Duration interval, int defaultDivider);

/// The blocks as the bus will read them. What changes slowly and costs a read of its own (LX:
/// temperature, voltage) is read about once a second only.
std::vector<bus::PollSpan> pollSpans(const catalog::Profile& profile,
                                     const std::vector<const catalog::Register*>& registers,
                                     base::Duration period);

/// Servos of one number may share a sync read: their maps and byte orders are the same.
class SyncReadGroups {
public:
    int of(const catalog::Profile& profile);

private:
    std::map<std::pair<QString, base::ByteOrder>, int> m_numbers;
};

/// Tells which blocks belong to one round of a servo. They come in the order of its spans; one that
/// is not answered ends the round, since the bus then leaves the servo alone for a while.
class PollRoundTracker {
public:
    /// True when what came before belongs to an earlier round. `block`: its place in the spans.
    bool startsNewRound(std::size_t block) const { return m_latest && block <= *m_latest; }
    /// True when the round is complete with this sample.
    bool take(std::size_t block, const bus::Sample& sample)
    {
        m_latest = block;
        return !sample.answered || sample.endsRound;
    }
    void reset() { m_latest.reset(); }
    bool open() const { return m_latest.has_value(); }

private:
    std::optional<std::size_t> m_latest;
};

/// The place among `spans` of the one a sample answers to; their count if there is none.
std::size_t blockIndex(const bus::Sample& sample, const std::vector<bus::PollSpan>& spans);
} // namespace jobs
