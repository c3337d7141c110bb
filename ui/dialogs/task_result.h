// SPDX-License-Identifier: GPL-3.0-or-later
// How a task ended, in a dialog: a sign in its tone, a headline, and lines that can be copied. The
// words are made by a function, so that they follow the language. Owned by its dialog; main thread.
#pragma once

#include "ui/dialogs/task_words.h"

#include <QWidget>

#include <functional>

class QLabel;

namespace ui {
class TaskResult final : public QWidget {
    Q_OBJECT

public:
    using Wording = std::function<TaskWords()>;

    explicit TaskResult(int width, QWidget* parent = nullptr);

    void tell(Wording wording); ///< shows it
    void clear();               ///< hides it
    const TaskWords& told() const { return m_told; }

protected:
    void changeEvent(QEvent* event) override;

private:
    void fill();
    void colour();

    Wording m_wording;
    TaskWords m_told;
    QLabel* m_sign;
    QLabel* m_what;
    QLabel* m_more;
};
} // namespace ui
