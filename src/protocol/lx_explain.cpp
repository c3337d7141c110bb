// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/explain.h"
#include "protocol/lx_codec.h"
#include "protocol/lx_frame.h"

#include <algorithm>
#include <array>

namespace protocol {
namespace {
using base::ByteView;

struct CommandName {
    int command;
    const char* name;
};

constexpr std::array commandNames{
    CommandName{1, "MOVE TIME WRITE"},
    CommandName{2, "MOVE TIME READ"},
    CommandName{7, "MOVE TIME WAIT WRITE"},
    CommandName{8, "MOVE TIME WAIT READ"},
    CommandName{lx::cmdMoveStart, "MOVE START"},
    CommandName{lx::cmdMoveStop, "MOVE STOP"},
    CommandName{13, "ID WRITE"},
    CommandName{lx::cmdIdRead, "ID READ"},
    CommandName{17, "ANGLE OFFSET ADJUST"},
    CommandName{18, "ANGLE OFFSET WRITE"},
    CommandName{19, "ANGLE OFFSET READ"},
    CommandName{20, "ANGLE LIMIT WRITE"},
    CommandName{21, "ANGLE LIMIT READ"},
    CommandName{22, "VIN LIMIT WRITE"},
    CommandName{23, "VIN LIMIT READ"},
    CommandName{24, "TEMP MAX LIMIT WRITE"},
    CommandName{25, "TEMP MAX LIMIT READ"},
    CommandName{26, "TEMP READ"},
    CommandName{27, "VIN READ"},
    CommandName{lx::cmdPositionRead, "POS READ"},
    CommandName{29, "SERVO OR MOTOR MODE WRITE"},
    CommandName{30, "SERVO OR MOTOR MODE READ"},
    CommandName{31, "LOAD OR UNLOAD WRITE"},
    CommandName{32, "LOAD OR UNLOAD READ"},
    CommandName{33, "LED CTRL WRITE"},
    CommandName{34, "LED CTRL READ"},
    CommandName{35, "LED ERROR WRITE"},
    CommandName{36, "LED ERROR READ"},
};

QString commandName(int command)
{
    const auto known =
        std::find_if(commandNames.begin(), commandNames.end(),
                     [command](const CommandName& n) { return n.command == command; });
    return known != commandNames.end() ? QString::fromLatin1(known->name)
                                       : QStringLiteral("command %1").arg(command);
}

} // namespace

QString explainLx(ByteView frame, bool fromHost)
{
    const FrameMatch match = lx::matchAt(frame);
    const bool complete = match.status == FrameStatus::Valid || match.status == FrameStatus::Broken;
    if (!complete || match.size != frame.size())
        return withData(QStringLiteral("bytes"), frame);
    const QString id = frame[2] == broadcastId ? QStringLiteral("all") : QString::number(frame[2]);
    const QString head = fromHost ? QString() : QStringLiteral("REPLY ");
    const QString text = withData(head + commandName(frame[4]) + u' ' + id, lx::params(frame));
    return match.status == FrameStatus::Valid ? text : text + QStringLiteral(" (checksum wrong)");
}
} // namespace protocol
