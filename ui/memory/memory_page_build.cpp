// SPDX-License-Identifier: GPL-3.0-or-later
// The parts of the memory page and their connections.
#include "ui/common/follow_language.h"
#include "ui/common/widget_style.h"
#include "ui/memory/memory_output.h"
#include "ui/memory/memory_page.h"
#include "ui/memory/memory_toolbar.h"
#include "ui/memory/memory_view.h"
#include "ui/memory/register_delegate.h"
#include "ui/memory/register_panel.h"
#include "ui/memory/servo_history_panel.h"
#include "ui/widgets/banner.h"
#include "ui/widgets/floating_overlay.h"
#include "ui/widgets/servo_obstacle.h"

#include <QMenu>
#include <QSplitter>
#include <QStackedWidget>
#include <QVBoxLayout>

namespace ui {
namespace {
using namespace std::chrono_literals;
constexpr auto refreshDelay = 25ms; // forty looks a second are more than an eye follows
constexpr auto ageStep = 1s;
constexpr auto liveDelay = 150ms;
const QString columnsKey = QStringLiteral("memory/hidden_columns");
} // namespace

MemoryPage::MemoryPage(session::Workbench& workbench, Commands& commands, Selection& selection,
                       session::Settings& settings, QWidget* parent)
    : QWidget(parent)
    , m_workbench(workbench)
    , m_workbenchGuard(&workbench)
    , m_commands(commands)
    , m_selection(selection)
{
    setObjectName(QStringLiteral("memoryPage"));
    m_filter.setSourceModel(&m_model);
    build(settings);
    connectTable();
    connectToolbar();
    connectWorkbench();
    connectCommands();
    followLanguage(this, [this] { retranslate(); });
    select();
}

MemoryPage::~MemoryPage() = default;

void MemoryPage::build(session::Settings& settings)
{
    m_toolbar = new MemoryToolbar(m_commands, settings, this);
    m_banner = new Banner(this);
    m_banner->setObjectName(QStringLiteral("memoryBanner"));
    m_banner->hideMessage();
    m_view = new MemoryView(this);
    m_delegate = new RegisterDelegate(m_view);
    m_view->setItemDelegate(m_delegate);
    m_view->setModel(&m_filter);
    m_empty = new ServoObstacle(m_commands, QStringLiteral("memoryNothing"), this);
    m_stack = new QStackedWidget(this);
    m_stack->addWidget(m_view);
    m_stack->addWidget(m_empty);
    makeTableCard(m_stack);
    m_view->setFrameShape(QFrame::NoFrame);
    auto* card = new QWidget(this);
    auto* side = new QSplitter(Qt::Vertical, card);
    side->setChildrenCollapsible(false);
    (new QVBoxLayout(card))->addWidget(side);
    makeCard(card);
    m_panel = new RegisterPanel(side);
    m_history = new ServoHistoryPanel(side);
    side->addWidget(m_panel);
    side->addWidget(m_history);
    side->setStretchFactor(0, 3);
    side->setStretchFactor(1, 1);
    m_splitter = new QSplitter(this);
    m_splitter->setChildrenCollapsible(false);
    m_splitter->addWidget(m_stack);
    m_splitter->addWidget(card);
    connect(m_splitter, &QSplitter::splitterMoved, this, [this] { m_userSplit = true; });
    auto* column = new QVBoxLayout(this);
    column->addWidget(m_toolbar);
    column->addWidget(m_splitter, 1);
    new FloatingOverlay(m_banner, this, FloatingOverlay::Corner::BottomRight);
    m_output = new MemoryOutput(m_workbench.registry(), m_model, *m_view);
    m_model.setPhysicalFirst(m_toolbar->physicalFirst());
    m_view->setPhysicalFirst(m_toolbar->physicalFirst());
    m_view->setHiddenColumns(settings.pageValue(columnsKey, QString()).toString().split(u','));
    connect(m_view, &MemoryView::hiddenColumnsChanged, this, [this, &settings] {
        settings.setPageValue(columnsKey, m_view->hiddenColumns().join(u','));
    });
    connect(m_toolbar->columnMenu(), &QMenu::aboutToShow, m_view,
            [this] { m_view->fillColumnMenu(*m_toolbar->columnMenu()); });
}

void MemoryPage::connectTable()
{
    connect(&m_model, &MemoryModel::writeRequested, this, &MemoryPage::requestWrite);
    connect(m_panel, &RegisterPanel::writeRequested, this, &MemoryPage::requestWrite);
    connect(m_delegate, &RegisterDelegate::editorLeft, this, &MemoryPage::showWarning);
    connect(m_view, &MemoryView::readOnlyActivated, this, &MemoryPage::explainReadOnly);
    connect(m_view, &MemoryView::scrolled, &m_liveTimer, qOverload<>(&QTimer::start));
    connect(m_view->selectionModel(), &QItemSelectionModel::currentRowChanged, this, [this] {
        clearWarning();
        showPanel();
    });
    const auto filtered = [this] {
        m_liveTimer.start();
        updateVisibility();
    };
    connect(&m_filter, &QAbstractItemModel::rowsInserted, this, filtered);
    connect(&m_filter, &QAbstractItemModel::rowsRemoved, this, filtered);
    connect(&m_model, &QAbstractItemModel::modelReset, this, [this] {
        m_view->resizeColumns();
        m_liveTimer.start();
        if (m_filter.rowCount() > 0 && !m_view->currentIndex().isValid())
            m_view->setCurrentIndex(m_filter.index(0, static_cast<int>(MemoryColumn::Value)));
    });
    connect(m_output, &MemoryOutput::failed, this, [this](const base::Error& error) {
        m_showsServoState = m_showsWarning = false;
        m_banner->showMessage(error);
    });
    connect(m_output, &MemoryOutput::saved, this, [this](const QString& path) {
        m_showsServoState = m_showsWarning = false;
        m_banner->showMessage([path] {
            return BannerText{Tone::Good, tr("The table was saved to %1.").arg(path)};
        });
    });
}

void MemoryPage::connectToolbar()
{
    connect(m_toolbar, &MemoryToolbar::textChanged, &m_filter, &MemoryFilter::setText);
    connect(m_toolbar, &MemoryToolbar::rowFilterChanged, &m_filter, &MemoryFilter::setRowFilter);
    connect(m_toolbar, &MemoryToolbar::groupChanged, &m_filter, &MemoryFilter::setGroup);
    connect(m_toolbar, &MemoryToolbar::livePeriodChanged, this, &MemoryPage::updateLive);
    connect(m_toolbar, &MemoryToolbar::physicalFirstChanged, this, [this](bool on) {
        m_model.setPhysicalFirst(on);
        m_view->setPhysicalFirst(on);
        m_view->resizeColumns();
        showPanel();
    });
    connect(m_toolbar, &MemoryToolbar::helpRequested, m_panel,
            [this] { m_panel->setFocus(Qt::OtherFocusReason); });
}

void MemoryPage::connectWorkbench()
{
    m_refresh.setSingleShot(true);
    m_refresh.setInterval(refreshDelay);
    m_age.setInterval(ageStep);
    m_liveTimer.setSingleShot(true);
    m_liveTimer.setInterval(liveDelay);
    connect(&m_refresh, &QTimer::timeout, this, &MemoryPage::refresh);
    connect(&m_age, &QTimer::timeout, this, [this] {
        refresh();
        m_view->growColumns();
    });
    connect(&m_liveTimer, &QTimer::timeout, this, &MemoryPage::updateLive);
    const auto concern = [this](session::ServoRef ref) {
        if (ref == m_selection.current())
            scheduleRefresh();
    };
    connect(&m_workbench.registry(), &session::ServoRegistry::tableChanged, this, concern);
    connect(&m_workbench, &session::Workbench::eventOccurred, this,
            [this](const session::Event& event) {
                if (event.kind == session::Event::Kind::Stopped)
                    m_panel->discardEdit();
            });
    connect(&m_workbench.registry(), &session::ServoRegistry::servoChanged, this, concern);
    connect(&m_workbench.link(), &session::LinkController::linkChanged, this, [this] {
        scheduleRefresh();
        if (m_workbench.link().state() == session::LinkState::Open)
            read();
    });
    connect(&m_selection, &Selection::changed, this, &MemoryPage::select);
}

void MemoryPage::connectCommands()
{
    const auto on = [this](Command command, auto&& work) {
        connect(m_commands.action(command), &QAction::triggered, this, work);
    };
    on(Command::ReadTable, [this] { read(); });
    on(Command::FindRegister, [this] { m_toolbar->focusSearch(); });
    on(Command::CloseLock, [this] { closeLock(); });
    // Also from other pages, where the table is not kept up to date.
    on(Command::CopyRows, [this] {
        refresh();
        m_output->copyRows();
    });
    on(Command::ExportTable, [this] {
        refresh();
        m_output->exportTable();
    });
    on(Command::PrintTable, [this] {
        refresh();
        m_output->printTable();
    });
}
} // namespace ui
