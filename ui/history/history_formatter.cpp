// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/history/history_formatter.h"

#include "text/alarm_text.h"
#include "text/language.h"
#include "text/translate.h"
#include "text/write_text.h"
#include "ui/widgets/test_text.h"

#include <QDir>

namespace ui {
using history::HistoryKind;
using text::translate;

namespace {
const QString separator = QStringLiteral(" · ");

QString timeText(const QDateTime& at)
{
    return at.isValid() ? at.toLocalTime().toString(QStringLiteral("yyyy-MM-dd HH:mm:ss"))
                        : QString();
}

QString servoName(const QString& model, int id, const QString& label)
{
    const QString name = QStringLiteral("%1 · ID %2").arg(model).arg(id);
    return label.isEmpty() ? name : name + separator + label;
}

QString snapshotText(history::SnapshotReason reason)
{
    switch (reason) {
    case history::SnapshotReason::Automatic:
        return translate("History", "before a change");
    case history::SnapshotReason::Manual:
        return translate("History", "manual");
    case history::SnapshotReason::Bundle:
        return translate("History", "bundle");
    case history::SnapshotReason::Commission:
        return translate("History", "before commissioning");
    }
    return {};
}

using Details = std::vector<std::pair<QString, QString>>;

/// Header and cell, then the rest; without what is empty.
Details detailsOf(HistoryKind kind, const QStringList& cells, const Details& more)
{
    const QStringList headers = HistoryFormatter::headers(kind);
    Details details;
    for (int i = 0; i < int(cells.size()); ++i)
        details.emplace_back(headers.value(i), cells[i]);
    details.insert(details.end(), more.begin(), more.end());
    std::erase_if(details, [](const auto& one) { return one.second.isEmpty(); });
    return details;
}
} // namespace

QString HistoryLine::tip() const
{
    QStringList lines;
    for (const auto& [name, value] : details)
        lines << (name.isEmpty() ? value : QStringLiteral("%1: %2").arg(name, value));
    return lines.join(QLatin1Char('\n'));
}

QString HistoryLine::title() const
{
    return write ? cells.value(2) : cells.value(0);
}

void HistoryFormatter::addServos(const std::vector<history::HistoryServo>& servos)
{
    m_profiles.add(servos);
    for (const history::HistoryServo& one : servos)
        m_servos[one.number] = one;
}

const history::HistoryServo* HistoryFormatter::servo(std::int64_t number) const
{
    const auto found = m_servos.find(number);
    return found != m_servos.end() ? &found->second : nullptr;
}

int HistoryFormatter::listColumns(HistoryKind kind)
{
    // Outcomes are judged at a glance; how and where a write was made is asked for less often.
    return kind == HistoryKind::Writes ? 6 : int(headers(kind).size());
}

QString HistoryFormatter::kindName(HistoryKind kind)
{
    switch (kind) {
    case HistoryKind::Writes:
        return translate("History", "Writes");
    case HistoryKind::Snapshots:
        return translate("History", "Snapshots");
    case HistoryKind::Runs:
        return translate("History", "Tests");
    case HistoryKind::Alarms:
        return translate("History", "Alarms");
    case HistoryKind::Recordings:
        return translate("History", "Recordings");
    case HistoryKind::Servos:
        return translate("History", "Servos");
    }
    return {};
}

QStringList HistoryFormatter::headers(HistoryKind kind)
{
    const QString time = translate("History", "Time");
    const QString servo = translate("History", "Servo");
    const QString note = translate("History", "Note");
    switch (kind) {
    case HistoryKind::Writes:
        return {time,
                servo,
                translate("History", "Register"),
                translate("History", "Old"),
                translate("History", "New"),
                translate("History", "Result"),
                translate("History", "Type"),
                translate("History", "Port")};
    case HistoryKind::Snapshots:
        return {time,
                servo,
                translate("History", "Reason"),
                translate("History", "Label"),
                note,
                translate("History", "Rows"),
                translate("History", "File")};
    case HistoryKind::Runs:
        return {time,
                translate("History", "Test"),
                translate("History", "Servos"),
                translate("History", "Verdict"),
                translate("History", "Operator"),
                note};
    case HistoryKind::Alarms:
        return {translate("History", "Raised"), translate("History", "Cleared"), servo,
                translate("History", "Alarm"), translate("History", "Port")};
    case HistoryKind::Recordings:
        return {time, translate("History", "Servos"), translate("History", "Duration"),
                translate("History", "Rows"), translate("History", "File")};
    case HistoryKind::Servos:
        return {servo, translate("History", "Firmware"), translate("History", "Label"),
                translate("History", "Last write"), translate("History", "Port")};
    }
    return {};
}

int HistoryFormatter::timeColumn(HistoryKind kind)
{
    return kind == HistoryKind::Servos ? -1 : 0;
}

QString HistoryFormatter::listTime(const QDateTime& at, const QDate& today)
{
    const QDateTime local = at.toLocalTime();
    return local.toString(local.date() == today ? QStringLiteral("HH:mm:ss")
                                                : QStringLiteral("yyyy-MM-dd HH:mm"));
}

int HistoryFormatter::toneColumn(HistoryKind kind)
{
    return kind == HistoryKind::Writes   ? 5
           : kind == HistoryKind::Runs   ? 3
           : kind == HistoryKind::Alarms ? 1
                                         : -1;
}

QString HistoryFormatter::servoTitle(const history::HistoryServo& servo)
{
    return servoName(servo.identity.model, servo.identity.id, servo.label);
}

HistoryLine HistoryFormatter::formatLine(const history::HistoryWrite& row) const
{
    const bool isGood = row.isGood();
    const bool chinese = text::isUiChinese();
    const auto value = [&](std::int64_t raw) { return m_profiles.valueText(row, raw, chinese); };
    const QString sign = isGood                  ? QStringLiteral("✔ ")
                         : row.outcome.isEmpty() ? QStringLiteral("⚠ ")
                                                 : QStringLiteral("✘ ");
    HistoryLine line{row.number, row.servo, row.at};
    line.cells = {timeText(row.at),
                  servoName(row.model, row.servoId, row.label),
                  m_profiles.registerName(row, chinese),
                  value(row.oldRaw),
                  row.newRaw ? value(*row.newRaw) : QStringLiteral("–"),
                  sign + text::writeOutcomeLabel(row.outcome),
                  text::intentLabel(row.kind, row.temporary, row.ownDefaults),
                  row.port};
    line.tone = isGood ? Tone::Good : row.outcome.isEmpty() ? Tone::Warn : Tone::Bad;
    line.details = detailsOf(
        HistoryKind::Writes, line.cells,
        {{translate("History", "Address"), QStringLiteral("%1 (%2)").arg(row.address).arg(row.key)},
         {translate("History", "Read back"), row.readBack ? value(*row.readBack) : QString()},
         {{}, row.detail},
         {translate("History", "Program"), row.program}});
    line.label = row.label;
    line.write = row;
    return line;
}

HistoryLine HistoryFormatter::formatLine(const history::HistorySnapshot& row) const
{
    HistoryLine line{row.number, row.servo, row.at};
    line.cells = {timeText(row.at),
                  servoName(row.model, row.servoId, {}),
                  snapshotText(row.reason),
                  row.label,
                  row.note,
                  QString::number(row.registers),
                  QDir::toNativeSeparators(row.file)};
    line.details = detailsOf(
        HistoryKind::Snapshots, line.cells,
        {{translate("History", "Port"), row.port}, {translate("History", "Program"), row.program}});
    line.label = row.label;
    line.note = row.note;
    return line;
}

HistoryLine HistoryFormatter::formatLine(const history::HistoryAlarm& row) const
{
    const bool isCleared = row.clearedAt.isValid();
    HistoryLine line{row.number, row.servo, row.at};
    line.cells = {timeText(row.at),
                  isCleared ? QStringLiteral("✔ ") + timeText(row.clearedAt)
                            : QStringLiteral("⚠ ") + translate("History", "still active"),
                  servoName(row.model, row.servoId, row.label), text::alarmLabel(row.key),
                  row.port};
    line.tone = isCleared ? Tone::Good : Tone::Warn;
    line.details = detailsOf(
        HistoryKind::Alarms, line.cells,
        {{{},
          row.derived
              ? translate("History",
                          "This alarm is derived from the limits, not reported by the servo.")
              : QString()}});
    line.label = row.label;
    return line;
}

HistoryLine HistoryFormatter::formatLine(const history::HistoryRecording& row) const
{
    QStringList servos;
    for (const history::HistoryRecording::Servo& one : row.servos)
        servos << servoName(one.model, one.id, one.label);
    const double seconds = std::chrono::duration<double>(row.length).count();
    HistoryLine line{row.number, 0, row.at};
    line.cells = {timeText(row.at), servos.join(QStringLiteral(", ")),
                  QStringLiteral("%1 s").arg(seconds, 0, 'f', 1), QString::number(row.rows),
                  QDir::toNativeSeparators(row.file)};
    line.details =
        detailsOf(HistoryKind::Recordings, line.cells, {{translate("History", "Port"), row.port}});
    return line;
}

HistoryLine HistoryFormatter::formatLine(const history::HistoryServo& row) const
{
    HistoryLine line{row.number, row.number, row.lastWrite};
    line.cells = {
        servoName(row.identity.model, row.identity.id, {}),
        QStringLiteral("%1.%2").arg(row.identity.firmwareMajor).arg(row.identity.firmwareMinor),
        row.label, timeText(row.lastWrite), row.identity.port};
    line.details = detailsOf(HistoryKind::Servos, line.cells, {});
    line.label = row.label;
    return line;
}

HistoryLine HistoryFormatter::formatLine(const history::TestRun& row) const
{
    QStringList servos;
    for (const history::TestServo& one : row.servos)
        servos << servoName(one.model, one.id, one.label);
    HistoryLine line{row.number, 0, row.at};
    line.isStepResponse = row.kind == QLatin1StringView("step");
    line.cells = {timeText(row.at),
                  line.isStepResponse ? translate("History", "step response")
                                      : translate("History", "sweep test"),
                  servos.join(QStringLiteral(", ")),
                  line.isStepResponse ? QString() : gradeText(row.verdict),
                  row.operatorName,
                  row.note};
    line.tone = gradeTone(row.verdict);
    line.details = detailsOf(HistoryKind::Runs, line.cells,
                             {{translate("History", "Files"), row.files.join(QLatin1Char('\n'))}});
    line.note = row.note;
    return line;
}
} // namespace ui
