// SPDX-License-Identifier: GPL-3.0-or-later
// Builds the widgets that show the results of step responses, and their texts.
#include "text/error_text.h"
#include "ui/charts/trend_chart.h"
#include "ui/common/widget_style.h"
#include "ui/step/step_results.h"
#include "ui/step/step_text.h"
#include "ui/widgets/flow_layout.h"
#include "ui/widgets/stretch_first_column.h"
#include "ui/widgets/tone_delegate.h"

#include <QComboBox>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QSplitter>
#include <QTableWidget>
#include <QUrl>
#include <QVBoxLayout>

namespace ui {
namespace {
constexpr int columns = 4;
constexpr int minAdviceWidth = 200;
constexpr int minChartHeight = 260;

QTableWidget* metricsTableWidget(QWidget* parent)
{
    auto* table = new QTableWidget(0, columns, parent);
    table->setObjectName(QStringLiteral("stepFigures"));
    table->setItemDelegate(new ToneDelegate(table));
    table->setEditTriggers(QAbstractItemView::NoEditTriggers);
    styleTable(table);
    new StretchFirstColumn(table);
    return table;
}
} // namespace

void StepResults::build()
{
    setObjectName(QStringLiteral("stepResults"));
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins({});
    auto* split = new QSplitter(Qt::Vertical, this);
    split->setChildrenCollapsible(false);
    split->setHandleWidth(cardMargin);
    split->addWidget(buildChart());
    m_findings = new QSplitter(Qt::Horizontal, this);
    m_findings->setObjectName(QStringLiteral("stepFindings"));
    m_findings->setChildrenCollapsible(false);
    m_findings->setHandleWidth(cardMargin);
    m_findings->addWidget(buildMetrics());
    m_findings->addWidget(buildAdvice());
    m_findings->setStretchFactor(0, 3);
    m_findings->setStretchFactor(1, 2);
    split->addWidget(m_findings);
    split->setStretchFactor(0, 3);
    split->setStretchFactor(1, 2);
    column->addWidget(split);
}

QWidget* StepResults::buildChart()
{
    auto* card = new QWidget(this);
    auto* column = new QVBoxLayout(card);
    makeCard(card);
    card->setMinimumHeight(minChartHeight);
    m_title = new QLabel(card);
    makeHeading(m_title);
    m_choiceLabel = new QLabel(card);
    m_choice = new QComboBox(card);
    m_choice->setObjectName(QStringLiteral("stepChoice"));
    m_choice->setSizeAdjustPolicy(QComboBox::AdjustToContents);
    m_choiceLabel->setBuddy(m_choice);
    m_previousRuns = new QPushButton(card);
    m_previousRuns->setObjectName(QStringLiteral("stepEarlier"));
    connect(m_previousRuns, &QPushButton::clicked, this, &StepResults::previousRunsRequested);
    m_forget = new QPushButton(card);
    m_forget->setObjectName(QStringLiteral("stepForget"));
    auto* head = new QHBoxLayout;
    head->addWidget(m_title, 1);
    head->addWidget(m_choiceLabel);
    head->addWidget(m_choice);
    head->addWidget(m_previousRuns);
    head->addWidget(m_forget);
    m_storedRuns = new QLabel(card);
    m_storedRuns->setObjectName(QStringLiteral("stepStored"));
    m_storedRuns->setTextFormat(Qt::PlainText);
    m_storedRuns->setWordWrap(true);
    m_emptyLabel = new QLabel(card);
    m_emptyLabel->setObjectName(QStringLiteral("stepNothing"));
    makeEmptyState(m_emptyLabel);
    m_chart = new TrendChart(card);
    m_chart->setObjectName(QStringLiteral("stepChart"));
    column->addLayout(head);
    column->addWidget(m_storedRuns);
    column->addWidget(m_emptyLabel, 1);
    column->addWidget(m_chart, 1);
    return card;
}

QWidget* StepResults::buildMetrics()
{
    auto* card = new QWidget(this);
    m_figures = metricsTableWidget(card);
    m_figures->setFrameShape(QFrame::NoFrame);
    (new QVBoxLayout(card))->addWidget(m_figures);
    makeCard(card);
    return card;
}

QWidget* StepResults::buildAdvice()
{
    auto* card = new QWidget(this);
    auto* side = new QScrollArea(card);
    side->setWidgetResizable(true);
    side->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    side->setMinimumWidth(minAdviceWidth);
    m_adviceBox = new QWidget(side);
    auto* advice = new QVBoxLayout(m_adviceBox);
    advice->setContentsMargins({});
    m_adviceTitle = new QLabel(m_adviceBox);
    m_adviceTitle->setTextFormat(Qt::RichText);
    m_advice = new QVBoxLayout;
    m_saved = new QLabel(m_adviceBox);
    m_saved->setTextFormat(Qt::RichText);
    m_saved->setObjectName(QStringLiteral("stepSaved"));
    m_saved->setWordWrap(true);
    m_saved->setOpenExternalLinks(true);
    m_saved->setTextInteractionFlags(Qt::TextBrowserInteraction);
    advice->addWidget(m_adviceTitle);
    advice->addLayout(m_advice, 1);
    side->setWidget(m_adviceBox);
    makeTransparent(side);
    auto* buttons = new QWidget(card);
    auto* flow = new FlowLayout(buttons);
    for (const char* ending : {"html", "pdf", "csv", "json"}) {
        auto* button = new QPushButton(buttons);
        const QString end = QString::fromLatin1(ending);
        button->setObjectName(QStringLiteral("stepReport_") + end);
        button->setProperty("ending", end);
        connect(button, &QPushButton::clicked, this, [this, end] { askForSavePath(end); });
        flow->addWidget(button);
        m_reports.push_back(button);
    }
    auto* column = new QVBoxLayout(card);
    column->addWidget(side, 1);
    column->addWidget(m_saved);
    column->addWidget(buttons);
    makeCard(card);
    return card;
}

void StepResults::retranslate()
{
    const bool some = !m_test.runs().empty();
    const QString name = some ? QStringLiteral("ID %1 · %2")
                                    .arg(m_test.runs().back().parameters.servo.id)
                                    .arg(m_test.runs().back().parameters.servo.model)
                              : QString();
    m_title->setText(name.isEmpty() ? tr("Response") : tr("Response — %1").arg(name));
    m_title->setToolTip(
        tr("Movement in steps from the start toward the goal, on the way out and on the way back"));
    m_choiceLabel->setText(tr("Step"));
    m_choiceLabel->setVisible(m_choice->count() > 1);
    m_choice->setVisible(m_choice->count() > 1);
    m_forget->setVisible(some);
    m_choice->setAccessibleName(tr("Step to show for each run"));
    m_choice->setToolTip(tr("Step to show for each run"));
    m_storedRuns->setText(storedRunsText());
    m_storedRuns->setVisible(!m_test.openedNumbers().empty());
    m_previousRuns->setText(tr("Earlier runs…"));
    m_previousRuns->setAccessibleName(m_previousRuns->text());
    m_previousRuns->setToolTip(
        tr("Lists the stored step responses; you can open one or compare two"));
    m_forget->setText(tr("Clear"));
    m_forget->setToolTip(tr("Removes these runs from the page; the servo and the history do not "
                            "change"));
    m_forget->setAccessibleName(m_forget->toolTip());
    m_forget->setEnabled(some && !m_test.isRunning());
    m_emptyLabel->setText(
        tr("Click Measure to record the servo's step response. Then change a gain under Trial and "
           "click Try gains to compare."));
    m_chart->setAccessibleName(tr("Overlaid step responses"));
    m_figures->setAccessibleName(tr("Metrics before and after"));
    m_figures->setToolTip(tr("Mean of all steps in a run, out and back"));
    const QString value = m_test.previousRun() == nullptr           ? tr("Value")
                          : m_test.runs().back().spec.trial.empty() ? tr("After")
                                                                    : tr("Trial");
    m_figures->setHorizontalHeaderLabels(
        {tr("Metric"),
         wasAborted(m_test.previousRun()) ? tr("%1 (interrupted)").arg(tr("Before")) : tr("Before"),
         some && wasAborted(&m_test.runs().back()) ? tr("%1 (interrupted)").arg(value) : value,
         tr("Change")});
    const bool advised = !m_test.advice().empty();
    m_adviceTitle->setText(advised ? tr("<b>What to try next</b>")
                           : some  ? tr("These results do not suggest any changes.")
                                   : QString());
    m_adviceTitle->setWordWrap(true);
    for (QPushButton* button : m_reports) {
        const QString ending = button->property("ending").toString();
        button->setText(ending.toUpper());
        button->setEnabled(some && !m_test.isRunning());
        button->setToolTip(tr("Saves these runs as %1").arg(ending.toUpper()));
        button->setAccessibleName(button->toolTip());
    }
    m_saved->setVisible(m_saveError || !m_savedPath.isEmpty());
    if (m_saveError) {
        m_saved->setText(text::describe(*m_saveError).message.toHtmlEscaped());
    } else if (!m_savedPath.isEmpty()) {
        m_saved->setText(QStringLiteral("<a href=\"%1\">%2</a>")
                             .arg(QUrl::fromLocalFile(m_savedPath).toString(QUrl::FullyEncoded),
                                  QFileInfo(m_savedPath).fileName().toHtmlEscaped()));
    }
}
} // namespace ui
