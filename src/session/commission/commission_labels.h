// SPDX-License-Identifier: GPL-3.0-or-later
// Labels of a commissioning line as names in the history. The history identifies servos by model,
// firmware and ID, which are the same for all factory servos of a model. A name is therefore
// removed while another servo of the kind has the same ID, and restored when that one has its own
// ID. Owned by one run of the line; its thread. Fails as history::History does.
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

    /// jobs::CommissionCallbacks::onNewServo
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
    QString m_assigned; ///< to the current servo
};
} // namespace session
