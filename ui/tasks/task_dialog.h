// SPDX-License-Identifier: GPL-3.0-or-later
// What the dialogs of the servo menu have in common: which servo, what will happen, one button that
// does it, a stop while it runs, and how it ended. Never blocks; deletes itself when closed. Closes
// when the servo leaves the list; closed during its task, the task goes on and ends in the message
// log. Main thread.
#pragma once

#include "session/desk.h"
#include "ui/widgets/task_result.h"

#include <QDialog>
#include <QVBoxLayout>

class QLabel;
class QProgressBar;
class QPushButton;

namespace ui {
class TaskDialog : public QDialog {
    Q_OBJECT

public:
    TaskDialog(session::Desk& desk, session::ServoRef servo, const char* name, QWidget* parent);

    session::ServoRef servo() const { return m_ref; }

protected:
    static constexpr int textWidth = 460;

    session::Desk& desk() const { return m_desk; }
    const session::ServoEntry* entry() const { return m_desk.servo(m_ref); }
    QVBoxLayout* body() const { return m_body; } ///< between explanation and result
    TaskResult* result() const { return m_result; }
    QLabel* textLabel(const char* name); ///< wrapped, as wide as the dialog

    /// To be called by retranslate().
    void setTexts(const QString& title, const QString& explanation, const QString& actionText,
                  const QString& actionTip);
    void setReady(bool ready); ///< whether the deed makes sense now
    bool isRunning() const { return m_running; }
    void setRunning(bool running);

    /// All texts. Called by begin() and after a change of language.
    virtual void retranslate() = 0;
    /// The servo, the list or the link have changed.
    virtual void refresh() {}
    virtual void runAction() {} ///< the deed was asked for
    /// The end of the constructor of each kind.
    void finishSetup();

    /// Runs it as this dialog's task: Stop and progress are shown meanwhile. `done` on the main
    /// thread, while the dialog lives.
    void run(session::Task task, std::function<void(const session::TaskCompletion&)> done);
    /// Beside it, without a word: looks only.
    void runInBackground(session::Task task,
                         std::function<void(const session::TaskCompletion&)> done);
    void showResult(TaskResult::Wording wording) { m_result->showResult(std::move(wording)); }
    void showError(const base::Error& error);

    bool event(QEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    void buildButtons(QVBoxLayout* column);
    void retranslateCommon();
    void fitToContents();
    void updateButtons();
    void showProgress(const jobs::Progress& progress);

    session::Desk& m_desk;
    session::ServoRef m_ref;
    bool m_ready = true;
    bool m_running = false;
    QLabel* m_servoLabel;
    QLabel* m_explanation;
    QVBoxLayout* m_body;
    QProgressBar* m_progress;
    TaskResult* m_result;
    QPushButton* m_stop = nullptr;
    QPushButton* m_close = nullptr;
    QPushButton* m_action = nullptr;
};
} // namespace ui
