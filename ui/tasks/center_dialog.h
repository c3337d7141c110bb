// SPDX-License-Identifier: GPL-3.0-or-later
// Makes the present position the midpoint: shows position and offset before and after, and that
// torque stays off. Main thread.
#pragma once

#include "jobs/change/change.h"
#include "ui/tasks/task_dialog.h"

#include <array>

namespace ui {
class CenterDialog final : public TaskDialog {
    Q_OBJECT

public:
    CenterDialog(session::Workbench& workbench, session::ServoRef servo, QWidget* parent);

protected:
    void retranslate() override;
    void refresh() override;
    void runAction() override;

private:
    void readBefore();
    bool canRun() const;
    QString fieldText(catalog::Role role, const std::optional<std::int64_t>& raw) const;

    std::array<QLabel*, 3> m_headers{};
    std::array<QLabel*, 3> m_position{};
    std::array<QLabel*, 3> m_offset{};
    jobs::CenterReport m_report; ///< what is known so far
};
} // namespace ui
