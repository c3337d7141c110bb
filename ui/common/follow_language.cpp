// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/common/follow_language.h"

#include <QEvent>
#include <QWidget>

namespace ui {
namespace {
class LanguageFilter final : public QObject {
public:
    LanguageFilter(QWidget* widget, std::function<void()> show)
        : QObject(widget)
        , m_show(std::move(show))
    {
        m_show();
        widget->installEventFilter(this);
    }

    bool eventFilter(QObject* /*widget*/, QEvent* event) override
    {
        if (event->type() == QEvent::LanguageChange)
            m_show();
        return false;
    }

private:
    const std::function<void()> m_show;
};
} // namespace

void followLanguage(QWidget* widget, std::function<void()> show)
{
    new LanguageFilter(widget, std::move(show));
}
} // namespace ui
