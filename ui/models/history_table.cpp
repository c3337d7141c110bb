// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/models/history_table.h"

#include "ui/models/sweep_cells.h"

#include <algorithm>
#include <set>
#include <utility>

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
/// The question without the page of the answer.
record::HistoryFilter unpaged(record::HistoryFilter filter)
{
    filter.after.reset();
    filter.most = HistoryTable::page;
    return filter;
}
} // namespace

HistoryTable::HistoryTable(const catalog::Catalog& catalog, QObject* parent)
    : QAbstractTableModel(parent)
    , m_words(catalog)
{}

void HistoryTable::ask(session::Archive* archive, HistoryKind kind,
                       const record::HistoryFilter& filter)
{
    const bool same = archive != nullptr && archive == m_archive && kind == m_kind &&
                      unpaged(filter) == unpaged(m_filter);
    if (!same)
        begin(archive, kind, filter);
    else if (m_asking)
        m_askAgain = true;
    else
        askAgain();
}

void HistoryTable::begin(session::Archive* archive, HistoryKind kind,
                         const record::HistoryFilter& filter)
{
    beginResetModel();
    m_archive = archive;
    m_kind = kind;
    m_filter = unpaged(filter);
    m_lines.clear();
    m_renewing = false;
    m_askAgain = false;
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
    begin(m_archive, m_kind, m_filter);
}

/// One page more than there is: what is new must not push out what is shown.
void HistoryTable::askAgain()
{
    m_askAgain = false;
    m_renewing = true;
    m_asking = true;
    ++m_question;
    m_filter.after.reset();
    m_filter.most = int(m_lines.size()) + page;
    askServos();
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
            if (!servos) {
                fail(servos.error());
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
        if (!rows) {
            fail(rows.error());
            return;
        }
        std::vector<HistoryLine> lines;
        lines.reserve(rows->size());
        for (const Row& row : *rows)
            lines.push_back(m_words.line(row));
        take(std::move(lines), int(rows->size()) < m_filter.most);
    };
}

void HistoryTable::fail(const base::Error& error)
{
    m_asking = false;
    m_askAgain = false;
    m_complete = m_complete || !std::exchange(m_renewing, false);
    markEnd();
    Q_EMIT failed(error);
    Q_EMIT changed();
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

void HistoryTable::take(std::vector<HistoryLine> lines, bool last)
{
    m_asking = false;
    if (std::exchange(m_renewing, false))
        renew(std::move(lines), last);
    else
        add(std::move(lines), last);
    markEnd();
    if (m_askAgain)
        askAgain();
    Q_EMIT changed();
}

/// Where the next page begins.
void HistoryTable::markEnd()
{
    m_filter.most = page;
    if (!m_lines.empty())
        m_filter.after = record::PageMark{m_lines.back().at, m_lines.back().number};
}

/// As far as was shown before, and a page at least; tests come all at once.
void HistoryTable::renew(std::vector<HistoryLine> lines, bool last)
{
    std::size_t shown = std::max(m_lines.size(), std::size_t(page));
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

/// Row by row: a view keeps what it shows of rows that stay.
void HistoryTable::merge(std::vector<HistoryLine> lines)
{
    std::set<std::int64_t> stay;
    for (const HistoryLine& line : lines)
        stay.insert(line.number);
    for (int row = int(m_lines.size()); row-- > 0;) {
        if (stay.count(at(row).number) > 0)
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

void HistoryTable::add(std::vector<HistoryLine> lines, bool last)
{
    m_complete = last || lines.empty();
    if (!lines.empty()) {
        const int first = int(m_lines.size());
        beginInsertRows({}, first, first + int(lines.size()) - 1);
        std::move(lines.begin(), lines.end(), std::back_inserter(m_lines));
        endInsertRows();
    }
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
