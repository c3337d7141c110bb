// SPDX-License-Identifier: GPL-3.0-or-later
// The results of step-response runs: overlaid responses, figures before and after, advice, reports.
// Reads the test, changes nothing in the servo. Owned by the step page; main thread, never
// waits.
#pragma once

#include "recording/sample_store.h"
#include "session/settings.h"
#include "session/step/step_test.h"
#include "ui/charts/trend_channel.h"

#include <QWidget>

class QComboBox;
class QLabel;
class QPushButton;
class QSplitter;
class QTableWidget;
class QVBoxLayout;

namespace ui {
class TrendChart;

class StepResults final : public QWidget {
    Q_OBJECT

public:
    StepResults(session::StepTest& test, const session::ServoRegistry& registry,
                const catalog::Catalog& catalog, session::Settings& settings, QWidget* parent);

    /// After other runs, or another language or theme.
    void refresh();

Q_SIGNALS:
    /// The button of an advice: its value is to be copied to Trial.
    void adviceRequested(const results::StepAdvice& advice);
    void previousRunsRequested();

protected:
    void changeEvent(QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    void build();
    void showCurves();
    void addCurve(const std::vector<results::StepResponse>& responses, const QString& name);
    void showTarget(const std::vector<results::StepResponse>& responses);
    void showMetrics();
    void fillRow(int row, const results::StepFigure& figure);
    void showAdvice();
    QWidget* adviceRow(const results::StepAdvice& advice);
    void fillChoice();
    void askForSavePath(const QString& ending);
    void retranslate();
    QString nameOf(const results::StepSpec& spec, const catalog::Profile* profile,
                   std::size_t place) const;
    const catalog::Profile* testedProfile() const;
    QWidget* buildChart();
    QWidget* buildMetrics();
    QWidget* buildAdvice();
    QString storedRunsText() const;
    int shownResponse() const; ///< from 1

    session::StepTest& m_test;
    const session::ServoRegistry& m_registry;
    const catalog::Catalog& m_catalog;
    session::Settings& m_settings;
    recording::SampleStore m_store;
    std::vector<recording::ChannelId> m_opened;

    QLabel* m_title;
    QLabel* m_choiceLabel;
    QComboBox* m_choice; ///< which response of each run
    QLabel* m_emptyLabel;
    QLabel* m_storedRuns; ///< those opened from the history
    TrendChart* m_chart;
    QTableWidget* m_figures;
    QSplitter* m_findings; ///< metrics and advice; hidden until there is a run
    QWidget* m_adviceBox;
    QLabel* m_adviceTitle;
    QVBoxLayout* m_advice;
    std::vector<QPushButton*> m_reports;
    QPushButton* m_previousRuns;
    QPushButton* m_forget;
    QLabel* m_saved;
    QString m_savedPath;
    std::optional<base::Error> m_saveError{};
    std::size_t m_nextColor = 0;
    std::vector<TrendChannel> m_channels;
};
} // namespace ui
