// SPDX-License-Identifier: GPL-3.0-or-later
#include "jobs/diagnose/line_content.h"

#include <algorithm>

namespace jobs {
namespace {
constexpr std::size_t minText = 16; ///< random bytes pass for it once in 100,000 times
constexpr double minTextShare = 0.9;
constexpr int maxTextSample = 60;
constexpr std::size_t maxSample = 12;

bool isTextByte(std::uint8_t byte)
{
    constexpr int firstPrintable = 0x20;
    constexpr int lastPrintable = 0x7E;
    return (byte >= firstPrintable && byte <= lastPrintable) || byte == '\r' || byte == '\n' ||
           byte == '\t' || byte == 0x1B; // colors of a log
}
} // namespace

QString textIn(base::ByteView bytes)
{
    if (bytes.size() < minText)
        return {};
    const auto share = double(std::count_if(bytes.begin(), bytes.end(), isTextByte));
    if (share < minTextShare * double(bytes.size()))
        return {};
    QString text;
    for (const std::uint8_t byte : bytes)
        text += isTextByte(byte) && byte != 0x1B ? QLatin1Char(char(byte)) : QLatin1Char(' ');
    return text.simplified().left(maxTextSample);
}

QString sampleOf(base::ByteView bytes)
{
    return base::toHex(bytes.first(std::min(bytes.size(), maxSample)));
}
} // namespace jobs
