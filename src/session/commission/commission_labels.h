// SPDX-License-Identifier: GPL-3.0-or-later
// Labels of a commissioning line as names in the history. Servos are told by model, firmware and
// ID there, and all of a bag have the same, so a name is put aside while another servo of the kind
// stands under the same ID, and taken up again when that one has got its own. Owned by one run of
// the line; its thread. Fails as record::History does.
#pragma once

#include "device/servo.h"
#include "session/paths.h"

#include <optional>

namespace session {
class CommissionLabels {
public:
    explicit CommissionLabels(QString history = historyFile())
        : m_history(std::move(history))
    {}

    /// jobs::CommissionCallbacks::meet
    base::Result<void> servoFound(const device::Servo& servo);
    /// jobs::CommissionCallbacks::name
    base::Result<void> setLabel(const device::Servo& servo, const QString& label, bool another);

private:
    struct ParkedLabel {
        base::ServoIdentity identity;
        QString label;
    };

    QString m_history;
    std::optional<ParkedLabel> m_parked;
    QString m_assigned; ///< to the servo at hand
};
} // namespace session
