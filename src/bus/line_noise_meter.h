// SPDX-License-Identifier: GPL-3.0-or-later
// How much of the line is taken up by bytes that answer no request. Reports when they are more than
// a line with pauses could carry, and whether they are valid frames, among which a reply could not
// be recognized. Bus thread only.
#pragma once

#include "base/clock.h"

namespace bus {
class LineNoiseMeter {
public:
    /// Bytes that would occupy the line for `wireTime`; `frame`: they are a valid frame. The level
    /// never exceeds `maxLevel`.
    void addBytes(base::Duration wireTime, bool frame, base::Duration now, base::Duration maxLevel);

    /// More than `allowed` has come beyond what the passing time accounts for.
    bool isOverloaded(base::Duration allowed, base::Duration now) const;
    /// Valid frames are coming without a pause, not only noise.
    bool hasFrames() const { return m_frames >= minFrames; }

private:
    base::Duration levelAt(base::Duration now) const;

    /// One may be a late reply.
    static constexpr int minFrames = 2;

    base::Duration m_level{}; ///< wire time beyond what the clock accounts for
    base::Duration m_lastAt{};
    int m_frames = 0; ///< since the last pause
};
} // namespace bus
