// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/step/step_results.h"

#include "report/step_text.h"
#include "text/error_text.h"
#include "text/language.h"
#include "ui/charts/palette.h"
#include "ui/charts/trend_chart.h"
#include "ui/step/step_text.h"
#include "ui/widgets/test_text.h"

#include <QComboBox>
#include <QEvent>
#include <QFileDialog>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QStandardPaths>
#include <QTableWidget>
#include <QUrl>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

namespace ui {
using record::StepChange;

namespace {
constexpr std::size_t storeBudget = std::size_t(16) << 20;
const QString folderKey = QStringLiteral("sweep/report_folder");

enum Column : int { Figure, Before, After, Difference, Change, Columns };

QString in(const catalog::Text& words)
{
    return words.in(text::isUiChinese());
}

Tone toneOf(StepChange change)
{
    switch (change) {
    case StepChange::Better:
        return Tone::Good;
    case StepChange::Worse:
        return Tone::Warn;
    default:
        return Tone::Quiet;
    }
}
} // namespace

StepResults::StepResults(session::StepTest& test, session::Settings& settings, QWidget* parent)
    : QWidget(parent)
    , m_test(test)
    , m_settings(settings)
    , m_store(storeBudget)
{
    build();
    m_chart->setStore(&m_store);
    m_chart->setLive(false);
    m_chart->setOrigin({});
    connect(m_choice, &QComboBox::activated, this, &StepResults::showCurves);
    connect(&m_test, &session::StepTest::responsesAdded, this, &StepResults::showCurves);
    connect(&m_test, &session::StepTest::finished, this, &StepResults::refresh);
    connect(&m_test, &session::StepTest::failed, this, &StepResults::refresh);
    connect(&m_test, &session::StepTest::saved, this, [this](const QString& path) {
        m_savedPath = path;
        m_saveError.reset();
        retranslate();
    });
    connect(&m_test, &session::StepTest::saveFailed, this, [this](const base::Error& error) {
        m_saveError = error;
        retranslate();
    });
    connect(m_forget, &QPushButton::clicked, this, [this] {
        m_test.clear();
        refresh();
    });
    refresh();
}

void StepResults::refresh()
{
    fillChoice();
    showCurves();
    showMetrics();
    showAdvice();
    retranslate();
}

/// "1: there", "1: back", "2: there" … of the longest run.
void StepResults::fillChoice()
{
    std::size_t maxResponses = 0;
    for (const record::StepRun& run : m_test.runs())
        maxResponses = std::max(maxResponses, run.responses.size());
    const int kept = std::max(0, m_choice->currentIndex());
    m_choice->clear();
    for (std::size_t i = 0; i < maxResponses; ++i)
        m_choice->addItem(i % 2 == 0 ? tr("%1, there").arg(i / 2 + 1)
                                     : tr("%1, back").arg(i / 2 + 1));
    m_choice->setCurrentIndex(maxResponses == 0 ? -1 : std::min(kept, int(maxResponses) - 1));
    m_choice->setEnabled(maxResponses > 1);
}

int StepResults::shownResponse() const
{
    return std::max(0, m_choice->currentIndex()) + 1;
}

/// "1 · own values", "2 · position_p 40".
QString StepResults::nameOf(const record::StepSpec& spec, std::size_t place) const
{
    return QStringLiteral("%1 · %2").arg(place).arg(spec.trial.empty() ? tr("own values")
                                                                       : stepGainsText(spec.trial));
}

void StepResults::addCurve(const std::vector<record::StepResponse>& responses, const QString& name)
{
    const QColor ground = palette().color(QPalette::Base);
    const auto found =
        std::find_if(responses.begin(), responses.end(), [this](const record::StepResponse& one) {
            return one.number == shownResponse();
        });
    const int color = int(m_nextColor++);
    if (found == responses.end())
        return;
    const record::ChannelId channel = m_store.open();
    m_opened.push_back(channel);
    const double sign = found->target < found->start ? -1 : 1;
    for (const record::StepSample& sample : found->samples)
        m_store.append(channel, sample.at, sign * (sample.position - found->start));
    m_channels.push_back({channel, QStringLiteral("run%1").arg(color), name, tr("steps"),
                          trendColor(color, ground)});
}

/// Where the way ends, as long as the longest response.
void StepResults::showTarget(const std::vector<record::StepResponse>& responses)
{
    if (responses.empty() || responses.front().samples.empty())
        return;
    const record::StepResponse& one = responses.front();
    const record::ChannelId channel = m_store.open();
    m_opened.push_back(channel);
    m_store.append(channel, {}, std::abs(one.target - one.start));
    m_store.append(channel, one.samples.back().at, std::abs(one.target - one.start));
    TrendChannel goal{channel, QStringLiteral("goal"), tr("Target"), tr("steps"),
                      trendColor(trendColorCount - 1, palette().color(QPalette::Base))};
    goal.steps = true;
    m_channels.push_back(goal);
}

void StepResults::showCurves()
{
    m_chart->setChannels({});
    m_channels.clear();
    for (const record::ChannelId channel : m_opened)
        m_store.close(channel);
    m_opened.clear();
    m_nextColor = 0;
    const auto& runs = m_test.runs();
    const auto& live = m_test.liveResponses();
    showTarget(!runs.empty() ? runs.back().responses : live);
    std::size_t place = 0;
    for (const record::StepRun& run : runs)
        addCurve(run.responses, nameOf(run.spec, ++place));
    if (!live.empty())
        addCurve(live, nameOf(m_test.liveSpec(), ++place));
    m_emptyLabel->setVisible(m_channels.empty());
    m_chart->setChannels(m_channels);
    m_chart->zoomToFit();
}

void StepResults::showMetrics()
{
    const auto& runs = m_test.runs();
    const record::StepRun* before = m_test.previousRun();
    m_figures->setRowCount(0);
    if (runs.empty())
        return;
    const record::StepRun& after = runs.back();
    for (const record::StepFigure& figure : record::stepFigures) {
        const bool known =
            after.mean.*figure.member || (before != nullptr && before->mean.*figure.member);
        if (!known)
            continue;
        const int row = m_figures->rowCount();
        m_figures->insertRow(row);
        fillRow(row, figure);
    }
    for (const int column : {Before, Difference, Change})
        m_figures->setColumnHidden(column, before == nullptr);
    // Of a run that was broken off nothing is better or worse.
    if (wasAborted(before) || wasAborted(&after))
        m_figures->setColumnHidden(Change, true);
    m_figures->resizeColumnsToContents();
}

void StepResults::fillRow(int row, const record::StepFigure& figure)
{
    const record::StepRun& after = m_test.runs().back();
    const record::StepRun* before = m_test.previousRun();
    const auto setCell = [this, row](int column, const QString& words, Tone tone = Tone::Quiet) {
        auto* item = new QTableWidgetItem(words);
        const bool number = column != Figure && column != Change;
        item->setTextAlignment((number ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter);
        if (tone != Tone::Quiet)
            item->setData(toneRole, int(tone));
        m_figures->setItem(row, column, item);
    };
    const QString unit = report::stepUnit(figure, text::isUiChinese());
    const QString name = in(report::stepFigureText(QString::fromLatin1(figure.key)));
    setCell(Figure, unit.isEmpty() ? name : QStringLiteral("%1 (%2)").arg(name, unit));
    setCell(After, report::stepValue(after.mean.*figure.member));
    if (before == nullptr)
        return;
    setCell(Before, report::stepValue(before->mean.*figure.member));
    for (const record::StepDifference& one : record::compareSteps(*before, after)) {
        if (QLatin1StringView(one.figure.key) != QLatin1StringView(figure.key))
            continue;
        setCell(Difference, report::stepValue(one.difference));
        setCell(Change, in(report::stepChangeText(one.change)), toneOf(one.change));
    }
}

/// What may help, and where it can be tried a button that puts it there.
QWidget* StepResults::adviceRow(const record::StepAdvice& advice)
{
    auto* row = new QWidget(m_adviceBox);
    auto* line = new QHBoxLayout(row);
    line->setContentsMargins(8, 0, 0, 0);
    auto* words = new QLabel(in(report::stepAdviceLine(advice)), row);
    words->setWordWrap(true);
    line->addWidget(words, 1);
    if (advice.key.isEmpty())
        return row;
    auto* button = new QPushButton(tr("Take"), row);
    button->setObjectName(QStringLiteral("stepTake_") + advice.key);
    button->setAccessibleName(words->text());
    button->setToolTip(tr("Put this value into Try; nothing is written"));
    connect(button, &QPushButton::clicked, this,
            [this, advice] { Q_EMIT adviceRequested(advice); });
    line->addWidget(button);
    return row;
}

void StepResults::showAdvice()
{
    while (QLayoutItem* item = m_advice->takeAt(0)) {
        if (item->widget() != nullptr)
            item->widget()->deleteLater();
        delete item;
    }
    const auto& advice = m_test.advice();
    for (std::size_t i = 0; i < advice.size(); ++i) {
        const record::StepAdvice one = advice[i];
        if (i == 0 || one.symptom != advice[i - 1].symptom) {
            auto* symptom = new QLabel(in(report::stepSymptomText(one.symptom)), m_adviceBox);
            symptom->setWordWrap(true);
            symptom->setObjectName(QStringLiteral("stepSymptom"));
            m_advice->addWidget(symptom);
        }
        m_advice->addWidget(adviceRow(one));
    }
    m_advice->addStretch();
}

void StepResults::askForSavePath(const QString& ending)
{
    const QString folder =
        m_settings
            .pageValue(folderKey,
                       QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation))
            .toString();
    auto* dialog = new QFileDialog(this, tr("Save the runs"), folder);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setAcceptMode(QFileDialog::AcceptSave);
    dialog->setDefaultSuffix(ending);
    dialog->setNameFilter(QStringLiteral("*.") + ending);
    dialog->selectFile(QStringLiteral("step-response.") + ending);
    connect(dialog, &QFileDialog::fileSelected, this, [this](const QString& path) {
        m_settings.setPageValue(folderKey, QFileInfo(path).absolutePath());
        m_test.save(path, text::isUiChinese());
    });
    dialog->open();
}

void StepResults::changeEvent(QEvent* event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange)
        refresh();
    else if (event->type() == QEvent::PaletteChange)
        showCurves();
}
} // namespace ui
