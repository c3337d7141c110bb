// SPDX-License-Identifier: GPL-3.0-or-later
#include "bus/bus.h"

namespace bus {
QString exceptionName(std::uint8_t exception)
{
    switch (exception) {
    case 1:
        return QStringLiteral("illegal-function");
    case 2:
        return QStringLiteral("illegal-address");
    case 3:
        return QStringLiteral("illegal-value");
    default:
        return QStringLiteral("exception %1").arg(exception);
    }
}

Hold::~Hold()
{
    if (m_owner != nullptr && m_token != 0)
        m_owner->release(m_token);
}
} // namespace bus
