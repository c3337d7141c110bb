// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/history/history_formatter.h"

#include "text/alarm_text.h"
#include "text/language.h"
#include "text/translate.h"
#include "text/write_text.h"
#include "ui/widgets/test_text.h"

#include <QDir>
#include <QFileInfo>

#include <array>

namespace ui {
using history::HistoryKind;
using text::translate;

namespace {
const QString separator = QStringLiteral(" · ");

// Outcomes are judged at a glance; how and where a write was made is asked for less often.
constexpr std::array writeColumns{
    HistoryColumn{QT_TRANSLATE_NOOP("History", "Time"), HistoryCell::Time},
    HistoryColumn{QT_TRANSLATE_NOOP("History", "Servo")},
    HistoryColumn{QT_TRANSLATE_NOOP("History", "Register")},
    HistoryColumn{QT_TRANSLATE_NOOP("History", "Old"), HistoryCell::Number},
    HistoryColumn{QT_TRANSLATE_NOOP("History", "New"), HistoryCell::Number},
    HistoryColumn{QT_TRANSLATE_NOOP("History", "Result"), HistoryCell::Outcome},
    HistoryColumn{QT_TRANSLATE_NOOP("History", "Type"), HistoryCell::Detail},
    HistoryColumn{QT_TRANSLATE_NOOP("History", "Port"), HistoryCell::Detail},
};
constexpr std::array snapshotColumns{
    HistoryColumn{QT_TRANSLATE_NOOP("History", "Time"), HistoryCell::Time},
    HistoryColumn{QT_TRANSLATE_NOOP("History", "Servo")},
    HistoryColumn{QT_TRANSLATE_NOOP("History", "Reason")},
    HistoryColumn{QT_TRANSLATE_NOOP("History", "Label")},
    HistoryColumn{QT_TRANSLATE_NOOP("History", "Note")},
    HistoryColumn{QT_TRANSLATE_NOOP("History", "Rows"), HistoryCell::Number},
    HistoryColumn{QT_TRANSLATE_NOOP("History", "File")},
};
constexpr std::array testColumns{
    HistoryColumn{QT_TRANSLATE_NOOP("History", "Time"), HistoryCell::Time},
    HistoryColumn{QT_TRANSLATE_NOOP("History", "Test")},
    HistoryColumn{QT_TRANSLATE_NOOP("History", "Servos")},
    HistoryColumn{QT_TRANSLATE_NOOP("History", "Verdict"), HistoryCell::Outcome},
    HistoryColumn{QT_TRANSLATE_NOOP("History", "Operator")},
    HistoryColumn{QT_TRANSLATE_NOOP("History", "Note")},
};
constexpr std::array alarmColumns{
    HistoryColumn{QT_TRANSLATE_NOOP("History", "Raised"), HistoryCell::Time},
    HistoryColumn{QT_TRANSLATE_NOOP("History", "Cleared"), HistoryCell::Outcome},
    HistoryColumn{QT_TRANSLATE_NOOP("History", "Servo")},
    HistoryColumn{QT_TRANSLATE_NOOP("History", "Alarm")},
    HistoryColumn{QT_TRANSLATE_NOOP("History", "Port")},
};
constexpr std::array recordingColumns{
    HistoryColumn{QT_TRANSLATE_NOOP("History", "Time"), HistoryCell::Time},
    HistoryColumn{QT_TRANSLATE_NOOP("History", "Servos")},
    HistoryColumn{QT_TRANSLATE_NOOP("History", "Duration"), HistoryCell::Number},
    HistoryColumn{QT_TRANSLATE_NOOP("History", "Rows"), HistoryCell::Number},
    HistoryColumn{QT_TRANSLATE_NOOP("History", "File")},
};
constexpr std::array servoColumns{
    HistoryColumn{QT_TRANSLATE_NOOP("History", "Servo")},
    HistoryColumn{QT_TRANSLATE_NOOP("History", "Firmware")},
    HistoryColumn{QT_TRANSLATE_NOOP("History", "Label")},
    HistoryColumn{QT_TRANSLATE_NOOP("History", "Last write")},
    HistoryColumn{QT_TRANSLATE_NOOP("History", "Port")},
};

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
    const std::span<const HistoryColumn> columns = HistoryFormatter::columns(kind);
    Details details;
    for (std::size_t i = 0; i < columns.size(); ++i)
        details.emplace_back(translate("History", columns[i].header), cells.value(int(i)));
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

std::span<const HistoryColumn> HistoryFormatter::columns(HistoryKind kind)
{
    switch (kind) {
    case HistoryKind::Writes:
        return writeColumns;
    case HistoryKind::Snapshots:
        return snapshotColumns;
    case HistoryKind::Runs:
        return testColumns;
    case HistoryKind::Alarms:
        return alarmColumns;
    case HistoryKind::Recordings:
        return recordingColumns;
    case HistoryKind::Servos:
        return servoColumns;
    }
    return {};
}

QString HistoryFormatter::listTime(const QDateTime& at, const QDate& today)
{
    const QDateTime local = at.toLocalTime();
    return local.toString(local.date() == today ? QStringLiteral("HH:mm:ss")
                                                : QStringLiteral("yyyy-MM-dd HH:mm"));
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
    line.title = line.cells[2];
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
    line.title = line.cells[2];
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
    line.title = text::alarmLabel(row.key);
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
    line.cells = {timeText(row.at), text::joinItems(servos),
                  QStringLiteral("%1 s").arg(seconds, 0, 'f', 1), QString::number(row.rows),
                  QDir::toNativeSeparators(row.file)};
    line.title = QFileInfo(row.file).fileName();
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
    line.title = line.cells[0];
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
                  text::joinItems(servos),
                  line.isStepResponse ? QString() : gradeText(row.verdict),
                  row.operatorName,
                  row.note};
    line.title = line.cells[1];
    line.tone = gradeTone(row.verdict);
    line.details = detailsOf(HistoryKind::Runs, line.cells,
                             {{translate("History", "Files"), row.files.join(QLatin1Char('\n'))}});
    line.note = row.note;
    return line;
}
} // namespace ui
