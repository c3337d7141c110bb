// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/step/step_results.h"

#include "report/step_text.h"
#include "text/error_text.h"
#include "text/language.h"
#include "ui/charts/trend_chart.h"
#include "ui/common/file_dialog.h"
#include "ui/common/palette.h"
#include "ui/step/step_text.h"
#include "ui/widgets/test_text.h"

#include <QComboBox>
#include <QEvent>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSplitter>
#include <QStandardPaths>
#include <QTableWidget>
#include <QUrl>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

namespace ui {
using results::StepChange;

namespace {
constexpr int minWidthForAdvice = 560; // its card beside the table
constexpr std::size_t storeBudget = std::size_t(16) << 20;

enum Column : int { Figure, Before, After, Change, Columns };

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
/// "−18.1 better", "unchanged", "+520".
QString changeText(const QString& amount, StepChange change)
{
    const QString word = text::localized(report::stepChangeText(change));
    if (change == StepChange::Same || change == StepChange::NotMeasured)
        return word;
    return change == StepChange::Neither ? amount : amount + QLatin1Char(' ') + word;
}
} // namespace

StepResults::StepResults(session::StepTest& test, const session::ServoRegistry& registry,
                         const catalog::Catalog& catalog, session::Settings& settings,
                         QWidget* parent)
    : QWidget(parent)
    , m_test(test)
    , m_registry(registry)
    , m_catalog(catalog)
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
    connect(&m_test, &session::StepTest::storedOpened, this, &StepResults::refresh);
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
    for (const results::StepRun& run : m_test.runs())
        maxResponses = std::max(maxResponses, run.responses.size());
    const int kept = std::max(0, m_choice->currentIndex());
    m_choice->clear();
    for (std::size_t i = 0; i < maxResponses; ++i)
        m_choice->addItem(i % 2 == 0 ? tr("%1, outbound").arg(i / 2 + 1)
                                     : tr("%1, return").arg(i / 2 + 1));
    m_choice->setCurrentIndex(maxResponses == 0 ? -1 : std::min(kept, int(maxResponses) - 1));
    m_choice->setEnabled(maxResponses > 1);
}

int StepResults::shownResponse() const
{
    return std::max(0, m_choice->currentIndex()) + 1;
}

/// Null: nothing has been measured, or the servo has left the list.
const catalog::Profile* StepResults::testedProfile() const
{
    const session::ServoEntry* entry = m_registry.servo(m_test.servo());
    return entry != nullptr ? entry->servo.profile.get() : nullptr;
}

/// "Test 12 · baseline" of the history, "1 · baseline", "2 · Position loop P 40".
QString StepResults::nameOf(const results::StepSpec& spec, const catalog::Profile* profile,
                            std::size_t place) const
{
    const auto& opened = m_test.openedNumbers();
    const QString number = place < opened.size() ? tr("Test %1").arg(qint64(opened[place]))
                                                 : QString::number(place - opened.size() + 1);
    return QStringLiteral("%1 · %2").arg(number, stepTrialText(spec, profile));
}

/// One line for each, and why the figures of another step stand alone.
QString StepResults::storedRunsText() const
{
    const auto& opened = m_test.openedNumbers();
    const auto& runs = m_test.runs();
    QStringList lines;
    for (std::size_t i = 0; i < opened.size(); ++i)
        lines << tr("Test %1 (%2): %3")
                     .arg(qint64(opened[i]))
                     .arg(runs[i].at.toLocalTime().toString(QStringLiteral("yyyy-MM-dd HH:mm")),
                          stepDetailsText(runs[i], m_catalog));
    const results::StepRun* before = m_test.previousRun();
    const bool isCompared = before != nullptr && before < runs.data() + opened.size();
    if (runs.size() > 1 && !isCompared)
        lines << tr("The steps differ in size, so their metrics are not compared.");
    return lines.join(QLatin1Char('\n'));
}

void StepResults::addCurve(const std::vector<results::StepResponse>& responses, const QString& name)
{
    const QColor ground = palette().color(QPalette::Base);
    const auto found =
        std::find_if(responses.begin(), responses.end(), [this](const results::StepResponse& one) {
            return one.number == shownResponse();
        });
    const int color = int(m_nextColor++);
    if (found == responses.end())
        return;
    const recording::ChannelId channel = m_store.open();
    m_opened.push_back(channel);
    const double sign = found->target < found->start ? -1 : 1;
    for (const results::StepSample& sample : found->samples)
        m_store.append(channel, sample.at, sign * (sample.position - found->start));
    m_channels.push_back({channel, QStringLiteral("run%1").arg(color), name, tr("steps"),
                          trendColor(color % goalColor, ground)});
}

/// The target, as long as the longest response.
void StepResults::showTarget(const std::vector<results::StepResponse>& responses)
{
    if (responses.empty() || responses.front().samples.empty())
        return;
    const results::StepResponse& one = responses.front();
    const recording::ChannelId channel = m_store.open();
    m_opened.push_back(channel);
    m_store.append(channel, {}, std::abs(one.target - one.start));
    m_store.append(channel, one.samples.back().at, std::abs(one.target - one.start));
    TrendChannel goal{channel, QStringLiteral("goal"), tr("Goal"), tr("steps"),
                      trendColor(goalColor, palette().color(QPalette::Base))};
    goal.steps = goal.dashed = true;
    m_channels.push_back(goal);
}

