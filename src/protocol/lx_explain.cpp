// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/lx_codec.h"
#include "protocol/lx_frame.h"

#include <algorithm>
#include <array>

namespace protocol {
namespace {
using base::ByteView;

struct Name {
    int command;
    const char* name;
};

constexpr std::array names{
    Name{1, "MOVE TIME WRITE"},
    Name{2, "MOVE TIME READ"},
    Name{7, "MOVE TIME WAIT WRITE"},
    Name{8, "MOVE TIME WAIT READ"},
    Name{lx::cmdMoveStart, "MOVE START"},
    Name{lx::cmdMoveStop, "MOVE STOP"},
    Name{13, "ID WRITE"},
    Name{lx::cmdIdRead, "ID READ"},
    Name{17, "ANGLE OFFSET ADJUST"},
    Name{18, "ANGLE OFFSET WRITE"},
    Name{19, "ANGLE OFFSET READ"},
    Name{20, "ANGLE LIMIT WRITE"},
    Name{21, "ANGLE LIMIT READ"},
    Name{22, "VIN LIMIT WRITE"},
    Name{23, "VIN LIMIT READ"},
    Name{24, "TEMP MAX LIMIT WRITE"},
    Name{25, "TEMP MAX LIMIT READ"},
    Name{26, "TEMP READ"},
    Name{27, "VIN READ"},
    Name{lx::cmdPositionRead, "POS READ"},
    Name{29, "SERVO OR MOTOR MODE WRITE"},
    Name{30, "SERVO OR MOTOR MODE READ"},
    Name{31, "LOAD OR UNLOAD WRITE"},
    Name{32, "LOAD OR UNLOAD READ"},
    Name{33, "LED CTRL WRITE"},
    Name{34, "LED CTRL READ"},
    Name{35, "LED ERROR WRITE"},
    Name{36, "LED ERROR READ"},
};

QString commandName(int command)
{
    const auto known = std::find_if(names.begin(), names.end(),
                                    [command](const Name& n) { return n.command == command; });
    return known != names.end() ? QString::fromLatin1(known->name)
                                : QStringLiteral("command %1").arg(command);
}

QString withData(const QString& head, ByteView data)
{
    return data.empty() ? head : head + QStringLiteral(": ") + base::toHex(data);
}
} // namespace

QString explainLx(ByteView frame, bool fromHost)
{
    const Claim claim = lx::claimAt(frame);
    const bool whole = claim.fit == Fit::Valid || claim.fit == Fit::Broken;
    if (!whole || claim.size != frame.size())
        return withData(QStringLiteral("bytes"), frame);
    const QString id = frame[2] == broadcastId ? QStringLiteral("all") : QString::number(frame[2]);
    const QString head = fromHost ? QString() : QStringLiteral("REPLY ");
    const QString text = withData(head + commandName(frame[4]) + u' ' + id, lx::params(frame));
    return claim.fit == Fit::Valid ? text : text + QStringLiteral(" (checksum wrong)");
}
} // namespace protocol
