// SPDX-License-Identifier: GPL-3.0-or-later
// The user's consent to writes that can make a servo unreachable or dangerous. A value; the device
// layer refuses without it. Only the place that asked makes one and states how it asked; a test
// checks where each kind may be made.
#pragma once

#include "device/transactions.h"

namespace device {
class Consent {
public:
    constexpr Consent() = default; ///< none

    /// The user accepted a question that named the risk (window).
    static constexpr Consent confirmed() { return Consent(true); }
    /// An option of the command line.
    static constexpr Consent byOption(bool given) { return Consent(given); }
    /// Given for the change that was interrupted or failed, and is now finished or rolled back.
    static constexpr Consent ofEarlierChange() { return Consent(true); }
    /// The task itself names the risk: changing the mode, clearing an alarm.
    static constexpr Consent byTask(bool given = true) { return Consent(given); }

    constexpr explicit operator bool() const { return m_isGiven; }

private:
    constexpr explicit Consent(bool given)
        : m_isGiven(given)
    {}

    bool m_isGiven = false;
};
/// Whether both angle limits become 0 and were not: in the mode of that, now or later, the shaft
/// turns past any position. By what has been read of the servo; false where that is too little.
bool removesAngleLimits(const Servo& servo, const RegisterValues& items);
/// The same of servos of this model whose values are not known: the lower limit may be 0 there.
bool canRemoveAngleLimits(const catalog::Profile& profile, const RegisterValues& items);

/// NeedsConsent (write_meaning.h decides) where writing this value needs a consent that is not
/// given; "turns" as detail where it also moves the shaft. `id`: of the servo, for the error.
base::Result<void> requireConsent(const catalog::Register& reg, std::int64_t raw, Consent consent,
                                  int id);
/// Of the whole write: also where it removes the angle limits ("free-turning" as detail).
base::Result<void> requireConsent(const Servo& servo, const RegisterValues& items, Consent consent);
} // namespace device
