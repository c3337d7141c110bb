// SPDX-License-Identifier: GPL-3.0-or-later
// A recording as text, line by line: what its writer and its readers agree on. Numbers are the
// shortest that read back the same, in every locale. Plain values; one thread.
#pragma once

#include "recording/recording.h"

#include <memory>
#include <string>
#include <string_view>

namespace recording {
constexpr int recordingVersion = 1;

/// Makes lines with their line feed and appends them to `out`. Times count from the start of the
/// recording.
class RecordingFormatter {
public:
    RecordingFormatter(RecordingFormat format, const RecordingHeader& head);

    std::string head() const;
    /// Values beyond the servo's channels are left out; missing ones are "not read".
    /// False, and no line: the servo is not in the head.
    bool row(base::Duration at, const RecordingRow& row, std::string& out) const;
    void mark(base::Duration at, const Mark& mark, std::string& out) const;

private:
    struct Servo {
        int number = 0;
        std::string label;              ///< in the CSV: the ID, and a ' if two have it
        std::vector<std::size_t> cells; ///< columns of its channels
    };
    std::string uniqueLabel(int servoId) const;
    const Servo* servoOf(int number) const;
    std::string csvHeader() const;
    std::string jsonHeader() const;

    RecordingFormat m_format;
    RecordingHeader m_head;
    std::vector<Servo> m_servos;
};

/// One line of a recording as read.
struct RecordingLine {
    base::Duration at{};
    bool isRow = false;
    std::size_t servo = 0; ///< index into RecordingReader::servos()
    std::vector<double> values;
    std::optional<Mark> mark;
    void clear();
};

class RecordingReader {
public:
    enum class HeaderState : std::uint8_t { More, Complete };
    enum class LineKind : std::uint8_t { Content, Blank, Invalid };

    virtual ~RecordingReader() = default;
    /// The next line of the head, without its end. Fails with what is wrong with it.
    virtual tl::expected<HeaderState, QString> parseHeader(std::string_view line) = 0;
    virtual LineKind take(std::string_view line, RecordingLine& out) = 0;

    const RecordingHeader& head() const { return m_head; }
    /// For each servo the channels that are its.
    const std::vector<std::vector<std::size_t>>& servos() const { return m_servos; }

protected:
    /// Adds it to the head; its servo, and its place in that servo's values.
    std::pair<std::size_t, std::size_t> addChannel(const RecordingChannel& channel);
    std::optional<std::size_t> servoOf(int number) const;

    RecordingHeader m_head;

private:
    std::vector<int> m_numbers;
    std::vector<std::vector<std::size_t>> m_servos;
};

std::unique_ptr<RecordingReader> makeCsvReader();
std::unique_ptr<RecordingReader> makeJsonLinesReader();

/// All of `text` is this number; not a number and infinite ones are none.
std::optional<double> parseNumber(std::string_view text);
/// Further away is no time of a recording, but a slip of the hand.
bool isValidTime(base::Duration at);
std::optional<base::Duration> parseInstant(std::string_view text);
} // namespace recording
