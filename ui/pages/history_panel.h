// SPDX-License-Identifier: GPL-3.0-or-later
// "History of this servo": what was written to it, newest first. Owned by the page; main thread.
#pragma once

#include "ui/models/history_model.h"

#include <QWidget>

class QLabel;
class QListView;

namespace ui {
class HistoryPanel final : public QWidget {
    Q_OBJECT

public:
    explicit HistoryPanel(QWidget* parent);
    void setEntry(const session::ServoEntry* entry);

protected:
    void changeEvent(QEvent* event) override;

private:
    void retranslate();
    void showWhich();

    bool m_chosen = false; ///< there is a servo
    HistoryModel m_model;
    QLabel* m_title;
    QLabel* m_nothing;
    QListView* m_list;
};
} // namespace ui
