// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/commands.h"
#include "cli/exit_code.h"
#include "cli/input/arguments.h"
#include "cli/output/progress.h"
#include "cli/output/report_text.h"
#include "cli/output/restore_text.h"
#include "cli/run.h"
#include "cli/translate.h"
#include "jobs/firmware/firmware_preflight.h"
#include "jobs/firmware/firmware_update.h"
#include "jobs/restore/take_snapshot.h"
#include "session/battery.h"
#include "session/snapshot/safety_snapshot.h"
#include "text/error_text.h"
#include "text/firmware_text.h"
#include "text/language.h"

#include <algorithm>
#include <set>

namespace cli {
namespace {
using base::FirmwareCheck;
using base::FirmwareCheckResult;
using base::FirmwareOutcome;

constexpr Positional firmwareFileArgument{
    "FILE", QT_TRANSLATE_NOOP("cli", "the vendor's firmware file, *.bin")};

base::Result<std::set<FirmwareCheck>> acceptedChecks(const Values& values)
{
    std::set<FirmwareCheck> accepted;
    const QString words = values.option("--accept").value_or(QString());
    for (const QString& word : words.split(QLatin1Char(','), Qt::SkipEmptyParts)) {
        const bool isAll = word == QLatin1String("all");
        if (!isAll && !base::firmwareCheckOf(word))
            return badArgument(translate("cli", "--accept takes %1, or all")
                                   .arg(text::joinItems(base::firmwareCheckNames())));
        for (const QString& name : base::firmwareCheckNames()) {
            if (isAll || name == word)
                accepted.insert(*base::firmwareCheckOf(name));
        }
    }
    return accepted;
}

Json jsonCheck(const FirmwareCheckResult& result, bool isAccepted)
{
    return Json::object()
        .add("check", base::firmwareCheckName(result.check))
        .add("passed", result.isPassed)
        .add("accepted", !result.isPassed && isAccepted)
        .add("text", text::firmwareCheckText(result));
}

Json jsonReport(const jobs::FirmwareReport& report)
{
    Json json = Json::object()
                    .add("outcome", base::firmwareOutcomeName(report.outcome))
                    .add("blocks", report.blocks)
                    .add("accepted_blocks", report.acceptedBlocks)
                    .add("repeats", report.repeats);
    if (report.servo) {
        json.add("id", report.servo->id)
            .add("baud", report.servo->baud)
            .add("firmware", report.servo->profile->identity.firmware());
    }
    if (report.error)
        json.add("error", jsonError(*report.error));
    return json;
}

QString reportText(const jobs::FirmwareReport& report, const QString& path)
{
    QStringList lines{text::firmwareOutcomeText(report.outcome)};
    if (report.servo && report.outcome == FirmwareOutcome::Updated)
        lines << translate("cli", "Servo %1 at %2 baud: firmware %3")
                     .arg(report.servo->id)
                     .arg(report.servo->baud)
                     .arg(report.servo->profile->identity.firmware());
    if (report.outcome != FirmwareOutcome::Updated) {
        lines << translate("cli", "%1 of %2 blocks were accepted.")
                     .arg(report.acceptedBlocks)
                     .arg(report.blocks);
        if (report.error)
            lines << text::describe(*report.error).message;
    }
    const QString remedy = text::firmwareOutcomeRemedy(report.outcome);
    if (!remedy.isEmpty())
        lines << remedy;
    if (report.outcome == FirmwareOutcome::Incomplete || report.outcome == FirmwareOutcome::Unknown)
        lines << translate("cli", "Rescue: servodesk-cli firmware rescue \"%1\"").arg(path);
    return lines.join(QLatin1Char('\n')) + QLatin1Char('\n');
}

Exit exitOf(const jobs::FirmwareReport& report)
{
    if (report.outcome == FirmwareOutcome::Updated)
        return Exit::Success;
    return report.outcome == FirmwareOutcome::Unknown ? Exit::NoReply : Exit::Failed;
}

/// One servo after the other.
class FirmwareUpdates {
public:
    FirmwareUpdates(Run& run, const jobs::FirmwareFile& file, std::set<FirmwareCheck> accepted)
        : m_run(run)
        , m_file(file)
        , m_accepted(std::move(accepted))
    {}

