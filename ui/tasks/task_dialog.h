// SPDX-License-Identifier: GPL-3.0-or-later
// The base of the dialogs of the servo menu: the servo, what will happen, a button that does it,
// Stop while it runs, and the result. Never blocks; deletes itself when closed. Closes when the
// servo leaves the list; a dialog that concerns none has servo 0. A task continues when its dialog
// is closed, and its result goes to the message log. Main thread.
#pragma once

#include "session/workbench.h"
#include "ui/widgets/task_result.h"

#include <QDialog>
#include <QVBoxLayout>

class QLabel;
class QPushButton;

namespace ui {
class ThinProgress;

class TaskDialog : public QDialog {
    Q_OBJECT

public:
    TaskDialog(session::Workbench& workbench, session::ServoRef servo, const char* name,
               QWidget* parent);

    session::ServoRef servo() const { return m_ref; }

protected:
    static constexpr int textWidth = 460;

    session::Workbench& workbench() const { return m_workbench; }
    const session::ServoEntry* entry() const { return m_workbench.registry().servo(m_ref); }
    QVBoxLayout* body() const { return m_body; } ///< between explanation and result
    TaskResult* result() const { return m_result; }
    QLabel* textLabel(const char* name); ///< wrapped, as wide as the dialog

    /// To be called by retranslate().
    void setTexts(const QString& title, const QString& explanation, const QString& actionText,
                  const QString& actionTip);
    void setReady(bool ready); ///< whether the action is possible now
    bool isRunning() const { return m_running; }
    void setRunning(bool running);
    bool wasStopped() const { return m_wasStopped; } ///< by the user, since the action was started

    virtual QString servoText() const; ///< the line above the explanation
    void updateServoText();
    virtual QString closeTip() const; ///< of the Close button
    virtual QString progressText(const jobs::Progress& progress) const;
    /// All texts. Called by finishSetup() and after a change of language.
    virtual void retranslate() = 0;
    /// The servo, the list or the link have changed.
    virtual void refresh() {}
    virtual void runAction() {} ///< the action button was pressed
    /// To be called at the end of the constructor of each subclass.
    void finishSetup();

    /// Runs it as this dialog's task, with Stop and progress. `done` is called on the main thread
    /// if the dialog still exists.
    void run(session::Task task, std::function<void(const session::TaskCompletion&)> done);
    /// The same with another servo than that of the dialog.
    void run(session::ServoRef ref, session::Task task,
             std::function<void(const session::TaskCompletion&)> done);
    /// In the background, without a message; it only reads.
    void runInBackground(session::Task task,
                         std::function<void(const session::TaskCompletion&)> done);
    /// Writes the register as this dialog's task; the dialog itself is the question. `success` is a
    /// text of the context "ServoTasks".
    void writeRegister(const catalog::Register& reg, std::int64_t raw, const char* success);
    void showResult(TaskResult::Wording wording) { m_result->showResult(std::move(wording)); }
    void showError(const base::Error& error);

    bool event(QEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    void buildButtons(QVBoxLayout* column);
    void connectWorkbench();
    bool isServoThere() const { return m_ref == 0 || entry() != nullptr; }
    void retranslateCommon();
    void fitToContents();
    void updateButtons();
    void showProgress(const jobs::Progress& progress);
    void onWritten(const session::Event& event);

    session::Workbench& m_workbench;
    session::ServoRef m_ref;
    bool m_ready = true;
    bool m_running = false;
    bool m_wasStopped = false;
    QString m_writtenKey; ///< of writeRegister(), until it has ended; else empty
    const char* m_writeSuccess = nullptr;
    QLabel* m_servoLabel;
    QLabel* m_explanation;
    QVBoxLayout* m_body;
    ThinProgress* m_progress;
    QLabel* m_state;
    TaskResult* m_result;
    QPushButton* m_stop = nullptr;
    QPushButton* m_close = nullptr;
    QPushButton* m_action = nullptr;
};
} // namespace ui
