// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/history/history_table_model.h"

#include "text/translate.h"
#include "ui/widgets/test_text.h"

#include <algorithm>
#include <set>
#include <utility>

namespace ui {
using history::HistoryKind;

namespace {
constexpr int maxServos = 5000;

const HistoryColumn& columnAt(HistoryKind kind, int column)
{
    return HistoryFormatter::columns(kind)[std::size_t(column)];
}

int alignment(const HistoryColumn& column)
{
    return int((column.cell == HistoryCell::Number ? Qt::AlignRight : Qt::AlignLeft) |
               Qt::AlignVCenter);
}

/// The filter without the page.
history::HistoryFilter unpaged(history::HistoryFilter filter)
{
    filter.after.reset();
    filter.limit = HistoryTableModel::pageSize;
    return filter;
}
} // namespace

HistoryTableModel::HistoryTableModel(const catalog::Catalog& catalog, QObject* parent)
    : QAbstractTableModel(parent)
    , m_formatter(catalog)
{}

void HistoryTableModel::query(session::HistoryService* historyService, HistoryKind kind,
                              const history::HistoryFilter& filter)
{
    const bool same = historyService != nullptr && historyService == m_historyService &&
                      kind == m_kind && unpaged(filter) == unpaged(m_filter);
    if (!same)
        startQuery(historyService, kind, filter);
    else if (m_loading)
        m_queryPending = true;
    else
        repeatQuery();
}

void HistoryTableModel::startQuery(session::HistoryService* historyService, HistoryKind kind,
                                   const history::HistoryFilter& filter)
{
    beginResetModel();
    m_historyService = historyService;
    m_kind = kind;
    m_filter = unpaged(filter);
    m_lines.clear();
    m_replacing = false;
    m_queryPending = false;
    m_complete = historyService == nullptr;
    ++m_queryId;
    m_loading = historyService != nullptr; // a view must not fetch more meanwhile
    endResetModel();
    Q_EMIT changed();
    if (historyService != nullptr)
        fetchServos();
}

void HistoryTableModel::retranslate()
{
    startQuery(m_historyService, m_kind, m_filter);
}

/// One page more than is shown: new rows must not push out rows that are shown.
void HistoryTableModel::repeatQuery()
{
    m_queryPending = false;
    m_replacing = true;
    m_loading = true;
    ++m_queryId;
    m_filter.after.reset();
    m_filter.limit = int(m_lines.size()) + pageSize;
    fetchServos();
}

/// Register names depend on the model of the servo.
void HistoryTableModel::fetchServos()
{
    history::HistoryFilter all;
    all.limit = maxServos;
    m_historyService->servos(all, this,
                             [this, queryId = m_queryId](
                                 const base::Result<std::vector<history::HistoryServo>>& servos) {
                                 if (queryId != m_queryId)
                                     return;
                                 if (!servos) {
                                     handleError(servos.error());
                                     return;
                                 }
                                 m_formatter.addServos(*servos);
                                 fetchPage();
                             });
}

template <typename Row>
std::function<void(const base::Result<std::vector<Row>>&)> HistoryTableModel::resultHandler()
{
    return [this, queryId = m_queryId](const base::Result<std::vector<Row>>& rows) {
        if (queryId != m_queryId)
            return;
        if (!rows) {
            handleError(rows.error());
            return;
        }
        std::vector<HistoryLine> lines;
        lines.reserve(rows->size());
        for (const Row& row : *rows)
            lines.push_back(m_formatter.formatLine(row));
        addPage(std::move(lines), int(rows->size()) < m_filter.limit);
    };
}

void HistoryTableModel::handleError(const base::Error& error)
{
    m_loading = false;
    m_queryPending = false;
    m_complete = m_complete || !std::exchange(m_replacing, false);
    markEnd();
    Q_EMIT failed(error);
    Q_EMIT changed();
}

void HistoryTableModel::fetchPage()
{
    m_loading = true;
    switch (m_kind) {
    case HistoryKind::Writes:
        m_historyService->writes(m_filter, this, resultHandler<history::HistoryWrite>());
        break;
    case HistoryKind::Snapshots:
        m_historyService->snapshots(m_filter, this, resultHandler<history::HistorySnapshot>());
        break;
    case HistoryKind::Alarms:
        m_historyService->alarms(m_filter, this, resultHandler<history::HistoryAlarm>());
        break;
    case HistoryKind::Recordings:
        m_historyService->recordings(m_filter, this, resultHandler<history::HistoryRecording>());
        break;
    case HistoryKind::Servos:
        m_historyService->servos(m_filter, this, resultHandler<history::HistoryServo>());
        break;
    case HistoryKind::Runs: {
        history::RunFilter runs;
        runs.id = m_filter.id;
        runs.model = m_filter.model;
        runs.from = m_filter.from;
        runs.until = m_filter.until;
        m_filter.limit = runs.limit; // this list is not paged
        m_historyService->list(runs, this, resultHandler<history::TestRun>());
        break;
    }
    }
}

void HistoryTableModel::addPage(std::vector<HistoryLine> lines, bool last)
{
    m_loading = false;
    if (std::exchange(m_replacing, false))
        replaceRows(std::move(lines), last);
    else
        add(std::move(lines), last);
    markEnd();
    if (m_queryPending)
        repeatQuery();
    Q_EMIT changed();
}

/// Where the next page begins.
void HistoryTableModel::markEnd()
{
    m_filter.limit = pageSize;
    if (!m_lines.empty())
        m_filter.after = history::PageCursor{m_lines.back().at, m_lines.back().number};
}

/// All rows that were shown before, at least one page; tests are not paged.
void HistoryTableModel::replaceRows(std::vector<HistoryLine> lines, bool last)
{
    std::size_t shown = std::max(m_lines.size(), std::size_t(pageSize));
    const auto old = std::find_if(lines.rbegin(), lines.rend(), [this](const HistoryLine& line) {
        return !m_lines.empty() && line.number == m_lines.back().number;
    });
    shown = std::max(shown, std::size_t(std::distance(old, lines.rend())));
    if (m_kind == HistoryKind::Runs)
        shown = lines.size();
    m_complete = last && lines.size() <= shown;
    if (lines.size() > shown)
        lines.resize(shown);
    merge(std::move(lines));
}

/// Row by row, so that a view keeps the selection and position of rows that stay.
void HistoryTableModel::merge(std::vector<HistoryLine> lines)
{
    std::set<std::int64_t> remaining;
    for (const HistoryLine& line : lines)
        remaining.insert(line.number);
    for (int row = int(m_lines.size()); row-- > 0;) {
        if (remaining.count(lineAt(row).number) > 0)
            continue;
        beginRemoveRows({}, row, row);
        m_lines.erase(m_lines.begin() + row);
        endRemoveRows();
    }
    for (int row = 0; row < int(lines.size()); ++row) {
        HistoryLine& line = lines[std::size_t(row)];
        const auto place = m_lines.begin() + row;
        const auto known = std::find_if(place, m_lines.end(), [&](const HistoryLine& other) {
            return other.number == line.number;
        });
        if (known == m_lines.end()) {
            beginInsertRows({}, row, row);
            m_lines.insert(place, std::move(line));
            endInsertRows();
            continue;
        }
        if (known != place) {
            const auto from = int(known - m_lines.begin());
            beginMoveRows({}, from, from, {}, row);
            std::rotate(place, known, known + 1);
            endMoveRows();
        }
        m_lines[std::size_t(row)] = std::move(line);
    }
    if (!m_lines.empty())
        Q_EMIT dataChanged(index(0, 0), index(rowCount() - 1, columnCount() - 1));
}

void HistoryTableModel::add(std::vector<HistoryLine> lines, bool last)
{
    m_complete = last || lines.empty();
    if (!lines.empty()) {
        const int first = int(m_lines.size());
        beginInsertRows({}, first, first + int(lines.size()) - 1);
        std::move(lines.begin(), lines.end(), std::back_inserter(m_lines));
        endInsertRows();
    }
}

int HistoryTableModel::rowCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : int(m_lines.size());
}

