// SPDX-License-Identifier: GPL-3.0-or-later
#include "text/arm_text.h"

#include "text/translate.h"

namespace text {
using base::JointState;

QString jointStateText(JointState state)
{
    switch (state) {
    case JointState::NotMoved:
        return translate("text", "not moved yet");
    case JointState::KeepMoving:
        return translate("text", "keep moving");
    case JointState::Recorded:
        return translate("text", "range recorded");
    case JointState::FullTurn:
        return translate("text", "turns through a full turn");
    case JointState::LostTrack:
        return translate("text", "lost track: record again");
    case JointState::NoReply:
        return translate("text", "no reply");
    }
    return {};
}
} // namespace text
