// SPDX-License-Identifier: GPL-3.0-or-later
#include "files/csv_text.h"
#include "files/json_text.h"
#include "files/text_file.h"
#include "snapshot/snapshot.h"

#include <algorithm>
#include <cmath>

namespace snapshot {
namespace {

QString cellText(std::optional<std::int64_t> raw)
{
    return raw ? QString::number(*raw) : QString();
}

QString cellText(std::optional<double> value)
{
    return value && std::isfinite(*value) ? QString::number(*value, 'g', files::registerValueDigits)
                                          : QString();
}
} // namespace

QByteArray encodeSnapshotCsv(const Snapshot& snapshot)
{
    std::vector<SnapshotRegister> registers = snapshot.registers;
    std::sort(registers.begin(), registers.end(), [](const auto& left, const auto& right) {
        return std::tie(left.address, left.key) < std::tie(right.address, right.key);
    });
    const SnapshotServo& servo = snapshot.servo;
    const QStringList identity{QString::number(servo.id),
                               servo.model,
                               servo.firmware,
                               servo.map,
                               snapshot.label,
                               snapshot.at.toUTC().toString(Qt::ISODate)};
    QByteArray text = "id,model,firmware,map,label,time,key,address,raw,value,unit,area,access\n";
    for (const SnapshotRegister& reg : registers) {
        text += files::csvLine(identity + QStringList{reg.key, QString::number(reg.address),
                                                      cellText(reg.raw), cellText(reg.value),
                                                      reg.unit, catalog::areaName(reg.area),
                                                      catalog::accessName(reg.access)});
    }
    return text;
}

base::Result<void> saveSnapshotCsv(const Snapshot& snapshot, const QString& path)
{
    const QByteArray text = files::csvStart(files::CsvReader::Spreadsheet);
    return files::saveTextFile(QStringLiteral("save-snapshot"), text + encodeSnapshotCsv(snapshot),
                               path);
}
} // namespace snapshot
