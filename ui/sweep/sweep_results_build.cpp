// SPDX-License-Identifier: GPL-3.0-or-later
// Builds the widgets that show the results of a sweep test.
#include "ui/charts/trend_chart.h"
#include "ui/common/widget_style.h"
#include "ui/sweep/sweep_results.h"
#include "ui/widgets/error_histogram.h"
#include "ui/widgets/flow_layout.h"
#include "ui/widgets/pill.h"
#include "ui/widgets/stretch_first_column.h"
#include "ui/widgets/tone_delegate.h"

#include <QComboBox>
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
constexpr int minReportWidth = 180; // the table needs the rest for its last column
constexpr int minChartHeight = 250; // of its card, also before there is a chart

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
    auto* card = new QWidget(this);
    auto* chartColumn = new QVBoxLayout(card);
    chartColumn->setSpacing(6);
    makeCard(card);
    card->setMinimumHeight(minChartHeight);
    auto* head = new QHBoxLayout;
    m_title = new QLabel(this);
    makeHeading(m_title);
    m_servos = new QComboBox(this);
    m_servos->setObjectName(QStringLiteral("sweepShownServo"));
    m_servos->setSizeAdjustPolicy(QComboBox::AdjustToContents);
    m_servos->hide();
    m_verdict = new Pill(this);
    m_verdict->setObjectName(QStringLiteral("sweepVerdict"));
    head->addWidget(m_title);
    head->addWidget(m_servos);
    head->addStretch();
    head->addWidget(m_verdict);
    m_emptyLabel = new QLabel(this);
    m_emptyLabel->setObjectName(QStringLiteral("sweepNothing"));
    makeEmptyState(m_emptyLabel);
    m_chart = new TrendChart(this);
    m_chart->setObjectName(QStringLiteral("sweepChart"));
    auto* split = new QSplitter(Qt::Vertical, this);
    split->setChildrenCollapsible(false);
    split->setHandleWidth(cardMargin);
    chartColumn->addLayout(head);
    chartColumn->addWidget(m_emptyLabel, 1);
    chartColumn->addWidget(m_chart, 1);
    split->addWidget(card);
    split->addWidget(buildFindings());
    split->setStretchFactor(0, chartStretch);
    split->setStretchFactor(1, findingsStretch);
    split->setSizes({400, 400}); // the same height for both, whatever is shown first
    column->addWidget(split);
}

QWidget* SweepResults::buildFindings()
{
    auto* split = new QSplitter(Qt::Horizontal, this);
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
    split->addWidget(buildReport());
    split->setStretchFactor(0, tableStretch);
    split->setStretchFactor(1, reportStretch);
    return split;
}

QWidget* SweepResults::buildReport()
{
    auto* card = new QWidget(this);
    card->setMinimumWidth(minReportWidth);
    auto* outer = new QVBoxLayout(card);
    outer->setSpacing(4);
    makeCard(card);
    auto* area =
        new QScrollArea(card); // what comes and goes in it must not move the table beside it
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
    m_end = text("sweepEnd");
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
    column->addWidget(m_end);
    column->addWidget(m_comparison);
    column->addWidget(m_histogramTitle);
    column->addWidget(m_histogram, 1);
    area->setWidget(side);
    makeTransparent(area);
    return card;
}
} // namespace ui
