// SPDX-License-Identifier: GPL-3.0-or-later
// The snapshots to compare with and to restore: opened files, bundles with their servos, and the
// snapshots of the history, newest first. Several can be selected; the current one is restored.
// Loads the selected ones by itself, without waiting. Owned by the snapshots page; main thread.
#pragma once

#include "session/history/history_service.h"
#include "session/snapshot/snapshots.h"
#include "ui/common/selection.h"

#include <QPointer>
#include <QTimer>
#include <QWidget>

#include <map>

class QComboBox;
class QLabel;
class QLineEdit;
class QTreeWidget;
class QTreeWidgetItem;

namespace ui {
struct SnapshotItem;

/// One selected table.
struct SnapshotSelection {
    QString title{}; ///< short: "reference, tested", "12 Nov 09:40"
    QString tip{};
    session::SharedSnapshot snapshot{};
    std::int64_t number = 0; ///< in the history; 0: it is not there
    QString path{};          ///< of the file; empty: none
};

class SnapshotBrowser final : public QWidget {
    Q_OBJECT

public:
    SnapshotBrowser(session::Workbench& workbench, session::HistoryService& historyService,
                    Selection& selection, QWidget* parent);

    /// The current one first, then the other selected ones; only those that are loaded.
    std::vector<SnapshotSelection> selectedSnapshots() const;
    session::SharedBundle bundle() const; ///< the current row's; null: it is none
    QString bundlePath() const;
    std::vector<std::int64_t> selectedNumbers() const; ///< rows of the history
    /// The selected row, if it is the only one and from the history.
    std::optional<history::HistorySnapshot> selectedHistoryRow() const;

    /// The added snapshot becomes the current row.
    void add(const session::OpenedFile& file);
    void add(session::SharedSnapshot snapshot, const QString& title);
    /// Selects that row of the history as soon as the list has it.
    void selectNumber(std::int64_t number);
    /// It has changed in the history and is loaded again.
    void invalidate(std::int64_t number);

Q_SIGNALS:
    void snapshotSelectionChanged();
    void failed(const base::Error& error);

protected:
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;

private:
    void build();
    void retranslate();
    QString noneText() const;
    void ask();
    void fill(const std::vector<history::HistorySnapshot>& all);
    std::map<std::int64_t, session::SharedSnapshot> takeHistoryRows();
    void insertHistoryRows(const std::vector<history::HistorySnapshot>& rows);
    bool hasRows(const std::vector<history::HistorySnapshot>& rows) const;
    std::int64_t topNumber() const;
    void scrollToTop(std::int64_t number);
    void addFile(const session::OpenedFile& file, const QString& title);
    void load(const std::shared_ptr<SnapshotItem>& item);
    void selectionChanged();

    session::Workbench& m_workbench;
    session::HistoryService& m_historyService;
    QPointer<session::HistoryService> m_historyGuard; ///< the window may hide its pages after it
    Selection& m_selection;
    QLabel* m_title = nullptr;
    QComboBox* m_servoFilter = nullptr;
    QLineEdit* m_search = nullptr;
    QTreeWidget* m_tree = nullptr;
    QLabel* m_emptyLabel = nullptr;
    QTimer m_queryTimer; ///< several changes cause one query
    int m_queryId = 0;
    std::int64_t m_pendingNumber = 0; ///< becomes current when the list has it
    bool m_filling = false;
};
} // namespace ui
