// SPDX-License-Identifier: GPL-3.0-or-later
// One list of the history, page by page: what is scrolled to is asked for, without waiting. Newest
// first. The archive must outlive it; owned by the history page; main thread.
#pragma once

#include "session/archive.h"
#include "ui/models/history_lines.h"

#include <QAbstractTableModel>

namespace ui {
class HistoryTable final : public QAbstractTableModel {
    Q_OBJECT

public:
    static constexpr int page = 200;

    explicit HistoryTable(const catalog::Catalog& catalog, QObject* parent = nullptr);

    /// Asks the archive for the first page; null: an empty list. The same question again keeps
    /// the rows until the answer comes, and those that are still there after it: a selection and
    /// the place scrolled to stay.
    void ask(session::Archive* archive, record::HistoryKind kind,
             const record::HistoryFilter& filter);
    void retranslate(); ///< asks again: words are made with the rows
    bool asking() const { return m_asking; }
    bool complete() const { return m_complete; }
    record::HistoryKind kind() const { return m_kind; }
    const HistoryLine& at(int row) const { return m_lines[std::size_t(row)]; }

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
    void begin(session::Archive* archive, record::HistoryKind kind,
               const record::HistoryFilter& filter);
    void askAgain();
    void askServos();
    void askPage();
    template <typename Row>
    std::function<void(const base::Result<std::vector<Row>>&)> taker();
    void take(std::vector<HistoryLine> lines, bool last);
    void add(std::vector<HistoryLine> lines, bool last);
    void renew(std::vector<HistoryLine> lines, bool last);
    void merge(std::vector<HistoryLine> lines);
    void markEnd();
    void fail(const base::Error& error);

    session::Archive* m_archive = nullptr;
    record::HistoryKind m_kind = record::HistoryKind::Writes;
    record::HistoryFilter m_filter;
    HistoryWords m_words;
    std::vector<HistoryLine> m_lines;
    int m_question = 0; ///< only answers to the latest count
    bool m_asking = false;
    bool m_complete = true;
    bool m_renewing = false; ///< the answer takes the place of the rows
    bool m_askAgain = false; ///< when the present answer has come
};
} // namespace ui