int HistoryTableModel::columnCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : int(HistoryFormatter::columns(m_kind).size());
}

QVariant HistoryTableModel::data(const QModelIndex& index, int role) const
{
    if (!index.isValid())
        return {};
    const HistoryLine& line = lineAt(index.row());
    const HistoryColumn& column = columnAt(m_kind, index.column());
    switch (role) {
    case Qt::DisplayRole:
        if (column.cell == HistoryCell::Time)
            return HistoryFormatter::listTime(line.at, QDate::currentDate());
        return line.cells.value(index.column()).simplified();
    case Qt::ToolTipRole:
        return line.tip();
    case Qt::TextAlignmentRole:
        return alignment(column);
    case toneRole:
        return column.cell == HistoryCell::Outcome ? QVariant(int(line.tone)) : QVariant();
    default:
        return {};
    }
}

QVariant HistoryTableModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation != Qt::Horizontal || section < 0 || section >= columnCount())
        return {};
    const HistoryColumn& column = columnAt(m_kind, section);
    if (role == Qt::DisplayRole)
        return text::translate("History", column.header);
    if (role == Qt::TextAlignmentRole)
        return alignment(column);
    return {};
}

bool HistoryTableModel::canFetchMore(const QModelIndex& parent) const
{
    return !parent.isValid() && !m_complete && !m_loading;
}

void HistoryTableModel::fetchMore(const QModelIndex& parent)
{
    if (canFetchMore(parent))
        fetchPage();
}
} // namespace ui
