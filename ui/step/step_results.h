// SPDX-License-Identifier: GPL-3.0-or-later
// What step-response runs have measured: responses over each other, figures before and after, what
// to try next, reports. Reads the lab, changes nothing. Owned by the step page; main thread, never
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
class QTableWidget;
class QVBoxLayout;

namespace ui {
class TrendChart;

class StepResults final : public QWidget {
    Q_OBJECT

public:
    StepResults(session::StepTest& test, session::Settings& settings, QWidget* parent);

    /// All anew: other runs, another language or theme.
    void refresh();

Q_SIGNALS:
    /// The button of a piece of advice: into what is tried.
    void adviceRequested(const record::StepAdvice& advice);

protected:
    void changeEvent(QEvent* event) override;

private:
    void build();
    void showCurves();
    void addCurve(const std::vector<record::StepResponse>& responses, const QString& name);
    void showTarget(const std::vector<record::StepResponse>& responses);
    void showMetrics();
    void fillRow(int row, const record::StepFigure& figure);
    void showAdvice();
    QWidget* adviceRow(const record::StepAdvice& advice);
    void fillChoice();
    void askForSavePath(const QString& ending);
    void retranslate();
    QString nameOf(const record::StepSpec& spec, std::size_t place) const;
    int shownResponse() const; ///< from 1

    session::StepTest& m_test;
    session::Settings& m_settings;
    record::SampleStore m_store;
    std::vector<record::ChannelId> m_opened;

    QLabel* m_title;
    QLabel* m_choiceLabel;
    QComboBox* m_choice; ///< which response of each run
    QLabel* m_emptyLabel;
    TrendChart* m_chart;
    QTableWidget* m_figures;
    QWidget* m_adviceBox;
    QLabel* m_adviceTitle;
    QVBoxLayout* m_advice;
    std::vector<QPushButton*> m_reports;
    QPushButton* m_forget;
    QLabel* m_saved;
    QString m_savedPath;
    std::optional<base::Error> m_saveError{};
    std::size_t m_nextColor = 0;
    std::vector<TrendChannel> m_channels;
};
} // namespace ui