void StepResults::showCurves()
{
    m_chart->setChannels({});
    m_channels.clear();
    for (const recording::ChannelId channel : m_opened)
        m_store.close(channel);
    m_opened.clear();
    m_nextColor = 0;
    const auto& runs = m_test.runs();
    const auto& live = m_test.liveResponses();
    showTarget(!runs.empty() ? runs.back().responses : live);
    std::size_t place = 0;
    for (const results::StepRun& run : runs)
        addCurve(run.responses, nameOf(run.spec, jobs::profileOf(run, m_catalog).get(), place++));
    if (!live.empty())
        addCurve(live, nameOf(m_test.liveSpec(), testedProfile(), place));
    m_emptyLabel->setVisible(m_channels.empty() && !m_test.isRunning());
    m_chart->setVisible(!m_emptyLabel->isVisibleTo(this));
    m_findings->setVisible(!m_emptyLabel->isVisibleTo(this));
    m_chart->setChannels(m_channels);
    m_chart->zoomToFit();
}

void StepResults::showMetrics()
{
    const auto& runs = m_test.runs();
    const results::StepRun* before = m_test.previousRun();
    m_figures->setRowCount(0);
    if (runs.empty())
        return;
    const results::StepRun& after = runs.back();
    for (const results::StepFigure& figure : results::stepFigures) {
        const bool known =
            after.mean.*figure.member || (before != nullptr && before->mean.*figure.member);
        if (!known)
            continue;
        const int row = m_figures->rowCount();
        m_figures->insertRow(row);
        fillRow(row, figure);
    }
    for (const int column : {Before, Change})
        m_figures->setColumnHidden(column, before == nullptr);
    // An interrupted run is neither better nor worse.
    if (wasAborted(before) || wasAborted(&after))
        m_figures->setColumnHidden(Change, true);
    m_figures->resizeColumnsToContents();
}

void StepResults::fillRow(int row, const results::StepFigure& figure)
{
    const results::StepRun& after = m_test.runs().back();
    const results::StepRun* before = m_test.previousRun();
    const auto setCell = [this, row](int column, const QString& words, Tone tone = Tone::Quiet) {
        auto* item = new QTableWidgetItem(words);
        const bool number = column != Figure;
        item->setTextAlignment((number ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter);
        if (tone != Tone::Quiet)
            item->setData(toneRole, int(tone));
        m_figures->setItem(row, column, item);
    };
    const QString unit = report::stepUnit(figure, text::isUiChinese());
    const QString name = text::localized(report::stepFigureText(QString::fromLatin1(figure.key)));
    setCell(Figure, unit.isEmpty() ? name : QStringLiteral("%1 (%2)").arg(name, unit));
    const auto& value = after.mean.*figure.member;
    setCell(After, report::stepValue(value));
    if (before == nullptr)
        return;
    const report::StepPairText pair = report::stepPairText(before->mean.*figure.member, value);
    setCell(Before, pair.before);
    setCell(After, pair.after);
    for (const results::StepDifference& one : results::compareSteps(*before, after)) {
        if (QLatin1StringView(one.figure.key) != QLatin1StringView(figure.key))
            continue;
        setCell(Change, changeText(pair.difference, one.change), toneOf(one.change));
    }
}

/// The advice, with a button that copies its value to Trial.
QWidget* StepResults::adviceRow(const results::StepAdvice& advice)
{
    auto* row = new QWidget(m_adviceBox);
    auto* line = new QHBoxLayout(row);
    line->setContentsMargins(8, 0, 0, 0);
    const catalog::ProfilePtr profile = jobs::profileOf(m_test.runs().back(), m_catalog);
    QString sentence = text::localized(report::stepRemedyText(advice.remedy));
    if (!advice.key.isEmpty())
        sentence += QStringLiteral(": %1 %2 → %3")
                        .arg(text::registerName(profile.get(), advice.key))
                        .arg(advice.now)
                        .arg(advice.proposed);
    auto* words = new QLabel(sentence, row);
    words->setWordWrap(true);
    line->addWidget(words, 1);
    if (advice.key.isEmpty())
        return row;
    if (jobs::wasMeasured(advice, m_test.runs())) {
        words->setText(tr("%1 (already measured)").arg(sentence));
        return row;
    }
    auto* button = new QPushButton(tr("Use"), row);
    button->setObjectName(QStringLiteral("stepTake_") + advice.key);
    button->setAccessibleName(words->text());
    button->setToolTip(tr("Copies this value to Trial; nothing is written"));
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
        const results::StepAdvice one = advice[i];
        if (i == 0 || one.symptom != advice[i - 1].symptom) {
            auto* symptom =
                new QLabel(text::localized(report::stepSymptomText(one.symptom)), m_adviceBox);
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
    ui::askForSavePath(this,
                       {QStringLiteral("stepReportDialog"),
                        tr("Save the runs"),
                        {QStringLiteral("%1 (*.%2)").arg(ending.toUpper(), ending)},
                        QStringLiteral("step-response.") + ending,
                        &m_settings,
                        reportFolderKey()},
                       [this](const QString& path) { m_test.save(path, text::isUiChinese()); });
}

/// The advice stands below the table where there is no room beside it.
void StepResults::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    m_findings->setOrientation(width() < minWidthForAdvice ? Qt::Vertical : Qt::Horizontal);
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
