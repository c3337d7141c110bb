// SPDX-License-Identifier: GPL-3.0-or-later
// Builds the widgets that show the results of a sweep test.
#include "ui/charts/trend_chart.h"
#include "ui/common/widget_style.h"
#include "ui/sweep/sweep_results.h"
#include "ui/widgets/error_histogram.h"
#include "ui/widgets/flow_layout.h"
#include "ui/widgets/stretch_first_column.h"
#include "ui/widgets/tone_delegate.h"
#include "ui/widgets/verdict_banner.h"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QSplitter>
#include <QTabWidget>
#include <QTableView>
#include <QToolButton>
#include <QVBoxLayout>

namespace ui {
namespace {
constexpr int chartStretch = 5;
constexpr int findingsStretch = 5;
constexpr int tableStretch = 5;
constexpr int reportStretch = 2;
constexpr int minReportWidth = 180;     // the table needs the rest for its last column
constexpr int maxHistogramHeight = 240; // the chart and the table say more
constexpr int minChartHeight = 250;     // of its card, also before there is a chart

QTableView* table(const char* name, QAbstractItemModel& model, QWidget* parent)
{
    auto* view = new QTableView(parent);
    view->setObjectName(QString::fromLatin1(name));
    view->setModel(&model);
    view->setItemDelegate(new ToneDelegate(view));
    view->setEditTriggers(QAbstractItemView::NoEditTriggers);
    view->setFrameShape(QFrame::NoFrame);
    styleTable(view);
    return view;
}
} // namespace

void SweepResults::build()
{
    setObjectName(QStringLiteral("sweepResults"));
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins({});
    column->setSpacing(cardMargin);
    m_verdict = new VerdictBanner(this);
    m_verdict->setObjectName(QStringLiteral("sweepVerdict"));
    m_split = new QSplitter(Qt::Vertical, this);
    m_split->setChildrenCollapsible(false);
    m_split->setHandleWidth(cardMargin);
    m_split->addWidget(buildChart());
    m_findings = buildFindings();
    m_split->addWidget(m_findings);
    m_split->setStretchFactor(0, chartStretch);
    m_split->setStretchFactor(1, findingsStretch);
    column->addWidget(m_verdict);
    column->addWidget(m_split, 1);
}

QWidget* SweepResults::buildChart()
{
    m_chartCard = new QWidget(this);
    auto* column = new QVBoxLayout(m_chartCard);
    column->setSpacing(6);
    makeCard(m_chartCard);
    m_chartCard->setMinimumHeight(minChartHeight);
    m_title = new QLabel(m_chartCard);
    makeHeading(m_title);
    m_empty = new QWidget(m_chartCard);
    m_emptyLabel = new QLabel(m_empty);
    m_emptyLabel->setObjectName(QStringLiteral("sweepNothing"));
    makeEmptyState(m_emptyLabel);
    m_emptyPreviousTests = new QPushButton(m_empty);
    m_emptyPreviousTests->setObjectName(QStringLiteral("sweepEmptyEarlier"));
    auto* sentence = new QVBoxLayout(m_empty);
    sentence->setSpacing(12);
    sentence->addStretch();
    sentence->addWidget(m_emptyLabel);
    sentence->addWidget(m_emptyPreviousTests, 0, Qt::AlignCenter);
    sentence->addStretch();
    m_chart = new TrendChart(m_chartCard);
    m_chart->setObjectName(QStringLiteral("sweepChart"));
    column->addWidget(m_title);
    column->addWidget(m_empty, 1);
    column->addWidget(m_chart, 1);
    return m_chartCard;
}

QWidget* SweepResults::buildFindings()
{
    auto* split = new QSplitter(Qt::Horizontal, this);
    split->setObjectName(QStringLiteral("sweepFindings"));
    split->setChildrenCollapsible(false);
    split->setHandleWidth(cardMargin);
    auto* card = new QWidget(split);
    m_tabs = new QTabWidget(card);
    (new QVBoxLayout(card))->addWidget(m_tabs);
    makeCard(card);
    m_tabs->setObjectName(QStringLiteral("sweepTabs"));
    m_tabs->setDocumentMode(true);
    m_verdictView = table("sweepVerdictTable", m_verdictModel, m_tabs);
    new StretchFirstColumn(m_verdictView);
    m_all = new QToolButton(m_tabs);
    m_all->setObjectName(QStringLiteral("sweepAllFigures"));
    m_all->setCheckable(true);
    m_all->setAutoRaise(true);
    m_tabs->setCornerWidget(m_all);
    auto* legs = new QWidget(m_tabs);
    auto* legsColumn = new QVBoxLayout(legs);
    legsColumn->setContentsMargins({});
    m_legsView = table("sweepLegsTable", m_legsModel, legs);
    m_legsView->horizontalHeader()->setSectionResizeMode(QHeaderView::Interactive);
    m_legsNotice = new QLabel(legs);
    m_legsNotice->setWordWrap(true);
    m_legsNotice->hide();
    legsColumn->addWidget(m_legsView, 1);
    legsColumn->addWidget(m_legsNotice);
    m_tabs->addTab(m_verdictView, QString());
    m_tabs->addTab(legs, QString());
    split->addWidget(card);
    m_report = buildReport();
    m_reportCard = new QWidget(split);
    m_reportCard->setMinimumWidth(minReportWidth);
    (new QVBoxLayout(m_reportCard))->addWidget(m_report);
    makeCard(m_reportCard);
    split->addWidget(m_reportCard);
    split->setStretchFactor(0, tableStretch);
    split->setStretchFactor(1, reportStretch);
    return split;
}

QWidget* SweepResults::buildReport()
{
    auto* report = new QWidget(this);
    auto* outer = new QVBoxLayout(report);
    outer->setContentsMargins({});
    outer->setSpacing(4);
    auto* area =
        new QScrollArea(report); // what comes and goes in it must not move the table beside it
    area->setWidgetResizable(true);
    area->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    auto* side = new QWidget(area);
    auto* column = new QVBoxLayout(side);
    column->setContentsMargins({});
    column->setSpacing(4);
    const auto text = [side](const char* name) {
        auto* label = new QLabel(side);
        label->setObjectName(QString::fromLatin1(name));
        label->setWordWrap(true);
        return label;
    };
    m_histogramTitle = text("sweepHistogramTitle");
    m_histogram = new ErrorHistogram(side);
    m_histogram->setObjectName(QStringLiteral("sweepHistogram"));
    makeHeading(m_histogramTitle);
    m_comparison = text("sweepComparison");
    m_comparison->hide();
    m_reportTitle = text("sweepReportTitle");
    makeHeading(m_reportTitle);
    auto* buttons = new QWidget(side);
    QSizePolicy policy(QSizePolicy::Expanding, QSizePolicy::Minimum);
    policy.setHeightForWidth(true);
    buttons->setSizePolicy(policy);
    auto* row = new FlowLayout(buttons, 4);
    for (const char* ending : {"html", "pdf", "csv", "json"}) {
        auto* button = new QPushButton(QString::fromLatin1(ending).toUpper(), buttons);
        button->setObjectName(QStringLiteral("sweepReport_") + QLatin1String(ending));
        button->setMinimumWidth(0);
        row->addWidget(button);
        m_reports.push_back(button);
        connect(button, &QPushButton::clicked, this,
                [this, ending] { askForSavePath(QString::fromLatin1(ending)); });
    }
    m_previousTests = new QPushButton(buttons);
    m_previousTests->setObjectName(QStringLiteral("sweepEarlier"));
    row->addWidget(m_previousTests);
    connect(m_previousTests, &QPushButton::clicked, this, &SweepResults::previousTestsRequested);
    m_saved = text("sweepSaved");
    m_saved->setTextFormat(Qt::RichText);
    m_saved->setOpenExternalLinks(true);
    m_saved->setTextInteractionFlags(Qt::TextBrowserInteraction);
    m_saved->hide();
    // The buttons stand first: what comes and goes below them must not move them, and messages
    // float at the bottom.
    outer->addWidget(m_reportTitle);
    outer->addWidget(buttons);
    outer->addWidget(area, 1);
    column->addWidget(m_saved);
    column->addWidget(m_comparison);
    column->addWidget(m_histogramTitle);
    m_histogram->setMaximumHeight(maxHistogramHeight);
    column->addWidget(m_histogram, 1);
    column->addStretch();
    area->setWidget(side);
    makeTransparent(area);
    return report;
}
} // namespace ui
