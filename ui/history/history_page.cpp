// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/history/history_page.h"

#include "session/history/history_server_choice.h"
#include "session/history/history_server_source.h"
#include "text/language.h"
#include "ui/common/file_dialog.h"
#include "ui/common/follow_language.h"
#include "ui/common/widget_style.h"
#include "ui/common/widget_text.h"
#include "ui/history/history_details.h"
#include "ui/history/history_filter_bar.h"
#include "ui/history/history_list_view.h"
#include "ui/history/history_send_label.h"
#include "ui/history/history_server_dialog.h"
#include "ui/history/history_undo.h"
#include "ui/widgets/banner.h"
#include "ui/widgets/flow_layout.h"
#include "ui/widgets/note_dialog.h"

#include <QDir>
#include <QLabel>
#include <QPushButton>
#include <QSplitter>
#include <QVBoxLayout>

namespace ui {
using history::HistoryKind;

namespace {
constexpr int listStretch = 3; ///< of the width, the details have 1
constexpr auto historyQueryDelay = std::chrono::milliseconds(150);
const QString historyFolderKey = QStringLiteral("history/folder");

QString secondText(const QDateTime& at)
{
    return at.toLocalTime().toString(QStringLiteral("yyyy-MM-dd HH:mm:ss"));
}
} // namespace

HistoryPage::HistoryPage(AppContext& appContext, session::Settings& settings, QWidget* parent)
    : QWidget(parent)
    , m_workbench(appContext.workbench)
    , m_local(appContext.workbench.history())
    , m_localGuard(&appContext.workbench.history())
    , m_settings(settings)
    , m_table(appContext.workbench.catalog())
{
    setObjectName(QStringLiteral("historyPage"));
    build();
    connectAll();
    followLanguage(this, [this] { retranslate(); });
}

HistoryPage::~HistoryPage() = default;

void HistoryPage::build()
{
    auto* column = new QVBoxLayout(this);
    m_banner = new Banner(this);
    m_banner->setObjectName(QStringLiteral("historyBanner"));
    m_banner->hideMessage();
    m_identityHint = new QLabel(this);
    m_identityHint->setObjectName(QStringLiteral("historyHonest"));
    m_identityHint->setWordWrap(true);
    m_view = new HistoryListView(m_table, this);
    m_filters = new HistoryFilterBar(m_settings, this);
    column->addWidget(m_banner);
    column->addWidget(m_filters);
    auto* card = new QWidget(this);
    m_emptyLabel = new QLabel(card);
    m_emptyLabel->setObjectName(QStringLiteral("historyNothing"));
    makeEmptyState(m_emptyLabel);
    auto* inside = new QVBoxLayout(card);
    inside->addWidget(m_emptyLabel, 1);
    inside->addWidget(m_view, 1);
    makeTableCard(card);
    m_view->setFrameShape(QFrame::NoFrame);
    auto* split = new QSplitter(Qt::Horizontal, this);
    split->setChildrenCollapsible(false);
    split->setHandleWidth(cardMargin);
    m_details = new HistoryDetails(split);
    m_undo = m_details->addButton("historyUndo");
    m_open = m_details->addButton("historyOpen");
    m_ofServo = m_details->addButton("historyOfServo");
    m_label = m_details->addButton("historyLabel");
    split->addWidget(card);
    split->addWidget(m_details);
    split->setStretchFactor(0, listStretch);
    split->setStretchFactor(1, 1);
    column->addWidget(split, 1);
    column->addWidget(m_identityHint);
    column->addWidget(buildActions());
    column->addWidget(new HistorySendLabel(m_workbench.historySender(), this));
    m_queryTimer.setSingleShot(true);
    m_queryTimer.setInterval(historyQueryDelay);
}

QWidget* HistoryPage::buildActions()
{
    auto* box = new QWidget(this);
    auto* row = new FlowLayout(box, 6);
    const auto button = [&](const char* name) {
        auto* made = new QPushButton(box);
        made->setObjectName(QString::fromLatin1(name));
        row->addWidget(made);
        return made;
    };
    m_export = button("historyExport");
    m_serverSet = button("historyServer");
    m_count = new QLabel(box);
    m_count->setObjectName(QStringLiteral("historyCount"));
    row->addWidget(m_count);
    return box;
}

void HistoryPage::connectAll()
{
    connect(&m_queryTimer, &QTimer::timeout, this, &HistoryPage::query);
    connect(&m_local, &session::HistoryService::changed, this, [this] {
        if (!isRemote())
            scheduleQuery();
    });
    // The journal writes into the database without HistoryService, which therefore does not signal.
    connect(&m_workbench, &session::Workbench::eventOccurred, this,
            [this](const session::Event& event) {
                using Kind = session::Event::Kind;
                if (!isRemote() && (event.kind == Kind::Written || event.kind == Kind::Task ||
                                    event.kind == Kind::TableSaved))
                    scheduleQuery();
            });
    connect(&m_local, &session::HistoryService::failed, this, &HistoryPage::showError);
    connect(&m_table, &HistoryTableModel::changed, this, [this] {
        showState();
        if (m_table.rowCount() > 0 && !m_view->selectedRow())
            m_view->selectRow(0);
    });
    connect(&m_table, &HistoryTableModel::failed, this, &HistoryPage::showError);
    connect(m_filters, &HistoryFilterBar::sourceChanged, this, &HistoryPage::onSourceChanged);
    connect(m_filters, &HistoryFilterBar::filterChanged, this, &HistoryPage::scheduleQuery);
    connect(m_view->selectionModel(), &QItemSelectionModel::selectionChanged, this,
            &HistoryPage::showState);
    connect(m_view, &QTableView::activated, this, &HistoryPage::openSelected);
    connect(m_open, &QPushButton::clicked, this, &HistoryPage::openSelected);
    connect(m_undo, &QPushButton::clicked, this, [this] {
        if (const HistoryLine* line = selectedLine(); line != nullptr && line->write)
            askToUndo(this, m_workbench, *line->write, m_table.servoOf(*line));
    });
    connect(m_ofServo, &QPushButton::clicked, this, [this] {
        if (const HistoryLine* line = selectedLine())
            m_filters->selectServo(line->servo);
    });
    // Whether a write can be undone depends on the servo.
    for (const auto signal :
         {&session::ServoRegistry::servoAdded, &session::ServoRegistry::servoRemoved,
          &session::ServoRegistry::tableChanged})
        connect(&m_workbench.registry(), signal, this, [this] {
            if (isVisible())
                showActions();
        });
    connect(&m_workbench, &session::Workbench::stateChanged, this, [this] {
        if (isVisible())
            showActions();
    });
    connect(m_label, &QPushButton::clicked, this, &HistoryPage::editLabel);
    connect(m_export, &QPushButton::clicked, this, &HistoryPage::exportList);
    connect(m_serverSet, &QPushButton::clicked, this, &HistoryPage::editServer);
}

session::HistoryService& HistoryPage::historyService() const
{
    return m_server ? *m_server : m_local;
}

void HistoryPage::onSourceChanged()
{
    m_banner->hideMessage();
    m_table.query(nullptr, m_table.kind(), {});
    const HistorySourceChoice source = m_filters->source();
    if (!source.isServer) {
        m_server.reset();
    } else {
        if (!m_server)
            m_server = std::make_unique<session::HistoryService>(
                std::make_unique<session::HistoryServerSource>(
                    session::historyServerChoice(m_settings).address));
        m_server->selectBench(source.bench);
    }
    setViewing(isVisible());
    query();
}

void HistoryPage::setViewing(bool viewing)
{
    if (m_localGuard)
        m_local.setWatched(this, viewing && !isRemote());
}

/// A hidden page asks when it is shown.
void HistoryPage::scheduleQuery()
{
    if (isVisible())
        m_queryTimer.start();
}

void HistoryPage::query()
{
    m_queryTimer.stop();
    m_filters->showFiltersOfKind();
    m_table.query(&historyService(), m_filters->kind(), m_filters->filter());
    m_filters->loadChoices(historyService(), isRemote());
}

QString HistoryPage::emptyText() const
{
    const QString kind = HistoryFormatter::kindName(m_filters->kind());
    if (m_filters->filter() != history::HistoryFilter{})
        return tr("No entries under “%1” match the filters above.").arg(kind);
    return tr("No entries under “%1” yet. Select another kind of entry above: writes, snapshots, "
              "tests, alarms, recordings or servos.")
        .arg(kind);
}

QString HistoryPage::countText() const
{
    const int rows = m_table.rowCount();
    if (rows == 0)
        return m_table.isLoading() ? tr("Loading…") : tr("No entries");
    return m_table.isComplete() ? tr("%Ln row(s)", nullptr, rows)
                                : tr("%Ln or more rows", nullptr, rows);
}

bool HistoryPage::isStepResponseSelected() const
{
    const auto row = m_view->selectedRow();
    return row && !isRemote() && m_table.kind() == HistoryKind::Runs &&
           m_table.lineAt(*row).isStepResponse;
}

const HistoryLine* HistoryPage::selectedLine() const
{
    const auto row = m_view->selectedRow();
    return row ? &m_table.lineAt(*row) : nullptr;
}

void HistoryPage::showState()
{
    m_view->updateAfterChange();
    m_details->show(selectedLine());
    m_details->setVisible(m_table.rowCount() > 0);
    m_export->setEnabled(m_table.rowCount() > 0);
    m_count->setText(countText());
    const bool empty = m_table.rowCount() == 0 && !m_table.isLoading();
    m_emptyLabel->setText(emptyText());
    m_emptyLabel->setVisible(empty);
    m_view->setVisible(!empty);
    showActions();
}

void HistoryPage::showActions()
{
    const HistoryKind kind = m_table.kind();
    const bool one = m_view->selectedRow().has_value();
    const bool writes = kind == HistoryKind::Writes;
    const bool runs = kind == HistoryKind::Runs;
    const bool step = isStepResponseSelected();
    setButtonText(
        m_open,
        writes ? tr("Memory table before write")
        : step ? tr("Open step response")
        : runs ? tr("Earlier tests…")
               : tr("Open snapshot"),
        writes ? tr("Opens the servo's memory table as it was just before this write; you can "
                    "compare and restore it")
        : step
            ? tr("Shows this run on the Step response page, where the next run is compared with it")
        : runs ? tr("Shows reports and comparisons of saved tests")
               : tr("Opens the snapshot so that you can compare and restore it"));
    m_open->setVisible(writes || kind == HistoryKind::Snapshots || (runs && !isRemote()));
    m_open->setEnabled(one || runs);
    m_label->setVisible(!isRemote() &&
                        (kind == HistoryKind::Servos || kind == HistoryKind::Snapshots));
    m_label->setEnabled(one);
    const HistoryLine* line = selectedLine();
    const QString refusal = line != nullptr && line->write
                                ? undoRefusal(m_workbench, *line->write, m_table.servoOf(*line))
                                : tr("Select a write.");
    m_undo->setVisible(writes && !isRemote());
    m_undo->setEnabled(refusal.isEmpty());
    setButtonText(m_undo, tr("Undo this write"),
                  refusal.isEmpty() ? tr("Writes the old value back to the servo after you confirm")
                                    : refusal);
    m_ofServo->setVisible(kind != HistoryKind::Servos && kind != HistoryKind::Runs &&
                          kind != HistoryKind::Recordings);
    m_ofServo->setEnabled(line != nullptr && line->servo != 0);
}

void HistoryPage::openSelected()
{
    if (isStepResponseSelected()) {
        Q_EMIT stepResponseRequested(m_table.lineAt(*m_view->selectedRow()).number);
        return;
    }
    if (m_table.kind() == HistoryKind::Runs) {
        Q_EMIT previousTestsRequested();
        return;
    }
    const auto row = m_view->selectedRow();
    if (!row)
        return;
    m_banner->hideMessage();
    const HistoryLine line = m_table.lineAt(*row);
    if (m_table.kind() == HistoryKind::Snapshots)
        openSnapshot(line.number);
    else if (m_table.kind() == HistoryKind::Writes)
        openTableAt(line);
}

void HistoryPage::openSnapshot(std::int64_t number)
{
    if (!isRemote()) {
        Q_EMIT snapshotRequested(number);
        return;
    }
    historyService().loadSnapshot(
        number, this, [this](const base::Result<session::SharedSnapshot>& loaded) {
            if (!loaded) {
                showError(loaded.error());
                return;
            }
            const QString label = (*loaded)->label;
            Q_EMIT tableRequested(*loaded, label.isEmpty() ? tr("from the server") : label);
        });
}

/// As it was just before the write.
void HistoryPage::openTableAt(const HistoryLine& line)
{
    historyService().tableAt(m_workbench.catalog(), line.servo, line.at.addMSecs(-1), this,
                             [this, line](const base::Result<history::TableState>& state) {
                                 if (!state) {
                                     showError(state.error());
                                     return;
                                 }
                                 Q_EMIT tableRequested(
                                     std::make_shared<const snapshot::Snapshot>(state->table),
                                     tr("before %1").arg(secondText(line.at)));
                                 showTableNote(*state);
                             });
}

/// Why the table may differ from what the servo had.
void HistoryPage::showTableNote(const history::TableState& table)
{
    if (!table.unknown.isEmpty()) {
        m_banner->showMessage([keys = table.unknown] {
            return BannerText{Tone::Warn, tr("Some register values from that time are unknown."),
                              tr("These registers were changed by unrecorded operations: %1.")
                                  .arg(text::joinItems(keys)),
                              tr("Restoring the memory table leaves these registers unchanged.")};
        });
    } else if (table.changedId) {
        m_banner->showMessage([changed = *table.changedId] {
            return BannerText{Tone::Warn, tr("The servo had ID %1 at that time.").arg(changed.id),
                              tr("The ID was changed on %1.").arg(secondText(changed.at)),
                              tr("Writes made under ID %1 are in the history of the servo with "
                                 "that ID, not in this memory table.")
                                  .arg(changed.id)};
        });
    }
}

void HistoryPage::editLabel()
{
    const auto row = m_view->selectedRow();
    if (!row)
        return;
    const HistoryLine line = m_table.lineAt(*row);
    const HistoryKind kind = m_table.kind();
    auto* dialog = new NoteDialog(line.label, line.note, this);
    dialog->setNoteVisible(kind == HistoryKind::Snapshots);
    connect(dialog, &NoteDialog::accepted, this, [this, dialog, kind, number = line.number] {
        if (kind == HistoryKind::Snapshots)
            m_local.setSnapshotNote(number, dialog->label(), dialog->note());
        else
            m_local.setServoLabel(number, dialog->label());
    });
    dialog->open();
}

void HistoryPage::exportList()
{
    const FileRequest request{
        QStringLiteral("historyFileDialog"),
        tr("Export the history"),
        {tr("Table for spreadsheets (*.csv)"), tr("Data (*.json)")},
        QStringLiteral("history-%1.csv").arg(history::historyKindName(m_table.kind())),
        &m_settings,
        historyFolderKey};
    askForSavePath(this, request, [this](const QString& path) { exportTo(path); });
}

void HistoryPage::exportTo(const QString& path)
{
    const bool csv = !path.endsWith(QLatin1StringView(".json"), Qt::CaseInsensitive);
    historyService().exportTo(
        path, csv, {m_table.kind()}, m_filters->filter(), this,
        [this, path](const base::Result<std::int64_t>& rows) {
            if (!rows) {
                showError(rows.error());
                return;
            }
            m_banner->showMessage([path, count = *rows] {
                return BannerText{Tone::Good, tr("%Ln row(s) saved: %1", nullptr, int(count))
                                                  .arg(QDir::toNativeSeparators(path))};
            });
        });
}

void HistoryPage::editServer()
{
    auto* dialog = new HistoryServerDialog(m_settings, m_workbench.historySender(), this);
    connect(dialog, &HistoryServerDialog::accepted, this, [this] {
        m_filters->setBenches({}); // it may be another server now
        if (!isRemote())
            return query();
        m_server.reset();
        onSourceChanged();
    });
    dialog->open();
}

void HistoryPage::showError(const base::Error& error)
{
    m_banner->showMessage(error);
}

void HistoryPage::retranslate()
{
    setAccessibleName(tr("History"));
    m_identityHint->setText(
        tr("Servos have no serial number. They are identified by model, firmware, ID and the label "
           "you assign; two identical servos without a label cannot be distinguished."));
    setAccessText(m_view, tr("History"), tr("Newest first"));
    setButtonText(m_ofServo, tr("All entries for this servo"),
                  tr("Lists only entries for the servo in this row"));
    setButtonText(m_label, tr("Label…"), tr("Labels the servo or the snapshot"));
    setButtonText(m_export, tr("Export…"), tr("Saves the filtered list as CSV or JSON"));
    setButtonText(m_serverSet, tr("Server…"),
                  tr("Sends copies of the history to a PostgreSQL server and shows the history "
                     "of all benches"));
    m_filters->loadChoices(historyService(), isRemote());
    m_table.retranslate();
    showState();
}

void HistoryPage::showEvent(QShowEvent* event)
{
    QWidget::showEvent(event);
    setViewing(true); // first, so that no change is missed in between
    query();
}

void HistoryPage::hideEvent(QHideEvent* event)
{
    QWidget::hideEvent(event);
    setViewing(false);
}
} // namespace ui
