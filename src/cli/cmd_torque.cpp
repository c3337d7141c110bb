// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/arguments.h"
#include "cli/commands.h"
#include "cli/report_words.h"
#include "cli/run.h"
#include "cli/translate.h"
#include "device/motion.h"
#include "device/release.h"

#include <functional>
#include <memory>

namespace cli {
namespace {
struct State {
    const char* word;
    device::Torque torque;
    const char* shown;
};

constexpr State states[]{
    {"on", device::Torque::On, QT_TRANSLATE_NOOP("cli", "torque on")},
    {"off", device::Torque::Off, QT_TRANSLATE_NOOP("cli", "torque off")},
    {"damp", device::Torque::Damp, QT_TRANSLATE_NOOP("cli", "damping")},
};

base::Result<State> parseState(const QString& word)
{
    for (const State& state : states) {
        if (word == QLatin1String(state.word))
            return state;
    }
    return badArgument(translate("cli", "the last word must be on, off or damp"));
}

/// The rest of what is done to a servo, when all have had their turn; empty: it is done.
using Confirm = std::function<base::Result<void>()>;

/// What is done to each of several servos, and how it is told.
struct Task {
    const char* name; ///< operation, and the member of the JSON document
    Json result;
    QString shown;
    std::function<base::Result<Confirm>(const device::Context&, device::Servo)> act;
    bool releases = false; ///< torque off goes out even if the servo cannot be identified
};

base::Result<Confirm> doOne(Run& run, int id, const Task& task)
{
    auto servo = run.servo(id);
    if (servo)
        return task.act(*run.context(), std::move(*servo));
    const auto connection = run.connect();
    if (!task.releases || !connection)
        return tl::unexpected(servo.error());
    return tl::unexpected(device::releaseUnidentified(
        *run.context(), id, (*connection)->protocols(), std::move(servo.error())));
}

/// All servos get their turn, whatever becomes of the others: off must reach as many as it can.
base::Result<Exit> doAll(Run& run, const std::vector<int>& ids, const Task& task)
{
    std::vector<base::Result<Confirm>> begun;
    for (const int id : ids) {
        if (run.stop().requested())
            return base::fail(base::ErrorCode::Stopped, QLatin1String(task.name), {}, id);
        begun.push_back(doOne(run, id, task));
    }
    Json::Array servos;
    QString text;
    Exit exit = Exit::Done;
    for (std::size_t i = 0; i < ids.size(); ++i) {
        const int id = ids[i];
        base::Result<void> done;
        if (!begun[i])
            done = tl::unexpected(begun[i].error());
        else if (*begun[i])
            done = (*begun[i])();
        Json json = Json::object();
        json.add("id", id);
        if (done) {
            json.add(task.name, task.result);
            text += translate("cli", "Servo %1: %2").arg(id).arg(task.shown) + QLatin1Char('\n');
        } else if (ids.size() == 1) {
            return tl::unexpected(done.error());
        } else {
            json.add("error", jsonError(done.error()));
            run.console().remark(errorText(done.error()));
            exit = exit == Exit::Done ? exitCode(done.error().code) : exit;
        }
        servos.push_back(std::move(json));
    }
    run.finish(Json::object().add("servos", std::move(servos)), text);
    return exit;
}

base::Result<Exit> runTorque(Run& run, const Values& values)
{
    QStringList words = values.words("ID… on|off|damp");
    const auto state = parseState(words.takeLast());
    if (!state)
        return tl::unexpected(state.error());
    const auto ids = parseIds(words);
    if (!ids)
        return tl::unexpected(ids.error());
    if (const auto connection = run.connect(); !connection)
        return tl::unexpected(connection.error());
    const Task task{
        "torque", QString::fromLatin1(state->word), translate("cli", state->shown),
        [torque = state->torque](const device::Context& context, device::Servo servo) {
            return device::setTorque(context, servo, torque).map([] { return Confirm(); });
        },
        state->torque == device::Torque::Off};
    return doAll(run, *ids, task);
}

base::Result<Confirm> beginHalt(const device::Context& context, device::Servo servo)
{
    const auto stopping = std::make_shared<device::Servo>(std::move(servo));
    return device::commandHalt(context, *stopping).map([=](const device::HaltCommand& command) {
        return Confirm([=] { return device::confirmHalt(context, *stopping, command); });
    });
}

base::Result<Exit> runStop(Run& run, const Values& values)
{
    const auto ids = parseIds(values.words("ID"));
    if (!ids)
        return tl::unexpected(ids.error());
    if (const auto connection = run.connect(); !connection)
        return tl::unexpected(connection.error());
    const Task task{"stopped", true, translate("cli", "stopped"), beginHalt, true};
    return doAll(run, *ids, task);
}

base::Result<Exit> runMode(Run& run, const Values& values)
{
    auto servo = run.servoWithSettings(values);
    if (!servo)
        return tl::unexpected(servo.error());
    const QString wanted = values.word("MODE");
    if (servo->profile->mode(wanted) == nullptr) {
        QStringList known;
        for (const catalog::Mode& mode : servo->profile->modes)
            known << mode.key;
        return base::fail(base::ErrorCode::NotSupported, QStringLiteral("mode"),
                          translate("cli", "no mode \"%1\"; it has %2")
                              .arg(wanted, known.join(QStringLiteral(", "))),
                          servo->id);
    }
    if (const auto saved = run.saveFirst(*servo); !saved)
        return tl::unexpected(saved.error());
    const auto report = device::switchMode(*run.context(), *servo, wanted);
    if (!report)
        return tl::unexpected(report.error());
    Json document = jsonWrites(*report);
    const catalog::Mode* now = servo->mode();
    document.add("mode", report->allGood() && now != nullptr ? Json(now->key) : Json());
    run.finish(std::move(document), writeText(*servo, *report));
    return exitCode(*report);
}
} // namespace

Command torqueCommand()
{
    return {"torque",
            QT_TRANSLATE_NOOP("cli",
                              "switch torque; on holds where the servo is, off is sent whatever "
                              "speaks against writing"),
            {{"ID… on|off|damp",
              QT_TRANSLATE_NOOP("cli", "servos (1 2 3, 1-6, 1,3), then what to do"), 2, many}},
            {},
            runTorque};
}

Command stopCommand()
{
    return {"stop",
            QT_TRANSLATE_NOOP("cli", "end the motion; torque stays as it is, and goes off where "
                                     "holding cannot be proven"),
            {{"ID", QT_TRANSLATE_NOOP("cli", "servos: 1 2 3, 1-6, 1,3"), 1, many}},
            {},
            runStop};
}

Command modeCommand()
{
    return {"mode",
            QT_TRANSLATE_NOOP("cli", "switch the operating mode; torque stays off afterwards"),
            {{"ID", QT_TRANSLATE_NOOP("cli", "the servo")},
             {"MODE",
              QT_TRANSLATE_NOOP("cli", "position, multiturn, speed, pwm, step, current or motor, "
                                       "as the family has them")}},
            {},
            runMode};
}
} // namespace cli
