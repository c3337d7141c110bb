// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/operate/move_result.h"

#include "ui/operate/control_text.h"

namespace ui {
MoveResult::MoveResult(QWidget* parent)
    : QLabel(parent)
{
    setObjectName(QStringLiteral("controlSaid"));
    setWordWrap(true);
}

void MoveResult::showNotices(const device::Notices& notices, const catalog::ProfilePtr& profile)
{
    m_notices = notices;
    m_profile = profile;
    retranslate();
}

void MoveResult::retranslate()
{
    setText(noticeLines(m_notices, m_profile, NoticeKind::Result));
    if (!text().isEmpty())
        setMinimumHeight(std::max(minimumHeight(), heightForWidth(width())));
}
} // namespace ui
