// SPDX-License-Identifier: GPL-3.0-or-later
// The checklist after a search: rows that fit are open, the others can be opened; each cause has a
// box to check off, or shows what the search has ruled out. Owned by the search panel; main thread.
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
