// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/bus_busy_hint.h"
#include "cli/commands.h"
#include "cli/input/arguments.h"
#include "cli/input/register_input.h"
#include "cli/input/sweep_input.h"
#include "cli/output/progress.h"
#include "cli/output/step_output.h"
#include "cli/run.h"
#include "cli/sweep_history.h"
#include "cli/translate.h"
#include "jobs/step/step_advice.h"
#include "jobs/step/step_response.h"
#include "report/step_report.h"
#include "results/step_json.h"
#include "session/snapshot/safety_snapshot.h"
#include "text/language.h"

#include <QFileInfo>

namespace cli {
namespace {
constexpr int maxRepeats = 50;
constexpr int maxHold = 10'000; ///< ms
constexpr int minHold = 50;

/// One run with the servo's own gains, and with --try one with the trial after it.
class StepCommand {
public:
    StepCommand(Run& run, const Values& values)
        : m_run(run)
        , m_values(values)
    {}

    base::Result<Exit> run();

private:
    base::Result<void> collect();
    base::Result<void> takeNumbers();
    base::Result<void> takeTrial();
    base::Result<void> perform(const std::vector<results::StepGain>& trial);
    base::Result<void> save() const;
    QString keep();
    void show(const QString& kept);

    Run& m_run;
    const Values& m_values;
    std::optional<device::Servo> m_servo;
    jobs::StepRequest m_order;
    std::vector<results::StepGain> m_trial;
    QString m_report; ///< its file; empty: none
    std::vector<results::StepRun> m_runs;
    std::vector<results::StepAdvice> m_advice;
    bool m_unreleasedTorque = false;
};

base::Result<void> StepCommand::takeNumbers()
{
    const auto size = m_values.option("--size");
    if (!size)
        return badArgument(translate("cli", "--size is required"));
    m_order.spec.size = *size;
    m_order.spec.from = m_values.option("--from").value_or(QString());
    const auto speed = nonNegativeOption(m_values, "--speed");
    if (!speed)
        return tl::unexpected(speed.error());
    const auto acceleration = nonNegativeOption(m_values, "--acceleration");
    if (!acceleration)
        return tl::unexpected(acceleration.error());
    m_order.spec.speed = *speed;
    m_order.spec.acceleration = *acceleration;
    const auto repeats = intOption(m_values, "--repeats", 1, maxRepeats);
    if (!repeats)
        return tl::unexpected(repeats.error());
    m_order.spec.repeats = repeats->value_or(m_order.spec.repeats);
    const auto hold = intOption(m_values, "--hold", minHold, maxHold);
    if (!hold)
        return tl::unexpected(hold.error());
    m_order.spec.hold = std::chrono::milliseconds(hold->value_or(0));
    return {};
}

base::Result<void> StepCommand::takeTrial()
{
    const auto words = m_values.option("--try");
    if (!words)
        return {};
    const auto items =
        parseWriteItems(*m_servo, words->split(QLatin1Char(','), Qt::SkipEmptyParts));
    if (!items)
        return tl::unexpected(items.error());
    const auto known = jobs::loopRegisters(*m_servo->profile);
    for (const device::WriteItem& item : *items) {
        const bool good =
            std::any_of(known.begin(), known.end(),
                        [&](const catalog::Register* reg) { return reg->key == item.key; });
        if (!good) {
            QStringList keys;
            for (const catalog::Register* reg : known)
                keys << reg->key;
            return badArgument(translate("cli", "%1 cannot be used in a trial; available on "
                                                "this servo: %2")
                                   .arg(item.key, text::joinItems(keys)));
        }
        m_trial.push_back({item.key, item.raw});
    }
    return {};
}

base::Result<void> StepCommand::collect()
{
    if (const auto numbers = takeNumbers(); !numbers)
        return numbers;
    if (const auto path = m_values.option("--report")) {
        if (const auto known = checkStepReportName(*path); !known)
            return known;
        m_report = *path;
    }
    auto servo = m_run.servoWithSettings(m_values);
    if (!servo)
        return tl::unexpected(servo.error());
    m_servo = std::move(*servo);
    if (const auto trial = takeTrial(); !trial)
        return trial;
    m_order.switchMode = m_values.has("--switch-mode");
    m_order.program = session::programName();
    const auto connection = m_run.connect();
    m_order.simulated = connection && (*connection)->isSimulated();
    return {};
}

base::Result<void> StepCommand::perform(const std::vector<results::StepGain>& trial)
{
    const auto context = m_run.context();
    if (!context)
        return tl::unexpected(context.error());
    if (!trial.empty() || m_order.switchMode) {
        if (const auto saved = m_run.backupTableAndReport(*m_servo); !saved)
            return saved;
    }
    ProgressLine line(m_run.console(), trial.empty() ? translate("cli", "Step response")
                                                     : translate("cli", "Step response (trial)"));
    jobs::StepCallbacks watch;
    watch.onProgress = [&line](const jobs::SweepProgress& progress) {
        line.update({progress.fraction});
    };
    watch.onUnreleasedTorque = [this](const jobs::UnreleasedTorque& left) {
        m_unreleasedTorque = true;
        m_run.console().printMessage(unreleasedTorqueText(left));
    };
    jobs::StepRequest order = m_order;
    order.spec.trial = trial;
    auto done = jobs::stepResponse(*context, *m_servo, order, watch);
    if (!done)
        return tl::unexpected(done.error());
    explainBusyLine(m_run.console(), *context, *m_servo, done->end);
    m_advice = jobs::adviseStep(*done, *m_servo->profile);
    m_runs.push_back(std::move(*done));
    return {};
}

base::Result<void> StepCommand::save() const
{
    return m_report.isEmpty()
               ? base::Result<void>()
               : report::saveStepReport(m_runs, m_advice, text::isUiChinese(), m_report);
}

/// Saves every run, also the one with the present values.
QString StepCommand::keep()
{
    QStringList files;
    if (!m_report.isEmpty())
        files.append(QFileInfo(m_report).absoluteFilePath());
    QStringList kept;
    for (const results::StepRun& run : m_runs) {
        const QString line = saveStep(m_run.console(), run, files);
        if (!line.isEmpty())
            kept.append(line);
    }
    return kept.join(QLatin1Char('\n'));
}

void StepCommand::show(const QString& kept)
{
    if (m_run.console().isJson()) {
        m_run.console().write(results::encodeStepRuns(m_runs, m_advice));
        if (const QString notices = m_run.takeNotices(); !notices.isEmpty())
            m_run.console().printMessage(notices.trimmed());
        return;
    }
    QString text = stepRunsText(m_runs, m_advice);
    const bool tried = m_runs.size() > 1;
    if (!m_trial.empty() && !tried)
        text += translate("cli", "The trial was not run.") + QLatin1Char('\n');
    if (tried && m_runs.back().isReverted) // else a notice names the register
        text += translate("cli",
                          "The trial has ended. The servo has its old values again unless a note "
                          "says otherwise. To save values that worked well, use \"write\".") +
                QLatin1Char('\n');
    if (!m_report.isEmpty())
        text += translate("cli", "Report: %1").arg(m_report) + QLatin1Char('\n');
    if (!kept.isEmpty())
        text += kept + QLatin1Char('\n');
    m_run.console().print(text + m_run.takeNotices());
}

base::Result<Exit> StepCommand::run()
{
    if (const auto ready = collect(); !ready)
        return tl::unexpected(ready.error());
    if (const auto before = perform({}); !before)
        return tl::unexpected(before.error());
    base::Result<void> after;
    if (!m_trial.empty() && m_runs.front().end == results::SweepEnd::Finished)
        after = perform(m_trial);
    const auto saved = save();
    show(keep());
    if (!after)
        return tl::unexpected(after.error());
    if (!saved)
        return tl::unexpected(saved.error());
    const results::StepRun& last = m_runs.back();
    if (last.end == results::SweepEnd::LinkLost)
        return Exit::Port;
    return last.end == results::SweepEnd::Finished && last.isReverted && !m_unreleasedTorque
               ? Exit::Success
               : Exit::Failed;
}

base::Result<Exit> runStepResponse(Run& run, const Values& values)
{
    return StepCommand(run, values).run();
}
} // namespace

Command stepResponseCommand()
{
    return {
        "step-response",
        QT_TRANSLATE_NOOP(
            "cli", "measure the step response of a servo, before and after changing its gains"),
        {servoIdArgument},
        {{"--size",
          QT_TRANSLATE_NOOP("cli", "step size: raw value, or value with its unit (30deg)"), "N"},
         {"--from",
          QT_TRANSLATE_NOOP("cli", "start position (default: present position, if "
                                   "there is enough room)"),
          "POS"},
         {"--repeats", QT_TRANSLATE_NOOP("cli", "number of back-and-forth movements (default: 3)"),
          "N"},
         {"--hold", QT_TRANSLATE_NOOP("cli", "time from one goal to the next (default: automatic)"),
          "MS"},
         {"--speed",
          QT_TRANSLATE_NOOP("cli",
                            "raw value, or value with its unit (default: as fast as possible)"),
          "V"},
         {"--acceleration",
          QT_TRANSLATE_NOOP("cli",
                            "raw value, or value with its unit (default: as fast as possible)"),
          "A"},
         {"--try",
          QT_TRANSLATE_NOOP("cli", "values for a second run: position_p=40,position_d=20; the old "
                                   "values are restored afterwards"),
          "KEY=VALUE,…"},
         {"--switch-mode",
          QT_TRANSLATE_NOOP(
              "cli", "switch servos in other modes to position mode for the test, then back")},
         {"--report", QT_TRANSLATE_NOOP("cli", "write a report of the test to a file"),
          "FILE.html|pdf|json|csv"}},
        runStepResponse};
}
} // namespace cli
