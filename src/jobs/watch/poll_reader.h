// SPDX-License-Identifier: GPL-3.0-or-later
// From the polled blocks of one servo back to readings: the blocks of one round joined, and their
// bytes decoded. Used by the watch, the sweep test and the window's polling. Belongs to whoever
// owns it; one thread.
#pragma once

#include "bus/poll.h"
#include "device/servo.h"

#include <optional>

namespace jobs {
struct PollValue {
    const catalog::Register* reg = nullptr; ///< of the servo's profile
    std::int64_t raw = 0;
    double physical = 0; ///< in the unit the register has now (phase, mode)
};

/// What one round read of a servo. Not answered: no values.
struct PollReading {
    base::Duration at{};                              ///< bus clock, when the last byte had arrived
    bool answered = false;                            ///< at least one block was read
    base::ErrorCode error = base::ErrorCode::NoReply; ///< meaningful when not answered
    std::uint8_t status = 0;                          ///< as device::Servo::status
    std::vector<PollValue> values;
};

/// The blocks of a round come in the order of `spans`. One that is not answered ends the round,
/// since the bus then leaves the servo alone for a while.
class PollReader {
public:
    PollReader() = default;
    /// `spans`: as the bus reads them. updateMeanings() before the first sample.
    PollReader(const std::vector<const catalog::Register*>& registers,
               std::vector<bus::PollSpan> spans);

    /// After the servo's settings were read again: phase and mode decide units and ranges.
    void updateMeanings(const device::Servo& servo);

    const std::vector<bus::PollSpan>& spans() const { return m_spans; }
    /// The place among spans() of the one a sample answers to; their count if there is none.
    std::size_t blockIndex(const bus::Sample& sample) const;

    /// Of the reading whose round is not complete; nullopt if there is none.
    std::optional<base::Duration> unfinishedAt() const;
    /// Gives up the blocks that the unfinished reading still lacks. Before each add(): a sample of
    /// a later round, or of one that stands for more than a second, ends the reading before it.
    std::optional<PollReading> takeUnfinishedBefore(const bus::Sample& next);
    PollReading takeUnfinished();

    /// The reading that is complete with this block. An answer is stored in the servo's image and
    /// status; null: it counts as an answer, but nothing is read from it.
    std::optional<PollReading> add(const bus::Sample& sample, device::Servo* servo);

private:
    struct Field {
        const catalog::Register* reg = nullptr;
        catalog::ValueFormat meaning{};
    };
    void decode(const bus::Sample& sample, device::Servo& servo);

    std::vector<Field> m_fields;
    std::vector<bus::PollSpan> m_spans;
    std::optional<std::size_t> m_latestBlock{}; ///< of the unfinished reading
    PollReading m_reading;
};

/// A reading whose other blocks stay out for longer (a job holds the servo) is given up.
constexpr base::Duration maxRoundTime = std::chrono::seconds(1);
} // namespace jobs
