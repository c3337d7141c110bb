// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/commands.h"
#include "cli/input/arguments.h"
#include "cli/output/progress.h"
#include "cli/output/report_text.h"
#include "cli/run.h"
#include "cli/translate.h"
#include "device/motion/motion.h"
#include "device/motion/stop_frames.h"
#include "device/motion/torque_off.h"
#include "device/responding.h"
#include "text/language.h"
#include "transport/port_opener.h"

#include <algorithm>
#include <functional>
#include <map>
#include <memory>
#include <set>

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
    return badArgument(translate("cli", "the last argument must be on, off or damp"));
}

/// Confirms the task of one servo after all have been commanded; empty: already done.
using Confirm = std::function<base::Result<void>()>;

/// A task for several servos, and its texts.
struct Task {
    const char* name; ///< of the operation and of the member in the JSON document
    Json result;
    QString shown;
    std::function<base::Result<Confirm>(const device::Context&, device::Servo)> act;
    /// Torque off is sent even if the servo cannot be identified.
    bool releases = false;
    bool sent = false;        ///< torque off has been sent to all servos
    QString confirmingText{}; ///< shown after all have been commanded; %1: their IDs
};

QString formatIds(const std::vector<int>& ids)
{
    QStringList words;
    for (const int id : ids)
        words << QString::number(id);
    return text::joinItems(words);
}

/// Commands all servos, also if some of them fail.
class Round {
public:
    Round(Run& run, const Task& task)
        : m_run(run)
        , m_task(task)
    {}

    /// Commands all servos, to be confirmed afterwards. After Ctrl-C the others stay unchanged.
    void command(const std::vector<int>& ids)
    {
        ProgressLine line(m_run.console(), translate("cli", "Querying"));
        for (const int id : ids) {
            line.show(translate("cli", "ID %1").arg(id));
            if (m_run.stop().isRequested()) {
                m_notReached.insert(id);
                m_begun.emplace_back(id, stopped(id));
            } else {
                m_begun.emplace_back(id, begin(id));
            }
        }
    }
    void confirm()
    {
        ProgressLine line(m_run.console(), translate("cli", "Querying"));
        reportCommanded();
        for (auto& [id, rest] : m_begun) {
            line.show(translate("cli", "ID %1").arg(id));
            if (!rest)
                m_done[id] = tl::unexpected(rest.error());
            else
                m_done[id] = *rest ? (*rest)() : base::Result<void>{};
        }
        m_begun.clear();
    }

    base::Result<Exit> show(const std::vector<int>& ids) const
    {
        Json::Array servos;
        QString text;
        Exit exit = Exit::Success;
        std::map<QString, std::vector<int>> endedByUser;
        for (const int id : ids) {
            const base::Result<void>& done = m_done.at(id);
            if (!done && ids.size() == 1)
                return tl::unexpected(done.error());
            Json json = Json::object();
            json.add("id", id);
            if (done) {
                json.add(m_task.name, m_task.result);
                text +=
                    translate("cli", "Servo %1: %2").arg(id).arg(m_task.shown) + QLatin1Char('\n');
            } else {
                json.add("error", jsonError(done.error()));
                if (done.error().code == base::ErrorCode::Stopped)
                    endedByUser[endedText(id, done.error())].push_back(id);
                else
                    m_run.console().printNote(errorText(done.error()));
                exit = exit == Exit::Success ? exitCode(done.error().code) : exit;
            }
            servos.push_back(std::move(json));
        }
        for (const auto& [ended, its] : endedByUser)
            m_run.console().printNote(ended.arg(formatIds(its)));
        m_run.finish(Json::object().add("servos", std::move(servos)), text);
        return exit;
    }

private:
    using HaltState = std::vector<std::pair<int, base::Result<Confirm>>>;

