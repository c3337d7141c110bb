// SPDX-License-Identifier: GPL-3.0-or-later
// A Feetech frame built from the published rule, not by the codec under test; addresses of an
// STS3215.
#pragma once

#include <QByteArray>

namespace support {
constexpr int modeAddress = 33;
constexpr int torqueSwitch = 40;
constexpr int goalAddress = 42;

/// `word`: the instruction of a request, the error byte of a status packet.
inline QByteArray feetechFrame(int id, int word, const QByteArray& params = {})
{
    QByteArray frame = QByteArray::fromHex("FFFF");
    for (const int byte : {id, int(params.size()) + 2, word})
        frame.append(char(byte));
    frame.append(params);
    unsigned sum = 0;
    for (qsizetype i = 2; i < frame.size(); ++i)
        sum += static_cast<unsigned char>(frame[i]);
    return frame.append(char(~sum));
}
} // namespace support
