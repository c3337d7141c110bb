// SPDX-License-Identifier: GPL-3.0-or-later
// What a sweep test measures, while it does and afterwards, of one of its servos: position against
// goal, verdict, legs, errors at the target, and the report to be saved. Reads the test, changes
// nothing. Owned by the sweep page; main thread, never waits.
#pragma once

#include "session/settings.h"
#include "session/sweep/sweep_test.h"
#include "ui/sweep/sweep_legs_model.h"
#include "ui/sweep/sweep_verdict_model.h"

#include <QTimer>
#include <QWidget>

class QComboBox;
class QLabel;
class QPushButton;
class QTableView;
class QTabWidget;
class QToolButton;

namespace ui {
class ErrorHistogram;
class Pill;
class TrendChart;

class SweepResults final : public QWidget {
    Q_OBJECT

public:
    QWidget* chart() const; ///< messages may float over it
    SweepResults(session::Workbench& workbench, session::SweepTest& test,
                 session::Settings& settings, QWidget* parent);

    /// Below the verdict: the result of another test of this model. Empty: nothing to compare
    /// with.
    void setComparison(const QString& text);
    std::size_t shownServo() const { return m_servo; }
    QString verdictText() const; ///< the verdict in a line, as it is shown
    /// The figures of this servo of the test.
    void showServo(int index);

Q_SIGNALS:
    void previousTestsRequested();
    void servoShown();

protected:
    void changeEvent(QEvent* event) override;
    void showEvent(QShowEvent* event) override;

private:
    void build();
    QWidget* buildFindings();
    QWidget* buildReport();
    void connectTest();
    void startRun();
    void finishRun();
    void updateServoNames();
    void showEnd();
    void showCurves();
    void appendLegs();
    void showMetrics();
    void hideEmptyColumns();
    void showVerdict();
    void askForSavePath(const QString& ending);
    void enableReports();
    void retranslate();
    const results::SweepServo* servo() const;

    session::Workbench& m_workbench;
    session::SweepTest& m_test;
    session::Settings& m_settings;
    SweepVerdictModel m_verdictModel;
    SweepLegsModel m_legsModel;
    std::size_t m_servo = 0;
    std::size_t m_legsTaken = 0;
    QTimer m_figures; ///< not after every leg anew

    QLabel* m_title = nullptr;
    QComboBox* m_servos = nullptr;
    Pill* m_verdict = nullptr;
    QLabel* m_emptyLabel = nullptr; ///< over the chart, until there is something
    TrendChart* m_chart = nullptr;
    QTabWidget* m_tabs = nullptr;
    QTableView* m_verdictView = nullptr;
    QTableView* m_legsView = nullptr;
    QToolButton* m_all = nullptr;
    QLabel* m_legsNotice = nullptr;
    QLabel* m_end = nullptr;
    QLabel* m_histogramTitle = nullptr;
    ErrorHistogram* m_histogram = nullptr;
    QLabel* m_reportTitle = nullptr;
    std::vector<QPushButton*> m_reports;
    QPushButton* m_previousTests = nullptr;
    QLabel* m_comparison = nullptr;
    QLabel* m_saved = nullptr;
    QString m_savedPath;
    std::optional<base::Error> m_saveError;
};
} // namespace ui
