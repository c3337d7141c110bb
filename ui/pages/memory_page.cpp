// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/memory_page.h"

#include "device/writer.h"
#include "text/error_words.h"
#include "ui/editors/register_delegate.h"
#include "ui/pages/history_panel.h"
#include "ui/pages/lock_badge.h"
#include "ui/pages/memory_output.h"
#include "ui/pages/memory_toolbar.h"
#include "ui/pages/memory_view.h"
#include "ui/pages/register_panel.h"
#include "ui/pages/write_question.h"
#include "ui/widgets/banner.h"

#include <QEvent>
#include <QHeaderView>
#include <QLabel>
#include <QSplitter>
#include <QStackedWidget>
#include <QVBoxLayout>

#include <utility>

namespace ui {
using catalog::Role;

namespace {
using namespace std::chrono_literals;
constexpr auto refreshDelay = 25ms; // forty looks a second are more than an eye follows
constexpr auto ageStep = 1s;
constexpr auto liveDelay = 150ms;
// Of the panel beside the table, in letters; between them a share of the width.
constexpr int leastPanel = 28;
constexpr int mostPanel = 48;
constexpr int panelPercent = 28;

/// What the servo left out of its whole table it never tells (stored move of some LX).
bool answersTo(const session::ServoEntry& entry, const catalog::Register& reg)
{
    return entry.servo.raw(reg).has_value();
}
} // namespace

MemoryPage::MemoryPage(session::Desk& desk, Commands& commands, Selection& selection,
                       session::Settings& settings, QWidget* parent)
    : QWidget(parent)
    , m_desk(desk)
    , m_deskLives(&desk)
    , m_commands(commands)
    , m_selection(selection)
{
    setObjectName(QStringLiteral("memoryPage"));
    m_filter.setSourceModel(&m_model);
    build(settings);
    connectTable();
    connectToolbar();
    connectDesk();
    connectCommands();
    retranslate();
    select();
}

MemoryPage::~MemoryPage() = default;

void MemoryPage::build(session::Settings& settings)
{
    m_toolbar = new MemoryToolbar(m_commands, settings, this);
    m_banner = new Banner(this);
    m_banner->setObjectName(QStringLiteral("memoryBanner"));
    m_banner->clear();
    m_view = new MemoryView(this);
    m_delegate = new RegisterDelegate(m_view);
    m_view->setItemDelegate(m_delegate);
    m_view->setModel(&m_filter);
    m_nothing = new QLabel(this);
    m_nothing->setObjectName(QStringLiteral("memoryNothing"));
    m_nothing->setAlignment(Qt::AlignCenter);
    m_nothing->setWordWrap(true);
    m_stack = new QStackedWidget(this);
    m_stack->addWidget(m_view);
    m_stack->addWidget(m_nothing);
    auto* side = new QSplitter(Qt::Vertical, this);
    side->setChildrenCollapsible(false);
    m_panel = new RegisterPanel(side);
    m_history = new HistoryPanel(side);
    side->addWidget(m_panel);
    side->addWidget(m_history);
    side->setStretchFactor(0, 3);
    side->setStretchFactor(1, 1);
    m_panel->setMinimumWidth(fontMetrics().averageCharWidth() * leastPanel);
    m_splitter = new QSplitter(this);
    m_splitter->setChildrenCollapsible(false);
    m_splitter->addWidget(m_stack);
    m_splitter->addWidget(side);
    connect(m_splitter, &QSplitter::splitterMoved, this, [this] { m_ownSplit = true; });
    auto* column = new QVBoxLayout(this);
    column->addWidget(m_toolbar);
    column->addWidget(m_banner);
    column->addWidget(m_splitter, 1);
    m_output = new MemoryOutput(m_desk, m_model, *m_view);
    m_model.setPhysicalFirst(m_toolbar->physicalFirst());
    m_view->setPhysicalFirst(m_toolbar->physicalFirst());
}

void MemoryPage::connectTable()
{
    connect(&m_model, &MemoryModel::writeWanted, this,
            [this](const QString& key, qint64 raw) { orderWrite(key, raw, false); });
    connect(m_panel, &RegisterPanel::writeWanted, this, &MemoryPage::orderWrite);
    connect(m_delegate, &RegisterDelegate::leftUnwritten, this, &MemoryPage::complain);
    connect(m_view, &MemoryView::readOnlyChosen, this, &MemoryPage::explainReadOnly);
    connect(m_view, &MemoryView::scrolled, &m_live, qOverload<>(&QTimer::start));
    connect(m_view->selectionModel(), &QItemSelectionModel::currentRowChanged, this, [this] {
        settleComplaint();
        showPanel();
    });
    const auto filtered = [this] {
        m_live.start();
        showWhich();
    };
    connect(&m_filter, &QAbstractItemModel::rowsInserted, this, filtered);
    connect(&m_filter, &QAbstractItemModel::rowsRemoved, this, filtered);
    connect(&m_model, &QAbstractItemModel::modelReset, this, [this] {
        m_view->measure();
        m_live.start();
        if (m_filter.rowCount() > 0 && !m_view->currentIndex().isValid())
            m_view->setCurrentIndex(m_filter.index(0, static_cast<int>(MemoryColumn::Value)));
    });
    connect(m_output, &MemoryOutput::failed, this, [this](const base::Error& error) {
        m_standing = m_complaining = false;
        m_banner->present(error);
    });
    connect(m_output, &MemoryOutput::saved, this, [this](const QString& path) {
        m_standing = m_complaining = false;
        m_banner->present([path] {
            return BannerWords{Tone::Good, tr("The table was written to %1.").arg(path)};
        });
    });
}

void MemoryPage::connectToolbar()
{
    connect(m_toolbar, &MemoryToolbar::textChanged, &m_filter, &MemoryFilter::setText);
    connect(m_toolbar, &MemoryToolbar::choiceChanged, &m_filter, &MemoryFilter::setChoice);
    connect(m_toolbar, &MemoryToolbar::groupChanged, &m_filter, &MemoryFilter::setGroup);
    connect(m_toolbar, &MemoryToolbar::livePeriodChanged, this, &MemoryPage::updateLive);
    connect(m_toolbar, &MemoryToolbar::physicalFirstChanged, this, [this](bool on) {
        m_model.setPhysicalFirst(on);
        m_view->setPhysicalFirst(on);
        m_view->measure();
        showPanel();
    });
    connect(m_toolbar, &MemoryToolbar::helpWanted, m_panel,
            [this] { m_panel->setFocus(Qt::OtherFocusReason); });
}

void MemoryPage::connectDesk()
{
    m_refresh.setSingleShot(true);
    m_refresh.setInterval(refreshDelay);
    m_age.setInterval(ageStep);
    m_live.setSingleShot(true);
    m_live.setInterval(liveDelay);
    connect(&m_refresh, &QTimer::timeout, this, &MemoryPage::refresh);
    connect(&m_age, &QTimer::timeout, this, [this] {
        refresh();
        m_view->grow();
    });
    connect(&m_live, &QTimer::timeout, this, &MemoryPage::updateLive);
    const auto concern = [this](session::ServoRef ref) {
        if (ref == m_selection.current())
            refreshSoon();
    };
    connect(&m_desk, &session::Desk::tableChanged, this, concern);
    connect(&m_desk, &session::Desk::servoChanged, this, concern);
    connect(&m_desk, &session::Desk::linkChanged, this, [this] {
        refreshSoon();
        if (m_desk.state() == session::LinkState::Open)
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
    on(Command::FindRegister, [this] { m_toolbar->focusFind(); });
    on(Command::CloseLock, [this] { closeLock(); });
    on(Command::CopyRows, [this] { m_output->copyRows(); });
    on(Command::ExportTable, [this] { m_output->exportTable(); });
    on(Command::PrintTable, [this] { m_output->printTable(); });
}

const session::ServoEntry* MemoryPage::entry() const
{
    return m_desk.servo(m_selection.current());
}

void MemoryPage::select()
{
    m_banner->clear();
    m_standing = m_complaining = false;
    refresh();
    read();
    if (entry() != nullptr)
        m_desk.loadHistory(m_selection.current());
    updateLive();
}

void MemoryPage::read()
{
    const session::ServoEntry* known = entry();
    if (known != nullptr && known->servo.profile && m_desk.state() == session::LinkState::Open)
        m_desk.readTable(m_selection.current());
}

void MemoryPage::refreshSoon()
{
    if (!m_refresh.isActive())
        m_refresh.start();
}

void MemoryPage::refresh()
{
    const session::ServoEntry* known = entry();
    const bool open = m_desk.state() == session::LinkState::Open;
    m_model.setEntry(known, {m_desk.now(), open});
    m_toolbar->lockBadge()->setEntry(known);
    const bool wasComplete = std::exchange(m_complete, known != nullptr && known->tableRead);
    if (m_complete && !wasComplete)
        m_live.start();
    m_history->setEntry(known);
    showPanel();
    showWhich();
    showStanding();
}

void MemoryPage::showPanel()
{
    const QModelIndex source = m_filter.mapToSource(m_view->currentIndex());
    const MemoryRow* row = source.isValid() ? &m_model.row(source.row()) : nullptr;
    m_panel->showRow(m_model.servo(), row, m_model.profile(), m_model.physicalFirst());
}

/// The table, or why there is none.
void MemoryPage::showWhich()
{
    const session::ServoEntry* known = entry();
    QString why;
    if (known == nullptr)
        why = tr("Choose a servo at the left to see its memory table. Choosing reads it and writes "
                 "nothing.");
    else if (!known->servo.profile)
        why = tr("This servo answers, but does not say what it is, so there is no table for it. "
                 "Search again, or check whether two servos share the ID.");
    else if (m_filter.rowCount() == 0)
        why = tr("No register fits the filter.");
    if (m_nothing->text() != why)
        m_nothing->setText(why);
    m_stack->setCurrentWidget(why.isEmpty() ? static_cast<QWidget*>(m_view) : m_nothing);
}

/// What is wrong with the servo as a whole; an input's complaint is not pushed aside by it.
void MemoryPage::showStanding()
{
    const session::ServoEntry* known = entry();
    const bool unknownMap =
        known != nullptr && known->servo.profile && !known->servo.profile->writable;
    const bool failed = known != nullptr && known->readError && !known->reading;
    if (!unknownMap && !failed) {
        if (m_standing)
            m_banner->clear();
        m_standing = false;
        return;
    }
    if (m_standing || m_banner->isVisibleTo(this))
        return;
    m_standing = true;
    if (failed) {
        m_banner->present(*known->readError);
        return;
    }
    m_banner->present([] {
        return BannerWords{
            Tone::Warn, tr("The firmware of this servo is not known."),
            tr("No public memory table fits it, so a write could do damage."),
            tr("Identity and measurements are shown. Writing becomes possible with a model file.")};
    });
}

void MemoryPage::complain(const QString& words)
{
    m_standing = false;
    m_complaining = true;
    m_banner->present([words] { return BannerWords{Tone::Warn, words}; });
}

/// What was wrong with an input is over when one goes on.
void MemoryPage::settleComplaint()
{
    if (m_complaining)
        m_banner->clear();
    m_complaining = false;
}

void MemoryPage::explainReadOnly(const QModelIndex& index)
{
    const QModelIndex source = m_filter.mapToSource(index);
    if (!source.isValid())
        return;
    base::Error error{base::ErrorCode::ReadOnly, QStringLiteral("write")};
    error.registerKey = m_model.row(source.row()).reg->key;
    m_standing = false;
    m_complaining = true;
    m_banner->present(error);
}

void MemoryPage::updateLive()
{
    const auto period = m_toolbar->livePeriod();
    const session::ServoEntry* known = entry();
    // The whole table first: it tells what this servo answers to.
    const bool may = known != nullptr && known->servo.profile && known->tableRead && isVisible();
    if (!period || !may) {
        m_desk.watchLive(0, {}, {});
        return;
    }
    QStringList keys;
    for (const QString& key : m_view->visibleKeys()) {
        const catalog::Register* reg = known->servo.profile->find(key);
        if (reg != nullptr && answersTo(*known, *reg))
            keys << key;
    }
    m_desk.watchLive(m_selection.current(), keys, *period);
}

void MemoryPage::orderWrite(const QString& key, std::int64_t raw, bool temporary)
{
    const session::ServoEntry* known = entry();
    const catalog::Register* reg =
        known != nullptr && known->servo.profile ? known->servo.profile->find(key) : nullptr;
    if (reg == nullptr || writeOtherwise(*known, *reg, raw))
        return;
    settleComplaint();
    const session::ServoRef ref = known->ref;
    auto question = writeQuestion(*known, *reg, raw, temporary);
    if (!question) {
        send(ref, key, raw, temporary);
        return;
    }
    question->guard = this;
    ask(this, *question, [this, ref, key, raw, temporary] { send(ref, key, raw, temporary); });
}

/// Registers whose value is a deed of its own go the way of that deed.
bool MemoryPage::writeOtherwise(const session::ServoEntry& entry, const catalog::Register& reg,
                                std::int64_t raw)
{
    constexpr std::int64_t makeMiddle = 128;
    constexpr std::int64_t centreBit = 4;
    const bool centres = (reg.role == Role::TorqueSwitch && raw == makeMiddle) ||
                         (reg.role == Role::FaultReset && (raw & centreBit) != 0);
    QAction* centre = m_commands.action(Command::Center);
    if (centres && centre->isEnabled()) {
        centre->trigger();
        return true;
    }
    if (reg.role == Role::Lock && raw != 0 && entry.lockOpen().value_or(false)) {
        closeLock();
        return true;
    }
    return false;
}

/// Consent has been given where it was due; asking is over by now.
void MemoryPage::send(session::ServoRef ref, const QString& key, std::int64_t raw, bool temporary)
{
    session::WriteOrder order;
    order.items.push_back({key, raw});
    order.temporary = temporary;
    order.dangerous = true;
    m_desk.write(ref, order);
}

void MemoryPage::closeLock()
{
    session::Task task;
    task.name = QStringLiteral("close-lock");
    task.work = [](session::TaskContext& context) -> base::Result<void> {
        const device::LockState lock = device::closeLock(context.device, context.servo);
        if (lock == device::LockState::Closed || lock == device::LockState::None)
            return {};
        return base::fail(base::ErrorCode::LockOpen, QStringLiteral("close-lock"), {},
                          context.servo.id);
    };
    m_desk.perform(m_selection.current(), std::move(task));
}

void MemoryPage::retranslate()
{
    setAccessibleName(tr("Memory table"));
    m_view->setAccessibleName(tr("Memory table"));
    m_view->setToolTip(tr("Enter or a double click changes a value; nothing is written before "
                          "Enter is pressed again"));
    m_model.retranslate();
    m_view->measure();
    refresh();
}

void MemoryPage::changeEvent(QEvent* event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange)
        retranslate();
}

void MemoryPage::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    if (m_ownSplit)
        return;
    const int letter = fontMetrics().averageCharWidth();
    const int side =
        std::clamp(width() * panelPercent / 100, leastPanel * letter, mostPanel * letter);
    m_splitter->setSizes({std::max(0, width() - side), side});
}

void MemoryPage::showEvent(QShowEvent* event)
{
    QWidget::showEvent(event);
    m_age.start();
    refreshSoon();
    m_live.start();
}

void MemoryPage::hideEvent(QHideEvent* event)
{
    QWidget::hideEvent(event);
    m_age.stop();
    if (m_deskLives)
        updateLive();
}
} // namespace ui
