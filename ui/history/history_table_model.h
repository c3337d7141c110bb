// SPDX-License-Identifier: GPL-3.0-or-later
// One list of the history, page by page: what is scrolled to is asked for, without waiting. Newest
// first. The archive must outlive it; owned by the history page; main thread.
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

    /// Asks the archive for the first page; null: an empty list. The same question again keeps
    /// the rows until the answer comes, and those that are still there after it: a selection and
    /// the place scrolled to stay.
    void query(session::HistoryService* historyService, record::HistoryKind kind,
               const record::HistoryFilter& filter);
    void retranslate(); ///< asks again: words are made with the rows
    bool isLoading() const { return m_loading; }
    bool isComplete() const { return m_complete; }
    record::HistoryKind kind() const { return m_kind; }
    const HistoryLine& lineAt(int row) const { return m_lines[std::size_t(row)]; }

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
    void startQuery(session::HistoryService* historyService, record::HistoryKind kind,
                    const record::HistoryFilter& filter);
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
    record::HistoryKind m_kind = record::HistoryKind::Writes;
    record::HistoryFilter m_filter;
    HistoryFormatter m_formatter;
    std::vector<HistoryLine> m_lines;
    int m_queryId = 0; ///< only answers to the latest count
    bool m_loading = false;
    bool m_complete = true;
    bool m_replacing = false;    ///< the answer takes the place of the rows
    bool m_queryPending = false; ///< when the present answer has come
};
} // namespace ui
