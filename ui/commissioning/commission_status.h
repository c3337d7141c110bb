// SPDX-License-Identifier: GPL-3.0-or-later
// Which servo is at hand, which step it is in and what the user does next, with the buttons that
// answer the questions of commissioning. Owned by the commissioning page; main thread.
#pragma once

#include "session/commission/commissioning.h"
#include "session/search/search_service.h"

#include <QWidget>

class QLabel;
class QPushButton;

namespace ui {
class StepStrip;

class CommissionStatus final : public QWidget {
    Q_OBJECT

public:
    CommissionStatus(session::Commissioning& commissioning, const session::SearchService& search,
                     QWidget* parent);

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

    session::Commissioning& m_commissioning;
    const session::SearchService& m_search;
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
