// SPDX-License-Identifier: GPL-3.0-or-later
// Two servos' sweep tests side by side: what differs in the tests first, then the figures, then the
// settings. A is what is held against. Can be saved as a page. Main thread, never waits; the
// archive must outlive it.
#pragma once

#include "session/archive.h"
#include "session/settings.h"
#include "ui/dialogs/task_result.h"

#include <QDialog>

class QLabel;
class QPushButton;
class QTableWidget;

namespace ui {
struct ComparedSide {
    QString name;
    session::SharedRun run;
    int servo = -1; ///< ID; must be in the run
};

class CompareDialog final : public QDialog {
    Q_OBJECT

public:
    CompareDialog(session::Archive& archive, session::Settings& settings, const ComparedSide& a,
                  const ComparedSide& b, QWidget* parent);

protected:
    void changeEvent(QEvent* event) override;

private:
    void build();
    void retranslate();
    void fillSides();
    void fillWarnings();
    void colour();
    void fillFigures();
    void fillSettings();
    void askWhere();
    void save(const QString& path);

    session::Archive& m_archive;
    session::Settings& m_settings;
    const ComparedSide m_a;
    const ComparedSide m_b;
    const record::SweepComparison m_found;
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
