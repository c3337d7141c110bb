// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/operate/control_messages.h"

#include "text/error_text.h"
#include "ui/editors/register_text.h"
#include "ui/operate/control_text.h"
#include "ui/operate/torque_hint.h"
#include "ui/widgets/banner.h"

#include <QVBoxLayout>

namespace ui {
ControlMessages::ControlMessages(session::Settings& settings, QWidget* parent)
    : QWidget(parent)
    , m_hint(new TorqueHint(settings, this))
    , m_banner(new Banner(this))
{
    setObjectName(QStringLiteral("controlMessages"));
    m_banner->setObjectName(QStringLiteral("controlBanner"));
    m_banner->hideMessage();
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins({});
    column->addWidget(m_hint);
    column->addWidget(m_banner);
}

void ControlMessages::showError(const base::Error& error, const catalog::ProfilePtr& profile)
{
    m_banner->showMessage([error, profile] {
        const catalog::Register* reg = profile ? profile->find(error.registerKey) : nullptr;
        const text::Description words = text::describe(withName(error, reg));
        return BannerText{Tone::Bad, words.message, words.cause, words.remedy};
    });
}

void ControlMessages::showWarnings(const device::Notices& notices,
                                   const catalog::ProfilePtr& profile)
{
    if (noticeLines(notices, profile, NoticeKind::Warning).isEmpty())
        return;
    m_banner->showMessage([notices, profile] {
        return BannerText{Tone::Warn, noticeLines(notices, profile, NoticeKind::Warning)};
    });
}

/// An input that was corrected meanwhile has no error: the last text stays.
void ControlMessages::showInputError(const std::function<QString()>& error)
{
    m_banner->showMessage([error, last = QString()]() mutable {
        if (const QString words = error(); !words.isEmpty())
            last = words;
        return BannerText{Tone::Warn, last};
    });
}

void ControlMessages::hideMessage()
{
    m_banner->hideMessage();
}
} // namespace ui
