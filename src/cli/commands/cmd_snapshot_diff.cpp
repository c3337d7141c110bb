// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/commands.h"
#include "cli/input/arguments.h"
#include "cli/output/restore_text.h"
#include "cli/output/table.h"
#include "cli/run.h"
#include "cli/translate.h"
#include "jobs/restore/take_snapshot.h"
#include "session/snapshot/safety_snapshot.h"
#include "snapshot/factory_snapshot.h"
#include "snapshot/snapshot_compare.h"
#include "text/restore_text.h"

#include <deque>

namespace cli {
namespace {
const QLatin1String factoryText("default");

struct Column {
    QString title;
    QString source; ///< "servo", "file", "default"
    snapshot::Snapshot table;
    catalog::ProfilePtr profile; ///< null: the map of a file is unknown
};

base::Result<Column> fromServo(Run& run, const QString& word, int id)
{
    auto servo = run.servo(id);
    if (!servo)
        return tl::unexpected(servo.error());
    const auto context = run.context();
    auto table = jobs::takeSnapshot(*context, *servo, session::programName());
    if (!table)
        return tl::unexpected(table.error());
    return Column{translate("cli", "Servo %1").arg(word), QStringLiteral("servo"),
                  std::move(*table), servo->profile};
}

base::Result<Column> fromFile(Run& run, const QString& file)
{
    auto table = snapshot::loadSnapshot(file);
    if (!table)
        return tl::unexpected(table.error());
    catalog::ProfilePtr profile = snapshot::profileOf(*table, run.session().catalog());
    return Column{file, QStringLiteral("file"), std::move(*table), std::move(profile)};
}

/// The defaults of the model of the first other side.
base::Result<void> fillDefaults(std::deque<Column>& columns)
{
    catalog::ProfilePtr kind;
    for (const Column& column : columns) {
        if (!kind && column.source != factoryText)
            kind = column.profile;
    }
    for (Column& column : columns) {
        if (column.source != factoryText)
            continue;
        if (!kind)
            return badArgument(translate("cli", "\"default\" must be combined with a servo, or "
                                                "with a file of a known model"));
        column.table = snapshot::factorySnapshot(*kind);
        column.profile = kind;
    }
    return {};
}

base::Result<std::deque<Column>> readColumns(Run& run, const QStringList& words)
{
    std::deque<Column> columns;
    for (const QString& word : words) {
        bool number = false;
        word.toInt(&number);
        if (word == factoryText) {
            columns.push_back({translate("cli", "Factory default"), factoryText, {}, nullptr});
            continue;
        }
        const auto id = number ? parseId(word) : base::Result<int>(-1);
        if (!id)
            return tl::unexpected(id.error());
        auto column = number ? fromServo(run, word, *id) : fromFile(run, word);
        if (!column)
            return tl::unexpected(column.error());
        columns.push_back(std::move(*column));
    }
    if (const auto filled = fillDefaults(columns); !filled)
        return tl::unexpected(filled.error());
    return columns;
}

Json jsonColumn(const Column& column)
{
    const snapshot::SnapshotServo& servo = column.table.servo;
    return Json::object()
        .add("source", column.source)
        .add("title", column.title)
        .add("id", servo.id < 0 ? Json() : Json(servo.id))
        .add("model", servo.model)
        .add("firmware", servo.firmware)
        .add("map", servo.map);
}

Json jsonComparison(const snapshot::SnapshotComparison& comparison,
                    const std::deque<Column>& columns)
{
    Json::Array heads;
    for (const Column& column : columns)
        heads.push_back(jsonColumn(column));
    Json::Array rows;
    for (const snapshot::CompareRow& row : comparison.rows) {
        Json::Array cells;
        for (const snapshot::CompareCell& cell : row.cells) {
            cells.push_back(Json::object()
                                .add("state", snapshot::cellStateName(cell.state))
                                .add("raw", cell.raw)
                                .add("value", cell.value)
                                .add("unit", cell.unit));
        }
        rows.push_back(Json::object()
                           .add("key", row.key)
                           .add("address", row.address)
                           .add("verdict", snapshot::verdictName(row.verdict))
                           .add("cells", std::move(cells)));
    }
    return Json::object()
        .add("columns", std::move(heads))
        .add("different", comparison.different)
        .add("missing", comparison.missing)
        .add("unknown", comparison.unknown)
        .add("identical", comparison.identical)
        .add("read_only", comparison.readOnly)
        .add("rows", std::move(rows));
}

QString cellText(const snapshot::CompareCell& cell)
{
    switch (cell.state) {
    case snapshot::CellState::Known:
        return formatNumber(cell.raw, cell.value, cell.unit);
    case snapshot::CellState::Unknown:
        return QStringLiteral("?");
    case snapshot::CellState::Missing:
        return noValue();
    case snapshot::CellState::NotChosen:
        break;
    }
    return {};
}

QString comparisonText(const snapshot::SnapshotComparison& comparison,
                       const std::deque<Column>& columns, bool all)
{
    QStringList header{QString(), translate("cli", "Address"), translate("cli", "Key")};
    QSet<int> right{1};
    for (const Column& column : columns) {
        right.insert(int(header.size()));
        header << column.title;
    }
    Table table(header);
    table.alignRight(right);
    for (const snapshot::CompareRow& row : comparison.rows) {
        const bool interesting = row.verdict == snapshot::RowVerdict::Different ||
                                 row.verdict == snapshot::RowVerdict::Missing;
        if (!all && !interesting)
            continue;
        QStringList cells{text::compareVerdictSymbol(snapshot::verdictName(row.verdict)),
                          QString::number(row.address), row.key};
        for (const snapshot::CompareCell& cell : row.cells)
            cells << cellText(cell);
        table.add(cells);
    }
    return (table.empty() ? QString() : table.text()) +
           translate("cli", "%1 different, %2 missing, %3 unknown, %4 identical, %5 read-only")
               .arg(comparison.different)
               .arg(comparison.missing)
               .arg(comparison.unknown)
               .arg(comparison.identical)
               .arg(comparison.readOnly) +
           QLatin1Char('\n');
}

base::Result<Exit> runDiff(Run& run, const Values& values)
{
    const QStringList words = values.arguments("WHAT");
    if (words.size() < 2)
        return badArgument(
            translate("cli", "specify at least two sources: files, IDs or \"default\""));
    const auto columns = readColumns(run, words);
    if (!columns)
        return tl::unexpected(columns.error());
    std::vector<const snapshot::Snapshot*> tables;
    for (const Column& column : *columns)
        tables.push_back(&column.table);
    const snapshot::SnapshotComparison comparison = snapshot::compareSnapshots(tables);
    run.finish(jsonComparison(comparison, *columns),
               comparisonText(comparison, *columns, values.has("--all")));
    return Exit::Success;
}
} // namespace

Command snapshotDiffCommand()
{
    return {
        "snapshot diff",
        QT_TRANSLATE_NOOP(
            "cli",
            "compare memory tables from files, servos and the factory defaults side by side"),
        {{"WHAT",
          QT_TRANSLATE_NOOP(
              "cli",
              "two or more sources: file, ID (reads the servo) or default; ./5 is a file named 5"),
          1, many}},
        {{"--all", QT_TRANSLATE_NOOP("cli", "also show rows that are identical, unknown or "
                                            "read-only")}},
        runDiff};
}
} // namespace cli
