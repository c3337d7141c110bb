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
#include "ui/widgets/pill.h"

#include <QComboBox>
#include <QDir>
#include <QEvent>
#include <QFileInfo>
#include <QLabel>
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
constexpr auto metricsInterval = 500ms;
/// Figures are worked out from all legs: of a long test less often.
constexpr std::size_t legsPerMillisecond = 20;
constexpr auto defaultWidth = std::chrono::seconds(10);

Tone toneOf(Grade grade)
{
    switch (grade) {
    case Grade::Pass:
        return Tone::Good;
    case Grade::Warn:
        return Tone::Warn;
    case Grade::Fail:
        return Tone::Bad;
    default:
        return Tone::Quiet;
    }
}

QString servoName(const results::SweepServo& servo)
{
    return QStringLiteral("ID %1 · %2")
        .arg(servo.parameters.servo.id)
        .arg(servo.parameters.servo.model);
}

QString gradeSentence(Grade grade)
{
    return report::gradeSign(grade) + QLatin1Char(' ') + text::localized(report::gradeLabel(grade));
}

QString withReasons(const QString& grade, const QStringList& reasons)
{
    return reasons.isEmpty() ? grade
                             : grade + QStringLiteral(": ") + reasons.join(QStringLiteral(", "));
}

/// "✘ Failed: hysteresis, overshoot"
QString verdictWords(const results::SweepServo& servo)
{
    QStringList reasons;
    for (const results::VerdictLine& line : servo.lines) {
        if (line.grade == servo.verdict && (line.grade == Grade::Fail || line.grade == Grade::Warn))
            reasons.append(text::localized(report::metricLabel(line.limit.metric)));
    }
    return withReasons(gradeSentence(servo.verdict), reasons);
}

/// The worst one counts, and is named: "✘ Failed: ID 2, ID 5".
QString verdictWords(const results::SweepRun& run)
{
    if (run.servos.size() == 1)
        return verdictWords(run.servos.front());
    QStringList worst;
    for (const results::SweepServo& servo : run.servos) {
        if (servo.verdict == run.verdict() && servo.verdict != Grade::Pass)
            worst.append(QStringLiteral("ID %1").arg(servo.parameters.servo.id));
    }
    return withReasons(gradeSentence(run.verdict()), worst);
}
} // namespace

SweepResults::SweepResults(session::Workbench& workbench, session::SweepTest& test,
                           session::Settings& settings, QWidget* parent)
    : QWidget(parent)
    , m_workbench(workbench)
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

QWidget* SweepResults::chart() const
{
    return m_chart;
}

