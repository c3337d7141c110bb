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
constexpr int columns = 5;
constexpr int minAdviceHeight = 220;
constexpr int minChartHeight = 260; ///< of its card, also before there is a chart

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
    auto* card = new QWidget(this);
    auto* chartColumn = new QVBoxLayout(card);
    makeCard(card);
    auto* head = new QHBoxLayout;
    m_title = new QLabel(this);
    makeHeading(m_title);
    m_choiceLabel = new QLabel(this);
    m_choice = new QComboBox(this);
    m_choice->setObjectName(QStringLiteral("stepChoice"));
    m_choice->setSizeAdjustPolicy(QComboBox::AdjustToContents);
    m_choiceLabel->setBuddy(m_choice);
    m_previousRuns = new QPushButton(this);
    m_previousRuns->setObjectName(QStringLiteral("stepEarlier"));
    connect(m_previousRuns, &QPushButton::clicked, this, &StepResults::previousRunsRequested);
    m_forget = new QPushButton(this);
    m_forget->setObjectName(QStringLiteral("stepForget"));
    head->addWidget(m_choiceLabel);
    head->addWidget(m_choice);
    head->addStretch();
    head->addWidget(m_previousRuns);
    head->addWidget(m_forget);
    m_storedRuns = new QLabel(this);
    m_storedRuns->setObjectName(QStringLiteral("stepStored"));
    m_storedRuns->setTextFormat(Qt::PlainText);
    m_storedRuns->setWordWrap(true);
    m_emptyLabel = new QLabel(this);
    m_emptyLabel->setObjectName(QStringLiteral("stepNothing"));
    makeEmptyState(m_emptyLabel);
    m_chart = new TrendChart(this);
    m_chart->setObjectName(QStringLiteral("stepChart"));
    card->setMinimumHeight(minChartHeight);
    auto* findings = new QSplitter(Qt::Horizontal, this);
    findings->setChildrenCollapsible(false);
    findings->setHandleWidth(cardMargin);
    auto* figures = new QWidget(findings);
    m_figures = metricsTableWidget(figures);
    m_figures->setFrameShape(QFrame::NoFrame);
    (new QVBoxLayout(figures))->addWidget(m_figures);
    makeCard(figures);
    auto* adviceCard = new QWidget(findings);
    auto* side = new QScrollArea(adviceCard);
    (new QVBoxLayout(adviceCard))->addWidget(side);
    makeCard(adviceCard);
    side->setWidgetResizable(true);
    side->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    side->setMinimumWidth(minAdviceHeight);
    m_adviceBox = new QWidget(side);
    auto* advice = new QVBoxLayout(m_adviceBox);
    advice->setContentsMargins({});
    m_adviceTitle = new QLabel(m_adviceBox);
    m_adviceTitle->setTextFormat(Qt::RichText);
    advice->addWidget(m_adviceTitle);
    m_advice = new QVBoxLayout;
    advice->addLayout(m_advice, 1);
    auto* buttons = new QWidget(m_adviceBox);
    auto* flow = new FlowLayout(buttons);
    for (const char* ending : {"html", "csv", "json"}) {
        auto* button = new QPushButton(buttons);
        const QString end = QString::fromLatin1(ending);
        button->setObjectName(QStringLiteral("stepReport_") + end);
        button->setProperty("ending", end);
        connect(button, &QPushButton::clicked, this, [this, end] { askForSavePath(end); });
        flow->addWidget(button);
        m_reports.push_back(button);
    }
    m_saved = new QLabel(m_adviceBox);
    m_saved->setTextFormat(Qt::RichText);
    m_saved->setObjectName(QStringLiteral("stepSaved"));
    m_saved->setWordWrap(true);
    m_saved->setOpenExternalLinks(true);
    m_saved->setTextInteractionFlags(Qt::TextBrowserInteraction);
    advice->addWidget(buttons);
    advice->addWidget(m_saved);
    side->setWidget(m_adviceBox);
    makeTransparent(side);
    findings->addWidget(figures);
    findings->addWidget(adviceCard);
    findings->setStretchFactor(0, 3);
    findings->setStretchFactor(1, 2);
    auto* split = new QSplitter(Qt::Vertical, this);
    split->setChildrenCollapsible(false);
    split->setHandleWidth(cardMargin);
    chartColumn->addWidget(m_title);
    chartColumn->addLayout(head);
    chartColumn->addWidget(m_storedRuns);
    chartColumn->addWidget(m_emptyLabel, 1);
    chartColumn->addWidget(m_chart, 1);
    split->addWidget(card);
    split->addWidget(findings);
    split->setStretchFactor(0, 3);
    split->setStretchFactor(1, 2);
    split->setSizes({400, 360});
    column->addWidget(split);
}

void StepResults::retranslate()
{
    const bool some = !m_test.runs().empty();
    m_title->setText(tr("Responses, in steps toward the goal"));
    m_choiceLabel->setText(tr("Step"));
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
        tr("Click Run to measure the servo's step response. Click Try to repeat it with other "
           "gains, overlay both responses, and restore the gains."));
    m_chart->setAccessibleName(tr("Overlaid step responses"));
    m_figures->setAccessibleName(tr("Metrics before and after"));
    m_figures->setToolTip(tr("Mean of all steps of a run, out and back"));
    const QString value = m_test.previousRun() != nullptr ? tr("After") : tr("Value");
    m_figures->setHorizontalHeaderLabels(
        {tr("Metric"),
         wasAborted(m_test.previousRun()) ? tr("%1 (interrupted)").arg(tr("Before")) : tr("Before"),
         some && wasAborted(&m_test.runs().back()) ? tr("%1 (interrupted)").arg(value) : value,
         tr("Difference"), tr("Change")});
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
