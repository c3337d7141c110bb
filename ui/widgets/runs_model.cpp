// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/runs_model.h"

#include "text/translate.h"
#include "ui/widgets/test_text.h"

namespace ui {
using text::translate;

namespace {
int alignmentOf(RunColumn column)
{
    const bool number = column == RunColumn::Number || column == RunColumn::Servo;
    return int(Qt::AlignVCenter | (number ? Qt::AlignRight : Qt::AlignLeft));
}
} // namespace

void RunsModel::show(std::vector<history::TestRun> runs)
{
    beginResetModel();
    m_runs = std::move(runs);
    m_rows.clear();
    for (std::size_t run = 0; run < m_runs.size(); ++run) {
        for (std::size_t servo = 0; servo < m_runs[run].servos.size(); ++servo)
            m_rows.push_back({run, servo});
    }
    endResetModel();
}

void RunsModel::retranslate()
{
    Q_EMIT headerDataChanged(Qt::Horizontal, 0, columnCount() - 1);
    if (rowCount() > 0)
        Q_EMIT dataChanged(index(0, 0), index(rowCount() - 1, columnCount() - 1));
}

const history::TestServo& RunsModel::servo(int row) const
{
    const RowIndex& place = m_rows.at(std::size_t(row));
    return m_runs[place.run].servos[place.servo];
}

int RunsModel::rowOf(const RunRow& wantedRow) const
{
    for (int row = 0; row < rowCount(); ++row) {
        if (at(row) == wantedRow)
            return row;
    }
    return -1;
}

int RunsModel::rowCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : static_cast<int>(m_rows.size());
}

int RunsModel::columnCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : static_cast<int>(RunColumn::Count);
}

QString RunsModel::cell(int row, RunColumn column) const
{
    const history::TestRun& test = run(row);
    const history::TestServo& one = servo(row);
    switch (column) {
    case RunColumn::Number:
        return QString::number(qint64(test.number));
    case RunColumn::When:
        return test.at.toLocalTime().toString(QStringLiteral("yyyy-MM-dd HH:mm:ss"));
    case RunColumn::Servo:
        return QString::number(one.id);
    case RunColumn::Model:
        return test.simulated ? translate("ui::RunListDialog", "%1 (simulated)").arg(one.model)
                              : one.model;
    case RunColumn::Firmware:
        return one.firmware;
    case RunColumn::Verdict:
        return gradeText(one.verdict);
    case RunColumn::Reference:
        if (one.reference && !history::canBeReference(test))
            return translate("ui::RunListDialog", "ignored: did not finish");
        if (one.reference && !history::canBeReference(test, one))
            return translate("ui::RunListDialog", "ignored: failed");
        return one.reference ? translate("ui::RunListDialog", "★ reference") : QString();
    case RunColumn::Label:
        return QString(one.label).simplified();
    case RunColumn::Note:
        return QString(test.note).simplified();
    case RunColumn::Count:
        break;
    }
    return {};
}

QString RunsModel::toolTipText(int row) const
{
    QStringList lines;
    for (int column = 0; column < columnCount(); ++column) {
        const QString words = cell(row, static_cast<RunColumn>(column));
        if (!words.isEmpty())
            lines << QStringLiteral("%1: %2").arg(headerData(column, Qt::Horizontal).toString(),
                                                  words);
    }
    return lines.join(QLatin1Char('\n'));
}

QVariant RunsModel::data(const QModelIndex& index, int role) const
{
    if (!checkIndex(index, CheckIndexOption::IndexIsValid))
        return {};
    const auto column = static_cast<RunColumn>(index.column());
    if (role == Qt::DisplayRole)
        return cell(index.row(), column);
    if (role == Qt::ToolTipRole)
        return toolTipText(index.row());
    if (role == toneRole && column == RunColumn::Verdict)
        return static_cast<int>(gradeTone(servo(index.row()).verdict));
    if (role == Qt::TextAlignmentRole)
        return alignmentOf(column);
    return {};
}

QVariant RunsModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation == Qt::Horizontal && role == Qt::TextAlignmentRole)
        return alignmentOf(static_cast<RunColumn>(section));
    if (orientation != Qt::Horizontal || role != Qt::DisplayRole)
        return {};
    switch (static_cast<RunColumn>(section)) {
    case RunColumn::Number:
        return translate("ui::RunListDialog", "Test");
    case RunColumn::When:
        return translate("ui::RunListDialog", "Time");
    case RunColumn::Servo:
        return translate("ui::RunListDialog", "ID");
    case RunColumn::Model:
        return translate("ui::RunListDialog", "Model");
    case RunColumn::Firmware:
        return translate("ui::RunListDialog", "Firmware");
    case RunColumn::Verdict:
        return translate("ui::RunListDialog", "Verdict");
    case RunColumn::Reference:
        return translate("ui::RunListDialog", "Reference");
    case RunColumn::Label:
        return translate("ui::RunListDialog", "Label");
    case RunColumn::Note:
        return translate("ui::RunListDialog", "Note");
    case RunColumn::Count:
        break;
    }
    return {};
}
} // namespace ui
