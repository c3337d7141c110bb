// SPDX-License-Identifier: GPL-3.0-or-later
// Everything known about one entry of the history, beside the list, and below it the buttons for
// what one can do with it. Owned by the history page, which owns the buttons' meaning; main thread.
#pragma once

#include "ui/history/history_formatter.h"

#include <QWidget>

class QFormLayout;
class QLabel;
class QPushButton;
class QVBoxLayout;

namespace ui {
class HistoryDetails final : public QWidget {
    Q_OBJECT

public:
    explicit HistoryDetails(QWidget* parent);

    /// Null: a sentence in place of the details.
    void show(const HistoryLine* line);
    /// Below the details, in the order of the calls.
    QPushButton* addButton(const char* name);

private:
    QLabel* m_title;
    QLabel* m_emptyLabel;
    QWidget* m_rows;
    QFormLayout* m_form;
    QVBoxLayout* m_buttons;
};
} // namespace ui
