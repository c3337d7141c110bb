// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/bus_busy_hint.h"
#include "cli/commands.h"
#include "cli/input/arguments.h"
#include "cli/input/register_input.h"
#include "cli/input/sweep_input.h"
#include "cli/output/progress.h"
#include "cli/output/table.h"
#include "cli/run.h"
#include "cli/sweep_history.h"
#include "cli/translate.h"
#include "jobs/step/step_advice.h"
#include "jobs/step/step_response.h"
#include "report/step_html.h"
#include "report/step_text.h"
#include "report/sweep_text.h"
#include "results/step_json.h"
#include "session/snapshot/safety_snapshot.h"
#include "text/language.h"

#include <QFileInfo>

namespace cli {
namespace {
constexpr int maxRepeats = 50;
constexpr int maxHold = 10'000; ///< ms
constexpr int minHold = 50;

QString in(const catalog::Text& words)
{
    return words.in(text::isUiChinese());
}

enum class FileKind : std::uint8_t { None, Json, Csv, Html };

base::Result<FileKind> kindOf(const std::optional<QString>& path)
{
    if (!path)
        return FileKind::None;
    const QString end = QFileInfo(*path).suffix().toLower();
    if (end == QLatin1String("json"))
        return FileKind::Json;
    if (end == QLatin1String("csv"))
        return FileKind::Csv;
    if (end == QLatin1String("html"))
        return FileKind::Html;
    return badArgument(translate("cli", "a report ends with .html, .json or .csv"));
}

QString gainsText(const record::StepRun& run)
{
    QStringList gains;
    for (const record::StepGain& gain : run.gains)
        gains << QStringLiteral("%1=%2").arg(gain.key).arg(gain.raw);
    return gains.join(QLatin1Char(' '));
}

QString runText(const record::StepRun& run)
{
    Table table({translate("cli", "Figure"), translate("cli", "Value"), translate("cli", "Unit")});
    table.alignRight({1});
    for (const record::StepFigure& figure : record::stepFigures) {
        const auto& value = run.mean.*figure.member;
        if (value)
            table.add({in(report::stepFigureText(QString::fromLatin1(figure.key))),
                       report::stepValue(value), report::stepUnit(figure, text::isUiChinese())});
    }
    return table.text();
}

QString comparisonText(const record::StepRun& before, const record::StepRun& after)
{
    Table table({translate("cli", "Figure"), translate("cli", "Before"), translate("cli", "After"),
                 translate("cli", "Difference"), translate("cli", "Unit"),
                 translate("cli", "Change")});
    table.alignRight({1, 2, 3});
    for (const record::StepDifference& row : record::compareSteps(before, after)) {
        table.add({in(report::stepFigureText(QString::fromLatin1(row.figure.key))),
                   report::stepValue(row.before), report::stepValue(row.after),
                   report::stepValue(row.difference),
                   report::stepUnit(row.figure, text::isUiChinese()),
                   in(report::stepChangeText(row.change))});
    }
    return table.text();
}

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
    base::Result<void> perform(const std::vector<record::StepGain>& trial);
    base::Result<void> save() const;
    QString keep();
    void show(const QString& kept);

    Run& m_run;
    const Values& m_values;
    std::optional<device::Servo> m_servo;
    jobs::StepRequest m_order;
    std::vector<record::StepGain> m_trial;
    FileKind m_kind = FileKind::None;
    std::vector<record::StepRun> m_runs;
    std::vector<record::StepAdvice> m_advice;
    bool m_unreleasedTorque = false;
};

base::Result<void> StepCommand::takeNumbers()
{
    const auto size = m_values.option("--size");
    if (!size)
        return badArgument(translate("cli", "--size is needed"));
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
            return badArgument(translate("cli", "%1 cannot be tried; this servo has %2")
                                   .arg(item.key, keys.join(QStringLiteral(", "))));
        }
        m_trial.push_back({item.key, item.raw});
    }
    return {};
}

