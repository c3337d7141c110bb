// SPDX-License-Identifier: GPL-3.0-or-later
// Campaigns against servodesk-cli and servodesk-sim as programs: every command that writes is
// killed (SIGKILL) or its cable is cut while it changes something, then `recover` runs until it
// reports that no change is open. What the servos hold is read with raw frames, never through the
// program under test. The test and the bench differ in the count only. One thread; takes seconds
// per round.
#pragma once

#include <QString>

#include <cstdint>
#include <functional>

namespace support {
struct CampaignTotals {
    int rounds = 0;
    int broken = 0;          ///< ended by the kill or the cut, not by itself
    int openChanges = 0;     ///< of those: the journal knew of a change
    int unlocked = 0;        ///< servos whose lock is open although `recover` reported none
    int lost = 0;            ///< servos that do not answer at any ID or rate
    int falseClaimCount = 0; ///< claims of the programs that the raw frames disprove
    int unrecovered = 0;     ///< changes still open after many tries
    int hung = 0;            ///< programs that did not end after the cable was cut
    int missed = 0;          ///< commands in which no break has met an open change
    QString firstFailure;    ///< in words, with command, seed and moment

    CampaignTotals& operator+=(const CampaignTotals& other);
    bool clean() const
    {
        return unlocked + lost + falseClaimCount + unrecovered + hung + missed == 0;
    }
};

/// Cuts are of a terminal that hangs up and of a TCP link that drops, in turn.
enum class Interruption { Kill, KillDuringNoise, LinkCut };

/// `rounds` that break something, shared among the commands that write; a command that ends before
/// its moment is run again. `only`: the name of one; empty: all. `line` is given the counts of each
/// command.
CampaignTotals runCampaign(Interruption how, int rounds, std::uint32_t seed, const QString& only,
                           const std::function<void(const QString& text)>& line);
} // namespace support
