// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/motion/move_blocks.h"

#include <algorithm>

namespace device {
namespace {
std::vector<RegisterValues> framesOf(const MovePlan& plan)
{
    const catalog::Profile& profile = *plan.servo->profile;
    RegisterValues fields;
    for (const WriteItem& field : plan.fields)
        fields.push_back({profile.find(field.key), field.raw});
    std::sort(fields.begin(), fields.end(), [](const RegisterValue& a, const RegisterValue& b) {
        return a.reg->writeOffset < b.reg->writeOffset;
    });
    std::vector<RegisterValues> frames;
    for (const RegisterValue& field : fields) {
        if (frames.empty() || !sharesFrame(*frames.back().back().reg, *field.reg))
            frames.emplace_back();
        frames.back().push_back(field);
    }
    return frames;
}

} // namespace

std::vector<Block> blocksOf(const MovePlan& plan)
{
    std::vector<Block> blocks;
    for (const RegisterValues& frame : framesOf(plan)) {
        const bool goal = std::any_of(frame.begin(), frame.end(), [&](const RegisterValue& value) {
            return value.reg->role == plan.goalRole;
        });
        blocks.push_back({patchOf(*plan.servo, frame), goal});
    }
    // The goal starts the motion, so speed and acceleration must be there before it.
    std::stable_partition(blocks.begin(), blocks.end(), [](const Block& b) { return !b.goal; });
    return blocks;
}

base::Result<void> refreshBlocks(const Context& context, MovePlan& plan)
{
    for (const RegisterValues& frame : framesOf(plan)) {
        if (const auto fresh = freshPatch(context, *plan.servo, frame); !fresh)
            return tl::unexpected(fresh.error());
    }
    return {};
}
} // namespace device
