// SPDX-License-Identifier: GPL-3.0-or-later
// One list of the history, newest first. More rows are loaded when the user scrolls to them,
// without waiting. The history service must outlive it; owned by the history page; main thread.
#pragma once

#include "session/history/history_service.h"
#include "ui/history/history_formatter.h"

#include <QAbstractTableModel>

namespace ui {
class HistoryTableModel final : public QAbstractTableModel {
    Q_OBJECT

public:
    static constexpr int pageSize = 200;

    explicit HistoryTableModel(const catalog::Catalog& catalog, QObject* parent = nullptr);

    /// Loads the first page; null: an empty list. The same query again keeps the rows until the
    /// answer comes, and the rows that are in it: the selection and the scroll position stay.
    void query(session::HistoryService* historyService, history::HistoryKind kind,
               const history::HistoryFilter& filter);
    void retranslate(); ///< repeats the query, because rows are text
    bool isLoading() const { return m_loading; }
    bool isComplete() const { return m_complete; }
    history::HistoryKind kind() const { return m_kind; }
    const HistoryLine& lineAt(int row) const { return m_lines[std::size_t(row)]; }
    /// Of the row; null: several, none or unknown.
    const history::HistoryServo* servoOf(const HistoryLine& line) const
    {
        return m_formatter.servo(line.servo);
    }

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
    QVariant headerData(int section, Qt::Orientation orientation,
                        int role = Qt::DisplayRole) const override;
    bool canFetchMore(const QModelIndex& parent) const override;
    void fetchMore(const QModelIndex& parent) override;

Q_SIGNALS:
    void changed(); ///< more rows, or none
    void failed(const base::Error& error);

private:
    void startQuery(session::HistoryService* historyService, history::HistoryKind kind,
                    const history::HistoryFilter& filter);
    void repeatQuery();
    void fetchServos();
    void fetchPage();
    template <typename Row>
    std::function<void(const base::Result<std::vector<Row>>&)> resultHandler();
    void addPage(std::vector<HistoryLine> lines, bool last);
    void add(std::vector<HistoryLine> lines, bool last);
    void replaceRows(std::vector<HistoryLine> lines, bool last);
    void merge(std::vector<HistoryLine> lines);
    void markEnd();
    void handleError(const base::Error& error);

    session::HistoryService* m_historyService = nullptr;
    history::HistoryKind m_kind = history::HistoryKind::Writes;
    history::HistoryFilter m_filter;
    HistoryFormatter m_formatter;
    std::vector<HistoryLine> m_lines;
    int m_queryId = 0; ///< of the latest query; other answers are dropped
    bool m_loading = false;
    bool m_complete = true;
    bool m_replacing = false;    ///< the answer replaces the rows
    bool m_queryPending = false; ///< starts when the current answer has come
};
} // namespace ui
