// SPDX-License-Identifier: GPL-3.0-or-later
// Feetech instructions: what a servo does, and what it answers. Source: instruction and answer
// tables of the Feetech protocol notes. Unknown instructions and malformed parameters stay
// unanswered. Owned by a VirtualServo; one thread.
#pragma once

#include "sim/requests/request_handler.h"

namespace sim {
class FeetechHandler : public RequestHandler {
public:
    using RequestHandler::RequestHandler;

    std::optional<ServoReply> handle(const ServoRequest& request) override;
    AddressMatch addressMatch(int id, std::uint8_t instruction) const override;
    void forgetStored() override { setPendingWrite(std::nullopt); }

private:
    struct PendingWrite {
        int address = 0;
        base::Bytes data;
    };
    ServoReply makeReply(base::ByteView data = {}) const;
    std::optional<ServoReply> ping(const ServoRequest& request) const;
    std::optional<ServoReply> readTable(base::ByteView params);
    bool answersWrite(const ServoRequest& request, int level) const;
    bool execute(const ServoRequest& request);
    bool executeWithoutParams(std::uint8_t instruction);
    void syncWrite(base::ByteView params);
    bool storePendingWrite(base::ByteView params);
    void executePendingWrite();
    void setPendingWrite(std::optional<PendingWrite> write);
    bool calibrate(base::ByteView params);

    std::optional<PendingWrite> m_pendingWrite; ///< REG WRITE that waits for ACTION
};
} // namespace sim
