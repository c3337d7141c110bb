// SPDX-License-Identifier: GPL-3.0-or-later
// How the last action was carried out, below the controls: "value rounded to 2048". Keeps its
// height when its text goes, because a panel scrolled to its end would shift. Owned by the control
// panel; main thread.
#pragma once

#include "device/notice.h"
#include "device/servo.h"

#include <QLabel>

namespace ui {
class MoveResult final : public QLabel {
    Q_OBJECT

public:
    explicit MoveResult(QWidget* parent);

    /// Shows all notices but the warnings. Registers are called by their names in the profile,
    /// which may be null.
    void showNotices(const device::Notices& notices, const catalog::ProfilePtr& profile);
    void clearNotices() { showNotices({}, nullptr); }
    void retranslate();

private:
    device::Notices m_notices;
    catalog::ProfilePtr m_profile;
};
} // namespace ui
