// SPDX-License-Identifier: GPL-3.0-or-later
// Two servos' sweep tests side by side: what differs in the tests first, then the figures, then the
// settings. B is compared with A. Can be saved as a page. Main thread, never waits; the
// archive must outlive it.
#pragma once

#include "session/history/history_service.h"
#include "session/settings.h"
#include "ui/widgets/task_result.h"

#include <QDialog>

class QLabel;
class QPushButton;
class QTableWidget;

namespace ui {
struct CompareSide {
    QString name;
    session::SharedRun run;
    int servo = -1; ///< ID; must be in the run
};

class CompareDialog final : public QDialog {
    Q_OBJECT

public:
    CompareDialog(session::HistoryService& historyService, session::Settings& settings,
                  const CompareSide& a, const CompareSide& b, QWidget* parent);

protected:
    void changeEvent(QEvent* event) override;

private:
    void build();
    void retranslate();
    void fillSides();
    void fillWarnings();
    void updateColors();
    void fillFigures();
    void fillSettings();
    void askForSavePath();
    void save(const QString& path);

    session::HistoryService& m_historyService;
    session::Settings& m_settings;
    const CompareSide m_a;
    const CompareSide m_b;
    const results::SweepComparison m_found;
    QLabel* m_sides;
    QLabel* m_warnings;
    QTableWidget* m_tests;
    QTableWidget* m_figures;
    QLabel* m_settingsTitle;
    QTableWidget* m_settingsTable;
    TaskResult* m_result;
    QPushButton* m_save;
    QPushButton* m_close = nullptr;
};
} // namespace ui
