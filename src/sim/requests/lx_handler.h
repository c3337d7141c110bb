// SPDX-License-Identifier: GPL-3.0-or-later
// LX commands as reads and writes of the table. A command is recognized by the places its
// parameters have in the map, so every parameter of the sheet has its read, its write and its save.
// Source: Hiwonder LX protocol page. Writes are never answered; values out of range, other lengths
// and unknown commands are ignored. Owned by a VirtualServo; one thread.
#pragma once

#include "sim/requests/request_handler.h"

namespace sim {
class LxHandler : public RequestHandler {
public:
    using RequestHandler::RequestHandler;

    std::optional<ServoReply> handle(const ServoRequest& request) override;
    void forgetStored() override { m_moveStored = false; }

private:
    std::optional<ServoReply> readBlock(const ServoRequest& request, const catalog::Block& block);
    void executeWithoutParams(std::uint8_t command);
    void writeBlock(std::uint8_t command, base::ByteView params);
    bool accepts(const catalog::Block& block, base::ByteView params) const;
    void startStored();

    bool m_moveStored = false; ///< command 7 waits for 11
};
} // namespace sim
