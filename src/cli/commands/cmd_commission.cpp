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

QString in(const catalog::Text& words)
{
    return words.in(text::isUiChinese());
}

/// The hand that plugs servos in and out of a simulated bag, a moment after it is asked to.
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

    /// Called for every change of the line: what it asks for is done.
    void onViewChanged(const CommissionView& view)
    {
        if (view.step == CommissionStep::Unplug)
            post(Action::Unplug);
        else if (view.step == CommissionStep::Waiting)
            post(Action::PlugNext);
    }
    /// Nobody is left to be plugged in.
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
                continue; // overtaken
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

/// Ctrl-C, or the end of a simulated bag.
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
    void display(const record::CommissionRow& row);
    void listUnfinished();
    Exit finish(jobs::CommissionEnd end);

    Run& m_run;
    const Values& m_values;
    jobs::CommissionSpec m_spec;
    QString m_csv;
    record::CommissionBatch m_batch;
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
            return badArgument(translate("cli", "give --first-id or --id-list, not both"));
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
            return rates ? badArgument(translate("cli", "give one baud rate"))
                         : tl::unexpected(rates.error());
        m_spec.baud = rates->front();
    }
    if (const auto file = m_values.option("--template")) {
        auto snapshot = record::loadSnapshot(*file);
        if (!snapshot)
            return tl::unexpected(snapshot.error());
        m_spec.settings = std::move(*snapshot);
        m_spec.templateName = QFileInfo(*file).fileName();
    }
    if (const auto& language = m_run.globals().protocol)
        m_spec.protocols = {*language};
    m_spec.center = m_values.has("--center");
    m_spec.dangerous = m_values.has("--dangerous");
    m_spec.automatic = m_values.has("--auto");
    m_spec.labelFormat = m_values.option("--label-format").value_or(record::defaultLabelFormat());
    m_csv = m_values.option("--batch").value_or(QString());
    if (m_csv.isEmpty())
        return badArgument(translate("cli", "name the file of the batch with --batch FILE.csv"));
    auto batch = record::openCommissionBatch(m_csv);
    if (!batch)
        return tl::unexpected(batch.error());
    m_batch = std::move(*batch);
    m_batch.program = session::programName();
    m_before = m_batch.rows.size();
    return {};
}

/// Enter goes on. Without anybody who could press it the line ends, as with Ctrl-C.
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
    m_run.console().printNote(
        translate("cli", "Nothing is done. Enter: go on; a and Enter: set it aside."));
    return jobs::CommissionAnswer::None;
}

QString withConcerns(const QString& text, const std::vector<record::CommissionIssue>& issues)
{
    if (issues.empty())
        return text;
    return text + QLatin1Char(' ') +
           translate("cli", "Beware: %1.").arg(in(report::commissionIssuesText(issues)));
}

QString confirmText(const CommissionView& view)
{
    QString text = translate("cli", "%1, ID %2 at %3 baud, gets ID %4.")
                       .arg(view.servo.model)
                       .arg(view.servo.id)
                       .arg(view.baud)
                       .arg(view.newId);
    text = withConcerns(text, view.issues);
    if (view.candidateId >= 0 && view.candidateId == view.newId)
        return text + QLatin1Char(' ') +
               translate("cli", "A servo of this kind was left unfinished; no ID is left for "
                                "another one. If this is that servo, press s and Enter; a and "
                                "Enter: set it aside.");
    if (view.candidateId >= 0)
        text +=
            QLatin1Char(' ') +
            translate("cli",
                      "A servo of this kind was left unfinished; it was to have ID %1. If this is "
                      "that servo, press s and Enter; otherwise it is set up as a new one.")
                .arg(view.candidateId);
    else if (view.isResumed)
        text += QLatin1Char(' ') +
                translate("cli", "A servo of this kind was left unfinished here. Go on only if "
                                 "this is that servo.");
    return text + QLatin1Char(' ') + translate("cli", "Enter: go on; a and Enter: set it aside.");
}

