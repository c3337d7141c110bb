// SPDX-License-Identifier: GPL-3.0-or-later
// The operating modes of this family side by side, the present one highlighted. A click requests
// another one; nothing is switched here. Owned by the control panel; main thread.
#pragma once

#include "session/servos/servo_entry.h"
#include "ui/widgets/segmented_control.h"

namespace ui {
class ControlMode final : public SegmentedControl {
    Q_OBJECT

public:
    explicit ControlMode(QWidget* parent);

    void showServo(const session::ServoEntry* entry, bool usable);
    void retranslate();

Q_SIGNALS:
    void requested(const QString& mode);

private:
    void build();
    void showMode();

    catalog::ProfilePtr m_profile;
    QString m_mode; ///< as read; empty: not known
};
} // namespace ui
