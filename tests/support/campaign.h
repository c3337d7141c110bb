// SPDX-License-Identifier: GPL-3.0-or-later
// Campaigns against servodesk-cli and servodesk-sim as programs: every command that writes is
// killed (SIGKILL) or its cable is cut at a random moment, then `recover` runs until it says that
// no change is open. What the servos hold is read with raw frames, never through the program under
// test. The test and the bench differ in the count only. One thread; takes seconds per round.
#pragma once

#include <QString>

#include <cstdint>

namespace support {
struct Tally {
    int rounds = 0;
    int broken = 0;       ///< ended by the kill or the cut, not by itself
    int changesOpen = 0;  ///< of those: the journal knew of a change
    int unlocked = 0;     ///< servos whose lock is open after `recover` said nothing is
    int lost = 0;         ///< servos that nobody finds any more
    int falseWords = 0;   ///< claims of the programs that the raw frames disprove
    int unrecovered = 0;  ///< changes still open after many tries
    int hung = 0;         ///< programs that did not end after the cable was cut
    QString firstTrouble; ///< in words, with command, seed and moment

    Tally& operator+=(const Tally& other);
    bool clean() const { return unlocked + lost + falseWords + unrecovered + hung == 0; }
};

enum class Break { Kill, CutTcp, CutTerminal };

/// `rounds` of each writing command; `noisy`: with faults on the wire. `line` is told the counts of
/// each command.
Tally runCampaign(Break how, int rounds, bool noisy, std::uint32_t seed,
                  void (*line)(const QString& text));
} // namespace support
