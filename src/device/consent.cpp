// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/consent.h"

#include "device/write_meaning.h"

namespace device {
base::Result<void> requireConsent(const catalog::Register& reg, std::int64_t raw, Consent consent,
                                  int id)
{
    const WriteMeaning meaning = classify(reg, raw);
    if (!meaning.needsConsent || consent)
        return {};
    return tl::unexpected(base::Error{base::ErrorCode::NeedsConsent, QStringLiteral("write"),
                                      meaning.moves ? QStringLiteral("turns") : QString(), id,
                                      reg.key});
}
} // namespace device
