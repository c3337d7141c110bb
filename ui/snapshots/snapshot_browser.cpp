// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/snapshots/snapshot_browser.h"

#include "ui/common/follow_language.h"
#include "ui/common/widget_style.h"
#include "ui/snapshots/snapshot_query.h"
#include "ui/snapshots/snapshot_row.h"

#include <QComboBox>
#include <QFileInfo>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QScrollBar>
#include <QTreeWidget>
#include <QVBoxLayout>

#include <algorithm>

namespace ui {
namespace {
enum ServoFilter { ThisServo, AllServos };

constexpr int maxRows = 500;
constexpr auto queryDelay = std::chrono::milliseconds(120);
} // namespace

SnapshotBrowser::SnapshotBrowser(session::Workbench& workbench,
                                 session::HistoryService& historyService, Selection& selection,
                                 QWidget* parent)
    : QWidget(parent)
    , m_workbench(workbench)
    , m_historyService(historyService)
    , m_historyGuard(&historyService)
    , m_selection(selection)
{
    build();
    m_queryTimer.setSingleShot(true);
    m_queryTimer.setInterval(queryDelay);
    connect(&m_queryTimer, &QTimer::timeout, this, &SnapshotBrowser::ask);
    const auto scheduleQuery = [this] { m_queryTimer.start(); };
    connect(&m_historyService, &session::HistoryService::changed, this, scheduleQuery);
    connect(&m_selection, &Selection::changed, this, scheduleQuery);
    connect(&m_workbench, &session::Workbench::eventOccurred, this,
            [this](const session::Event& event) {
                if (event.kind == session::Event::Kind::TableSaved)
                    m_queryTimer.start();
            });
    connect(m_servoFilter, &QComboBox::currentIndexChanged, this, scheduleQuery);
    connect(m_search, &QLineEdit::textChanged, this, scheduleQuery);
    connect(m_tree, &QTreeWidget::itemSelectionChanged, this, &SnapshotBrowser::selectionChanged);
    connect(m_tree, &QTreeWidget::currentItemChanged, this, &SnapshotBrowser::selectionChanged);
    followLanguage(this, [this] { retranslate(); });
    ask();
}

void SnapshotBrowser::build()
{
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins({});
    column->setSpacing(6);
    m_title = new QLabel(this);
    makeHeading(m_title);
    m_servoFilter = new QComboBox(this);
    m_servoFilter->setObjectName(QStringLiteral("shelfWhose"));
    m_servoFilter->addItems({QString(), QString()});
    m_search = new QLineEdit(this);
    m_search->setObjectName(QStringLiteral("shelfSearch"));
    m_search->setClearButtonEnabled(true);
    m_tree = new QTreeWidget(this);
    m_tree->setObjectName(QStringLiteral("shelfTree"));
    m_tree->setColumnCount(2);
    m_tree->setHeaderHidden(true);
    m_tree->header()->setStretchLastSection(false);
    m_tree->header()->setSectionResizeMode(0, QHeaderView::Stretch);
    m_tree->header()->setSectionResizeMode(1, QHeaderView::ResizeToContents);
    m_tree->setRootIsDecorated(false);
    m_tree->setIndentation(14);
    m_tree->setSelectionMode(QAbstractItemView::ExtendedSelection);
    m_tree->setUniformRowHeights(true);
    m_tree->setTextElideMode(Qt::ElideRight);
    m_tree->hide(); // until there is a row
    m_emptyLabel = new QLabel(this);
    m_emptyLabel->setObjectName(QStringLiteral("shelfNothing"));
    makeEmptyState(m_emptyLabel);
    auto* row = new QHBoxLayout;
    row->addWidget(m_servoFilter);
    row->addWidget(m_search, 1);
    column->addWidget(m_title);
    column->addLayout(row);
    column->addWidget(m_emptyLabel, 1);
    column->addWidget(m_tree, 1);
}

QString SnapshotBrowser::noneText() const
{
    const session::ServoEntry* servo = m_workbench.registry().servo(m_selection.current());
    return m_servoFilter->currentIndex() == ThisServo && servo != nullptr && servo->servo.profile
               ? tr("No snapshots of this servo yet. Take one here; one is also saved "
                    "automatically before the first change.")
               : tr("No snapshots yet. Take one here; one is also saved automatically before the "
                    "first change to a servo.");
}

void SnapshotBrowser::retranslate()
{
    m_title->setText(tr("Snapshots"));
    m_servoFilter->setItemText(ThisServo, tr("This servo"));
    m_servoFilter->setItemText(AllServos, tr("All servos"));
    m_servoFilter->setAccessibleName(tr("Snapshots to show"));
    m_servoFilter->setToolTip(tr("Shows only snapshots whose model and ID match the selected "
                                 "servo, or all snapshots (servos have no serial number)"));
    m_search->setPlaceholderText(tr("Search"));
    m_search->setAccessibleName(tr("Search snapshots"));
    m_search->setToolTip(tr("Searches the model, label, note and file name"));
    m_tree->setAccessibleName(tr("Snapshots"));
    m_tree->setToolTip(tr("The selected snapshot is used for comparing and restoring; Ctrl+click "
                          "adds snapshots to the comparison"));
    m_emptyLabel->setText(m_search->text().isEmpty() ? noneText() : tr("No snapshot matches."));
    for (int i = 0; i < m_tree->topLevelItemCount(); ++i)
        static_cast<SnapshotRow*>(m_tree->topLevelItem(i))->updateText();
}

/// A servo is identified by all that is known of it. The row that another page asked for is
/// included, however old it is.
void SnapshotBrowser::ask()
{
    using Rows = std::vector<history::HistorySnapshot>;
    std::optional<base::ServoIdentity> identity;
    const session::ServoEntry* entry = m_workbench.registry().servo(m_selection.current());
    if (m_servoFilter->currentIndex() == ThisServo && entry != nullptr && entry->servo.profile)
        identity = entry->servo.identity();
    const int queryId = ++m_queryId;
    m_historyService.query<Rows>(
        [identity, currentNumber = m_pendingNumber](history::History& history) {
            return findSnapshots(history, identity, currentNumber, maxRows);
        },
        this,
        [this, queryId](const base::Result<Rows>& rows) {
            if (queryId != m_queryId)
                return;
            if (rows)
                fill(*rows);
            else
                Q_EMIT failed(rows.error());
        });
}

/// Whether the list has exactly these rows of the history.
bool SnapshotBrowser::hasRows(const std::vector<history::HistorySnapshot>& rows) const
{
    std::size_t found = 0;
    for (int i = 0; i < m_tree->topLevelItemCount(); ++i) {
        const SnapshotItem* item = SnapshotRow::itemOf(m_tree->topLevelItem(i));
        if (!item->kept)
            continue;
        if (found >= rows.size() || !(rows[found] == *item->kept))
            return false;
        ++found;
    }
    return found == rows.size();
}

/// Number of the row at the top of the view; 0: the list is not scrolled, or that row is a file.
std::int64_t SnapshotBrowser::topNumber() const
{
    const SnapshotItem* item = m_tree->verticalScrollBar()->value() > 0
                                   ? SnapshotRow::itemOf(m_tree->itemAt(QPoint(0, 0)))
                                   : nullptr;
    return item != nullptr ? item->number() : 0;
}

void SnapshotBrowser::scrollToTop(std::int64_t number)
{
    for (int i = 0; i < m_tree->topLevelItemCount(); ++i) {
        const SnapshotItem* item = SnapshotRow::itemOf(m_tree->topLevelItem(i));
        if (item->number() == number)
            m_tree->scrollToItem(m_tree->topLevelItem(i), QAbstractItemView::PositionAtTop);
    }
}

/// Opened files stay on top; selected rows of the history stay selected while they exist.
void SnapshotBrowser::fill(const std::vector<history::HistorySnapshot>& all)
{
    const QStringList words = m_search->text().split(QLatin1Char(' '), Qt::SkipEmptyParts);
    std::vector<history::HistorySnapshot> rows;
    std::copy_if(all.begin(), all.end(), std::back_inserter(rows),
                 [&](const history::HistorySnapshot& row) { return matchesSearch(row, words); });
    m_emptyLabel->setText(m_search->text().isEmpty() ? noneText() : tr("No snapshot matches."));
    if (m_pendingNumber == 0 && hasRows(rows)) {
        selectionChanged();
        return;
    }
    m_filling = true;
    insertHistoryRows(rows);
    m_pendingNumber = 0;
    m_emptyLabel->setVisible(m_tree->topLevelItemCount() == 0);
    m_tree->setHidden(m_emptyLabel->isVisibleTo(this));
    m_filling = false;
    selectionChanged();
}

/// Removes the rows of the history and returns their loaded snapshots.
std::map<std::int64_t, session::SharedSnapshot> SnapshotBrowser::takeHistoryRows()
{
    std::map<std::int64_t, session::SharedSnapshot> loaded;
    for (int i = m_tree->topLevelItemCount(); i-- > 0;) {
        const SnapshotItem* item = SnapshotRow::itemOf(m_tree->topLevelItem(i));
        if (!item->kept)
            continue;
        loaded[item->kept->number] = item->snapshot;
        delete m_tree->takeTopLevelItem(i);
    }
    return loaded;
}

/// Replaces the rows of the history; scroll position and selection stay.
void SnapshotBrowser::insertHistoryRows(const std::vector<history::HistorySnapshot>& rows)
{
    const bool isPending = m_pendingNumber != 0;
    const std::int64_t top = isPending ? 0 : topNumber();
    const SnapshotItem* current = SnapshotRow::itemOf(m_tree->currentItem());
    const std::int64_t currentNumber = isPending            ? m_pendingNumber
                                       : current != nullptr ? current->number()
                                                            : 0;
    const std::vector<std::int64_t> selected =
        isPending ? std::vector<std::int64_t>{m_pendingNumber} : selectedNumbers();
    if (isPending)
        m_tree->clearSelection();
    const auto loaded = takeHistoryRows();
    for (const history::HistorySnapshot& row : rows) {
        auto item = std::make_shared<SnapshotItem>();
        item->kept = row;
        if (const auto known = loaded.find(row.number); known != loaded.end())
            item->snapshot = known->second;
        auto* treeRow = new SnapshotRow(item);
        m_tree->addTopLevelItem(treeRow);
        if (row.number == currentNumber)
            m_tree->setCurrentItem(treeRow, 0, QItemSelectionModel::NoUpdate);
        if (std::find(selected.begin(), selected.end(), row.number) != selected.end())
            treeRow->setSelected(true);
    }
    if (top != 0)
        scrollToTop(top);
}

void SnapshotBrowser::add(const session::OpenedFile& file)
{
    addFile(file, QFileInfo(file.path).completeBaseName().section(QLatin1Char('.'), 0, 0));
}

void SnapshotBrowser::add(session::SharedSnapshot snapshot, const QString& title)
{
    addFile({{}, std::move(snapshot), {}}, title);
}

/// A file that is opened again replaces its row.
void SnapshotBrowser::addFile(const session::OpenedFile& file, const QString& title)
{
    m_filling = true;
    for (int i = m_tree->topLevelItemCount(); i-- > 0 && !file.path.isEmpty();) {
        const SnapshotItem* item = SnapshotRow::itemOf(m_tree->topLevelItem(i));
        if (!item->kept && item->path == file.path)
            delete m_tree->takeTopLevelItem(i);
    }
    const snapshot::Snapshot* table = file.snapshot.get();
    const QString label = table != nullptr && !table->label.isEmpty()    ? table->label
                          : file.bundle && !file.bundle->label.isEmpty() ? file.bundle->label
                                                                         : title;
    const auto item = std::make_shared<SnapshotItem>();
    item->snapshot = file.snapshot;
    item->bundle = file.bundle;
    item->path = file.path;
    item->title = label;
    auto* row = new SnapshotRow(item);
    m_tree->insertTopLevelItem(0, row);
    for (const snapshot::Snapshot& servo :
         file.bundle ? file.bundle->servos : std::vector<snapshot::Snapshot>{}) {
        const auto child = std::make_shared<SnapshotItem>();
        child->snapshot = std::make_shared<const snapshot::Snapshot>(servo);
        child->path = file.path;
        child->title =
            servo.label.isEmpty() ? tr("%1, ID %2").arg(label).arg(servo.servo.id) : servo.label;
        row->addChild(new SnapshotRow(child));
    }
    row->setExpanded(true);
    m_tree->clearSelection();
    m_tree->setCurrentItem(row);
    m_emptyLabel->hide();
    m_tree->show();
    m_filling = false;
    selectionChanged();
}

void SnapshotBrowser::selectNumber(std::int64_t number)
{
    m_servoFilter->setCurrentIndex(AllServos);
    m_search->clear();
    m_pendingNumber = number;
    ++m_queryId; // a pending answer does not have the row
    m_queryTimer.start();
}

void SnapshotBrowser::invalidate(std::int64_t number)
{
    for (int i = 0; i < m_tree->topLevelItemCount(); ++i) {
        SnapshotItem* item = SnapshotRow::itemOf(m_tree->topLevelItem(i));
        if (item->number() == number)
            item->snapshot.reset();
    }
}

/// Loads the selected rows of the history; selectedSnapshots() has them when they are loaded.
void SnapshotBrowser::selectionChanged()
{
    if (m_filling)
        return;
    for (const QTreeWidgetItem* row : m_tree->selectedItems()) {
        const std::shared_ptr<SnapshotItem>& item = static_cast<const SnapshotRow*>(row)->item();
        if (item->kept && !item->snapshot && !item->isLoading)
            load(item);
    }
    Q_EMIT snapshotSelectionChanged();
}

void SnapshotBrowser::load(const std::shared_ptr<SnapshotItem>& item)
{
    item->isLoading = true;
    m_historyService.loadSnapshot(
        item->kept->number, this,
        [this, item](const base::Result<session::SharedSnapshot>& loaded) {
            item->isLoading = false;
            if (!loaded) {
                Q_EMIT failed(loaded.error());
                return;
            }
            item->snapshot = *loaded;
            Q_EMIT snapshotSelectionChanged();
        });
}

std::vector<SnapshotSelection> SnapshotBrowser::selectedSnapshots() const
{
    std::vector<SnapshotSelection> all;
    const auto take = [&](const QTreeWidgetItem* row) {
        const SnapshotItem* item = SnapshotRow::itemOf(row);
        if (item == nullptr || !item->snapshot)
            return;
        all.push_back({item->name(), row->toolTip(0), item->snapshot, item->number(), item->path});
    };
    const QTreeWidgetItem* current = m_tree->currentItem();
    if (current != nullptr && current->isSelected())
        take(current);
    for (const QTreeWidgetItem* row : m_tree->selectedItems()) {
        if (row != current)
            take(row);
    }
    return all;
}

session::SharedBundle SnapshotBrowser::bundle() const
{
    const QTreeWidgetItem* current = m_tree->currentItem();
    const SnapshotItem* item =
        current != nullptr && current->isSelected() ? SnapshotRow::itemOf(current) : nullptr;
    return item != nullptr ? item->bundle : nullptr;
}

QString SnapshotBrowser::bundlePath() const
{
    const SnapshotItem* item = SnapshotRow::itemOf(m_tree->currentItem());
    return item != nullptr ? item->path : QString();
}

std::optional<history::HistorySnapshot> SnapshotBrowser::selectedHistoryRow() const
{
    const QList<QTreeWidgetItem*> rows = m_tree->selectedItems();
    return rows.size() == 1 ? SnapshotRow::itemOf(rows.front())->kept : std::nullopt;
}

std::vector<std::int64_t> SnapshotBrowser::selectedNumbers() const
{
    std::vector<std::int64_t> numbers;
    for (const QTreeWidgetItem* row : m_tree->selectedItems()) {
        const SnapshotItem* item = SnapshotRow::itemOf(row);
        if (item != nullptr && item->kept)
            numbers.push_back(item->kept->number);
    }
    return numbers;
}

void SnapshotBrowser::showEvent(QShowEvent* event)
{
    QWidget::showEvent(event);
    if (m_historyGuard)
        m_historyService.setWatched(this, true);
    m_queryTimer.start();
}

void SnapshotBrowser::hideEvent(QHideEvent* event)
{
    QWidget::hideEvent(event);
    if (m_historyGuard)
        m_historyService.setWatched(this, false);
}
} // namespace ui
