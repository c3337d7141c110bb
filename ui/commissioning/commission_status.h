// SPDX-License-Identifier: GPL-3.0-or-later
// Which servo is at hand, which step it is in and what the user does next, with the buttons that
// answer the questions of commissioning. The workbench must outlive it; owned by the commissioning
// page; main thread.
#pragma once

#include "session/commission/commissioning.h"

#include <QWidget>

class QLabel;
class QPushButton;

namespace ui {
class StepStrip;

class CommissionStatus final : public QWidget {
    Q_OBJECT

public:
    CommissionStatus(session::Workbench& workbench, QWidget* parent);

    /// `hasEnded`: the line has run on the batch that is entered.
    void show(bool hasEnded);

protected:
    void changeEvent(QEvent* event) override;

private:
    void build();
    void retranslate();
    void showView();
    void showSavedTable();
    void showHeadlineTone();
    int stepNumber() const; ///< in the strip; -1: not running
    QString headline() const;
    QString stoppedDetail() const;
    QString detail() const;
    QString servoText() const;
    QString unfinishedText() const;
    QString pendingQuestionText() const;

    session::Workbench& m_workbench;
    session::Commissioning& m_commissioning;
    bool m_hasEnded = false;
    QLabel* m_headline = nullptr;
    StepStrip* m_steps = nullptr;
    QLabel* m_detail = nullptr;
    QLabel* m_saved = nullptr; ///< where the memory table of the current servo is
    QPushButton* m_continue = nullptr;
    QPushButton* m_same = nullptr;
    QPushButton* m_aside = nullptr;
};
} // namespace ui
