// SPDX-License-Identifier: GPL-3.0-or-later
// "History of this servo": the writes to it, newest first. Owned by the page; main thread.
#pragma once

#include "ui/memory/servo_history_model.h"

#include <QWidget>

class QLabel;
class QListView;

namespace ui {
class ServoHistoryPanel final : public QWidget {
    Q_OBJECT

public:
    explicit ServoHistoryPanel(QWidget* parent);
    void setEntry(const session::ServoEntry* entry);

private:
    void retranslate();
    void updateVisibility();

    bool m_hasServo = false; ///< there is a servo
    ServoHistoryModel m_model;
    QLabel* m_title;
    QLabel* m_emptyLabel;
    QListView* m_list;
};
} // namespace ui
