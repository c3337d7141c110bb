// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/snapshot_report.h"

#include "catalog/value.h"
#include "report/bilingual.h"
#include "report/register_name.h"
#include "report/report_file.h"
#include "report/sweep_text.h"
#include "snapshot/factory_snapshot.h"

namespace report {
using catalog::Text;
using snapshot::Snapshot;
using snapshot::SnapshotRegister;

namespace {
QString about(const HtmlWriter& htmlWriter, const Snapshot& snapshot)
{
    const SweepTexts& words = sweepTexts();
    const snapshot::SnapshotServo& servo = snapshot.servo;
    const std::vector<QStringList> left{
        {htmlWriter.htmlText(words.model), escaped(servo.model)},
        {htmlWriter.htmlText(words.id),
         servo.id < 0 ? QStringLiteral("–") : QString::number(servo.id)},
        {htmlWriter.htmlText(words.firmware), escaped(servo.firmware)},
        {htmlWriter.htmlText(words.protocol), htmlWriter.htmlText(protocolText(servo.protocol))}};
    std::vector<QStringList> right;
    if (snapshot.at.isValid())
        right.push_back({htmlWriter.htmlText(words.date), localTime(snapshot.at)});
    if (!snapshot.port.isEmpty())
        right.push_back({htmlWriter.htmlText(words.port), escaped(snapshot.port)});
    if (snapshot.baud > 0)
        right.push_back({htmlWriter.htmlText(translate("SnapshotReport", "Baud rate")),
                         QString::number(snapshot.baud)});
    if (!snapshot.label.isEmpty())
        right.push_back({htmlWriter.htmlText(words.label), userText(snapshot.label)});
    if (!snapshot.note.isEmpty())
        right.push_back({htmlWriter.htmlText(words.note), userText(snapshot.note)});
    if (!snapshot.program.isEmpty())
        right.push_back({htmlWriter.htmlText(words.program), escaped(snapshot.program)});
    return sideBySide(htmlWriter, keyValueTable(left), keyValueTable(right));
}

/// In words where the map has them: "8.5 V", "position".
Text valueText(const Snapshot& snapshot, const catalog::ProfilePtr& profile,
               const SnapshotRegister& row)
{
    const catalog::Register* reg = profile ? profile->find(row.key) : nullptr;
    if (reg != nullptr && row.raw) {
        const auto rawOf = [&](const QString& key) -> std::optional<std::int64_t> {
            const SnapshotRegister* other = snapshot.find(key);
            return other != nullptr ? other->raw : std::nullopt;
        };
        const catalog::ValueFormat format = catalog::valueFormat(*reg, *profile, rawOf);
        // A template may lack the register that decides the unit; its own value knew it.
        if (!format.assumed || !row.value)
            return {catalog::formatValue(*row.raw, *reg, format, false),
                    catalog::formatValue(*row.raw, *reg, format, true)};
    }
    if (!row.value)
        return inBoth(QStringLiteral("–"));
    const Text unit = registerUnit(row.unit);
    return unit.en.isEmpty()
               ? inBoth(exactNumber(*row.value))
               : filled(inBoth(QStringLiteral("%1 %2")), inBoth(exactNumber(*row.value)), unit);
}

/// Rows from `first` to `end`, below the name of their area.
QString column(const HtmlWriter& htmlWriter, const Snapshot& snapshot,
               const catalog::ProfilePtr& profile, std::size_t first, std::size_t end)
{
    const SweepTexts& words = sweepTexts();
    const QStringList headings{htmlWriter.htmlText(words.address), htmlWriter.htmlText(words.name),
                               htmlWriter.htmlText(words.value), htmlWriter.htmlText(words.raw)};
    QString markup;
    while (first < end) {
        const catalog::Area area = snapshot.registers[first].area;
        std::vector<QStringList> rows;
        for (; first < end && snapshot.registers[first].area == area; ++first) {
            const SnapshotRegister& row = snapshot.registers[first];
            rows.push_back({QString::number(row.address),
                            htmlWriter.htmlText(registerName(snapshot.servo, row.key)),
                            htmlWriter.htmlText(valueText(snapshot, profile, row)),
                            row.raw ? QString::number(qint64(*row.raw)) : QStringLiteral("–")});
        }
        const Text name = areaText(area);
        markup +=
            htmlWriter.heading(3, {text::capitalized(name.en), name.zh}) + table(headings, rows);
    }
    return markup;
}

QString body(const HtmlWriter& htmlWriter, const Snapshot& snapshot,
             const catalog::ProfilePtr& profile, const Text& title)
{
    const bool isSimulated = snapshot.port.startsWith(QLatin1String("sim:"));
    const std::size_t half = (snapshot.registers.size() + 1) / 2;
    return htmlWriter.heading(1, title) +
           (isSimulated ? QStringLiteral("<p class=\"simulated\">%1</p>\n")
                              .arg(htmlWriter.htmlText(
                                  translate("SnapshotReport", "SIMULATED: not a real servo")))
                        : QString()) +
           about(htmlWriter, snapshot) +
           sideBySide(htmlWriter, column(htmlWriter, snapshot, profile, 0, half),
                      column(htmlWriter, snapshot, profile, half, snapshot.registers.size()));
}
} // namespace

base::Result<void> saveSnapshotReport(const Snapshot& snapshot, const catalog::Catalog& catalog,
                                      bool chinese, const QString& path)
{
    const catalog::ProfilePtr profile = snapshot::profileOf(snapshot, catalog);
    const Text kind = snapshot.isTemplate ? translate("SnapshotReport", "Template")
                                          : translate("SnapshotReport", "Servo snapshot");
    Text title = filled(inBoth(QStringLiteral("%1 · %2")), kind, inBoth(snapshot.servo.model));
    if (snapshot.servo.id >= 0)
        title = filled(inBoth(QStringLiteral("%1 · ID %2")), title,
                       inBoth(QString::number(snapshot.servo.id)));
    return saveReport(
        {title, snapshot.program, snapshot.at},
        [&](const HtmlWriter& htmlWriter, const EmbedChart&) {
            return body(htmlWriter, snapshot, profile, title);
        },
        chinese, path);
}
} // namespace report