    base::Result<Exit> run(const std::vector<int>& ids)
    {
        m_run.console().printMessage(text::firmwareUntriedText());
        Exit exit = Exit::Success;
        for (const int id : ids) {
            m_servo = Json::object().add("id", id);
            if (exit != Exit::Success) {
                addNotStarted();
                continue;
            }
            const auto done = update(id);
            if (!done && ids.size() == 1 && m_text.isEmpty())
                return done;
            if (!done)
                addFailed(done.error());
            exit = done ? *done : exitCode(done.error().code);
        }
        m_run.finish(Json::object().add("file", m_file.path).add("servos", std::move(m_servos)),
                     m_text);
        return exit;
    }

private:
    base::Result<Exit> update(int id)
    {
        const auto context = m_run.context();
        if (!context)
            return tl::unexpected(context.error());
        auto servo = m_run.servoWithSettings(id);
        if (!servo)
            return tl::unexpected(servo.error());
        m_servo = Json::object().add("id", id).add("firmware_before",
                                                   servo->profile->identity.firmware());
        m_text +=
            translate("cli", "Servo %1: %2").arg(id).arg(servoTitle(*servo)) + QLatin1Char('\n');
        const auto may = check(*context, *servo);
        if (!may)
            return tl::unexpected(may.error());
        if (!*may) {
            addNotStarted();
            m_text += translate("cli", "Not started. Correct what has failed, or accept the risk "
                                       "with --accept ITEM.") +
                      QLatin1Char('\n');
            return Exit::Failed;
        }
        const auto before = jobs::snapshotOf(*servo, session::programName());
        base::Result<jobs::FirmwareReport> report;
        {
            ProgressLine progress(m_run.console(),
                                  translate("cli", "Updating the firmware of servo %1").arg(id));
            report = jobs::updateFirmware(*context, *servo, m_file, session::programName(),
                                          [&](const jobs::Progress& now) { progress.update(now); });
        }
        if (!report)
            return tl::unexpected(report.error());
        add(before, *report);
        return exitOf(*report);
    }

    /// False: a check has failed that was not accepted.
    base::Result<bool> check(const device::Context& context, device::Servo& servo)
    {
        if (const auto possible = jobs::requireBootloader(servo); !possible)
            return tl::unexpected(possible.error());
        const auto saved = session::saveSafetySnapshot(context, servo);
        m_savedTable = saved.value_or(QString());
        if (saved)
            m_run.console().printNote(
                translate("cli", "Present settings saved to %1").arg(m_savedTable));
        m_servo.add("snapshot", saved ? Json(m_savedTable) : Json());
        ProgressLine progress(m_run.console(), translate("cli", "Checking"));
        const auto checks = jobs::checkFirmwareUpdate(
            context, servo,
            {m_file, saved.map([](const QString&) {}), session::lowBatteryPercent()},
            [&](const jobs::Progress& now) { progress.update(now); });
        if (!checks)
            return tl::unexpected(checks.error());
        Table table(
            {translate("cli", "Item"), translate("cli", "Result"), translate("cli", "Details")});
        Json::Array items;
        bool isGood = true;
        for (const FirmwareCheckResult& one : *checks) {
            const bool isAccepted = m_accepted.count(one.check) > 0;
            isGood &= one.isPassed || isAccepted;
            items.push_back(jsonCheck(one, isAccepted));
            table.add({base::firmwareCheckName(one.check),
                       one.isPassed ? translate("cli", "good")
                       : isAccepted ? translate("cli", "accepted")
                                    : translate("cli", "failed"),
                       text::firmwareCheckText(one)});
        }
        m_servo.add("checks", std::move(items));
        m_text += table.text();
        return isGood;
    }

