// SPDX-License-Identifier: GPL-3.0-or-later
// What hangs on the wire of the tests with several languages: Feetech servos 1 to 3 of the scripted
// link, Modbus station 1 and LX servo 1. Single thread. The station takes only frames that stand
// between silences of `modbusSilence`, as hardware does.
#pragma once

#include "base/crc.h"

#include "bus_fixture.h"

inline Bytes modbusFrame(Bytes frame)
{
    const unsigned crc = base::crc16Modbus(frame);
    frame.push_back(std::uint8_t(crc & 0xFF));
    frame.push_back(std::uint8_t(crc >> 8));
    return frame;
}

inline Bytes lxFrame(int id, int command, const Bytes& params)
{
    Bytes frame{0x55, 0x55, std::uint8_t(id), std::uint8_t(params.size() + 3),
                std::uint8_t(command)};
    for (const std::uint8_t byte : params)
        frame.push_back(byte);
    frame.push_back(std::uint8_t(~std::accumulate(frame.begin() + 2, frame.end(), 0)));
    return frame;
}

inline protocol::Request inModbus(protocol::Request request)
{
    return request.in(base::Protocol::Modbus);
}

inline protocol::Request inLx(protocol::Request request)
{
    return request.in(base::Protocol::Lx);
}

/// Registers and parameters, as a Request numbers them.
inline protocol::Request modbusRead(int number, int registers)
{
    return inModbus(protocol::Request::read(1, 2 * number, 2 * registers));
}

inline protocol::Request modbusWrite(int number, const Bytes& data, int id = 1)
{
    return inModbus(protocol::Request::write(id, 2 * number, data, protocol::Repeat::Safe));
}

inline protocol::Request lxRead(int command, int count)
{
    return inLx(protocol::Request::read(1, 8 * command, count));
}

struct MultiProtocolFixture : BusFixture {
    Duration modbusSilence{1750};
    std::vector<Bytes> executedFrames; ///< by the Modbus station
    int exception = 0;                 ///< what it answers instead of carrying out
    std::map<int, Bytes> lx{{26, {45}}, {27, {0xE8, 0x1C}}, {28, {0xFD, 0xFF}}};

    MultiProtocolFixture() { script.baud = 115'200; }

    void openMultiProtocol(const protocol::Codec& codec = protocol::feetechCodec())
    {
        open({}, codec);
        script.intercept = [this](const Bytes& frame) { return receive(frame); };
    }

    /// A broadcast counts once the silence after it was kept.
    void finishBroadcast() { finishModbusBroadcast(script.clock.now() - m_lineBusyUntil); }

private:
    bool receive(const Bytes& frame)
    {
        const Duration silent = script.clock.now() - m_lineBusyUntil;
        finishModbusBroadcast(silent);
        const bool feetech = frame[0] == 0xFF;
        if (frame[0] == 0x55)
            receiveLx(frame);
        else if (feetech)
            script.answer(frame);
        else if (silent >= modbusSilence)
            receiveModbus(frame);
        m_lineBusyUntil = script.wireFreeAt;
        return true;
    }

    void finishModbusBroadcast(Duration silent)
    {
        if (!m_unanswered.empty() && silent >= modbusSilence)
            executedFrames.push_back(m_unanswered);
        m_unanswered.clear();
    }

    void receiveLx(const Bytes& frame)
    {
        const auto parameter = lx.find(frame[4]);
        if (frame[2] == 1 && frame[3] == 3 && parameter != lx.end())
            script.reply(lxFrame(1, frame[4], parameter->second));
    }

    void receiveModbus(const Bytes& frame)
    {
        if (frame[0] == 0) {
            m_unanswered = frame;
            return;
        }
        if (frame[0] != 1)
            return;
        executedFrames.push_back(frame);
        if (exception != 0) {
            script.reply(modbusFrame({1, std::uint8_t(frame[1] | 0x80), std::uint8_t(exception)}));
            return;
        }
        Bytes answer(frame.begin(), frame.begin() + 6);
        if (frame[1] == 3) {
            answer.resize(2);
            answer.push_back(std::uint8_t(2 * frame[5]));
            for (int i = 0; i < frame[5]; ++i) {
                answer.push_back(frame[2]);
                answer.push_back(std::uint8_t(frame[3] + i));
            }
        }
        script.reply(modbusFrame(answer));
    }

    Bytes m_unanswered;
    Duration m_lineBusyUntil{-10'000};
};
