// SPDX-License-Identifier: GPL-3.0-or-later
// What a sweep test measures, while it does and afterwards: the verdict, and of one of its servos
// position against goal, metrics, legs, errors at the target, and the report to be saved. One
// sentence until there is a test. Reads the test, changes nothing. Owned by the sweep page; main
// thread, never waits.
#pragma once

#include "session/settings.h"
#include "session/sweep/sweep_test.h"
#include "ui/sweep/sweep_legs_model.h"
#include "ui/sweep/sweep_verdict_model.h"

#include <QTimer>
#include <QWidget>

class QLabel;
class QPushButton;
class QSplitter;
class QTableView;
class QTabWidget;
class QToolButton;

namespace ui {
class ErrorHistogram;
class TrendChart;
class VerdictBanner;

class SweepResults final : public QWidget {
    Q_OBJECT

public:
    QWidget* chartCard() const { return m_chartCard; } ///< messages may float over it
    SweepResults(const base::Clock& clock, session::SweepTest& test, session::Settings& settings,
                 QWidget* parent);

    /// Below the verdict: the result of another test of this model. Empty: nothing to compare
    /// with.
    void setComparison(const QString& text);
    std::size_t shownServo() const { return m_servo; }
    /// The user wants to see this servo of the test. Otherwise the worst one is shown at the end.
    void chooseServo(int index);

Q_SIGNALS:
    void previousTestsRequested();
    void servoShown();

protected:
    void changeEvent(QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void showEvent(QShowEvent* event) override;

private:
    void build();
    QWidget* buildChart();
    QWidget* buildFindings();
    QWidget* buildReport();
    void connectTest();
    void showServo(int index);
    void showWorstServo();
    void startRun();
    void finishRun();
    QString verdictReason() const;
    void showCurves();
    void appendLegs();
    void showMetrics();
    void hideEmptyColumns();
    void showVerdict();
    void showChips();
    void askForSavePath(const QString& ending);
    void enableReports();
    void retranslate();
    const results::SweepServo* servo() const;

    const base::Clock& m_clock; ///< of the readings
    session::SweepTest& m_test;
    session::Settings& m_settings;
    SweepVerdictModel m_verdictModel;
    SweepLegsModel m_legsModel;
    std::size_t m_servo = 0;
    bool m_isChosen = false; ///< by the user, in this run
    std::size_t m_legsTaken = 0;
    QTimer m_figures; ///< not after every leg anew

    VerdictBanner* m_verdict = nullptr;
    QSplitter* m_split = nullptr;
    QWidget* m_chartCard = nullptr;
    QWidget* m_findings = nullptr;
    QLabel* m_title = nullptr;
    QWidget* m_empty = nullptr; ///< in place of the chart, until there is something
    QLabel* m_emptyLabel = nullptr;
    QPushButton* m_emptyPreviousTests = nullptr;
    TrendChart* m_chart = nullptr;
    QTabWidget* m_tabs = nullptr;
    QTableView* m_verdictView = nullptr;
    QTableView* m_legsView = nullptr;
    QToolButton* m_all = nullptr;
    QLabel* m_legsNotice = nullptr;
    QWidget* m_reportCard = nullptr;
    QWidget* m_report = nullptr; ///< in the card, or in a tab
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
