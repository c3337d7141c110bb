// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/commands.h"
#include "cli/input/arguments.h"
#include "cli/output/report_text.h"
#include "cli/output/table.h"
#include "cli/run.h"
#include "cli/translate.h"
#include "device/write_access.h"
#include "jobs/restore/take_snapshot.h"
#include "report/report_file.h"
#include "report/snapshot_report.h"
#include "session/snapshot/safety_snapshot.h"
#include "text/language.h"
#include "text/notice_text.h"

#include <QFileInfo>

namespace cli {
namespace {
base::Result<Exit> runSave(Run& run, const Values& values)
{
    auto servo = run.servo(values);
    if (!servo)
        return tl::unexpected(servo.error());
    const QString file = values.argument("FILE");
    const auto context = run.context();
    if (!context)
        return tl::unexpected(context.error());
    const auto alone = device::requireUniqueId(*context, *servo, QStringLiteral("snapshot"));
    if (!alone)
        return tl::unexpected(alone.error());
    auto snapshot = jobs::takeSnapshot(*context, *servo, session::programName());
    if (!snapshot)
        return tl::unexpected(snapshot.error());
    snapshot->label = values.option("--label").value_or(QString());
    snapshot->note = values.option("--note").value_or(QString());
    if (const auto saved = snapshot::saveSnapshot(*snapshot, file); !saved)
        return tl::unexpected(saved.error());
    session::addToHistory(*snapshot, history::SnapshotReason::Manual,
                          QFileInfo(file).absoluteFilePath());
    const auto count = static_cast<int>(snapshot->registers.size());
    run.finish(Json::object().add("id", servo->id).add("file", file).add("registers", count),
               translate("cli", "Servo %1, %2: %n register(s) saved to %3", nullptr, int(count))
                       .arg(QString::number(servo->id), servoTitle(*servo), file) +
                   QLatin1Char('\n'));
    return Exit::Success;
}

Json jsonRow(const snapshot::SnapshotRegister& row)
{
    return Json::object()
        .add("key", row.key)
        .add("address", row.address)
        .add("raw", row.raw)
        .add("value", row.value)
        .add("unit", row.unit)
        .add("area", catalog::areaName(row.area))
        .add("access", catalog::accessName(row.access));
}

Json jsonSnapshot(const snapshot::Snapshot& snapshot)
{
    Json::Array rows;
    for (const snapshot::SnapshotRegister& row : snapshot.registers)
        rows.push_back(jsonRow(row));
    return Json::object()
        .add("id", snapshot.servo.id)
        .add("model", snapshot.servo.model)
        .add("model_id", snapshot.servo.modelId)
        .add("firmware", snapshot.servo.firmware)
        .add("map", snapshot.servo.map)
        .add("protocol", snapshot.servo.protocol)
        .add("label", snapshot.label)
        .add("note", snapshot.note)
        .add("program", snapshot.program)
        .add("template", snapshot.isTemplate)
        .add("at", snapshot.at.toString(Qt::ISODate))
        .add("port", snapshot.port)
        .add("baud", snapshot.baud)
        .add("registers", std::move(rows));
}

QString snapshotText(const snapshot::Snapshot& snapshot)
{
    Table table({translate("cli", "Address"), translate("cli", "Key"), translate("cli", "Value"),
                 translate("cli", "Unit"), translate("cli", "Raw"), translate("cli", "Area"),
                 translate("cli", "Access")});
    table.alignRight({0, 2, 4});
    for (const snapshot::SnapshotRegister& row : snapshot.registers) {
        table.add({QString::number(row.address), row.key,
                   row.value ? QString::number(*row.value, 'g', 8) : noValue(), row.unit,
                   row.raw ? QString::number(*row.raw) : noValue(), text::areaLabel(row.area),
                   text::accessLabel(row.access)});
    }
    const snapshot::SnapshotServo& servo = snapshot.servo;
    QString about;
    if (!snapshot.label.isEmpty())
        about += translate("cli", "Label: %1").arg(snapshot.label.simplified()) + QLatin1Char('\n');
    if (!snapshot.note.isEmpty())
        about += translate("cli", "Note: %1").arg(snapshot.note) + QLatin1Char('\n');
    return translate("cli", "Servo %1: %2 (%3), firmware %4, read on port %5 at %6")
               .arg(servo.id)
               .arg(servo.model, servo.modelId, servo.firmware, snapshot.port,
                    localTime(snapshot.at)) +
           QLatin1Char('\n') + about + table.text();
}

base::Result<Exit> runShow(Run& run, const Values& values)
{
    const auto path = values.option("--report");
    if (path && !report::isReportPath(*path))
        return badArgument(translate("cli", "the report file name must end with .html or .pdf"));
    const auto snapshot = snapshot::loadSnapshot(values.argument("FILE"));
    if (!snapshot)
        return tl::unexpected(snapshot.error());
    if (path) {
        const auto saved = report::saveSnapshotReport(*snapshot, run.session().catalog(),
                                                      text::isUiChinese(), *path);
        if (!saved)
            return tl::unexpected(saved.error());
    }
    if (values.has("--csv") && !run.console().isJson()) {
        run.console().write(snapshot::encodeSnapshotCsv(*snapshot));
        return Exit::Success;
    }
    run.finish(
        jsonSnapshot(*snapshot),
        snapshotText(*snapshot) +
            (path ? translate("cli", "Report: %1").arg(*path) + QLatin1Char('\n') : QString()));
    return Exit::Success;
}
} // namespace

Command snapshotSaveCommand()
{
    return {"snapshot save",
            QT_TRANSLATE_NOOP("cli", "save all registers of a servo to a file"),
            {servoIdArgument, outputFileArgument},
            {{"--label", QT_TRANSLATE_NOOP("cli", "label saved in the file"), "TEXT"},
             {"--note", QT_TRANSLATE_NOOP("cli", "note saved in the file"), "TEXT"}},
            runSave};
}

Command snapshotShowCommand()
{
    return {"snapshot show",
            QT_TRANSLATE_NOOP("cli", "show a saved file; no port is needed"),
            {{"FILE", QT_TRANSLATE_NOOP("cli", "file created by \"snapshot save\"")}},
            {{"--csv", QT_TRANSLATE_NOOP("cli", "output as CSV, without a byte order mark")},
             {"--report", QT_TRANSLATE_NOOP("cli", "also save the memory table as a report"),
              "FILE.html|pdf"}},
            runShow};
}
} // namespace cli
