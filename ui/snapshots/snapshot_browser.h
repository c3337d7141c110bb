// SPDX-License-Identifier: GPL-3.0-or-later
// What there is to compare with and to restore from: opened files, bundles with their servos, and
// the snapshots of the history, newest first. Several may be selected; the current one is what
// would be restored. Loads what is selected by itself, without waiting. Owned by the snapshots
// page; main thread.
#pragma once

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
/// One table that was chosen.
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
    SnapshotBrowser(session::Desk& desk, session::HistoryService& historyService,
                    Selection& selection, QWidget* parent);

    /// The current one first, then the others that are selected; those that are loaded.
    std::vector<SnapshotSelection> selectedSnapshots() const;
    session::SharedBundle bundle() const; ///< the current row's; null: it is none
    QString bundlePath() const;
    std::vector<std::int64_t> selectedNumbers() const; ///< rows of the history
    /// The selected row, where it is one alone and of the history.
    std::optional<record::HistorySnapshot> selectedHistoryRow() const;

    /// They become the current row.
    void add(const session::OpenedFile& file);
    void add(session::SharedSnapshot snapshot, const QString& title);
    /// That row of the history, when the list has it.
    void selectNumber(std::int64_t number);
    /// It has changed in the history and is loaded anew.
    void invalidate(std::int64_t number);

Q_SIGNALS:
    void snapshotSelectionChanged();
    void failed(const base::Error& error);

protected:
    void changeEvent(QEvent* event) override;
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;

private:
    struct Item;
    struct Row;
    void build();
    void retranslate();
    void ask();
    void fill(const std::vector<record::HistorySnapshot>& all);
    std::map<std::int64_t, session::SharedSnapshot> takeHistoryRows();
    void insertHistoryRows(const std::vector<record::HistorySnapshot>& rows);
    bool hasRows(const std::vector<record::HistorySnapshot>& rows) const;
    std::int64_t topNumber() const;
    void scrollToTop(std::int64_t number);
    void addFile(const session::OpenedFile& file, const QString& title);
    void updateRowText(QTreeWidgetItem* row) const; ///< its words
    void load(const std::shared_ptr<Item>& item);
    void selectionChanged();
    static Item* itemOf(const QTreeWidgetItem* row);

    session::Desk& m_desk;
    session::HistoryService& m_historyService;
    QPointer<session::HistoryService>
        m_archiveGuard; ///< a window may hide its pages on its way out
    Selection& m_selection;
    QLabel* m_title = nullptr;
    QComboBox* m_servoFilter = nullptr;
    QLineEdit* m_search = nullptr;
    QTreeWidget* m_tree = nullptr;
    QLabel* m_emptyLabel = nullptr;
    QTimer m_queryTimer; ///< several changes, one question
    int m_queryId = 0;
    std::int64_t m_pendingNumber = 0; ///< to become current when the list has it
    bool m_filling = false;
};
} // namespace ui