    /// %1: the IDs.
    QString endedText(int id, const base::Error& error) const
    {
        if (m_task.sent || device::isMarkedUnverified(error))
            return translate("cli", "Canceled before confirmation (ID %1): the torque-off command "
                                    "was sent but may not have taken effect.");
        if (m_task.releases)
            return translate("cli", "Canceled before confirmation (ID %1): torque may still be on, "
                                    "and these servos may still be moving.");
        return m_notReached.count(id) > 0
                   ? translate("cli", "Canceled before anything was sent (ID %1).")
                   : translate("cli", "Canceled before confirmation (ID %1): the torque state of "
                                      "these servos may have changed.");
    }
    void reportCommanded() const
    {
        std::vector<int> ids;
        for (const auto& [id, rest] : m_begun) {
            if (rest)
                ids.push_back(id);
        }
        if (!ids.empty() && !m_task.confirmingText.isEmpty())
            m_run.console().printNote(m_task.confirmingText.arg(formatIds(ids)));
    }
    base::Result<Confirm> begin(int id)
    {
        auto servo = m_run.servo(id);
        if (servo)
            return m_task.act(*m_run.context(), std::move(*servo));
        const auto connection = m_run.connect();
        if (!m_task.releases || !connection)
            return tl::unexpected(servo.error());
        return tl::unexpected(device::forceTorqueOffUnidentified(
            *m_run.context(), id, (*connection)->protocols(), std::move(servo.error())));
    }
    base::Result<Confirm> stopped(int id) const
    {
        const base::Error error{base::ErrorCode::Stopped, QLatin1String(m_task.name), {}, id};
        return tl::unexpected(m_task.sent ? device::markUnverified(error) : error);
    }

    Run& m_run;
    const Task& m_task;
    HaltState m_begun{};
    std::set<int> m_notReached{}; ///< because of Ctrl-C
    std::map<int, base::Result<void>> m_done{};
};

base::Result<Exit> runOnAll(Run& run, const std::vector<int>& ids, const Task& task)
{
    Round round(run, task);
    round.command(ids);
    round.confirm();
    return round.show(ids);
}

/// Sends torque off before anything is read; with --baud auto at every possible baud rate. True: it
/// was sent.
base::Result<bool> disableTorqueAtOnce(Run& run, const std::vector<int>& ids)
{
    const auto connection = run.connect();
    if (!connection)
        return tl::unexpected(connection.error());
    bus::Bus& bus = (*connection)->bus();
    const int rate = bus.baud();
    if (run.globals().autoBaud && bus.canSetBaud()) {
        for (const int other : transport::standardBaudRates()) {
            if (other != rate && bus.setBaud(other))
                device::torqueOffImmediately(bus, ids, (*connection)->protocols());
        }
        if (const auto back = bus.setBaud(rate); !back)
            return tl::unexpected(back.error());
    }
    device::torqueOffImmediately(bus, ids, (*connection)->protocols());
    if (bus.lost())
        return false;
    run.console().printNote(
        translate("cli", "Torque-off command sent (ID %1). Confirming…").arg(formatIds(ids)));
    return true;
}

base::Result<Confirm> startHalt(const device::Context& context, device::Servo servo)
{
    const auto stopping = std::make_shared<device::Servo>(std::move(servo));
    return device::commandHalt(context, *stopping).map([=](const device::HaltCommand& command) {
        return Confirm([=] { return device::confirmHalt(context, *stopping, command); });
    });
}

/// Servos that reply are commanded and confirmed before the slow retries of the silent ones. Each
/// is asked twice, because a lost reply may be that of a turning servo.
void runAnsweringFirst(Run& run, const device::Context& context, std::vector<int> ids,
                       const std::vector<base::Protocol>& protocols, Round& round)
{
    bool answered = false;
    for (int attempt = 0; attempt < 2 && !ids.empty(); ++attempt) {
        const auto answering = device::findResponding(context, ids, protocols);
        answered = answered || !answering.empty();
        round.command(answering);
        std::erase_if(ids, [&](int id) {
            return std::find(answering.begin(), answering.end(), id) != answering.end();
        });
    }
    if (answered && !ids.empty() && !run.stop().isRequested() && !context.bus.lost())
        run.console().printNote(
            translate("cli", "No reply yet (ID %1): trying again after the other servos.")
                .arg(formatIds(ids)));
    round.confirm();
    round.command(ids);
    round.confirm();
}

/// Not for a single servo, nor before the baud rate is known.
base::Result<Exit> answeringServosFirst(Run& run, const std::vector<int>& ids, const Task& task)
{
    const auto connection = run.connect();
    const auto context = run.context();
    if (!connection || !context)
        return tl::unexpected(!connection ? connection.error() : context.error());
    const bool rateUnknown = run.globals().autoBaud && context->bus.canSetBaud();
    if (ids.size() == 1 || rateUnknown)
        return runOnAll(run, ids, task);
    Round round(run, task);
    runAnsweringFirst(run, *context, ids, (*connection)->protocols(), round);
    return round.show(ids);
}

