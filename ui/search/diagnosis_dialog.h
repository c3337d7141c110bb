// SPDX-License-Identifier: GPL-3.0-or-later
// Why does a servo not reply? Shows the evidence while the diagnosis runs, and in the end the cause
// and what to do, with a button where the program can do it. Runs it when it is shown. Open it with
// show(); it does not block, and deletes itself. Main thread.
#pragma once

#include "session/search/search_service.h"
#include "ui/common/commands.h"

#include <QDialog>

class QLabel;
class QPushButton;
class QTextBrowser;

namespace ui {
class RemedyDrawing;
class ThinProgress;

class DiagnosisDialog final : public QDialog {
    Q_OBJECT

public:
    DiagnosisDialog(session::SearchService& search, session::LinkController& link,
                    Commands& commands, QWidget* parent);

    QString report() const; ///< as text, for a forum

protected:
    void changeEvent(QEvent* event) override;

private:
    void build();
    QWidget* buildEvidence();
    QWidget* buildCause();
    void start();
    void update();
    void showProgress(const jobs::Progress& progress);
    void showEvidence();
    void showState();
    void showAction();
    void act();
    void retranslate();

    session::SearchService& m_search;
    session::LinkController& m_link;
    Commands& m_commands;
    QString m_port;
    QLabel* m_evidenceTitle;
    QTextBrowser* m_evidence;
    ThinProgress* m_progress;
    QLabel* m_state;
    QLabel* m_causeTitle;
    QLabel* m_cause;
    QLabel* m_remedy;
    RemedyDrawing* m_drawing;
    QLabel* m_also;
    QPushButton* m_action;
    QPushButton* m_again;
    QPushButton* m_copy;
    QPushButton* m_close;
};
} // namespace ui
