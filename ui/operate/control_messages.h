// SPDX-License-Identifier: GPL-3.0-or-later
// The messages of the control panel: the question before the first torque, and a banner with what
// failed, what a move warned of, or what is wrong in a field. The page places it where it moves no
// control. Owned by the control panel until the page takes it; main thread.
#pragma once

#include "device/notice.h"
#include "session/servos/servo_entry.h"
#include "session/settings.h"

#include <QWidget>

#include <functional>

namespace ui {
class Banner;
class TorqueHint;

class ControlMessages final : public QWidget {
    Q_OBJECT

public:
    ControlMessages(session::Settings& settings, QWidget* parent);

    TorqueHint* hint() const { return m_hint; }
    /// Registers are called by their names in the profile, which may be null.
    void showError(const base::Error& error, const catalog::ProfilePtr& profile);
    /// Shows the warnings among the notices, if there are any.
    void showWarnings(const device::Notices& notices, const catalog::ProfilePtr& profile);
    /// `error` is asked again when the language changes.
    void showInputError(const std::function<QString()>& error);
    void hideMessage();

private:
    TorqueHint* m_hint;
    Banner* m_banner;
};
} // namespace ui