void SweepResults::connectTest()
{
    connect(&m_test, &session::SweepTest::started, this, &SweepResults::startRun);
    connect(&m_test, &session::SweepTest::finished, this, &SweepResults::finishRun);
    connect(&m_test, &session::SweepTest::failed, this, &SweepResults::showVerdict);
    connect(&m_test, &session::SweepTest::progressChanged, this, &SweepResults::showVerdict);
    connect(&m_test, &session::SweepTest::samplesAdded, this, [this] {
        if (isVisible())
            m_chart->advance(m_workbench.now());
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
    connect(m_servos, &QComboBox::activated, this, &SweepResults::showServo);
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
    m_servos->clear();
    for (const results::SweepServo& tested : m_test.run()->servos)
        m_servos->addItem(servoName(tested));
    updateServoNames();
    m_servos->setVisible(m_servos->count() > 1);
    m_chart->setOrigin(m_test.startedAt());
    m_chart->setWidth(defaultWidth);
    m_chart->setFollowing(true);
    showServo(0);
    enableReports();
}

/// With its verdict, once there is one.
void SweepResults::updateServoNames()
{
    const results::SweepRun* run = m_test.run();
    for (int i = 0; run != nullptr && i < m_servos->count(); ++i) {
        const results::SweepServo& tested = run->servos[std::size_t(i)];
        m_servos->setItemText(i, m_test.isRunning() ? servoName(tested)
                                                    : servoName(tested) + QStringLiteral(" · ") +
                                                          gradeSentence(tested.verdict));
    }
}

void SweepResults::finishRun()
{
    m_figures.stop();
    appendLegs();
    showMetrics();
    m_chart->zoomToFit();
    enableReports();
    retranslate();
}

void SweepResults::showServo(int index)
{
    m_servo = std::size_t(std::max(0, index));
    m_servos->setCurrentIndex(int(m_servo));
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
    showEnd();
    Q_EMIT servoShown();
}

void SweepResults::showCurves()
{
    const results::SweepServo* tested = servo();
    if (tested == nullptr)
        return;
    const QColor ground = palette().color(QPalette::Base);
    const session::SweepTest::Curves curves = m_test.curves(m_servo);
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

QString SweepResults::verdictText() const
{
    return m_verdict->text();
}

void SweepResults::showVerdict()
{
    const results::SweepServo* tested = servo();
    const bool none = tested == nullptr;
    m_emptyLabel->setVisible(none && !m_test.isRunning());
    m_chart->setVisible(!m_emptyLabel->isVisibleTo(this));
    m_verdict->setVisible(!none);
    if (none)
        return;
    m_title->setText(m_servos->count() > 1 ? tr("Position and goal")
                                           : tr("Position and goal — %1").arg(servoName(*tested)));
    if (m_test.isRunning() && !m_test.progress().silent.empty())
        m_verdict->setState(Tone::Warn, tr("no reply"));
    else if (m_test.isRunning())
        m_verdict->setState(Tone::Accent, tr("running"));
    else
        m_verdict->setState(toneOf(m_test.run()->verdict()), verdictWords(*m_test.run()),
                            text::localized(report::gradeLabel(m_test.run()->verdict())));
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
    m_emptyLabel->setText(
        tr("No test has been run yet. Select a test on the left, check start and end, then "
           "click Run: the servo will move."));
    m_servos->setToolTip(tr("Servo to show"));
    m_servos->setAccessibleName(tr("Servo shown"));
    m_tabs->setTabText(0, text::localized(words.verdict));
    m_tabs->setTabText(1, text::localized(words.legs));
    m_verdictView->setAccessibleName(tr("Metrics and their grades"));
    m_legsView->setAccessibleName(tr("Legs"));
    m_verdictView->setToolTip(tr("The tooltip of each row shows more"));
    m_legsView->setToolTip(m_verdictView->toolTip());
    m_all->setText(tr("All metrics"));
    m_all->setToolTip(tr("Shows metrics without a limit, too"));
    m_histogramTitle->setText(tr("Error at the goal"));
    m_reportTitle->setText(tr("Report"));
    for (QPushButton* button : m_reports) {
        button->setToolTip(
            button->text() == QLatin1StringView("CSV")
                ? tr("Saves all legs as a table and all readings in a file next to it")
                : tr("Saves the report as %1 and all readings in a file next to it")
                      .arg(button->text()));
        button->setAccessibleName(button->toolTip());
    }
    m_previousTests->setText(tr("Earlier tests…"));
    m_previousTests->setAccessibleName(m_previousTests->text());
    m_all->setAccessibleName(m_all->text());
    m_previousTests->setToolTip(tr("Shows saved tests, compares two, and selects a reference"));
    updateServoNames();
    showEnd();
    if (m_saveError) {
        const text::Description trouble = text::describe(*m_saveError);
        m_saved->setText((trouble.message + QLatin1Char(' ') + trouble.remedy).toHtmlEscaped());
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

/// How the run ended, and why the servo that is shown has no verdict.
void SweepResults::showEnd()
{
    const results::SweepRun* run = m_test.run();
    QStringList lines;
    if (run != nullptr && !m_test.isRunning()) {
        if (run->end != results::SweepEnd::Finished)
            lines.append(
                text::localized(report::endText(run->end)) +
                (run->endedBy >= 0 ? QStringLiteral(" (ID %1)").arg(run->endedBy) : QString()));
        const results::NoVerdictReason reason = servo() != nullptr
                                                    ? results::sweepVerdict(*run, *servo()).reason
                                                    : results::NoVerdictReason::None;
        if (reason != results::NoVerdictReason::None && reason != results::NoVerdictReason::Ended)
            lines.append(text::localized(report::noVerdictReasonText(reason)));
    }
    if (run != nullptr && !run->gaps.empty())
        lines.append(tr("The test waited for %n bus interruption(s) to end.", nullptr,
                        int(run->gaps.size())));
    m_end->setText(lines.join(QLatin1Char(' ')));
    m_end->setVisible(!lines.isEmpty());
}

void SweepResults::showEvent(QShowEvent* event)
{
    QWidget::showEvent(event);
    m_chart->advance(m_workbench.now());
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
