// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/sweep_history.h"

#include "cli/input/arguments.h"
#include "cli/translate.h"
#include "results/step_json.h"
#include "results/sweep_json.h"
#include "session/paths.h"
#include "text/error_text.h"
#include "text/language.h"

#include <QFile>
#include <QRegularExpression>

namespace cli {
namespace {
/// "12:3", "run.json:3"
const QRegularExpression& withServo()
{
    static const QRegularExpression expression(QStringLiteral("^(.+):(\\d{1,3})$"));
    return expression;
}

const QRegularExpression& runNumber()
{
    static const QRegularExpression expression(QStringLiteral("^#?(\\d{1,15})$"));
    return expression;
}

QString textFor(Console& console, const history::SavedRun& kept)
{
    if (!kept.trouble)
        return translate("cli", "Saved to the history as test run %1").arg(qint64(kept.number));
    console.printMessage(translate("cli", "The test could not be saved to the history: %1")
                             .arg(text::describe(*kept.trouble).message));
    console.printMessage(
        kept.file.isEmpty()
            ? translate("cli", "The test could not be saved to a file in the history folder either")
            : translate("cli", "The test was saved to %1 instead").arg(kept.file));
    return {};
}
} // namespace

QString saveSweep(Console& console, const results::SweepRun& run, const QStringList& files)
{
    return textFor(console, history::saveRun(session::historyFile(), run, files));
}

QString saveStep(Console& console, const results::StepRun& run, const QStringList& files)
{
    return textFor(console, history::saveRun(session::historyFile(), run, files));
}

QString unreleasedTorqueText(const jobs::UnreleasedTorque& left)
{
    const QString words =
        left.holding
            ? translate("cli", "After the test, servo %1 could not be stopped (%2). Torque may "
                               "still be on, and the servo may continue to its last goal. Use "
                               "\"torque %1 off\", or disconnect its power supply.")
            : translate(
                  "cli",
                  "After the test, torque could not be turned off on servo %1 (%2) and may still "
                  "be on. Use \"torque %1 off\", or disconnect the servo from its power supply.");
    return words.arg(QString::number(left.id), base::errorName(left.error.code));
}

base::Result<std::vector<history::TestRun>> listRuns(const history::RunFilter& filter)
{
    if (!QFile::exists(session::historyFile()))
        return std::vector<history::TestRun>();
    const auto history = history::History::open(session::historyFile());
    if (!history)
        return tl::unexpected(history.error());
    return (*history)->runs(filter);
}

base::Result<RunSelector> parseRunSelector(const QString& word)
{
    RunSelector parsed{word};
    if (QFile::exists(word))
        return parsed;
    if (const auto match = withServo().match(word); match.hasMatch()) {
        const auto id = parseId(match.captured(2));
        if (!id)
            return tl::unexpected(id.error());
        parsed = {match.captured(1), 0, *id};
    }
    if (const auto match = runNumber().match(parsed.name); match.hasMatch()) {
        parsed.number = match.captured(1).toLongLong();
        parsed.name = match.captured(1);
    }
    return parsed;
}

namespace {
/// A run of the history; `missing`: the message for a number that is not there.
template <typename T>
base::Result<T> loadRun(std::int64_t number, const QString& missing,
                        base::Result<T> (history::History::*load)(std::int64_t) const)
{
    if (!QFile::exists(session::historyFile()))
        return badArgument(missing);
    const auto history = history::History::open(session::historyFile());
    if (!history)
        return tl::unexpected(history.error());
    auto run = ((**history).*load)(number);
    if (!run && run.error().code == base::ErrorCode::BadArgument)
        return badArgument(missing);
    return run;
}
} // namespace

base::Result<results::SweepRun> loadSweep(const RunSelector& word)
{
    if (word.number == 0)
        return results::loadSweepRun(word.name);
    return loadRun(
        word.number,
        translate("cli", "no test run %1 in the history; \"sweep-runs\" lists all test runs")
            .arg(qint64(word.number)),
        &history::History::sweep);
}

base::Result<std::vector<results::StepRun>> loadSteps(const RunSelector& word)
{
    if (word.number == 0)
        return results::loadStepRuns(word.name);
    auto run = loadRun(
        word.number,
        translate("cli",
                  "no step response %1 in the history; \"step-runs\" lists all step responses")
            .arg(qint64(word.number)),
        &history::History::step);
    if (!run)
        return tl::unexpected(run.error());
    return std::vector<results::StepRun>{std::move(*run)};
}

base::Result<const results::SweepServo*> chooseServo(const results::SweepRun& run,
                                                     const RunSelector& word)
{
    if (word.servo) {
        if (const results::SweepServo* servo = results::servoOf(run, *word.servo))
            return servo;
        return badArgument(
            translate("cli", "%1 does not contain servo %2").arg(word.name).arg(*word.servo));
    }
    if (run.servos.size() == 1)
        return &run.servos.front();
    QStringList ids;
    for (const results::SweepServo& servo : run.servos)
        ids.append(QString::number(servo.parameters.servo.id));
    return badArgument(
        translate("cli", "%1 contains servos %2; choose one, for example %1:%3, or use --servo")
            .arg(word.name, text::joinItems(ids), ids.value(0)));
}
} // namespace cli
