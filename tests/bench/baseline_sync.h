// SPDX-License-Identifier: GPL-3.0-or-later
// The loop that every simple program has: sync reads of the same servos, one after the other, on a
// pseudo-terminal at 1 Mbaud. What the program's own reading is held against. POSIX.
#pragma once

#include "base/clock.h"
#include "integration/raw_client.h"
#include "protocol/codec.h"

namespace bench {
/// Rounds a second. Servos 1 … `servos`.
inline double baselineSyncRate(const QString& path, int servos, int address, int count,
                               base::Duration span)
{
    using base::Duration;
    base::SystemClock clock;
    std::vector<int> ids;
    for (int id = 1; id <= servos; ++id)
        ids.push_back(id);
    const auto asked = protocol::Request::syncRead(address, count, ids);
    const base::Bytes frame = protocol::feetechCodec().encode(asked).value();
    const QByteArray request(reinterpret_cast<const char*>(frame.data()), qsizetype(frame.size()));
    const qsizetype replyBytes =
        servos * qsizetype(protocol::feetechCodec().expect(asked).replyBytes);
    const raw::Client client(path, B1000000);
    clock.sleepFor(std::chrono::milliseconds(50));
    int rounds = 0;
    Duration lost{}; // spent on answers that a busy machine did not let through
    const Duration start = clock.now();
    while (clock.now() < start + span) {
        const Duration sentAt = clock.now();
        client.send(request);
        if (client.receive(replyBytes).size() == replyBytes) {
            ++rounds;
        } else {
            client.receive(replyBytes);
            lost += clock.now() - sentAt;
        }
    }
    if (rounds == 0)
        qFatal("no answer from the simulated bus");
    return rounds / std::chrono::duration<double>(clock.now() - start - lost).count();
}

} // namespace bench
