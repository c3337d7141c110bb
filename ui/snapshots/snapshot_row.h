// SPDX-License-Identifier: GPL-3.0-or-later
// One row of the list of snapshots: a snapshot of the history, an opened file, or a bundle, with
// its two lines of text, its time at the right and its tooltip. Owned by the tree; main thread.
#pragma once

#include "session/history/history_service.h"
#include "session/snapshot/snapshots.h"

#include <QTreeWidgetItem>

namespace ui {
struct SnapshotItem {
    session::SharedSnapshot snapshot{}; ///< null: not loaded, or a bundle
    session::SharedBundle bundle{};
    std::optional<history::HistorySnapshot> kept{}; ///< its row in the history
    QString path{};                                 ///< of the file; empty: none
    QString title{};                                ///< of a file
    bool isLoading = false;

    std::int64_t number() const { return kept ? kept->number : 0; } ///< in the history; 0: none
    QString name() const; ///< short: "reference, tested", "12 Nov 09:40"
};

class SnapshotRow final : public QTreeWidgetItem {
public:
    explicit SnapshotRow(std::shared_ptr<SnapshotItem> item);

    /// Null: `row` is null.
    static SnapshotItem* itemOf(const QTreeWidgetItem* row);
    const std::shared_ptr<SnapshotItem>& item() const { return m_item; }
    void updateText(); ///< in the current language, with its children

private:
    std::shared_ptr<SnapshotItem> m_item; ///< shared with the loading of its snapshot
};

/// All words are in the texts of the row.
bool matchesSearch(const history::HistorySnapshot& row, const QStringList& words);
} // namespace ui