base::Result<void> StepCommand::collect()
{
    if (const auto numbers = takeNumbers(); !numbers)
        return numbers;
    const auto kind = kindOf(m_values.option("--report"));
    if (!kind)
        return tl::unexpected(kind.error());
    m_kind = *kind;
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

base::Result<void> StepCommand::perform(const std::vector<record::StepGain>& trial)
{
    const auto context = m_run.context();
    if (!context)
        return tl::unexpected(context.error());
    if (!trial.empty() || m_order.switchMode) {
        if (const auto saved = m_run.backupTableAndReport(*m_servo); !saved)
            return saved;
    }
    ProgressLine line(m_run.console(), trial.empty() ? translate("cli", "Step response")
                                                     : translate("cli", "Step response, trial"));
    jobs::StepCallbacks watch;
    watch.onProgress = [&line](const jobs::SweepProgress& progress) {
        line.show(translate("cli", "%1 %").arg(int(progress.fraction * 100)));
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
    const QString path = m_values.option("--report").value_or(QString());
    switch (m_kind) {
    case FileKind::Json:
        return record::saveStepRuns(m_runs, m_advice, path);
    case FileKind::Csv:
        return record::saveStepSamples(m_runs, path);
    case FileKind::Html:
        return report::saveStepHtml(m_runs, m_advice, text::isUiChinese(), path);
    case FileKind::None:
        break;
    }
    return {};
}

/// Every run is kept, also the one with the values the servo had.
QString StepCommand::keep()
{
    QStringList files;
    if (m_kind != FileKind::None)
        files.append(QFileInfo(m_values.option("--report").value_or(QString())).absoluteFilePath());
    QStringList kept;
    for (const record::StepRun& run : m_runs) {
        const QString line = saveStep(m_run.console(), run, files);
        if (!line.isEmpty())
            kept.append(line);
    }
    return kept.join(QLatin1Char('\n'));
}

void StepCommand::show(const QString& kept)
{
    if (m_run.console().isJson()) {
        m_run.console().write(record::encodeStepRuns(m_runs, m_advice));
        if (const QString notices = m_run.takeNotices(); !notices.isEmpty())
            m_run.console().printMessage(notices.trimmed());
        return;
    }
    const record::StepRun& first = m_runs.front();
    QString text =
        QStringLiteral("%1 · %2, %3 → %4\n")
            .arg(first.parameters.servo.model, QString::number(first.parameters.servo.id),
                 report::stepValue(first.axis.from), report::stepValue(first.axis.to));
    for (const record::StepRun& run : m_runs) {
        if (!run.gains.empty())
            text += gainsText(run) + QLatin1Char('\n');
        if (run.end != record::SweepEnd::Finished)
            text += in(report::endText(run.end)) + QLatin1Char('\n');
    }
    text += m_runs.size() > 1 ? comparisonText(m_runs.front(), m_runs.back()) : runText(first);
    text += report::stepAdviceText(m_advice, text::isUiChinese());
    const bool tried = m_runs.size() > 1;
    if (!m_trial.empty() && !tried)
        text += translate("cli", "The trial was not run.") + QLatin1Char('\n');
    if (tried && m_runs.back().isReverted) // else a notice names what is left
        text += translate("cli", "The trial is over: the servo has its own values again, unless a "
                                 "note says otherwise. \"write\" keeps what proved good.") +
                QLatin1Char('\n');
    if (m_kind != FileKind::None)
        text +=
            translate("cli", "Report: %1").arg(m_values.option("--report").value_or(QString())) +
            QLatin1Char('\n');
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
    if (!m_trial.empty() && m_runs.front().end == record::SweepEnd::Finished)
        after = perform(m_trial);
    const auto saved = save();
    show(keep());
    if (!after)
        return tl::unexpected(after.error());
    if (!saved)
        return tl::unexpected(saved.error());
    const record::StepRun& last = m_runs.back();
    if (last.end == record::SweepEnd::LinkLost)
        return Exit::Port;
    return last.end == record::SweepEnd::Finished && last.isReverted && !m_unreleasedTorque
               ? Exit::Success
               : Exit::Failed;
}

base::Result<Exit> run(Run& run, const Values& values)
{
    return StepCommand(run, values).run();
}
} // namespace

Command stepResponseCommand()
{
    return {
        "step-response",
        QT_TRANSLATE_NOOP("cli", "measure how a servo answers a step, before and after a change of "
                                 "its gains"),
        {{"ID", QT_TRANSLATE_NOOP("cli", "the servo")}},
        {{"--size", QT_TRANSLATE_NOOP("cli", "how far: raw, or with its unit (30deg)"), "N"},
         {"--from", QT_TRANSLATE_NOOP("cli", "start (usual: where it stands, if there is room)"),
          "POS"},
         {"--repeats", QT_TRANSLATE_NOOP("cli", "there and back so many times (usual: 3)"), "N"},
         {"--hold", QT_TRANSLATE_NOOP("cli", "from one goal to the next (usual: as it needs)"),
          "MS"},
         {"--speed", QT_TRANSLATE_NOOP("cli", "raw or with its unit (usual: as fast as it can)"),
          "V"},
         {"--acceleration",
          QT_TRANSLATE_NOOP("cli", "raw or with its unit (usual: as fast as it can)"), "A"},
         {"--try",
          QT_TRANSLATE_NOOP("cli", "a second run with these values, which are put back "
                                   "afterwards: position_p=40,position_d=20"),
          "KEY=VALUE,…"},
         {"--switch-mode", QT_TRANSLATE_NOOP("cli", "a servo in another mode is in position mode "
                                                    "while the test lasts, and back afterwards")},
         {"--report", QT_TRANSLATE_NOOP("cli", "write the runs to a file"), "FILE.html|json|csv"}},
        run};
}
} // namespace cli
