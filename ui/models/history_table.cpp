// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/models/history_table.h"

#include "ui/models/sweep_cells.h"

namespace ui {
using record::HistoryKind;

namespace {
constexpr int mostServos = 5000;

bool numeric(HistoryKind kind, int column)
{
    switch (kind) {
    case HistoryKind::Writes:
        return column == 3 || column == 4;
    case HistoryKind::Snapshots:
        return column == 5;
    case HistoryKind::Recordings:
        return column == 2 || column == 3;
    default:
        return false;
    }
}
} // namespace

HistoryTable::HistoryTable(const catalog::Catalog& catalog, QObject* parent)
    : QAbstractTableModel(parent)
    , m_words(catalog)
{}

void HistoryTable::ask(session::Archive* archive, HistoryKind kind,
                       const record::HistoryFilter& filter)
{
    beginResetModel();
    m_archive = archive;
    m_kind = kind;
    m_filter = filter;
    m_filter.most = page;
    m_filter.after.reset();
    m_lines.clear();
    m_complete = archive == nullptr;
    ++m_question;
    m_asking = archive != nullptr; // a view that looks now asks for nothing of its own
    endResetModel();
    Q_EMIT changed();
    if (archive != nullptr)
        askServos();
}

void HistoryTable::retranslate()
{
    ask(m_archive, m_kind, m_filter);
}

/// Register names hang on what the servo is.
void HistoryTable::askServos()
{
    record::HistoryFilter all;
    all.most = mostServos;
    m_archive->servos(
        all, this,
        [this, mine = m_question](const base::Result<std::vector<record::HistoryServo>>& servos) {
            if (mine != m_question)
                return;
            m_asking = false;
            if (!servos) {
                m_complete = true;
                Q_EMIT failed(servos.error());
                Q_EMIT changed();
                return;
            }
            m_words.know(*servos);
            askPage();
        });
}

template <typename Row>
std::function<void(const base::Result<std::vector<Row>>&)> HistoryTable::taker()
{
    return [this, mine = m_question](const base::Result<std::vector<Row>>& rows) {
        if (mine != m_question)
            return;
        m_asking = false;
        if (!rows) {
            m_complete = true;
            Q_EMIT failed(rows.error());
            Q_EMIT changed();
            return;
        }
        std::vector<HistoryLine> lines;
        lines.reserve(rows->size());
        for (const Row& row : *rows)
            lines.push_back(m_words.line(row));
        add(std::move(lines), int(rows->size()) < m_filter.most);
    };
}

void HistoryTable::askPage()
{
    m_asking = true;
    switch (m_kind) {
    case HistoryKind::Writes:
        m_archive->writes(m_filter, this, taker<record::HistoryWrite>());
        break;
    case HistoryKind::Snapshots:
        m_archive->snapshots(m_filter, this, taker<record::HistorySnapshot>());
        break;
    case HistoryKind::Alarms:
        m_archive->alarms(m_filter, this, taker<record::HistoryAlarm>());
        break;
    case HistoryKind::Recordings:
        m_archive->recordings(m_filter, this, taker<record::HistoryRecording>());
        break;
    case HistoryKind::Servos:
        m_archive->servos(m_filter, this, taker<record::HistoryServo>());
        break;
    case HistoryKind::Runs: {
        record::RunFilter runs;
        runs.id = m_filter.id;
        runs.model = m_filter.model;
        runs.from = m_filter.from;
        runs.until = m_filter.until;
        m_filter.most = runs.most; // this list is not paged
        m_archive->list(runs, this, taker<record::TestRun>());
        break;
    }
    }
}

void HistoryTable::add(std::vector<HistoryLine> lines, bool last)
{
    m_complete = last || lines.empty();
    if (!lines.empty()) {
        const int first = int(m_lines.size());
        beginInsertRows({}, first, first + int(lines.size()) - 1);
        std::move(lines.begin(), lines.end(), std::back_inserter(m_lines));
        endInsertRows();
        m_filter.after = record::PageMark{m_lines.back().at, m_lines.back().number};
    }
    Q_EMIT changed();
}

int HistoryTable::rowCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : int(m_lines.size());
}

int HistoryTable::columnCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : int(HistoryWords::headers(m_kind).size());
}

QVariant HistoryTable::data(const QModelIndex& index, int role) const
{
    if (!index.isValid())
        return {};
    const HistoryLine& line = at(index.row());
    switch (role) {
    case Qt::DisplayRole:
        return line.cells.value(index.column()).simplified();
    case Qt::ToolTipRole:
        return line.tip;
    case Qt::TextAlignmentRole:
        return int((numeric(m_kind, index.column()) ? Qt::AlignRight : Qt::AlignLeft) |
                   Qt::AlignVCenter);
    case toneRole:
        return index.column() == HistoryWords::toneColumn(m_kind) ? QVariant(int(line.tone))
                                                                  : QVariant();
    default:
        return {};
    }
}

QVariant HistoryTable::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation != Qt::Horizontal)
        return {};
    if (role == Qt::DisplayRole)
        return HistoryWords::headers(m_kind).value(section);
    if (role == Qt::TextAlignmentRole)
        return int((numeric(m_kind, section) ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter);
    return {};
}

bool HistoryTable::canFetchMore(const QModelIndex& parent) const
{
    return !parent.isValid() && !m_complete && !m_asking;
}

void HistoryTable::fetchMore(const QModelIndex& parent)
{
    if (canFetchMore(parent))
        askPage();
}
} // namespace ui
