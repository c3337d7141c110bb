// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/memory/memory_sheet.h"

#include "text/translate.h"

#include <QRegularExpression>

namespace ui {
using text::translate;

namespace {
QString servoName(const session::ServoEntry& entry)
{
    return entry.servo.profile ? entry.servo.profile->modelName : QStringLiteral("servo");
}

QStringList cellsOf(const MemoryRow& row)
{
    QStringList cells{QString::number(row.reg->address), row.reg->key};
    for (int i = static_cast<int>(MemoryColumn::Name); i < memoryColumns; ++i) {
        const auto column = static_cast<MemoryColumn>(i);
        if (column == MemoryColumn::Name)
            cells << registerName(row);
        else if (column == MemoryColumn::Value)
            cells << (row.raw ? QString::number(*row.raw) : QString());
        else
            cells << memoryText(row, column, false);
    }
    return cells;
}
} // namespace

TableSheet memorySheet(const MemoryModel& model, const std::vector<int>& rows,
                       const session::ServoEntry& entry, const QDateTime& at)
{
    const device::Servo& servo = entry.servo;
    TableSheet sheet;
    sheet.title = translate("MemorySheet", "Memory table of %1, ID %2")
                      .arg(servoName(entry), QString::number(servo.id));
    if (servo.profile)
        sheet.captionLines << translate("MemorySheet", "Firmware %1, register map %2")
                                  .arg(servo.profile->identity.firmware(), servo.profile->mapKey);
    sheet.captionLines << translate("MemorySheet", "Port %1, %2 baud")
                              .arg(servo.port, QString::number(servo.baud));
    sheet.captionLines << translate("MemorySheet", "Created %1")
                              .arg(at.toString(QStringLiteral("yyyy-MM-dd HH:mm:ss")));
    sheet.headers << memoryHeader(MemoryColumn::Address) << translate("MemorySheet", "Key");
    sheet.numeric = {true, false};
    for (int i = static_cast<int>(MemoryColumn::Name); i < memoryColumns; ++i) {
        const auto column = static_cast<MemoryColumn>(i);
        sheet.headers << memoryHeader(column);
        sheet.numeric.push_back(column == MemoryColumn::Value || column == MemoryColumn::Physical ||
                                column == MemoryColumn::Default);
    }
    for (const int row : rows)
        sheet.rows.push_back(cellsOf(model.row(row)));
    return sheet;
}

QString memoryFileName(const session::ServoEntry& entry, const QDateTime& at)
{
    static const QRegularExpression invalidChars(QStringLiteral("[^A-Za-z0-9_.-]"));
    QString model = servoName(entry);
    model.replace(invalidChars, QStringLiteral("_"));
    return QStringLiteral("%1-id%2-%3")
        .arg(model)
        .arg(entry.servo.id)
        .arg(at.toString(QStringLiteral("yyyy-MM-dd")));
}
} // namespace ui
