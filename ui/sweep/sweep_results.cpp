// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/sweep/sweep_results.h"

#include "jobs/sweep/sweep_statistics.h"
#include "report/sweep_text.h"
#include "text/error_text.h"
#include "text/language.h"
#include "ui/charts/trend_chart.h"
#include "ui/common/file_dialog.h"
#include "ui/common/palette.h"
#include "ui/widgets/error_histogram.h"
#include "ui/widgets/test_text.h"
#include "ui/widgets/verdict_banner.h"

#include <QDir>
#include <QEvent>
#include <QFileInfo>
#include <QLabel>
#include <QLayout>
#include <QPushButton>
#include <QScrollBar>
#include <QStandardPaths>
#include <QTabWidget>
#include <QTableView>
#include <QToolButton>
#include <QUrl>

#include <algorithm>

namespace ui {
using namespace std::chrono_literals;
using results::Grade;

namespace {
constexpr int minWidthForReport = 560; // its card beside the table
constexpr auto metricsInterval = 500ms;
/// Figures are worked out from all legs: of a long test less often.
constexpr std::size_t legsPerMillisecond = 20;
constexpr auto defaultWidth = std::chrono::seconds(10);

QString servoName(const results::SweepServo& servo)
{
    return QStringLiteral("ID %1 · %2")
        .arg(servo.parameters.servo.id)
        .arg(servo.parameters.servo.model);
}

/// "Overshoot, Hysteresis": what decided the verdict; or why there is none. Empty: it has passed,
/// or the end of the test says why.
QString reasonText(const results::SweepRun& run, const results::SweepServo& servo)
{
    const results::NoVerdictReason none = results::sweepVerdict(run, servo).reason;
    if (none != results::NoVerdictReason::None)
        return none == results::NoVerdictReason::Ended
                   ? QString()
                   : text::localized(report::noVerdictReasonText(none));
    QStringList reasons;
    for (const results::VerdictLine& line : servo.lines) {
        if (line.grade == servo.verdict && (line.grade == Grade::Fail || line.grade == Grade::Warn))
            reasons.append(metricName(line.limit.metric));
    }
    return text::joinItems(reasons);
}

/// Of one servo why; of several the worst ones, which count: "ID 2 — Overshoot; ID 5 — Stall".
QString reasonText(const results::SweepRun& run)
{
    if (run.servos.size() == 1)
        return reasonText(run, run.servos.front());
    QStringList worst;
    for (const results::SweepServo& servo : run.servos) {
        if (servo.verdict != run.verdict() || servo.verdict == Grade::Pass)
            continue;
        const QString reason = reasonText(run, servo);
        worst.append(QStringLiteral("ID %1").arg(servo.parameters.servo.id) +
                     (reason.isEmpty() ? QString() : QStringLiteral(" — ") + reason));
    }
    return text::joinClauses(worst);
}
} // namespace

SweepResults::SweepResults(const base::Clock& clock, session::SweepTest& test,
                           session::Settings& settings, QWidget* parent)
    : QWidget(parent)
    , m_clock(clock)
    , m_test(test)
    , m_settings(settings)
{
    build();
    connectTest();
    m_chart->setStore(&test.store());
    m_chart->setWidth(defaultWidth);
    retranslate();
    showVerdict();
    enableReports();
}

void SweepResults::connectTest()
{
    connect(&m_test, &session::SweepTest::started, this, &SweepResults::startRun);
    connect(&m_test, &session::SweepTest::finished, this, &SweepResults::finishRun);
    connect(&m_test, &session::SweepTest::failed, this, &SweepResults::showVerdict);
    connect(&m_test, &session::SweepTest::progressChanged, this, &SweepResults::showVerdict);
    connect(&m_test, &session::SweepTest::samplesAdded, this, [this] {
        if (isVisible())
            m_chart->advance(m_clock.now());
    });
    connect(&m_test, &session::SweepTest::legsAdded, this, [this] {
        appendLegs();
        if (!m_figures.isActive()) {
            const auto slower = std::chrono::milliseconds(m_legsTaken / legsPerMillisecond);
            m_figures.start(std::max<std::chrono::milliseconds>(metricsInterval, slower));
        }
    });
    m_figures.setSingleShot(true);
    connect(&m_figures, &QTimer::timeout, this, &SweepResults::showMetrics);
    connect(m_verdict, &VerdictBanner::chipClicked, this, &SweepResults::chooseServo);
    connect(m_emptyPreviousTests, &QPushButton::clicked, this,
            &SweepResults::previousTestsRequested);
    connect(m_all, &QToolButton::toggled, &m_verdictModel, &SweepVerdictModel::setShowAll);
    connect(&m_legsModel, &SweepLegsModel::emptyColumnsChanged, this,
            &SweepResults::hideEmptyColumns);
    connect(&m_legsModel, &SweepLegsModel::noticeChanged, this, [this] {
        m_legsNotice->setText(m_legsModel.notice());
        m_legsNotice->setVisible(!m_legsModel.notice().isEmpty());
    });
    connect(&m_test, &session::SweepTest::saved, this, [this](const QString& path) {
        m_savedPath = path;
        m_saveError.reset();
        retranslate();
    });
    connect(&m_test, &session::SweepTest::saveFailed, this, [this](const base::Error& error) {
        m_saveError = error;
        retranslate();
    });
}

const results::SweepServo* SweepResults::servo() const
{
    const results::SweepRun* run = m_test.run();
    return run != nullptr && m_servo < run->servos.size() ? &run->servos[m_servo] : nullptr;
}

void SweepResults::startRun()
{
    m_savedPath.clear();
    m_saveError.reset();
    setComparison({});
    m_chart->setOrigin(m_test.startedAt());
    m_chart->setWidth(defaultWidth);
    m_chart->setFollowing(true);
    m_isChosen = false;
    showServo(0);
    enableReports();
}

void SweepResults::finishRun()
{
    m_figures.stop();
    if (!m_isChosen)
        showWorstServo();
    appendLegs();
    showMetrics();
    m_chart->zoomToFit();
    enableReports();
    retranslate();
}

void SweepResults::chooseServo(int index)
{
    m_isChosen = true;
    showServo(index);
}

void SweepResults::showWorstServo()
{
    const auto& servos = m_test.run()->servos;
    const Grade worst = m_test.run()->verdict();
    const auto found = std::find_if(servos.begin(), servos.end(),
                                    [worst](const auto& one) { return one.verdict == worst; });
    const auto place = found != servos.end() ? found - servos.begin() : 0;
    if (static_cast<std::size_t>(place) != m_servo)
        showServo(static_cast<int>(place));
}

void SweepResults::showServo(int index)
{
    m_servo = std::size_t(std::max(0, index));
    m_legsModel.clear();
    m_histogram->clear();
    m_legsTaken = 0;
    if (const results::SweepServo* tested = servo()) {
        const auto& lines = tested->limits.lines;
        const auto limit = std::find_if(lines.begin(), lines.end(), [](const auto& line) {
            return line.metric == QLatin1StringView("steady_error");
        });
        const bool limited = limit != lines.end();
        m_histogram->setLimits(limited ? limit->warn : std::nullopt,
                               limited ? limit->fail : std::nullopt);
    }
    showCurves();
    appendLegs();
    showMetrics();
    Q_EMIT servoShown();
}

void SweepResults::showCurves()
{
    const results::SweepServo* tested = servo();
    if (tested == nullptr)
        return;
    const QColor ground = palette().color(QPalette::Base);
    const jobs::SweepCurves curves = m_test.curves(m_servo);
    const report::SweepTexts& words = report::sweepTexts();
    const QString unit = text::localized(report::unitText(QStringLiteral("step")));
    TrendChannel goal{curves.goal, QStringLiteral("goal"), text::localized(words.goal), unit,
                      trendColor(goalColor, ground)};
    goal.steps = goal.dashed = true;
    m_chart->setChannels(
        {goal,
         {curves.position, QStringLiteral("position"), text::localized(words.position), unit,
          trendColor(positionColor, ground)}});
}

void SweepResults::appendLegs()
{
    const results::SweepServo* tested = servo();
    if (tested == nullptr || m_legsTaken >= tested->legs.size())
        return;
    const std::span fresh(tested->legs.data() + m_legsTaken, tested->legs.size() - m_legsTaken);
    QScrollBar* bar = m_legsView->verticalScrollBar();
    const bool atEnd = bar->value() >= bar->maximum();
    m_legsModel.append(fresh);
    std::vector<double> errors;
    for (const results::SweepLeg& leg : fresh) {
        if (leg.steadyError)
            errors.push_back(*leg.steadyError);
    }
    m_histogram->addErrors(errors);
    m_legsTaken = tested->legs.size();
    if (atEnd)
        m_legsView->scrollToBottom();
}

void SweepResults::showMetrics()
{
    if (const results::SweepServo* tested = servo()) {
        const auto metrics = m_test.metrics(m_servo);
        m_verdictModel.show(metrics, results::evaluate(*tested, metrics, m_test.run()->spec.shape));
    }
    showVerdict();
}

void SweepResults::hideEmptyColumns()
{
    for (int column = 0; column < m_legsModel.columnCount(); ++column)
        m_legsView->setColumnHidden(column,
                                    m_legsModel.isColumnEmpty(static_cast<LegColumn>(column)));
    m_legsView->resizeColumnsToContents();
}

void SweepResults::showVerdict()
{
    const results::SweepServo* tested = servo();
    const bool nothing = tested == nullptr && !m_test.isRunning();
    m_empty->setVisible(nothing);
    m_chart->setVisible(!nothing);
    m_verdict->setVisible(tested != nullptr);
    m_findings->setVisible(!nothing);
    if (tested == nullptr)
        return;
    m_title->setText(tr("Position and goal — %1").arg(servoName(*tested)));
    const results::SweepRun& run = *m_test.run();
    if (m_test.isRunning() && !m_test.progress().silent.empty())
        m_verdict->setVerdict(Tone::Warn, tr("RUNNING"), tr("no reply"));
    else if (m_test.isRunning())
        m_verdict->setVerdict(Tone::Accent, tr("RUNNING"));
    else
        m_verdict->setVerdict(gradeTone(run.verdict()), gradeText(run.verdict()).toUpper(),
                              verdictReason());
    showChips();
}

/// One for each of several servos; with its grade, once there is one.
void SweepResults::showChips()
{
    const results::SweepRun& run = *m_test.run();
    std::vector<VerdictChip> chips;
    for (const results::SweepServo& tested : run.servos) {
        const QString id = QStringLiteral("ID %1").arg(tested.parameters.servo.id);
        const QString name = servoName(tested);
        if (m_test.isRunning())
            chips.push_back({id, Tone::Accent, name});
        else
            chips.push_back({report::gradeSign(tested.verdict) + QLatin1Char(' ') + id,
                             gradeTone(tested.verdict),
                             QStringLiteral("%1: %2\n%3")
                                 .arg(name, text::localized(report::gradeLabel(tested.verdict)),
                                      reasonText(run, tested))
                                 .trimmed()});
    }
    m_verdict->setChips(chips.size() > 1 ? chips : std::vector<VerdictChip>(),
                        static_cast<int>(m_servo));
}

void SweepResults::setComparison(const QString& text)
{
    m_comparison->setText(text);
    m_comparison->setVisible(!text.isEmpty());
}

void SweepResults::enableReports()
{
    const bool ready = m_test.run() != nullptr && !m_test.isRunning();
    for (QPushButton* button : m_reports)
        button->setEnabled(ready);
}

void SweepResults::askForSavePath(const QString& ending)
{
    const results::SweepRun* run = m_test.run();
    if (run == nullptr || run->servos.empty())
        return;
    QStringList ids;
    for (const results::SweepServo& tested : run->servos)
        ids.append(QString::number(tested.parameters.servo.id));
    const QString name = QStringLiteral("sweep_%1_ID%2.%3")
                             .arg(run->at.toLocalTime().toString(QStringLiteral("yyyy-MM-dd_HHmm")),
                                  ids.mid(0, 8).join(QLatin1Char('-')), ending);
    ui::askForSavePath(this,
                       {QStringLiteral("sweepReportDialog"),
                        tr("Save the report"),
                        {QStringLiteral("%1 (*.%2)").arg(ending.toUpper(), ending)},
                        name,
                        &m_settings,
                        reportFolderKey()},
                       [this](const QString& path) { m_test.save(path, text::isUiChinese()); });
}

void SweepResults::retranslate()
{
    const report::SweepTexts& words = report::sweepTexts();
    if (servo() == nullptr)
        m_title->setText(tr("Position and goal"));
    m_emptyLabel->setText(tr("No test has been run yet. Select a test on the left, check the start "
                             "and end positions, then click Run; the servo will move."));
    m_tabs->setTabText(0, text::localized(words.verdict));
    m_tabs->setTabText(1, text::localized(words.legs));
    if (m_tabs->count() > 2)
        m_tabs->setTabText(2, tr("Report"));
    m_verdictView->setAccessibleName(tr("Metrics and their grades"));
    m_legsView->setAccessibleName(tr("Moves"));
    m_verdictView->setToolTip(tr("Hover over a row for details"));
    m_legsView->setToolTip(m_verdictView->toolTip());
    m_all->setText(tr("All metrics"));
    m_all->setToolTip(tr("Also shows metrics that have no limit"));
    m_histogramTitle->setText(tr("Error at the goal"));
    m_reportTitle->setText(tr("Report"));
    for (QPushButton* button : m_reports) {
        button->setToolTip(
            button->text() == QLatin1StringView("CSV")
                ? tr("Saves all moves as a table and all readings in a second file in the same "
                     "folder")
                : tr("Saves the report as %1 and all readings in a second file in the same folder")
                      .arg(button->text()));
        button->setAccessibleName(button->toolTip());
    }
    for (QPushButton* button : {m_previousTests, m_emptyPreviousTests}) {
        button->setText(tr("Earlier tests…"));
        button->setAccessibleName(button->text());
        button->setToolTip(tr("Lists saved tests; you can compare two or select a reference"));
    }
    m_all->setAccessibleName(m_all->text());
    if (m_saveError) {
        const text::Description trouble = text::describe(*m_saveError);
        m_saved->setText(text::joinSentences({trouble.message, trouble.remedy}).toHtmlEscaped());
    } else {
        const QString link = QStringLiteral("<a href=\"%1\">%2</a>")
                                 .arg(QUrl::fromLocalFile(m_savedPath).toString(QUrl::FullyEncoded),
                                      QFileInfo(m_savedPath).fileName().toHtmlEscaped());
        m_saved->setText(tr("Saved: %1").arg(link));
    }
    m_saved->setVisible(m_saveError || !m_savedPath.isEmpty());
    m_verdictModel.retranslate();
    m_legsModel.retranslate();
    showVerdict();
    hideEmptyColumns();
}

/// What decided the verdict or why there is none, and how the test ended if it was not by itself.
QString SweepResults::verdictReason() const
{
    const results::SweepRun& run = *m_test.run();
    const QString end = text::localized(report::endText(run.end));
    QStringList sentences;
    if (const QString reason = reasonText(run); !reason.isEmpty())
        sentences << reason;
    if (run.end != results::SweepEnd::Finished)
        sentences << (run.endedBy >= 0 ? tr("%1 (ID %2)").arg(end).arg(run.endedBy) : end);
    if (!run.gaps.empty())
        sentences << tr("The test was paused by %n bus interruption(s).", nullptr,
                        static_cast<int>(run.gaps.size()));
    return sentences.join(QStringLiteral(" · "));
}

/// Beside the table; where the table would lose its last column, behind a tab.
void SweepResults::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    const bool narrow = width() < minWidthForReport;
    if (narrow == m_reportCard->isHidden())
        return;
    m_reportCard->setVisible(!narrow);
    if (narrow) {
        m_tabs->addTab(m_report, QString());
    } else { // takes it out of the tabs, which hide what is not in front
        m_reportCard->layout()->addWidget(m_report);
        m_report->show();
    }
    retranslate();
}

void SweepResults::showEvent(QShowEvent* event)
{
    QWidget::showEvent(event);
    m_chart->advance(m_clock.now());
}

void SweepResults::changeEvent(QEvent* event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange) {
        retranslate();
        showCurves();
    } else if (event->type() == QEvent::PaletteChange) {
        showCurves();
    }
}
} // namespace ui
