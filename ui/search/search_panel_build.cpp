// SPDX-License-Identifier: GPL-3.0-or-later
// The parts of the search panel and their connections.
#include "ui/common/follow_language.h"
#include "ui/common/widget_style.h"
#include "ui/search/search_panel.h"
#include "ui/search/search_scope.h"
#include "ui/search/servo_delegate.h"
#include "ui/search/servo_list_model.h"
#include "ui/widgets/thin_progress.h"

#include <QLabel>
#include <QListView>
#include <QPushButton>
#include <QStackedWidget>
#include <QVBoxLayout>

namespace ui {
using session::ServoRef;
using namespace std::chrono_literals;

namespace {
QLabel* secondaryLabel(QWidget* parent, const char* name)
{
    auto* label = new QLabel(parent);
    label->setObjectName(QLatin1String(name));
    label->setTextFormat(Qt::PlainText);
    label->setWordWrap(true);
    label->setForegroundRole(QPalette::PlaceholderText);
    return label;
}
} // namespace

SearchPanel::SearchPanel(session::Workbench& workbench, Commands& commands, Selection& selection,
                         session::Settings& settings, QWidget* parent)
    : QWidget(parent)
    , m_workbench(workbench)
    , m_commands(commands)
    , m_selection(selection)
    , m_scope(new SearchScope(settings, this))
    , m_estimate(secondaryLabel(this, "searchEstimate"))
    , m_search(new QPushButton(this))
    , m_stop(new QPushButton(this))
    , m_progress(new ThinProgress(this))
    , m_status(secondaryLabel(this, "searchStatus"))
    , m_stack(new QStackedWidget(this))
    , m_list(new QListView(this))
    , m_empty(secondaryLabel(this, "servoListEmpty"))
    , m_model(new ServoListModel(workbench.registry(), workbench.catalog(), this))
    , m_delegate(new ServoDelegate(this))
    , m_findOut(new QPushButton(this))
    , m_why(new QPushButton(this))
{
    build();
    connectWorkbench();
    connectList();
    linkChanged();
    followLanguage(this, [this] {
        m_model->retranslate();
        showScope();
        showStatus();
        retranslate();
    });
    followSelection();
}

void SearchPanel::build()
{
    setObjectName(QStringLiteral("searchPanel"));
    setProperty("panel", true);
    setAttribute(Qt::WA_StyledBackground);
    m_search->setObjectName(QStringLiteral("searchButton"));
    makeMainAction(m_search);
    m_stop->setObjectName(QStringLiteral("stopSearchButton"));
    m_progress->setObjectName(QStringLiteral("searchProgress"));
    m_progress->setRange(0, permille);
    m_findOut->setObjectName(QStringLiteral("findOutButton"));
    m_why->setObjectName(QStringLiteral("whyButton"));
    m_why->setFlat(true);
    m_why->setProperty("link", true);
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
    m_list->setSelectionMode(QAbstractItemView::ExtendedSelection);
    m_list->setItemDelegate(m_delegate);
    m_list->setUniformItemSizes(false);
    m_list->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_list->setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
    m_list->setContextMenuPolicy(Qt::CustomContextMenu);
    m_list->setEditTriggers(QAbstractItemView::NoEditTriggers);
    auto* empty = new QWidget(m_stack);
    auto* column = new QVBoxLayout(empty);
    column->addWidget(m_empty);
    column->addWidget(m_findOut, 0, Qt::AlignLeft);
    column->addStretch(1);
    m_stack->addWidget(m_list);
    m_stack->addWidget(empty);
    return m_stack;
}

void SearchPanel::connectWorkbench()
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
    trigger(m_findOut, Command::Diagnose);
    trigger(m_why, Command::Diagnose);
    connect(&m_workbench.search(), &session::SearchService::searchChanged, this,
            &SearchPanel::searchChanged);
    connect(&m_workbench.search(), &session::SearchService::searchProgress, this,
            &SearchPanel::showProgress);
    connect(&m_workbench, &session::Workbench::eventOccurred, this, &SearchPanel::onEvent);
    connect(&m_workbench.link(), &session::LinkController::linkChanged, this,
            &SearchPanel::linkChanged);
    m_tick.setInterval(1s);
    connect(&m_tick, &QTimer::timeout, m_model, &ServoListModel::updateAges);
    m_tick.start();
}

void SearchPanel::connectList()
{
    connect(m_list->selectionModel(), &QItemSelectionModel::selectionChanged, this,
            &SearchPanel::onListSelectionChanged);
    connect(&m_selection, &Selection::selectedServosChanged, this, &SearchPanel::followSelection);
    connect(m_list, &QListView::customContextMenuRequested, this, &SearchPanel::showContextMenu);
    const auto updateList = [this] {
        showList();
        followSelection();
    };
    connect(m_model, &QAbstractItemModel::rowsInserted, this, updateList);
    connect(m_model, &QAbstractItemModel::modelReset, this, updateList);
    connect(m_model, &QAbstractItemModel::rowsRemoved, this, [this] {
        followSelection();
        showList();
    });
    // Remarks come and go: the rows have another height then.
    connect(m_model, &QAbstractItemModel::dataChanged, m_list, [this] { m_list->doItemsLayout(); });
}
} // namespace ui