QString viewText(const CommissionView& view)
{
    switch (view.step) {
    case CommissionStep::Waiting:
        if (view.obstacle == jobs::CommissionObstacle::Lost)
            return withConcerns(
                translate("cli", "The servo went away in the middle; plug it in again (ID %1).")
                    .arg(view.newId),
                view.issues);
        return view.newId < 0
                   ? translate("cli", "No ID is left; an unfinished servo is awaited.")
                   : translate("cli", "Connect the next servo (it gets ID %1).").arg(view.newId);
    case CommissionStep::Blocked:
        switch (view.obstacle) {
        case jobs::CommissionObstacle::DuplicateId:
            return translate("cli", "Several servos answer; leave one: nothing is written.");
        case jobs::CommissionObstacle::DuplicateIds:
            return translate("cli", "Two servos answer under ID %1; leave one: nothing is written.")
                .arg(view.detected.empty() ? -1 : view.detected.front().place.id);
        default:
            return translate("cli", "Somebody answers, but cannot be recognised.");
        }
    case CommissionStep::Confirm:
        return confirmText(view);
    case CommissionStep::Unplug:
        return view.newId < 0 ? translate("cli", "Unplug it.")
                              : translate("cli", "Unplug: ID %1 is done.").arg(view.newId);
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
        m_input.discardTyped(); // an Enter too many is no answer about a servo nobody has seen yet
    m_run.console().printNote(text);
}

Json jsonRow(const record::CommissionRow& row)
{
    Json::Array issues;
    for (const record::CommissionIssue& issue : row.issues)
        issues.push_back(Json::object().add("word", issue.word).add("detail", issue.detail));
    Json json = Json::object();
    json.add("time", row.at.toUTC().toString(Qt::ISODate))
        .add("verdict", record::verdictName(row.verdict))
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
        .add("snapshot", row.snapshot);
    return json;
}

void CommissionCommand::display(const record::CommissionRow& row)
{
    if (m_run.console().isJson()) {
        m_run.console().write(jsonRow(row).compact() + '\n');
        return;
    }
    const QString issues = in(report::commissionIssuesText(row.issues));
    const QString identity =
        row.label.isEmpty() ? QStringLiteral("%1 · ID %2").arg(row.servo.model).arg(row.servo.id)
                            : row.label;
    m_run.console().print(
        QStringLiteral("%1 %2: %3%4\n")
            .arg(report::commissionVerdictSign(row.verdict), identity,
                 in(report::commissionVerdictText(row.verdict)),
                 issues.isEmpty() ? QString() : QStringLiteral(" (%1)").arg(issues)));
}

void CommissionCommand::listUnfinished()
{
    if (m_batch.pending.empty())
        return;
    for (const record::PendingCommission& one : m_batch.pending)
        m_run.console().printNote(withConcerns(
            translate("cli", "Unfinished: %1 that was to have ID %2. A part of its settings may be "
                             "written. Connect it and run the same command again to finish it.")
                .arg(one.servo.model)
                .arg(one.newId),
            record::unfinishedIssues(one)));
    // Between two writes none is open.
    const auto open = m_run.session().journal().open();
    if (!open || !open->empty())
        m_run.console().printNote(translate("cli", "\"recover\" shows the changes that are open."));
}

Exit CommissionCommand::finish(jobs::CommissionEnd end)
{
    using record::CommissionVerdict;
    const QString summary =
        translate("cli", "%1 set up, %2 failed, %3 set aside; %4 unfinished. Batch: %5")
            .arg(m_batch.done())
            .arg(m_batch.count(CommissionVerdict::Failed))
            .arg(m_batch.count(CommissionVerdict::Skipped))
            .arg(m_batch.pending.size())
            .arg(m_csv);
    if (end == jobs::CommissionEnd::IdsExhausted)
        m_run.console().printNote(translate("cli", "All IDs have been given."));
    m_run.console().printNote(summary);
    listUnfinished();
    if (const QString notices = m_run.takeNotices(); !notices.isEmpty())
        m_run.console().printNote(notices.trimmed());
    const bool good = std::all_of(m_batch.rows.begin() + std::ptrdiff_t(m_before),
                                  m_batch.rows.end(), [](const record::CommissionRow& row) {
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
    callbacks.onRow = [this](const record::CommissionRow& row) { display(row); };
    callbacks.save = [this](const device::Context& with, device::Servo& servo) {
        auto saved = session::saveSafetySnapshot(with, servo, record::SnapshotReason::Commission);
        if (saved)
            m_run.console().printNote(
                translate("cli", "The present settings are saved in %1").arg(*saved));
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

base::Result<Exit> run(Run& run, const Values& values)
{
    return CommissionCommand(run, values).run();
}
} // namespace

Command commissionCommand()
{
    return {
        "commission",
        QT_TRANSLATE_NOOP("cli",
                          "set up servos plugged in one after the other: template, ID, rate"),
        {},
        {{"--batch",
          QT_TRANSLATE_NOOP("cli", "the list of the batch; one that exists is gone on with"),
          "FILE.csv"},
         {"--first-id", QT_TRANSLATE_NOOP("cli", "the first ID to give (usual: 1)"), "ID"},
         {"--id-list", QT_TRANSLATE_NOOP("cli", "the IDs to give, in this order: 4-9,12"), "IDS"},
         {"--count", QT_TRANSLATE_NOOP("cli", "end after so many servos of the batch"), "N"},
         {"--to-baud", QT_TRANSLATE_NOOP("cli", "the rate to give (else each keeps its own)"),
          "RATE"},
         {"--template", QT_TRANSLATE_NOOP("cli", "a snapshot or template to write"), "FILE"},
         {"--dangerous", QT_TRANSLATE_NOOP("cli", "also write its dangerous rows")},
         {"--center", QT_TRANSLATE_NOOP("cli", "make the present position the middle")},
         {"--auto", QT_TRANSLATE_NOOP("cli", "set up each servo without asking; what has an alarm "
                                             "or does not fit is set aside")},
         {"--label-format",
          QT_TRANSLATE_NOOP("cli", "text of the labels, with {model} {id} {rate} {baud} {firmware} "
                                   "{date} {was_id}"),
          "TEXT"}},
        run};
}
} // namespace cli