base::Result<Exit> runTorque(Run& run, const Values& values)
{
    QStringList words = values.arguments("ID… on|off|damp");
    const auto state = parseState(words.takeLast());
    if (!state)
        return tl::unexpected(state.error());
    const auto ids = parseIds(words);
    if (!ids)
        return tl::unexpected(ids.error());
    if (const auto connection = run.connect(); !connection)
        return tl::unexpected(connection.error());
    const bool off = state->torque == device::Torque::Off;
    const auto sent = off ? disableTorqueAtOnce(run, *ids) : base::Result<bool>(false);
    if (!sent)
        return tl::unexpected(sent.error());
    const Task task{
        "torque",
        QString::fromLatin1(state->word),
        translate("cli", state->shown),
        [torque = state->torque](const device::Context& context, device::Servo servo) {
            return device::setTorque(context, servo, torque).map([] { return Confirm(); });
        },
        off,
        *sent};
    return off ? answeringServosFirst(run, *ids, task) : runOnAll(run, *ids, task);
}

base::Result<Exit> runStop(Run& run, const Values& values)
{
    const auto ids = parseIds(values.arguments("ID"));
    if (!ids)
        return tl::unexpected(ids.error());
    if (const auto connection = run.connect(); !connection)
        return tl::unexpected(connection.error());
    const Task task{"stopped",
                    true,
                    translate("cli", "stopped"),
                    startHalt,
                    true,
                    false,
                    translate("cli", "Confirming the stop (ID %1)…")};
    return answeringServosFirst(run, *ids, task);
}

base::Result<Exit> runMode(Run& run, const Values& values)
{
    auto servo = run.servoWithSettings(values);
    if (!servo)
        return tl::unexpected(servo.error());
    const QString modeKey = values.argument("MODE");
    if (servo->profile->mode(modeKey) == nullptr) {
        QStringList known;
        for (const catalog::Mode& mode : servo->profile->modes)
            known << mode.key;
        return base::fail(base::ErrorCode::NotSupported, QStringLiteral("mode"),
                          translate("cli", "unknown mode \"%1\"; available modes: %2")
                              .arg(modeKey, text::joinItems(known)),
                          servo->id);
    }
    if (const auto saved = run.backupTable(*servo); !saved)
        return tl::unexpected(saved.error());
    const auto report = device::switchMode(*run.context(), *servo, modeKey);
    if (!report)
        return tl::unexpected(report.error());
    Json document = jsonWrites(*report);
    const catalog::Mode* now = servo->mode();
    document.add("mode", report->isSuccessful() && now != nullptr ? Json(now->key) : Json());
    run.finish(std::move(document), writeText(*servo, *report));
    return exitCode(*report);
}
} // namespace

Command torqueCommand()
{
    return {"torque",
            QT_TRANSLATE_NOOP("cli", "set the torque state: on holds the present position; off is "
                                     "sent even when other writes are refused"),
            {{"ID… on|off|damp",
              QT_TRANSLATE_NOOP("cli", "servo IDs (1 2 3, 1-6 or 1,3), then the action"), 2, many}},
            {},
            runTorque};
}

Command stopCommand()
{
    return {"stop",
            QT_TRANSLATE_NOOP(
                "cli", "stop the motion without changing the torque state; if it cannot be "
                       "confirmed that the servo is holding its position, torque is turned off"),
            {{"ID", QT_TRANSLATE_NOOP("cli", "servo IDs: 1 2 3, 1-6 or 1,3"), 1, many}},
            {},
            runStop};
}

Command modeCommand()
{
    return {"mode",
            QT_TRANSLATE_NOOP("cli", "switch the operating mode; torque stays off afterwards"),
            {servoIdArgument,
             {"MODE", QT_TRANSLATE_NOOP(
                          "cli", "position, position-pd, multiturn, speed, pwm, step, "
                                 "current, release or motor, depending on the servo family")}},
            {},
            runMode};
}
} // namespace cli
