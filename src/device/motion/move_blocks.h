// SPDX-License-Identifier: GPL-3.0-or-later
// The frames of a planned move. Internal to device; pure, except refreshBlocks, which runs
// on the job's thread with the errors of reading.
#pragma once

#include "device/motion/motion.h"
#include "device/transactions.h"

namespace device {
using Plans = std::vector<MovePlan*>;

/// Fields that share a frame are sent in one. No register between them is written.
struct Block {
    Patch patch;
    bool goal = false;
};

/// The goal's block is the last one.
std::vector<Block> blocksOf(const MovePlan& plan);

/// The bytes around the fields in their blocks, as the servo has them now.
base::Result<void> refreshBlocks(const Context& context, MovePlan& plan);
} // namespace device
