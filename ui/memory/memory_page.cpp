// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/memory/memory_page.h"

#include "device/write_access.h"
#include "device/write_meaning.h"
#include "device/writer.h"
#include "text/error_text.h"
#include "ui/editors/write_question.h"
#include "ui/memory/lock_badge.h"
#include "ui/memory/memory_output.h"
#include "ui/memory/memory_text.h"
#include "ui/memory/memory_toolbar.h"
#include "ui/memory/memory_view.h"
#include "ui/memory/register_panel.h"
#include "ui/memory/servo_history_panel.h"
#include "ui/widgets/banner.h"
#include "ui/widgets/servo_obstacle.h"

#include <QSplitter>
#include <QStackedWidget>

#include <utility>

namespace ui {
using catalog::Role;

namespace {
// Of the panel beside the table, in letters; between them a share of the width.
constexpr int minPanelChars = 28;
constexpr int maxPanelChars = 48;
constexpr int panelPercent = 20;

/// What is missing in a complete reading cannot be read (stored move of some LX).
bool hasValue(const session::ServoEntry& entry, const catalog::Register& reg)
{
    return entry.servo.raw(reg).has_value();
}
} // namespace

const session::ServoEntry* MemoryPage::entry() const
{
    return m_workbench.registry().servo(m_selection.current());
}

void MemoryPage::select()
{
    m_banner->hideMessage();
    m_showsServoState = m_showsWarning = false;
    refresh();
    read();
    if (entry() != nullptr)
        m_workbench.writes().loadHistory(m_selection.current());
    updateLive();
}

void MemoryPage::read()
{
    const session::ServoEntry* known = entry();
    if (known != nullptr && known->servo.profile &&
        m_workbench.link().state() == session::LinkState::Open)
        m_workbench.writes().readTable(m_selection.current());
}

void MemoryPage::scheduleRefresh()
{
    if (isVisible() && !m_refresh.isActive()) // shown again, it looks anyway
        m_refresh.start();
}

void MemoryPage::refresh()
{
    const session::ServoEntry* known = entry();
    const bool open = m_workbench.link().state() == session::LinkState::Open;
    m_model.setEntry(known, {m_workbench.now(), open});
    m_toolbar->lockBadge()->setEntry(known);
    const bool wasComplete = std::exchange(m_complete, known != nullptr && known->hasFullTable);
    if (m_complete && !wasComplete)
        m_liveTimer.start();
    m_history->setEntry(known);
    showPanel();
    updateVisibility();
    showServoState();
}

void MemoryPage::showPanel()
{
    const QModelIndex source = m_filter.mapToSource(m_view->currentIndex());
    const MemoryRow* row = source.isValid() ? &m_model.row(source.row()) : nullptr;
    m_panel->showRow(m_model.servo(), row, m_model.profile(), m_model.physicalFirst());
}

/// The table, or why there is none.
void MemoryPage::updateVisibility()
{
    const session::ServoEntry* known = entry();
    QString why;
    if (known == nullptr)
        why = tr("Select a servo on the left to see its memory table. Selecting a servo only "
                 "reads it and writes nothing.");
    else if (!known->servo.profile)
        why = unidentifiedText(*known);
    else if (m_filter.rowCount() == 0)
        why = tr("No register matches the filter.");
    m_empty->showObstacle(why, known);
    m_stack->setCurrentWidget(why.isEmpty() ? static_cast<QWidget*>(m_view) : m_empty);
}

/// Problems of the whole servo; they do not replace a message about an input.
void MemoryPage::showServoState()
{
    const session::ServoEntry* known = entry();
    const auto bar = known != nullptr && known->servo.profile ? device::writeObstacle(known->servo)
                                                              : std::nullopt;
    const bool failed = known != nullptr && known->readError && !known->isReadingTable;
    if (!bar && !failed) {
        if (m_showsServoState)
            m_banner->hideMessage();
        m_showsServoState = false;
        return;
    }
    if (m_showsServoState || m_banner->isVisibleTo(this))
        return;
    m_showsServoState = true;
    if (failed) {
        m_banner->showMessage(*known->readError);
        return;
    }
    if (bar->code == base::ErrorCode::FamilyConflict) {
        m_banner->showMessage([error = *bar] {
            const text::Description words = text::describe(error);
            return BannerText{Tone::Warn, words.message, words.cause, words.remedy};
        });
        return;
    }
    m_banner->showMessage([] {
        return BannerText{
            Tone::Warn, tr("The firmware of this servo is not known."),
            tr("No published register map matches this firmware, so a write could cause damage."),
            tr("Only the servo's identity and its measurements are shown. Add a model file to "
               "allow writing.")};
    });
}

void MemoryPage::showWarning(const QString& words)
{
    m_showsServoState = false;
    m_showsWarning = true;
    m_banner->showMessage([words] { return BannerText{Tone::Warn, words}; });
}

/// A message about an input is hidden when the user continues.
void MemoryPage::clearWarning()
{
    if (m_showsWarning)
        m_banner->hideMessage();
    m_showsWarning = false;
}

void MemoryPage::explainReadOnly(const QModelIndex& index)
{
    const QModelIndex source = m_filter.mapToSource(index);
    if (!source.isValid())
        return;
    const catalog::Register* reg = m_model.row(source.row()).reg;
    m_showsServoState = false;
    m_showsWarning = true;
    m_banner->showMessage([reg, profile = m_model.profile()] { // the profile is the register's home
        base::Error error{base::ErrorCode::ReadOnly, QStringLiteral("write")};
        error.registerKey = reg->key;
        const text::Description words = text::describe(withName(error, reg));
        return BannerText{Tone::Warn, words.message, words.cause, words.remedy};
    });
}

void MemoryPage::updateLive()
{
    const auto period = m_toolbar->livePeriod();
    const session::ServoEntry* known = entry();
    // The whole table first: it shows which registers this servo answers.
    const bool may = known != nullptr && known->servo.profile && known->hasFullTable && isVisible();
    if (!period || !may) {
        m_workbench.polling().subscribe(QStringLiteral("memory"), {});
        return;
    }
    QStringList keys;
    for (const QString& key : m_view->visibleKeys()) {
        const catalog::Register* reg = known->servo.profile->find(key);
        if (reg != nullptr && hasValue(*known, *reg))
            keys << key;
    }
    session::Subscription subscription{{}, *period};
    if (!keys.isEmpty())
        subscription.parts.push_back({m_selection.current(), keys});
    m_workbench.polling().subscribe(QStringLiteral("memory"), subscription);
}

void MemoryPage::requestWrite(const QString& key, std::int64_t raw, bool temporary)
{
    const session::ServoEntry* known = entry();
    const catalog::Register* reg =
        known != nullptr && known->servo.profile ? known->servo.profile->find(key) : nullptr;
    if (reg == nullptr || writeByOwnAction(*reg, raw))
        return;
    clearWarning();
    const session::ServoRef ref = known->ref;
    auto question = writeQuestion(*known, {{key, raw}}, temporary);
    if (!question) {
        m_workbench.writes().write(ref, {{{key, raw}}, temporary, {}});
        return;
    }
    question->guard = this;
    ask(this, *question, [this, ref, key, raw, temporary] {
        m_workbench.writes().write(ref, {{{key, raw}}, temporary, device::Consent::confirmed()});
    });
}

/// Values that are an action of their own are written by that action.
bool MemoryPage::writeByOwnAction(const catalog::Register& reg, std::int64_t raw)
{
    const device::WriteProcedure procedure = device::classify(reg, raw).procedure;
    QAction* action =
        procedure == device::WriteProcedure::Center      ? m_commands.action(Command::Center)
        : procedure == device::WriteProcedure::CloseLock ? m_commands.action(Command::CloseLock)
                                                         : nullptr;
    if (action == nullptr || !action->isEnabled())
        return false;
    action->trigger();
    return true;
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
    m_workbench.tasks().perform(m_selection.current(), std::move(task));
}

void MemoryPage::retranslate()
{
    setAccessibleName(tr("Memory table"));
    m_view->setAccessibleName(tr("Memory table"));
    m_view->setToolTip(tr("Press Enter or double-click to edit a value; nothing is written until "
                          "you press Enter after editing"));
    m_model.retranslate();
    m_view->resizeColumns();
    refresh();
}

void MemoryPage::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    const int charWidth = fontMetrics().averageCharWidth();
    m_panel->setMinimumWidth(minPanelChars * charWidth);
    if (m_userSplit)
        return;
    const int side = std::clamp(width() * panelPercent / 100, minPanelChars * charWidth,
                                maxPanelChars * charWidth);
    m_splitter->setSizes({std::max(0, width() - side), side});
}

void MemoryPage::showEvent(QShowEvent* event)
{
    QWidget::showEvent(event);
    m_age.start();
    scheduleRefresh();
    m_liveTimer.start();
}

void MemoryPage::hideEvent(QHideEvent* event)
{
    QWidget::hideEvent(event);
    m_age.stop();
    if (m_workbenchGuard)
        updateLive();
}
} // namespace ui
