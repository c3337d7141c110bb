// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/search_panel.h"

#include "text/error_words.h"
#include "ui/models/rate_words.h"
#include "ui/models/servo_list_model.h"
#include "ui/pages/search_scope.h"
#include "ui/widgets/checklist_view.h"
#include "ui/widgets/servo_delegate.h"
#include "ui/widgets/thin_progress.h"

#include <QEvent>
#include <QLabel>
#include <QListView>
#include <QMenu>
#include <QPushButton>
#include <QScrollArea>
#include <QSignalBlocker>
#include <QStackedWidget>
#include <QVBoxLayout>

namespace ui {
using session::LinkState;
using session::ServoRef;
using namespace std::chrono_literals;

namespace {
constexpr int panelWidth = 300;
constexpr int permille = 1000;

QLabel* quietLabel(QWidget* parent, const char* name)
{
    auto* label = new QLabel(parent);
    label->setObjectName(QLatin1String(name));
    label->setTextFormat(Qt::PlainText);
    label->setWordWrap(true);
    label->setForegroundRole(QPalette::PlaceholderText);
    return label;
}
} // namespace

SearchPanel::SearchPanel(session::Desk& desk, Commands& commands, Selection& selection,
                         session::Settings& settings, QWidget* parent)
    : QWidget(parent)
    , m_desk(desk)
    , m_commands(commands)
    , m_selection(selection)
    , m_scope(new SearchScope(settings, this))
    , m_estimate(quietLabel(this, "searchEstimate"))
    , m_search(new QPushButton(this))
    , m_stop(new QPushButton(this))
    , m_progress(new ThinProgress(this))
    , m_status(quietLabel(this, "searchStatus"))
    , m_stack(new QStackedWidget(this))
    , m_list(new QListView(this))
    , m_empty(quietLabel(this, "servoListEmpty"))
    , m_model(new ServoListModel(desk, this))
    , m_delegate(new ServoDelegate(this))
    , m_scroll(new QScrollArea(this))
    , m_checklist(new ChecklistView(this))
    , m_why(new QPushButton(this))
{
    build();
    connectDesk();
    connectList();
    linkChanged();
    showList(true);
    followSelection();
}

QSize SearchPanel::sizeHint() const
{
    return {panelWidth, QWidget::sizeHint().height()};
}

void SearchPanel::build()
{
    setObjectName(QStringLiteral("searchPanel"));
    m_search->setObjectName(QStringLiteral("searchButton"));
    m_search->setProperty("mainAction", true);
    m_stop->setObjectName(QStringLiteral("stopSearchButton"));
    m_progress->setObjectName(QStringLiteral("searchProgress"));
    m_progress->setRange(0, permille);
    m_why->setObjectName(QStringLiteral("whyButton"));
    m_why->setFlat(true);
    auto* buttons = new QHBoxLayout;
    buttons->addWidget(m_search, 1);
    buttons->addWidget(m_stop);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(8, 8, 8, 8);
    column->addWidget(m_scope);
    column->addLayout(buttons);
    column->addWidget(m_estimate);
    column->addWidget(m_progress);
    column->addWidget(m_status);
    column->addWidget(buildList(), 1);
    column->addWidget(m_why, 0, Qt::AlignLeft);
}

QWidget* SearchPanel::buildList()
{
    m_list->setObjectName(QStringLiteral("servoList"));
    m_list->setModel(m_model);
    m_list->setItemDelegate(m_delegate);
    m_list->setUniformItemSizes(false);
    m_list->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_list->setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
    m_list->setContextMenuPolicy(Qt::CustomContextMenu);
    m_list->setEditTriggers(QAbstractItemView::NoEditTriggers);
    m_empty->setAlignment(Qt::AlignTop | Qt::AlignLeft);
    m_empty->setMargin(8);
    m_scroll->setObjectName(QStringLiteral("checklistScroll"));
    m_scroll->setWidgetResizable(true);
    m_scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_scroll->setFrameShape(QFrame::NoFrame);
    m_scroll->setWidget(m_checklist);
    for (QWidget* page : std::initializer_list<QWidget*>{m_list, m_empty, m_scroll})
        m_stack->addWidget(page);
    return m_stack;
}

void SearchPanel::connectDesk()
{
    const auto trigger = [this](QPushButton* button, Command command) {
        QAction* action = m_commands.action(command);
        connect(button, &QPushButton::clicked, action, &QAction::trigger);
        const auto follow = [button, action] { button->setEnabled(action->isEnabled()); };
        connect(action, &QAction::changed, button, follow);
        follow();
    };
    trigger(m_search, Command::Search);
    trigger(m_stop, Command::StopSearch);
    connect(m_commands.action(Command::Search), &QAction::triggered, this, &SearchPanel::search);
    connect(m_scope, &SearchScope::changed, this, &SearchPanel::showScope);
    connect(m_checklist, &ChecklistView::widerWanted, this, &SearchPanel::searchEverything);
    connect(m_why, &QPushButton::clicked, this, [this] {
        if (m_stack->currentWidget() == m_scroll)
            showList(true);
        else
            showChecklist();
    });
    connect(&m_desk, &session::Desk::searchChanged, this, &SearchPanel::searchChanged);
    connect(&m_desk, &session::Desk::searchProgress, this, &SearchPanel::showProgress);
    connect(&m_desk, &session::Desk::happened, this, &SearchPanel::note);
    connect(&m_desk, &session::Desk::linkChanged, this, &SearchPanel::linkChanged);
    connect(&m_desk, &session::Desk::servoRemoved, this, [this] { ++m_removed; });
    m_tick.setInterval(1s);
    connect(&m_tick, &QTimer::timeout, m_model, &ServoListModel::tick);
    m_tick.start();
}

void SearchPanel::connectList()
{
    connect(m_list->selectionModel(), &QItemSelectionModel::currentChanged, this,
            [this](const QModelIndex& now) {
                if (const ServoRef ref = m_model->refAt(now.row()); now.isValid() && ref != 0)
                    m_selection.select(ref);
            });
    connect(&m_selection, &Selection::changed, this, &SearchPanel::followSelection);
    connect(m_list, &QListView::customContextMenuRequested, this, &SearchPanel::listMenu);
    const auto again = [this] {
        showList(true);
        followSelection();
    };
    connect(m_model, &QAbstractItemModel::rowsInserted, this, again);
    connect(m_model, &QAbstractItemModel::modelReset, this, again);
    connect(m_model, &QAbstractItemModel::rowsRemoved, this, [this] {
        followSelection();
        showList(m_stack->currentWidget() != m_scroll);
    });
    // Remarks come and go: the rows have another height then.
    connect(m_model, &QAbstractItemModel::dataChanged, m_list, [this] { m_list->doItemsLayout(); });
}

void SearchPanel::search()
{
    m_desk.search(m_scope->spec());
}

void SearchPanel::searchEverything()
{
    m_scope->setWidest();
    m_commands.action(Command::Search)->trigger();
}

void SearchPanel::searchChanged()
{
    const bool now = m_desk.searching();
    if (now && !m_searching) {
        m_removed = 0;
        m_error.reset();
        m_lastProgress.reset();
        m_progress->setValue(0);
        showList(true);
    }
    m_searching = now;
    showStatus();
}

/// The end is told after the list has been put right; searchChanged() comes before that.
void SearchPanel::note(const session::Event& event)
{
    if (event.kind == session::Event::Kind::SearchEnded) {
        m_error = event.error;
        m_history.vanished = m_removed;
        searchEnded();
    }
    if (event.kind != session::Event::Kind::Written || !event.report)
        return;
    for (const device::WriteResult& write : event.report->writes) {
        const bool moves =
            write.key == QLatin1String("id") || write.key == QLatin1String("baud_rate");
        if (moves && write.outcome == device::WriteOutcome::Kept)
            m_history.idOrRateChanged = true;
    }
}

void SearchPanel::searchEnded()
{
    m_progress->setValue(m_error || !m_desk.lastSearch() ? 0 : permille);
    showStatus();
    const bool nobody = m_model->rowCount() == 0;
    const auto& report = m_desk.lastSearch();
    if (!m_error && report && !report->stopped && (nobody || report->found.empty()))
        showChecklist();
}

void SearchPanel::showProgress(const jobs::Progress& progress)
{
    m_lastProgress = progress;
    m_progress->setValue(int(progress.fraction * permille));
    showStatus();
}

void SearchPanel::showStatus()
{
    QString words;
    QString tip;
    if (m_searching && m_lastProgress) {
        words = tr("%1 % · servos: %2 · %3 left")
                    .arg(int(m_lastProgress->fraction * 100))
                    .arg(m_lastProgress->found)
                    .arg(spanText(m_lastProgress->remaining));
        if (m_desk.hasBaud())
            words += tr(" · at %1").arg(shortRate(m_lastProgress->baud));
    } else if (m_searching) {
        words = tr("The search begins …");
    } else if (m_error) {
        const text::Description error = text::describe(*m_error);
        words = error.what;
        tip = error.cause + QLatin1Char('\n') + error.remedy;
    } else if (const auto& report = m_desk.lastSearch()) {
        words = (report->stopped ? tr("Stopped after %1 · servos: %2")
                                 : tr("Searched in %1 · servos: %2"))
                    .arg(spanText(report->elapsed))
                    .arg(report->found.size());
        if (report->slowPassAdvised)
            words += QLatin1Char('\n') + tr("Some answered late: search again with \"wait "
                                            "longer\", there may be more.");
    }
    m_status->setText(words);
    m_status->setToolTip(tip.isEmpty() ? words : words + QLatin1Char('\n') + tip);
    const bool done = m_desk.lastSearch().has_value() && !m_searching;
    m_why->setVisible(done || m_stack->currentWidget() == m_scroll);
}

void SearchPanel::showScope()
{
    const jobs::ScanSpec spec = m_scope->spec();
    const base::Duration span = m_desk.searchEstimate(spec);
    const int ids = spec.lastId - spec.firstId + 1;
    QString words = tr("IDs to ask: %1").arg(ids);
    if (spec.bauds.size() > 1)
        words += tr(" · rates: %1").arg(spec.bauds.size());
    if (span.count() > 0)
        words += tr(" · about %1").arg(spanText(span));
    m_estimate->setText(words);
    m_estimate->setToolTip(tr("How long a search takes that finds nobody"));
}

void SearchPanel::showList(bool list)
{
    if (!list)
        return;
    m_stack->setCurrentWidget(m_model->rowCount() > 0 ? static_cast<QWidget*>(m_list) : m_empty);
    retranslate();
}

void SearchPanel::showChecklist()
{
    if (const auto& report = m_desk.lastSearch()) {
        m_checklist->show({m_desk.lastSearchSpec(), *report, m_desk.lastRequest(),
                           m_desk.hasBaud() || m_desk.state() != LinkState::Open, m_history});
        m_stack->setCurrentWidget(m_scroll);
        retranslate();
    }
}

void SearchPanel::listMenu(const QPoint& place)
{
    if (!m_list->indexAt(place).isValid() && !m_list->currentIndex().isValid())
        return;
    auto* menu = new QMenu(this);
    menu->setObjectName(QStringLiteral("servoMenu"));
    menu->setAttribute(Qt::WA_DeleteOnClose);
    menu->setToolTipsVisible(true);
    const auto add = [&](std::initializer_list<Command> commands) {
        for (const Command command : commands)
            menu->addAction(m_commands.action(command));
        menu->addSeparator();
    };
    add({Command::ReadTable, Command::Identify});
    add({Command::SetId, Command::SetBaud, Command::Center, Command::RestoreDefaults});
    add({Command::Reboot, Command::ClearAlarm, Command::CloseLock});
    menu->popup(m_list->viewport()->mapToGlobal(place));
}

void SearchPanel::followSelection()
{
    const int row = m_model->rowOf(m_selection.current());
    QItemSelectionModel* chosen = m_list->selectionModel();
    if (row < 0) {
        const QSignalBlocker quiet(chosen); // another row becoming current is nobody's choice
        chosen->clear();
        m_list->viewport()->update();
        return;
    }
    if (m_list->currentIndex().row() != row || !chosen->isRowSelected(row))
        m_list->setCurrentIndex(m_model->index(row, 0));
}

void SearchPanel::linkChanged()
{
    const bool open = m_desk.state() == LinkState::Open;
    m_scope->setHasBaud(!open || m_desk.hasBaud());
    m_delegate->setAsleep(!open);
    m_list->viewport()->update();
    showScope();
    showStatus();
    retranslate();
}

void SearchPanel::retranslate()
{
    m_search->setText(tr("Search"));
    m_stop->setText(tr("Stop"));
    for (const auto& [button, command] :
         {std::pair{m_search, Command::Search}, std::pair{m_stop, Command::StopSearch}}) {
        button->setToolTip(m_commands.action(command)->toolTip());
        button->setAccessibleName(button->text());
    }
    m_progress->setAccessibleName(tr("Progress of the search"));
    m_progress->setToolTip(tr("How much of the search is done"));
    m_list->setAccessibleName(tr("Servos"));
    m_list->setToolTip(tr("Servos that have answered; choosing one reads it and writes nothing"));
    m_empty->setText(m_desk.state() == LinkState::Open
                         ? tr("No servo in the list yet. Search the bus.")
                         : tr("Servos appear here as they are found."));
    m_empty->setToolTip(m_empty->text());
    const bool checklist = m_stack->currentWidget() == m_scroll;
    m_why->setText(checklist ? tr("Back to the list") : tr("Not all there? Find out why…"));
    m_why->setToolTip(checklist ? tr("Show the servos again")
                                : tr("What to look at when servos are missing"));
    m_why->setAccessibleName(m_why->text());
}

void SearchPanel::changeEvent(QEvent* event)
{
    QWidget::changeEvent(event);
    if (event->type() != QEvent::LanguageChange)
        return;
    m_model->retranslate();
    showScope();
    showStatus();
    retranslate();
}
} // namespace ui
