// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/commands.h"
#include "cli/input/arguments.h"
#include "cli/output/report_text.h"
#include "cli/run.h"
#include "cli/translate.h"
#include "jobs/commission/commission.h"
#include "report/commission_text.h"
#include "session/commission/commission_labels.h"
#include "session/snapshot/safety_snapshot.h"
#include "text/language.h"
#include "transport/stdin_reader.h"

#include <QFileInfo>

#include <condition_variable>
#include <mutex>
#include <thread>

namespace cli {
namespace {
using jobs::CommissionStep;
using jobs::CommissionView;

/// Plugs simulated servos in and out, shortly after each request.
class SimHotplugDriver {
public:
    explicit SimHotplugDriver(session::Connection& connection)
        : m_connection(connection)
    {
        if (connection.hasHotplugQueue())
            m_thread = std::thread([this] { work(); });
    }
    ~SimHotplugDriver()
    {
        post(Action::End);
        if (m_thread.joinable())
            m_thread.join();
    }
    SimHotplugDriver(const SimHotplugDriver&) = delete;
    SimHotplugDriver& operator=(const SimHotplugDriver&) = delete;

    /// Called for every change of the batch; does what it asks for.
    void onViewChanged(const CommissionView& view)
    {
        if (view.step == CommissionStep::Unplug)
            post(Action::Unplug);
        else if (view.step == CommissionStep::Waiting)
            post(Action::PlugNext);
    }
    /// No servo is left to be plugged in.
    bool empty() const { return m_empty; }
    std::function<void()> onEmpty;

private:
    enum class Action { None, Unplug, PlugNext, End };

    void post(Action action)
    {
        const std::lock_guard lock(m_mutex);
        m_action = action;
        m_asked.notify_one();
    }
    void work()
    {
        constexpr auto moment = std::chrono::milliseconds(100);
        for (;;) {
            std::unique_lock lock(m_mutex);
            m_asked.wait(lock, [this] { return m_action != Action::None; });
            const Action action = std::exchange(m_action, Action::None);
            if (action == Action::End)
                return;
            if (m_asked.wait_for(lock, moment, [this] { return m_action != Action::None; }))
                continue; // outdated
            lock.unlock();
            if (action == Action::Unplug)
                m_connection.unplugAll();
            else if (!m_connection.connectNext() && onEmpty) {
                m_empty = true;
                onEmpty();
            }
        }
    }

    session::Connection& m_connection;
    std::mutex m_mutex;
    std::condition_variable m_asked;
    Action m_action = Action::None;
    std::atomic<bool> m_empty{false};
    std::thread m_thread;
};

/// Ctrl-C, or the end of the simulated servos.
class CombinedStop {
public:
    explicit CombinedStop(const base::StopToken& first)
        : m_first(first)
        , m_watch([this] { watch(); })
    {}
    ~CombinedStop()
    {
        m_finished = true;
        m_watch.join();
    }
    CombinedStop(const CombinedStop&) = delete;
    CombinedStop& operator=(const CombinedStop&) = delete;
    base::StopToken& stop() { return m_combined; }

private:
    void watch()
    {
        constexpr auto slice = std::chrono::milliseconds(20);
        while (!m_finished && !m_first.isRequested())
            (void)m_first.waitUntil(std::chrono::steady_clock::now() + slice);
        if (m_first.isRequested())
            m_combined.request();
    }

    const base::StopToken& m_first;
    base::StopToken m_combined;
    std::atomic<bool> m_finished{false};
    std::thread m_watch;
};

class CommissionCommand {
public:
    CommissionCommand(Run& run, const Values& values)
        : m_run(run)
        , m_values(values)
    {}
    base::Result<Exit> run();

private:
    base::Result<void> collect();
    base::Result<void> collectIds();
    jobs::CommissionAnswer answer();
    void display(const CommissionView& view);
    void display(const results::CommissionRow& row);
    void listUnfinished();
    Exit finish(jobs::CommissionEnd end);

