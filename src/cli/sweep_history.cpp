// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/sweep_history.h"

#include "cli/input/arguments.h"
#include "cli/translate.h"
#include "results/sweep_json.h"
#include "session/paths.h"
#include "text/error_text.h"

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

QString textFor(Console& console, const record::SavedRun& kept)
{
    if (!kept.trouble)
        return translate("cli", "Kept in the history as test run %1").arg(qint64(kept.number));
    console.printMessage(translate("cli", "The test could not be kept in the history: %1")
                             .arg(text::describe(*kept.trouble).message));
    console.printMessage(
        kept.file.isEmpty()
            ? translate("cli", "It could not be left in a file beside the history either")
            : translate("cli", "It was left in %1 instead").arg(kept.file));
    return {};
}
} // namespace

QString saveSweep(Console& console, const record::SweepRun& run, const QStringList& files)
{
    return textFor(console, record::saveRun(session::historyFile(), run, files));
}

QString saveStep(Console& console, const record::StepRun& run, const QStringList& files)
{
    return textFor(console, record::saveRun(session::historyFile(), run, files));
}

QString unreleasedTorqueText(const jobs::UnreleasedTorque& left)
{
    const QString words =
        left.holding
            ? translate("cli", "Servo %1 may still have torque and go on to its last goal: "
                               "stopping it after the test failed (%2). Use \"torque %1 off\", or "
                               "cut its supply.")
            : translate("cli", "Servo %1 may still have torque: switching it off after the test "
                               "failed (%2). Use \"torque %1 off\", or cut its supply.");
    return words.arg(QString::number(left.id), base::errorName(left.error.code));
}

base::Result<std::vector<record::TestRun>> listSweeps(const record::RunFilter& filter)
{
    if (!QFile::exists(session::historyFile()))
        return std::vector<record::TestRun>();
    const auto history = record::History::open(session::historyFile());
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

base::Result<record::SweepRun> loadSweep(const RunSelector& word)
{
    if (word.number == 0)
        return record::loadSweepRun(word.name);
    const auto none = [&] {
        return badArgument(
            translate("cli", "there is no test run %1 in the history; sweep-runs lists them")
                .arg(qint64(word.number)));
    };
    if (!QFile::exists(session::historyFile()))
        return none();
    const auto history = record::History::open(session::historyFile());
    if (!history)
        return tl::unexpected(history.error());
    auto run = (*history)->sweep(word.number);
    if (!run && run.error().code == base::ErrorCode::BadArgument)
        return none();
    return run;
}

base::Result<const record::SweepServo*> chooseServo(const record::SweepRun& run,
                                                    const RunSelector& word)
{
    if (word.servo) {
        if (const record::SweepServo* servo = record::servoOf(run, *word.servo))
            return servo;
        return badArgument(translate("cli", "%1 has no servo %2").arg(word.name).arg(*word.servo));
    }
    if (run.servos.size() == 1)
        return &run.servos.front();
    QStringList ids;
    for (const record::SweepServo& servo : run.servos)
        ids.append(QString::number(servo.parameters.servo.id));
    return badArgument(translate("cli", "%1 has servos %2; say which, as in %1:%3 or with --servo")
                           .arg(word.name, ids.join(QStringLiteral(", ")), ids.value(0)));
}
} // namespace cli
