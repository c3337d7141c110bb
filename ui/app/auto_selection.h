// SPDX-License-Identifier: GPL-3.0-or-later
// Selects the servo that the command line asks for when it is found, or the only servo that a
// search finds, and has it read; deselects servos that leave the list. Owned by the window; main
// thread.
#pragma once

#include "session/workbench.h"
#include "ui/common/selection.h"

#include <optional>

namespace ui {
class AutoSelection final : public QObject {
    Q_OBJECT

public:
    AutoSelection(session::Workbench& workbench, Selection& selection, QObject* parent);

    /// `selectFirst`: without an ID, selects the first servo that is found.
    void request(std::optional<int> id, bool selectFirst);

private:
    void onServoAdded(session::ServoRef added);
    void onSearchChanged();
    void onServoChanged(session::ServoRef changed);

    session::Workbench& m_workbench;
    Selection& m_selection;
    std::optional<int> m_requestedId; ///< until it is found
    bool m_selectFirst = false;
};
} // namespace ui
