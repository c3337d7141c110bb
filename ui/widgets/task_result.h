// SPDX-License-Identifier: GPL-3.0-or-later
// The result of a task in a dialog: a sign in its tone, a headline, and lines that can be copied. A
// function provides the text, so that it follows the language. Owned by its dialog; main thread.
#pragma once

#include "ui/widgets/task_text.h"

#include <QWidget>

#include <functional>

class QLabel;

namespace ui {
class TaskResult final : public QWidget {
    Q_OBJECT

public:
    using Wording = std::function<TaskText()>;

    explicit TaskResult(int width, QWidget* parent = nullptr);

    void showResult(Wording wording); ///< shows it
    void clear();                     ///< hides it
    const TaskText& text() const { return m_text; }

protected:
    void changeEvent(QEvent* event) override;

private:
    void fill();
    void updateColors();

    Wording m_wording;
    TaskText m_text;
    QLabel* m_sign;
    QLabel* m_headline;
    QLabel* m_details;
};
} // namespace ui
