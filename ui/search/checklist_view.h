// SPDX-License-Identifier: GPL-3.0-or-later
// The checklist after a search in words: rows that fit open, the others to be opened; each cause
// with a box to tick off what one has looked at, or with what has ruled it out already. Owned by
// the search panel; main thread.
#pragma once

#include "ui/search/search_advice.h"

#include <QWidget>

#include <set>

class QPushButton;
class QVBoxLayout;

namespace ui {
class ChecklistView final : public QWidget {
    Q_OBJECT

public:
    explicit ChecklistView(QWidget* parent = nullptr);

    void show(const SearchFacts& facts);

Q_SIGNALS:
    void fullSearchRequested(); ///< the button that searches everything

protected:
    void changeEvent(QEvent* event) override;

private:
    void retranslate();
    void fill();
    QWidget* rowWidget(const AdviceRow& row);
    QWidget* itemWidget(const AdviceItem& item, int row);

    SearchFacts m_facts;
    std::set<QString> m_ticked; ///< object names
    QWidget* m_content = nullptr;
    QVBoxLayout* m_column;
    QPushButton* m_wider;
};
} // namespace ui
