// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/snapshots/snapshot_browser.h"

#include "ui/snapshots/snapshot_query.h"

#include <QComboBox>
#include <QDir>
#include <QEvent>
#include <QFileInfo>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QScrollBar>
#include <QTreeWidget>
#include <QVBoxLayout>

#include <algorithm>

namespace ui {
namespace {
constexpr int maxRows = 500;
constexpr auto queryDelay = std::chrono::milliseconds(120);

enum ServoFilter : int { ThisServo, AllServos };

QString timeText(const QDateTime& at)
{
    const QDateTime local = at.toLocalTime();
    const bool today = local.date() == QDate::currentDate();
    return today ? local.toString(QStringLiteral("HH:mm:ss"))
                 : local.toString(QStringLiteral("yyyy-MM-dd HH:mm"));
}

QString reasonText(record::SnapshotReason reason)
{
    switch (reason) {
    case record::SnapshotReason::Automatic:
        return SnapshotBrowser::tr("before a change");
    case record::SnapshotReason::Manual:
        return SnapshotBrowser::tr("taken");
    case record::SnapshotReason::Bundle:
        return SnapshotBrowser::tr("with all servos");
    case record::SnapshotReason::Commission:
        return SnapshotBrowser::tr("before commissioning");
    }
    return {};
}
} // namespace

struct SnapshotBrowser::Item {
    session::SharedSnapshot snapshot{};
    session::SharedBundle bundle{};
    std::optional<record::HistorySnapshot> kept{};
    QString path{};
    QString title{};
    bool loading = false;
};

struct SnapshotBrowser::Row final : QTreeWidgetItem {
    explicit Row(std::shared_ptr<Item> about)
        : item(std::move(about))
    {}
    std::shared_ptr<Item> item; ///< shared with what loads it
};

SnapshotBrowser::SnapshotBrowser(session::Desk& desk, session::HistoryService& historyService,
                                 Selection& selection, QWidget* parent)
    : QWidget(parent)
    , m_desk(desk)
    , m_historyService(historyService)
    , m_archiveGuard(&historyService)
    , m_selection(selection)
{
    build();
    m_queryTimer.setSingleShot(true);
    m_queryTimer.setInterval(queryDelay);
    connect(&m_queryTimer, &QTimer::timeout, this, &SnapshotBrowser::ask);
    const auto scheduleQuery = [this] { m_queryTimer.start(); };
    connect(&m_historyService, &session::HistoryService::changed, this, scheduleQuery);
    connect(&m_selection, &Selection::changed, this, scheduleQuery);
    connect(&m_desk, &session::Desk::eventOccurred, this, [this](const session::Event& event) {
        if (event.kind == session::Event::Kind::TableSaved)
            m_queryTimer.start();
    });
    connect(m_servoFilter, &QComboBox::currentIndexChanged, this, scheduleQuery);
    connect(m_search, &QLineEdit::textChanged, this, scheduleQuery);
    connect(m_tree, &QTreeWidget::itemSelectionChanged, this, &SnapshotBrowser::selectionChanged);
    connect(m_tree, &QTreeWidget::currentItemChanged, this, &SnapshotBrowser::selectionChanged);
    retranslate();
    ask();
}

void SnapshotBrowser::build()
{
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins({});
    column->setSpacing(6);
    m_title = new QLabel(this);
    m_title->setTextFormat(Qt::RichText);
    m_servoFilter = new QComboBox(this);
    m_servoFilter->setObjectName(QStringLiteral("shelfWhose"));
    m_servoFilter->addItems({QString(), QString()});
    m_search = new QLineEdit(this);
    m_search->setObjectName(QStringLiteral("shelfSearch"));
    m_search->setClearButtonEnabled(true);
    m_tree = new QTreeWidget(this);
    m_tree->setObjectName(QStringLiteral("shelfTree"));
    m_tree->setColumnCount(1);
    m_tree->setHeaderHidden(true);
    m_tree->setRootIsDecorated(false);
    m_tree->setIndentation(14);
    m_tree->setSelectionMode(QAbstractItemView::ExtendedSelection);
    m_tree->setUniformRowHeights(true);
    m_tree->setTextElideMode(Qt::ElideRight);
    m_emptyLabel = new QLabel(this);
    m_emptyLabel->setObjectName(QStringLiteral("shelfNothing"));
    m_emptyLabel->setWordWrap(true);
    auto* row = new QHBoxLayout;
    row->addWidget(m_servoFilter);
    row->addWidget(m_search, 1);
    column->addWidget(m_title);
    column->addLayout(row);
    column->addWidget(m_emptyLabel);
    column->addWidget(m_tree, 1);
}

void SnapshotBrowser::retranslate()
{
    m_title->setText(QStringLiteral("<b>%1</b>").arg(tr("Snapshots")));
    m_servoFilter->setItemText(ThisServo, tr("This servo"));
    m_servoFilter->setItemText(AllServos, tr("All servos"));
    m_servoFilter->setAccessibleName(tr("Whose snapshots"));
    m_servoFilter->setToolTip(
        tr("Snapshots of servos like the selected one with its ID, or all there "
           "are. Servos carry no serial number: model, firmware and ID are all "
           "that can be known"));
    m_search->setPlaceholderText(tr("Search"));
    m_search->setAccessibleName(tr("Search snapshots"));
    m_search->setToolTip(tr("Words in model, label, note or file name"));
    m_tree->setAccessibleName(tr("Snapshots"));
    m_tree->setToolTip(tr("The current one is compared and restored; hold Ctrl to compare more"));
    m_emptyLabel->setText(
        tr("There is none yet. One is taken by itself before the first change to a "
           "servo."));
    for (int i = 0; i < m_tree->topLevelItemCount(); ++i) {
        QTreeWidgetItem* row = m_tree->topLevelItem(i);
        updateRowText(row);
        for (int child = 0; child < row->childCount(); ++child)
            updateRowText(row->child(child));
    }
}

SnapshotBrowser::Item* SnapshotBrowser::itemOf(const QTreeWidgetItem* row)
{
    return row != nullptr ? static_cast<const Row*>(row)->item.get() : nullptr;
}

/// Two lines: who, and what for.
void SnapshotBrowser::updateRowText(QTreeWidgetItem* row) const
{
    const Item* item = itemOf(row);
    if (item == nullptr)
        return;
    QString who;
    QString what;
    QStringList tip;
    if (item->bundle) {
        who = item->title;
        what = tr("%1 servos").arg(item->bundle->servos.size()) + QStringLiteral(" · ") +
               timeText(item->bundle->at);
        tip << item->bundle->note;
    } else if (item->kept) {
        const record::HistorySnapshot& kept = *item->kept;
        who = QStringLiteral("%1 · ID %2").arg(kept.model).arg(kept.servoId);
        what = (kept.label.isEmpty() ? reasonText(kept.reason) : kept.label) +
               QStringLiteral(" · ") + timeText(kept.at);
        tip << reasonText(kept.reason) << kept.note
            << tr("firmware %1, on %2").arg(kept.firmware, kept.port);
    } else if (item->snapshot) {
        const record::Snapshot& table = *item->snapshot;
        who = item->title;
        what = QStringLiteral("%1 · ID %2 · ").arg(table.servo.model).arg(table.servo.id) +
               (table.isTemplate ? tr("template, %1 rows").arg(table.registers.size())
                                 : timeText(table.at));
        tip << table.note << tr("firmware %1, on %2").arg(table.servo.firmware, table.port);
    }
    const QString path = item->path.isEmpty() && item->kept ? item->kept->file : item->path;
    tip << QDir::toNativeSeparators(path);
    tip.removeAll(QString());
    row->setText(0, who + QLatin1Char('\n') + what);
    row->setToolTip(0, QStringLiteral("%1\n%2\n%3").arg(who, what, tip.join(QLatin1Char('\n'))));
}

/// The servos of the list are told by all that can be known of them; the row that is wanted from
/// elsewhere comes along, however old it is.
void SnapshotBrowser::ask()
{
    using Rows = std::vector<record::HistorySnapshot>;
    std::optional<base::ServoIdentity> who;
    const session::ServoEntry* entry = m_desk.servo(m_selection.current());
    if (m_servoFilter->currentIndex() == ThisServo && entry != nullptr && entry->servo.profile)
        who = entry->servo.identity();
    const int queryId = ++m_queryId;
    m_historyService.query<Rows>(
        [who, currentNumber = m_pendingNumber](record::History& history) {
            return findSnapshots(history, who, currentNumber, maxRows);
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

namespace {
bool fits(const QStringList& terms, const record::HistorySnapshot& row)
{
    const QString all = QStringLiteral("%1 ID %2 %3 %4 %5 %6")
                            .arg(row.model)
                            .arg(row.servoId)
                            .arg(row.label, row.note, row.file, reasonText(row.reason));
    return std::all_of(terms.begin(), terms.end(), [&](const QString& word) {
        return all.contains(word, Qt::CaseInsensitive);
    });
}
} // namespace

/// The rows of the history as they are in the list.
bool SnapshotBrowser::hasRows(const std::vector<record::HistorySnapshot>& rows) const
{
    std::size_t found = 0;
    for (int i = 0; i < m_tree->topLevelItemCount(); ++i) {
        const Item* item = itemOf(m_tree->topLevelItem(i));
        if (!item->kept)
            continue;
        if (found >= rows.size() || !(rows[found] == *item->kept))
            return false;
        ++found;
    }
    return found == rows.size();
}

/// Of the row the list was scrolled to; 0: it is at its top, or that row is a file.
std::int64_t SnapshotBrowser::topNumber() const
{
    const Item* item =
        m_tree->verticalScrollBar()->value() > 0 ? itemOf(m_tree->itemAt(QPoint(0, 0))) : nullptr;
    return item != nullptr && item->kept ? item->kept->number : 0;
}

void SnapshotBrowser::scrollToTop(std::int64_t number)
{
    for (int i = 0; i < m_tree->topLevelItemCount(); ++i) {
        const Item* item = itemOf(m_tree->topLevelItem(i));
        if (item->kept && item->kept->number == number)
            m_tree->scrollToItem(m_tree->topLevelItem(i), QAbstractItemView::PositionAtTop);
    }
}

/// Opened files stay on top; what was selected of the history stays selected while it is there.
void SnapshotBrowser::fill(const std::vector<record::HistorySnapshot>& all)
{
    const QStringList terms = m_search->text().split(QLatin1Char(' '), Qt::SkipEmptyParts);
    std::vector<record::HistorySnapshot> rows;
    std::copy_if(all.begin(), all.end(), std::back_inserter(rows),
                 [&](const record::HistorySnapshot& row) { return fits(terms, row); });
    if (m_pendingNumber == 0 && hasRows(rows)) {
        selectionChanged();
        return;
    }
    m_filling = true;
    insertHistoryRows(rows);
    m_pendingNumber = 0;
    m_emptyLabel->setVisible(m_tree->topLevelItemCount() == 0);
    m_filling = false;
    selectionChanged();
}

/// What was loaded of them.
std::map<std::int64_t, session::SharedSnapshot> SnapshotBrowser::takeHistoryRows()
{
    std::map<std::int64_t, session::SharedSnapshot> loaded;
    for (int i = m_tree->topLevelItemCount(); i-- > 0;) {
        const Item* item = itemOf(m_tree->topLevelItem(i));
        if (!item->kept)
            continue;
        loaded[item->kept->number] = item->snapshot;
        delete m_tree->takeTopLevelItem(i);
    }
    return loaded;
}

/// In place of those that are there: the list stays where it was, with what was selected.
void SnapshotBrowser::insertHistoryRows(const std::vector<record::HistorySnapshot>& rows)
{
    const bool selectedSnapshots = m_pendingNumber != 0;
    const std::int64_t top = selectedSnapshots ? 0 : topNumber();
    const Item* current = itemOf(m_tree->currentItem());
    const std::int64_t currentNumber = selectedSnapshots          ? m_pendingNumber
                                       : current && current->kept ? current->kept->number
                                                                  : 0;
    const std::vector<std::int64_t> selected =
        selectedSnapshots ? std::vector<std::int64_t>{m_pendingNumber} : selectedNumbers();
    if (selectedSnapshots)
        m_tree->clearSelection();
    const auto loaded = takeHistoryRows();
    for (const record::HistorySnapshot& row : rows) {
        auto item = std::make_shared<Item>();
        item->kept = row;
        if (const auto known = loaded.find(row.number); known != loaded.end())
            item->snapshot = known->second;
        auto* line = new Row(item);
        m_tree->addTopLevelItem(line);
        updateRowText(line);
        if (row.number == currentNumber)
            m_tree->setCurrentItem(line, 0, QItemSelectionModel::NoUpdate);
        if (std::find(selected.begin(), selected.end(), row.number) != selected.end())
            line->setSelected(true);
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

/// A file opened again takes the place of its row.
void SnapshotBrowser::addFile(const session::OpenedFile& file, const QString& title)
{
    m_filling = true;
    for (int i = m_tree->topLevelItemCount(); i-- > 0 && !file.path.isEmpty();) {
        const Item* item = itemOf(m_tree->topLevelItem(i));
        if (!item->kept && item->path == file.path)
            delete m_tree->takeTopLevelItem(i);
    }
    const auto line = [this](const std::shared_ptr<Item>& item) {
        auto* row = new Row(item);
        updateRowText(row);
        return row;
    };
    const record::Snapshot* table = file.snapshot.get();
    const QString label = table != nullptr && !table->label.isEmpty()    ? table->label
                          : file.bundle && !file.bundle->label.isEmpty() ? file.bundle->label
                                                                         : title;
    const auto item = std::make_shared<Item>();
    item->snapshot = file.snapshot;
    item->bundle = file.bundle;
    item->path = file.path;
    item->title = label;
    QTreeWidgetItem* row = line(item);
    m_tree->insertTopLevelItem(0, row);
    for (const record::Snapshot& servo :
         file.bundle ? file.bundle->servos : std::vector<record::Snapshot>{}) {
        const auto child = std::make_shared<Item>();
        child->snapshot = std::make_shared<const record::Snapshot>(servo);
        child->path = file.path;
        child->title =
            servo.label.isEmpty() ? tr("%1, ID %2").arg(label).arg(servo.servo.id) : servo.label;
        row->addChild(line(child));
    }
    row->setExpanded(true);
    m_tree->clearSelection();
    m_tree->setCurrentItem(row);
    m_emptyLabel->hide();
    m_filling = false;
    selectionChanged();
}

void SnapshotBrowser::selectNumber(std::int64_t number)
{
    m_servoFilter->setCurrentIndex(AllServos);
    m_search->clear();
    m_pendingNumber = number;
    ++m_queryId; // an answer on its way knows nothing of it
    m_queryTimer.start();
}

void SnapshotBrowser::invalidate(std::int64_t number)
{
    for (int i = 0; i < m_tree->topLevelItemCount(); ++i) {
        Item* item = itemOf(m_tree->topLevelItem(i));
        if (item->kept && item->kept->number == number)
            item->snapshot.reset();
    }
}

/// What is selected of the history is loaded; chosen() has it when it is there.
void SnapshotBrowser::selectionChanged()
{
    if (m_filling)
        return;
    for (const QTreeWidgetItem* row : m_tree->selectedItems()) {
        const std::shared_ptr<Item>& item = static_cast<const Row*>(row)->item;
        if (item->kept && !item->snapshot && !item->loading)
            load(item);
    }
    Q_EMIT snapshotSelectionChanged();
}

void SnapshotBrowser::load(const std::shared_ptr<Item>& item)
{
    item->loading = true;
    m_historyService.loadSnapshot(
        item->kept->number, this,
        [this, item](const base::Result<session::SharedSnapshot>& loaded) {
            item->loading = false;
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
        const Item* item = itemOf(row);
        if (item == nullptr || !item->snapshot)
            return;
        const QString name = !item->kept                    ? item->title
                             : !item->kept->label.isEmpty() ? item->kept->label
                                                            : timeText(item->kept->at);
        all.push_back({name, row->toolTip(0), item->snapshot, item->kept ? item->kept->number : 0,
                       item->path});
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
    const Item* item = current != nullptr && current->isSelected() ? itemOf(current) : nullptr;
    return item != nullptr ? item->bundle : nullptr;
}

QString SnapshotBrowser::bundlePath() const
{
    const Item* item = itemOf(m_tree->currentItem());
    return item != nullptr ? item->path : QString();
}

std::optional<record::HistorySnapshot> SnapshotBrowser::selectedHistoryRow() const
{
    const QList<QTreeWidgetItem*> rows = m_tree->selectedItems();
    return rows.size() == 1 ? itemOf(rows.front())->kept : std::nullopt;
}

std::vector<std::int64_t> SnapshotBrowser::selectedNumbers() const
{
    std::vector<std::int64_t> numbers;
    for (const QTreeWidgetItem* row : m_tree->selectedItems()) {
        const Item* item = itemOf(row);
        if (item != nullptr && item->kept)
            numbers.push_back(item->kept->number);
    }
    return numbers;
}

void SnapshotBrowser::showEvent(QShowEvent* event)
{
    QWidget::showEvent(event);
    if (m_archiveGuard)
        m_historyService.setWatched(this, true);
    m_queryTimer.start();
}

void SnapshotBrowser::hideEvent(QHideEvent* event)
{
    QWidget::hideEvent(event);
    if (m_archiveGuard)
        m_historyService.setWatched(this, false);
}

void SnapshotBrowser::changeEvent(QEvent* event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange && m_tree != nullptr)
        retranslate();
}
} // namespace ui