    Run& m_run;
    const Values& m_values;
    jobs::CommissionSpec m_spec;
    QString m_csv;
    results::CommissionBatch m_batch;
    std::size_t m_before = 0; ///< rows of earlier runs
    QString m_lastLine;
    transport::StdinReader m_input;
    base::StopToken* m_stop = nullptr;
};

base::Result<void> CommissionCommand::collectIds()
{
    constexpr int defaultFirst = 1;
    if (const auto list = m_values.option("--id-list")) {
        auto ids = parseIds(list->split(QLatin1Char(','), Qt::SkipEmptyParts));
        if (!ids)
            return tl::unexpected(ids.error());
        if (m_values.option("--first-id"))
            return badArgument(translate("cli", "use either --first-id or --id-list, not both"));
        m_spec.ids = *ids;
    } else {
        auto first = m_values.option("--first-id") ? parseId(*m_values.option("--first-id"))
                                                   : base::Result<int>(defaultFirst);
        if (!first)
            return tl::unexpected(first.error());
        for (int id = *first; id <= 253; ++id)
            m_spec.ids.push_back(id);
    }
    if (const auto count = m_values.option("--count")) {
        const auto number = parseInt(*count, 1, 254);
        if (!number)
            return tl::unexpected(number.error());
        m_spec.count = *number;
    }
    return {};
}

base::Result<void> CommissionCommand::collect()
{
    if (const auto ids = collectIds(); !ids)
        return ids;
    if (const auto rate = m_values.option("--to-baud")) {
        const auto rates = parseBauds(*rate);
        if (!rates || rates->size() != 1)
            return rates ? badArgument(translate("cli", "specify exactly one baud rate"))
                         : tl::unexpected(rates.error());
        m_spec.baud = rates->front();
    }
    if (const auto file = m_values.option("--template")) {
        auto snapshot = snapshot::loadSnapshot(*file);
        if (!snapshot)
            return tl::unexpected(snapshot.error());
        m_spec.settings = std::move(*snapshot);
        m_spec.templateName = QFileInfo(*file).fileName();
    }
    if (const auto& language = m_run.globals().protocol)
        m_spec.protocols = {*language};
    m_spec.center = m_values.has("--center");
    m_spec.consent = device::Consent::byOption(m_values.has("--dangerous"));
    m_spec.automatic = m_values.has("--auto");
    m_spec.labelFormat = m_values.option("--label-format").value_or(results::defaultLabelFormat());
    m_csv = m_values.option("--batch").value_or(QString());
    if (m_csv.isEmpty())
        return badArgument(translate("cli", "specify the batch file with --batch FILE.csv"));
    auto batch = results::openCommissionBatch(m_csv);
    if (!batch)
        return tl::unexpected(batch.error());
    m_batch = std::move(*batch);
    m_batch.program = session::programName();
    m_before = m_batch.rows.size();
    return {};
}

/// Waits for Enter. At the end of the input the batch ends, as with Ctrl-C.
jobs::CommissionAnswer CommissionCommand::answer()
{
    const auto line = m_input.readLine();
    if (!line && !m_input.isOpen())
        m_stop->request();
    if (!line)
        return jobs::CommissionAnswer::None;
    if (line->isEmpty())
        return jobs::CommissionAnswer::Continue;
    if (*line == "a")
        return jobs::CommissionAnswer::Skip;
    if (*line == "s")
        return jobs::CommissionAnswer::SameServo;
    m_run.console().printNote(translate("cli", "Nothing was done. Press Enter to continue, or type "
                                               "\"a\" and press Enter to set the servo aside."));
    return jobs::CommissionAnswer::None;
}

QString withConcerns(const QString& text, const std::vector<results::CommissionIssue>& issues)
{
    if (issues.empty())
        return text;
    return text + QLatin1Char(' ') +
           translate("cli", "Warning: %1.")
               .arg(text::localized(report::commissionIssuesText(issues)));
}

QString confirmText(const CommissionView& view)
{
    QString text = translate("cli", "The %1 with ID %2 at %3 baud will be changed to ID %4.")
                       .arg(view.servo.model)
                       .arg(view.servo.id)
                       .arg(view.baud)
                       .arg(view.newId);
    text = withConcerns(text, view.issues);
    if (view.candidateId >= 0 && view.candidateId == view.newId)
        return text + QLatin1Char(' ') +
               translate("cli",
                         "Setup of a servo of this model was not finished, and no IDs are left for "
                         "other servos. If the connected servo is that one, type \"s\" and press "
                         "Enter. To set the connected servo aside, type \"a\" and press Enter.");
    if (view.candidateId >= 0)
        text += QLatin1Char(' ') +
                translate("cli", "Setup of a servo of this model was not finished; its assigned ID "
                                 "is %1. If the connected servo is that one, type \"s\" and press "
                                 "Enter; otherwise, the connected servo is set up as a new one.")
                    .arg(view.candidateId);
    else if (view.isResumed)
        text += QLatin1Char(' ') +
                translate("cli", "This batch contains an unfinished servo of the same model. "
                                 "Continue only if it is the one that is connected now.");
    return text + QLatin1Char(' ') +
           translate(
               "cli",
               "Press Enter to continue, or type \"a\" and press Enter to set the servo aside.");
}

QString viewText(const CommissionView& view)
{
    switch (view.step) {
    case CommissionStep::Waiting:
        if (view.obstacle == jobs::CommissionObstacle::Lost)
            return withConcerns(
                translate("cli", "The servo was disconnected during setup. Connect it again (ID "
                                 "%1).")
                    .arg(view.newId),
                view.issues);
        return view.newId < 0
                   ? translate("cli",
                               "No IDs are left. Waiting for a servo whose setup is not finished.")
                   : translate("cli", "Connect the next servo (it will get ID %1).")
                         .arg(view.newId);
    case CommissionStep::Blocked:
        switch (view.obstacle) {
        case jobs::CommissionObstacle::DuplicateId:
            return translate(
                "cli",
                "Several servos are replying, so nothing is written. Disconnect all but one.");
        case jobs::CommissionObstacle::DuplicateIds:
            return translate("cli", "Two servos are replying with ID %1, so nothing is written. "
                                    "Disconnect one of them.")
                .arg(view.detected.empty() ? -1 : view.detected.front().place.id);
        default:
            return translate("cli", "A device is replying but cannot be identified.");
        }
    case CommissionStep::Confirm:
        return confirmText(view);
    case CommissionStep::Unplug:
        return view.newId < 0
                   ? translate("cli", "Unplug the servo.")
                   : translate("cli", "ID %1 is done. Unplug the servo.").arg(view.newId);
    default:
        return {};
    }
}

void CommissionCommand::display(const CommissionView& view)
{
    const QString text = viewText(view);
    if (text.isEmpty() || text == m_lastLine)
        return;
    m_lastLine = text;
    if (view.step == CommissionStep::Confirm)
        m_input.discardTyped(); // an extra Enter must not answer for the next servo
    m_run.console().printNote(text);
}

Json jsonRow(const results::CommissionRow& row)
{
    Json::Array issues;
    for (const results::CommissionIssue& issue : row.issues)
        issues.push_back(Json::object().add("word", issue.word).add("detail", issue.detail));
    Json json = Json::object();
    json.add("time", row.at.toUTC().toString(Qt::ISODate))
        .add("verdict", results::verdictName(row.verdict))
        .add("model", row.servo.model)
        .add("firmware", row.servo.firmware)
        .add("was_id", row.servo.id)
        .add("was_baud", row.oldBaud)
        .add("id", row.newId >= 0 ? Json(row.newId) : Json())
        .add("baud", row.newBaud > 0 ? Json(row.newBaud) : Json())
        .add("template", row.templateName)
        .add("written", row.written)
        .add("centred", row.centered)
        .add("volts", row.volts)
        .add("celsius", row.celsius)
        .add("troubles", std::move(issues))
        .add("label", row.label)
        .add("snapshot", row.snapshot)
        .add("simulated", row.simulated);
    return json;
}

void CommissionCommand::display(const results::CommissionRow& row)
{
    if (m_run.console().isJson()) {
        m_run.console().write(jsonRow(row).compact() + '\n');
        return;
    }
    const QString issues = text::localized(report::commissionIssuesText(row.issues));
    const QString identity =
        row.label.isEmpty() ? QStringLiteral("%1 · ID %2").arg(row.servo.model).arg(row.servo.id)
                            : row.label;
    m_run.console().print(
        QStringLiteral("%1 %2: %3%4\n")
            .arg(report::commissionVerdictSign(row.verdict), identity,
                 text::localized(report::commissionVerdictText(row.verdict)),
                 issues.isEmpty() ? QString() : QStringLiteral(" (%1)").arg(issues)));
}

void CommissionCommand::listUnfinished()
{
    if (m_batch.pending.empty())
        return;
    for (const results::PendingCommission& one : m_batch.pending)
        m_run.console().printNote(withConcerns(
            translate(
                "cli",
                "Unfinished: %1 with assigned ID %2. Some of its settings may have been written. "
                "Connect the servo and run the same command again to finish its setup.")
                .arg(one.servo.model)
                .arg(one.newId),
            results::unfinishedIssues(one)));
    // Between two servos no write is unfinished.
    const auto open = m_run.session().journal().open();
    if (!open || !open->empty())
        m_run.console().printNote(translate("cli", "\"recover\" shows the unfinished changes."));
}

Exit CommissionCommand::finish(jobs::CommissionEnd end)
{
    using results::CommissionVerdict;
    const QString summary =
        translate("cli", "%1 set up, %2 failed, %3 set aside; %4 unfinished. Batch: %5")
            .arg(m_batch.done())
            .arg(m_batch.count(CommissionVerdict::Failed))
            .arg(m_batch.count(CommissionVerdict::Skipped))
            .arg(m_batch.pending.size())
            .arg(m_csv);
    if (end == jobs::CommissionEnd::IdsExhausted)
        m_run.console().printNote(translate("cli", "All IDs have been assigned."));
    m_run.console().printNote(summary);
    listUnfinished();
    if (const QString notices = m_run.takeNotices(); !notices.isEmpty())
        m_run.console().printNote(notices.trimmed());
    const bool good = std::all_of(m_batch.rows.begin() + std::ptrdiff_t(m_before),
                                  m_batch.rows.end(), [](const results::CommissionRow& row) {
                                      return row.verdict == CommissionVerdict::Good ||
                                             row.verdict == CommissionVerdict::Remark;
                                  });
    return good && m_batch.pending.empty() ? Exit::Success : Exit::Failed;
}

base::Result<Exit> CommissionCommand::run()
{
    if (const auto ready = collect(); !ready)
        return tl::unexpected(ready.error());
    const auto connection = m_run.connect();
    if (!connection)
        return tl::unexpected(connection.error());
    CombinedStop either(m_run.stop());
    device::Context context = *m_run.context();
    const device::Context stoppable{context.bus,   context.catalog, context.journal,
                                    either.stop(), context.notices, context.priority,
                                    context.hold,  context.epoch};
    m_stop = &either.stop();
    SimHotplugDriver hand(**connection);
    hand.onEmpty = [&either] { either.stop().request(); };
    jobs::CommissionCallbacks callbacks;
    callbacks.onChange = [&](const CommissionView& view) {
        display(view);
        hand.onViewChanged(view);
    };
    callbacks.answer = [this] { return answer(); };
    callbacks.onRow = [this](const results::CommissionRow& row) { display(row); };
    callbacks.save = [this](const device::Context& with, device::Servo& servo) {
        auto saved = session::saveSafetySnapshot(with, servo, history::SnapshotReason::Commission);
        if (saved)
            m_run.console().printNote(translate("cli", "Present settings saved to %1").arg(*saved));
        return saved;
    };
    session::CommissionLabels names;
    callbacks.onNewServo = [&names](const device::Servo& servo) { return names.servoFound(servo); };
    callbacks.name = [&names](const device::Servo& servo, const QString& label, bool another) {
        return names.setLabel(servo, label, another);
    };
    const auto end = jobs::commission(stoppable, m_spec, m_batch, m_csv, callbacks);
    if (!end) {
        listUnfinished();
        return tl::unexpected(end.error());
    }
    return finish(*end);
}

base::Result<Exit> runCommission(Run& run, const Values& values)
{
    return CommissionCommand(run, values).run();
}
} // namespace

Command commissionCommand()
{
    return {
        "commission",
        QT_TRANSLATE_NOOP("cli", "set up servos one at a time: template, ID, baud rate"),
        {},
        {{"--batch", QT_TRANSLATE_NOOP("cli", "batch file; an existing batch is resumed"),
          "FILE.csv"},
         {"--first-id", QT_TRANSLATE_NOOP("cli", "first ID to assign (default: 1)"), "ID"},
         {"--id-list", QT_TRANSLATE_NOOP("cli", "IDs to assign, in this order: 4-9,12"), "IDS"},
         {"--count",
          QT_TRANSLATE_NOOP("cli", "stop when this many servos in the batch have been set up"),
          "N"},
         {"--to-baud", QT_TRANSLATE_NOOP("cli", "baud rate to write (default: unchanged)"), "RATE"},
         {"--template", QT_TRANSLATE_NOOP("cli", "snapshot or template to write"), "FILE"},
         {"--dangerous", QT_TRANSLATE_NOOP("cli", "also write the dangerous registers of the "
                                                  "template")},
         {"--center", QT_TRANSLATE_NOOP("cli", "set the present position as the midpoint")},
         {"--auto", QT_TRANSLATE_NOOP("cli", "set up each servo without asking; servos with an "
                                             "alarm or another problem are set aside")},
         {"--label-format",
          QT_TRANSLATE_NOOP("cli", "label text, with placeholders: {model} {id} {rate} {baud} "
                                   "{firmware} {date} {was_id}"),
          "TEXT"}},
        runCommission};
}
} // namespace cli
