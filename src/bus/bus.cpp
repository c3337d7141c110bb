// SPDX-License-Identifier: GPL-3.0-or-later
#include "bus/bus.h"

namespace bus {
Hold::~Hold()
{
    if (m_owner != nullptr && m_token != 0)
        m_owner->release(m_token);
}
} // namespace bus
