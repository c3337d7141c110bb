// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/bus_busy_hint.h"
#include "cli/commands.h"
#include "cli/input/arguments.h"
#include "cli/input/sweep_input.h"
#include "cli/output/progress.h"
#include "cli/output/table.h"
#include "cli/run.h"
#include "cli/sweep_history.h"
#include "cli/translate.h"
#include "device/write_access.h"
#include "jobs/sweep/sweep.h"
#include "jobs/sweep/sweep_proposal.h"
#include "report/html_page.h"
#include "report/sweep_text.h"
#include "results/sweep_json.h"
#include "session/snapshot/safety_snapshot.h"
#include "session/sweep/sweep_report.h"
#include "text/language.h"
#include "text/progress_text.h"

#include <QFileInfo>

#include <cmath>
#include <map>

namespace cli {
namespace {
QString number(std::optional<double> value)
{
    return value ? report::figure(*value) : noValue();
}

/// "≤ 8"
QString bound(const results::SweepLimit& limit, std::optional<double> value)
{
    if (!value)
        return noValue();
    return (limit.atLeast ? QStringLiteral("≥ ") : QStringLiteral("≤ ")) +
           report::exactNumber(*value);
}

QString verdictText(const results::SweepRun& run, const results::SweepServo& servo)
{
    const snapshot::SnapshotServo& identity = servo.parameters.servo;
    QString text =
        QStringLiteral("%1 %2 · %3: %4\n")
            .arg(report::gradeSign(servo.verdict), identity.model, QString::number(identity.id),
                 text::localized(report::gradeLabel(servo.verdict)));
    Table table({translate("cli", "Metric"), translate("cli", "Value"), translate("cli", "Unit"),
                 translate("cli", "Warn"), translate("cli", "Fail"), translate("cli", "Grade")});
    table.alignRight({1, 3, 4});
    for (const results::SweepMetric& metric : servo.metrics) {
        const auto line = std::find_if(
            servo.lines.begin(), servo.lines.end(),
            [&](const results::VerdictLine& one) { return one.limit.metric == metric.key; });
        const bool judged = line != servo.lines.end();
        if (!metric.value && !judged)
            continue;
        const QString value =
            judged && metric.value
                ? report::figure(*metric.value, {line->limit.warn, line->limit.fail})
                : number(metric.value);
        table.add({text::localized(report::metricLabel(metric.key)), value,
                   text::localized(report::unitText(metric.unit)),
                   judged ? bound(line->limit, line->limit.warn) : QString(),
                   judged ? bound(line->limit, line->limit.fail) : QString(),
                   judged ? text::localized(report::lineGradeLabel(line->grade)) : QString()});
    }
    text += table.text();
    // The end of the run is printed once for all servos.
    const results::NoVerdictReason reason = results::sweepVerdict(run, servo).reason;
    if (reason != results::NoVerdictReason::None && reason != results::NoVerdictReason::Ended)
        text += text::localized(report::gradeLabel(results::Grade::NotMeasured)) +
                QStringLiteral(": ") + text::localized(report::noVerdictReasonText(reason)) +
                QLatin1Char('\n');
    return text;
}

/// Seconds since the first goal; empty: there was none.
QString gapsText(const results::SweepRun& run)
{
    const auto seconds = [](base::Duration at) {
        return QString::number(std::chrono::duration<double>(at).count(), 'f', 1);
    };
    QStringList gaps;
    for (const results::SweepGap& gap : run.gaps)
        gaps << QStringLiteral("%1–%2 s").arg(seconds(gap.at), seconds(gap.at + gap.span));
    if (gaps.isEmpty())
        return {};
    return translate("cli", "Gaps in the readings: %1. Times and speeds are not available for "
                            "moves that contain a gap.")
               .arg(text::joinItems(gaps)) +
           QLatin1Char('\n');
}

bool allReverted(const device::Notices& notices)
{
    return std::none_of(notices.begin(), notices.end(), [](const device::Notice& notice) {
        return notice.code == device::NoticeCode::SettingNotRestored;
    });
}

/// The test, from the options to the files.
class SweepCommand {
public:
    SweepCommand(Run& run, const Values& values)
        : m_run(run)
        , m_values(values)
        , m_line(std::make_unique<ProgressLine>(run.console(), translate("cli", "Sweep test")))
    {}