    void add(const snapshot::Snapshot& before, const jobs::FirmwareReport& report)
    {
        m_text += reportText(report, m_file.path);
        m_servo.add("update", jsonReport(report));
        m_servo.add("outcome", base::firmwareOutcomeName(report.outcome));
        if (report.table) {
            const auto changed = jobs::changedSettings(before, *report.table);
            Table table(
                {translate("cli", "Key"), translate("cli", "Before"), translate("cli", "Now")});
            Json::Array rows;
            for (const snapshot::CompareRow& row : changed) {
                rows.push_back(Json::object()
                                   .add("key", row.key)
                                   .add("before", row.cells[0].raw)
                                   .add("now", row.cells[1].raw));
                table.add({row.key,
                           formatNumber(row.cells[0].raw, row.cells[0].value, row.cells[0].unit),
                           formatNumber(row.cells[1].raw, row.cells[1].value, row.cells[1].unit)});
            }
            m_servo.add("changed", std::move(rows));
            m_text += text::firmwareChangesText(int(changed.size())) + QLatin1Char('\n');
            if (!changed.empty())
                m_text += table.text();
            if (!changed.empty() && !m_savedTable.isEmpty())
                m_text += translate("cli", "To restore the old values: servodesk-cli snapshot "
                                           "restore %1 \"%2\"")
                              .arg(before.servo.id)
                              .arg(m_savedTable) +
                          QLatin1Char('\n');
        } else if (report.outcome == FirmwareOutcome::Updated) {
            m_text += text::firmwareTableUnreadText() + QLatin1Char('\n');
        }
        m_servos.push_back(std::move(m_servo));
    }

    void addNotStarted()
    {
        m_servos.push_back(std::move(m_servo.add("outcome", QStringLiteral("not-started"))));
    }

    void addFailed(const base::Error& error)
    {
        m_servo.add("error", jsonError(error));
        addNotStarted();
        m_text += errorText(error);
    }

    Run& m_run;
    const jobs::FirmwareFile& m_file;
    const std::set<FirmwareCheck> m_accepted;
    Json m_servo = Json::object(); ///< the present one
    QString m_savedTable;          ///< its file; empty: not saved
    Json::Array m_servos;
    QString m_text;
};

base::Result<Exit> runFirmwareUpdate(Run& run, const Values& values)
{
    const auto ids = parseIds(values.arguments(servoIdArgument.name));
    if (!ids)
        return tl::unexpected(ids.error());
    const auto accepted = acceptedChecks(values);
    if (!accepted)
        return tl::unexpected(accepted.error());
    const auto file = jobs::loadFirmwareFile(values.argument(firmwareFileArgument.name));
    if (!file)
        return tl::unexpected(file.error());
    return FirmwareUpdates(run, *file, *accepted).run(*ids);
}

base::Result<Exit> runFirmwareRescue(Run& run, const Values& values)
{
    const auto file = jobs::loadFirmwareFile(values.argument(firmwareFileArgument.name));
    if (!file)
        return tl::unexpected(file.error());
    const auto context = run.context();
    if (!context)
        return tl::unexpected(context.error());
    run.console().printMessage(text::firmwareUntriedText());
    run.console().printMessage(
        translate("cli", "Connect only the servo to rescue. Turn its supply off, then on again "
                         "within the next 30 s."));
    base::Result<jobs::FirmwareReport> report;
    {
        ProgressLine progress(run.console(), translate("cli", "Waiting for a bootloader"));
        report = jobs::rescueFirmware(*context, *file, session::programName(),
                                      [&](const jobs::Progress& now) { progress.update(now); });
    }
    if (!report)
        return tl::unexpected(report.error());
    run.finish(jsonReport(*report).add("file", file->path), reportText(*report, file->path));
    return exitOf(*report);
}
} // namespace

Command firmwareUpdateCommand()
{
    return {"firmware update",
            QT_TRANSLATE_NOOP("cli", "write the vendor's firmware file to Feetech servos, after "
                                     "checks; not tried on real servos yet"),
            {firmwareFileArgument,
             {"ID", QT_TRANSLATE_NOOP("cli", "IDs of the servos, one after the other"), 1, many}},
            {{"--accept", QT_TRANSLATE_NOOP("cli", "start although these checks have failed"),
              "ITEM,…|all"}},
            runFirmwareUpdate};
}

Command firmwareRescueCommand()
{
    return {"firmware rescue",
            QT_TRANSLATE_NOOP("cli", "write the vendor's firmware file to a servo that is in its "
                                     "bootloader; not tried on real servos yet"),
            {firmwareFileArgument},
            {},
            runFirmwareRescue};
}
} // namespace cli
