// SPDX-License-Identifier: GPL-3.0-or-later
// A tab whose page is made when it is first shown or used, so that the start of the program does
// not wait for pages that are not shown. Owned by the tabs, owns its page; main thread.
#pragma once

#include "ui/common/widget_style.h"

#include <QVBoxLayout>
#include <QWidget>

#include <functional>

namespace ui {
template <typename Page>
class LazyPage final : public QWidget {
public:
    /// `make` makes the page as a child of the widget it gets.
    LazyPage(std::function<Page*(QWidget*)> make, QWidget* parent)
        : QWidget(parent)
        , m_make(std::move(make))
    {}

    bool isMade() const { return m_page != nullptr; }
    Page& page()
    {
        if (m_page == nullptr) {
            m_page = m_make(this);
            auto* column = new QVBoxLayout(this);
            column->setContentsMargins({});
            column->addWidget(m_page);
            m_page->layout()->setContentsMargins(cardMargin, cardMargin, cardMargin, cardMargin);
            m_page->setVisible(true);
            column->activate(); // it may be used before the next event
        }
        return *m_page;
    }

protected:
    void showEvent(QShowEvent* event) override
    {
        page();
        QWidget::showEvent(event);
    }

private:
    std::function<Page*(QWidget*)> m_make;
    Page* m_page = nullptr;
};
} // namespace ui