    base::Result<Exit> run();

private:
    base::Result<void> collect();
    void warnAboutSpeed(const device::Context& context);
    jobs::SweepCallbacks watch();
    base::Result<void> save(const results::SweepRun& run);
    QStringList files() const;
    void show(const results::SweepRun& run, const QString& kept);

    Run& m_run;
    const Values& m_values;
    std::unique_ptr<ProgressLine> m_line;
    std::vector<device::Servo> m_servos;
    jobs::SweepRequest m_order;
    std::optional<session::SweepFormat> m_format{}; ///< none: no report
    QString m_path;
    std::unique_ptr<jobs::SweepRecording> m_readings;
    std::vector<jobs::UnreleasedTorque> m_left;
};

base::Result<void> SweepCommand::collect()
{
    const auto ids = parseIds(m_values.arguments("ID"));
    if (!ids)
        return tl::unexpected(ids.error());
    auto spec = sweepSpec(m_values);
    if (!spec)
        return tl::unexpected(spec.error());
    m_order.spec = std::move(*spec);
    const auto limits = sweepLimits(m_values);
    if (!limits)
        return tl::unexpected(limits.error());
    m_path = m_values.option("--report").value_or(QString());
    m_format = session::sweepFormatOf(m_path);
    if (!m_path.isEmpty() && !m_format)
        return badArgument(
            translate("cli", "the report file name must end with .html, .pdf, .json or .csv"));
    for (const int id : *ids) {
        auto servo = m_run.servoWithSettings(id);
        if (!servo)
            return tl::unexpected(servo.error());
        m_order.limits.push_back(*limits ? **limits
                                         : results::builtInSweepLimits(servo->profile->modelName,
                                                                       servo->profile->series));
        const auto writable = device::requireWritable(*servo, QStringLiteral("sweep"));
        if (!writable)
            return writable;
        m_servos.push_back(std::move(*servo));
    }
    m_order.switchMode = m_values.has("--switch-mode");
    m_order.program = session::programName();
    const auto connection = m_run.connect();
    m_order.simulated = connection && (*connection)->isSimulated();
    return {};
}

/// Warns before the test of mistakes that would fail a good servo. The job reports what prevents
/// the test.
void SweepCommand::warnAboutSpeed(const device::Context& context)
{
    for (std::size_t i = 0; i < m_servos.size(); ++i) {
        const auto estimate =
            jobs::estimateSweep(context, m_servos[i], m_order.spec, m_order.limits[i]);
        if (!estimate)
            continue;
        if (estimate->minMove > 0)
            m_run.console().printMessage(
                translate("cli",
                          "Servo %1: most moves are too short for a verdict. A goal counts as "
                          "reached within %2 steps, so each move must be at least %3 steps long.")
                    .arg(QString::number(m_servos[i].id), number(estimate->axis.tolerance),
                         QString::number(std::ceil(estimate->minMove))));
        if (!estimate->tooShort)
            continue;
        const QString enough =
            QString::number(estimate->proposedDelay / std::chrono::milliseconds(1));
        const bool sine = m_order.spec.shape == results::SweepShape::Sine;
        m_run.console().printMessage(
            (sine ? translate("cli", "Servo %1: the sine wave is too fast for the servo. Use a "
                                     "period of at least %2 ms.")
                  : translate("cli",
                              "Servo %1: the delay is too short for the longest move, so the servo "
                              "reverses before it arrives. A delay of %2 ms is enough."))
                .arg(m_servos[i].id)
                .arg(enough));
    }
}

jobs::SweepCallbacks SweepCommand::watch()
{
    jobs::SweepCallbacks watch;
    watch.onBegin = [this](const results::SweepRun& run) {
        auto made = jobs::SweepRecording::start(run, m_format ? session::sweepReadingsPath(m_path)
                                                              : QString());
        if (made)
            m_readings = std::move(*made);
        return made ? std::nullopt : std::optional(made.error());
    };
    watch.onSample = [this](std::size_t servo, const jobs::SweepSample& sample, double goal,
                            int leg) { m_readings->add(servo, sample, goal, leg); };
    watch.onGoal = [this](std::size_t servo, int leg, base::Duration at) {
        m_readings->goal(servo, leg, at);
    };
    watch.onUnreleasedTorque = [this](const jobs::UnreleasedTorque& left) {
        m_left.push_back(left);
    };
    watch.onProgress = [this](const jobs::SweepProgress& progress) {
        m_line->show(progress.warmingUp
                         ? translate("cli", "moving to the start position or warming up")
                         : translate("cli", "cycle %1, %2")
                               .arg(progress.cycle)
                               .arg(text::progressText(progress.fraction, progress.remaining)));
    };
    return watch;
}

base::Result<void> SweepCommand::save(const results::SweepRun& run)
{
    m_readings->finish();
    if (const auto trouble = m_readings->failure())
        return tl::unexpected(*trouble);
    if (!m_format)
        return {};
    return session::saveSweepReport(run, *m_readings, *m_format, text::isUiChinese(), m_path);
}

/// With an absolute path, as saved in the history.
QStringList SweepCommand::files() const
{
    if (!m_format)
        return {};
    return {QFileInfo(m_path).absoluteFilePath(),
            QFileInfo(session::sweepReadingsPath(m_path)).absoluteFilePath()};
}

void SweepCommand::show(const results::SweepRun& run, const QString& kept)
{
    if (m_run.console().isJson()) {
        m_run.console().write(results::encodeSweepRun(run));
        // The document is the report itself.
        if (const QString notices = m_run.takeNotices(); !notices.isEmpty())
            m_run.console().printMessage(notices.trimmed());
        return;
    }
    QString text;
    for (const results::SweepServo& servo : run.servos)
        text += verdictText(run, servo) + QLatin1Char('\n');
    text += gapsText(run);
    if (run.end != results::SweepEnd::Finished) {
        text += text::localized(report::endText(run.end)) +
                (run.endedBy >= 0 ? QStringLiteral(" (ID %1)").arg(run.endedBy) : QString()) +
                QLatin1Char('\n');
    }
    text +=
        translate("cli", "Verdict: %1").arg(text::localized(report::gradeLabel(run.verdict()))) +
        QLatin1Char('\n');
    if (m_format)
        text += translate("cli", "Report: %1, readings: %2")
                    .arg(m_path, session::sweepReadingsPath(m_path)) +
                QLatin1Char('\n');
    if (!kept.isEmpty())
        text += kept + QLatin1Char('\n');
    m_run.console().print(text + m_run.takeNotices());
}

base::Result<Exit> SweepCommand::run()
{
    if (const auto ready = collect(); !ready)
        return tl::unexpected(ready.error());
    const auto context = m_run.context();
    if (!context)
        return tl::unexpected(context.error());
    if (m_order.switchMode) {
        for (device::Servo& servo : m_servos) {
            if (const auto saved = m_run.backupTableAndReport(servo); !saved)
                return tl::unexpected(saved.error());
        }
    }
    warnAboutSpeed(*context);
    const auto done = jobs::sweep(*context, m_servos, m_order, watch());
    m_line.reset();
    if (!done)
        return tl::unexpected(done.error());
    explainBusyLine(m_run.console(), *context, m_servos.front(), done->end);
    const auto saved = save(*done);
    const bool back = allReverted(context->notices);
    show(*done, saveSweep(m_run.console(), *done, saved ? files() : QStringList()));
    for (const jobs::UnreleasedTorque& left : m_left)
        m_run.console().printMessage(unreleasedTorqueText(left));
    if (!saved)
        return tl::unexpected(saved.error());
    if (done->end == results::SweepEnd::LinkLost)
        return Exit::Port;
    if (!back || !m_left.empty())
        return Exit::Failed;
    switch (done->verdict()) {
    case results::Grade::Pass:
    case results::Grade::Warn:
        return Exit::Success;
    default:
        return Exit::Failed;
    }
}

base::Result<Exit> runSweep(Run& run, const Values& values)
{
    return SweepCommand(run, values).run();
}
} // namespace

Command sweepCommand()
{
    return {"sweep",
            QT_TRANSLATE_NOOP("cli", "run a sweep test and evaluate the result"),
            {{"ID", QT_TRANSLATE_NOOP("cli", "servo IDs: 1 2 3, 1-6 or 1,3"), 1, many}},
            sweepOptions(),
            runSweep};
}
} // namespace cli
