// SPDX-License-Identifier: GPL-3.0-or-later
// What is shown. The parts are made in snapshots_page_build.cpp, the actions are in
// snapshots_page_actions.cpp.
#include "ui/snapshots/snapshots_page.h"

#include "session/polling/max_reading_age.h"
#include "snapshot/factory_snapshot.h"
#include "ui/snapshots/snapshot_browser.h"
#include "ui/snapshots/snapshot_pane.h"
#include "ui/widgets/banner.h"
#include "ui/widgets/rate_text.h"
#include "ui/widgets/task_text.h"

#include <QAction>
#include <QCheckBox>
#include <QDragEnterEvent>
#include <QLabel>
#include <QMenu>
#include <QMimeData>
#include <QPushButton>
#include <QToolButton>

namespace ui {
namespace {
using namespace std::chrono_literals;

constexpr base::Duration readInterval = 500ms;

/// The settings that it answers to; the whole table has shown which.
QStringList settingsOf(const session::ServoEntry& entry)
{
    QStringList keys;
    for (const catalog::Register& reg : entry.servo.profile->registers) {
        if (reg.writable() && entry.servo.raw(reg))
            keys << reg.key;
    }
    return keys;
}

/// Of its settings the oldest.
base::Duration tableAge(const session::ServoEntry& entry, base::Duration now)
{
    base::Duration oldest = now;
    for (const catalog::Register& reg : entry.servo.profile->registers) {
        if (reg.writable() && entry.servo.raw(reg))
            oldest = std::min(oldest, entry.servo.image.readAt(reg.offset).value_or(now));
    }
    return now - oldest;
}

bool isCurrent(const session::ServoEntry& entry, base::Duration now)
{
    return entry.hasFullTable && !entry.silent && tableAge(entry, now) <= session::maxReadingAge;
}

bool sameParts(const std::vector<session::SubscriptionItem>& one,
               const std::vector<session::SubscriptionItem>& other)
{
    return std::equal(one.begin(), one.end(), other.begin(), other.end(),
                      [](const session::SubscriptionItem& a, const session::SubscriptionItem& b) {
                          return a.servo == b.servo && a.slowKeys == b.slowKeys;
                      });
}
} // namespace

SnapshotsPage::SnapshotsPage(AppContext& appContext, session::Settings& settings, QWidget* parent)
    : QWidget(parent)
    , m_desk(appContext.desk)
    , m_deskGuard(&appContext.desk)
    , m_historyService(appContext.history)
    , m_selection(appContext.selection)
    , m_settings(settings)
    , m_snapshots(appContext.desk, appContext.history)
{
    setObjectName(QStringLiteral("snapshotsPage"));
    setAcceptDrops(true);
    build();
    connectAll();
    retranslate();
    onServoSelected();
}

const session::ServoEntry* SnapshotsPage::entry() const
{
    const session::ServoEntry* found = m_desk.servo(m_selection.current());
    return found != nullptr && found->servo.profile ? found : nullptr;
}

/// Compared is what was really read: the table is read anew when a servo is looked at.
void SnapshotsPage::onServoSelected()
{
    if (!m_deskGuard)
        return;
    if (isVisible() && entry() != nullptr && !m_writing)
        m_desk.readTable(m_selection.current());
    scheduleRefresh();
}

void SnapshotsPage::scheduleRefresh()
{
    if (isVisible() && !m_refresh.isActive())
        m_refresh.start();
}

CompareColumn SnapshotsPage::servoTable(session::ServoRef ref) const
{
    const session::ServoEntry* servo = m_desk.servo(ref);
    if (servo == nullptr || !servo->servo.profile)
        return {};
    const base::Duration now = m_desk.now();
    const QString title = isCurrent(*servo, now) ? tr("ID %1 now").arg(servo->servo.id)
                          : servo->hasFullTable  ? QStringLiteral("ID %1 · %2")
                                                      .arg(servo->servo.id)
                                                      .arg(timeAgoText(tableAge(*servo, now)))
                                                : QStringLiteral("ID %1").arg(servo->servo.id);
    return {title, servoTitle(*servo), m_snapshots.currentSnapshot(ref), servo->servo.profile};
}

/// One line for each servo whose column does not say how it is set now.
QStringList SnapshotsPage::ages() const
{
    std::set<session::ServoRef> shown = m_others;
    shown.insert(m_selection.current());
    QStringList lines;
    for (const session::ServoRef ref : shown) {
        const session::ServoEntry* servo = m_desk.servo(ref);
        const base::Duration now = m_desk.now();
        if (servo == nullptr || !servo->servo.profile || isCurrent(*servo, now))
            continue;
        const QString ago = timeAgoText(tableAge(*servo, now));
        lines << (!servo->hasFullTable ? tr("ID %1 · not read yet").arg(servo->servo.id)
                  : servo->silent ? tr("ID %1 · no answer · read %2").arg(servo->servo.id).arg(ago)
                                  : tr("ID %1 · read %2").arg(servo->servo.id).arg(ago));
    }
    return lines;
}

/// Other programs may write too, and a servo may be exchanged for one of the same model.
void SnapshotsPage::updateLive()
{
    std::vector<session::SubscriptionItem> parts;
    std::set<session::ServoRef> shown = m_others;
    shown.insert(m_selection.current());
    for (const session::ServoRef ref : shown) {
        const session::ServoEntry* servo = isVisible() ? m_desk.servo(ref) : nullptr;
        if (servo != nullptr && servo->servo.profile && servo->hasFullTable)
            parts.push_back({ref, {}, settingsOf(*servo)});
    }
    if (sameParts(parts, m_live))
        return;
    m_live = parts;
    m_desk.subscribe(QStringLiteral("snapshots"), {std::move(parts), readInterval});
}

std::vector<CompareColumn>
SnapshotsPage::tables(const std::vector<SnapshotSelection>& selectedSnapshots) const
{
    std::vector<CompareColumn> all;
    if (entry() != nullptr)
        all.push_back(servoTable(m_selection.current()));
    for (const SnapshotSelection& one : selectedSnapshots)
        all.push_back(
            {one.title, one.tip, one.snapshot, record::profileOf(*one.snapshot, m_desk.catalog())});
    for (const session::ServoRef ref : m_others) {
        if (ref != m_selection.current() && m_desk.servo(ref) != nullptr)
            all.push_back(servoTable(ref));
    }
    if (m_factory && !all.empty()) {
        const session::SharedSnapshot factory =
            entry() != nullptr ? std::make_shared<const record::Snapshot>(
                                     record::factorySnapshot(*entry()->servo.profile))
                               : m_snapshots.factorySnapshot(*all.front().table);
        if (factory)
            all.push_back({tr("Factory"), tr("Default of this model, as far as it is known"),
                           factory, all.front().profile});
    }
    return all;
}

/// What was ticked by hand stays so while servo and snapshot are the same.
void SnapshotsPage::rememberChecks()
{
    const auto& now = m_pane->model().plan();
    if (m_showing || !now)
        return;
    for (const jobs::RestoreRow& row : now->rows)
        m_checks[row.key] = row.selected;
}

std::optional<jobs::RestorePlan>
SnapshotsPage::makePlan(const std::vector<SnapshotSelection>& selectedSnapshots)
{
    const session::ServoEntry* servo = entry();
    const bool known = servo != nullptr && servo->hasFullTable && !selectedSnapshots.empty();
    const record::Snapshot* source = known ? selectedSnapshots.front().snapshot.get() : nullptr;
    const session::ServoRef about = known ? m_selection.current() : 0;
    if (source != m_checkedSource || about != m_checkedServo)
        m_checks.clear();
    m_checkedSource = source;
    m_checkedServo = about;
    if (!known)
        return std::nullopt;
    jobs::RestoreChoice choice;
    choice.identity = m_identity->isChecked();
    jobs::RestorePlan made = jobs::planRestore(servo->servo, *source, choice);
    jobs::selectTemporary(made, device::temporaryValues(servo->history, servo->servo), false);
    for (const auto& [key, on] : m_checks)
        (void)made.setSelected(key, on);
    return made;
}

QString SnapshotsPage::emptyText() const
{
    if (entry() == nullptr)
        return tr("Choose a servo in the list, or a snapshot at the left.");
    if (!entry()->hasFullTable)
        return tr("The servo's table is being read.");
    return tr("Choose a snapshot at the left to compare the servo with, or open a file.");
}

bool SnapshotsPage::isOfAnotherModel(const record::Snapshot& table) const
{
    if (entry() == nullptr)
        return false;
    const catalog::Profile& profile = *entry()->servo.profile;
    return table.servo.map != profile.mapKey || table.servo.modelId != profile.identity.modelId();
}

QString SnapshotsPage::titleText(const std::vector<SnapshotSelection>& selectedSnapshots) const
{
    if (const session::SharedBundle bundle = m_browser->bundle())
        return tr("Bundle with %1 servos; choose one of them to compare it")
            .arg(bundle->servos.size());
    const QString servo = entry() != nullptr ? servoTitle(*entry()) : QString();
    if (selectedSnapshots.empty())
        return servo;
    const record::Snapshot& table = *selectedSnapshots.front().snapshot;
    const QDateTime at = table.at.toLocalTime();
    QStringList about{selectedSnapshots.front().title,
                      QStringLiteral("%1 · ID %2").arg(table.servo.model).arg(table.servo.id)};
    if (at.isValid())
        about << at.toString(QStringLiteral("yyyy-MM-dd HH:mm"));
    if (isOfAnotherModel(table))
        about << tr("another model");
    const QString against = about.join(QStringLiteral(" · "));
    return servo.isEmpty() ? against : tr("%1 against %2").arg(servo, against);
}

void SnapshotsPage::refresh()
{
    if (!m_deskGuard)
        return;
    m_showing = true;
    const std::vector<SnapshotSelection> selectedSnapshots = m_browser->selectedSnapshots();
    auto restorePlan = makePlan(selectedSnapshots);
    m_pane->show(titleText(selectedSnapshots), tables(selectedSnapshots), std::move(restorePlan),
                 emptyText(), ages());
    m_showing = false;
    showState();
    updateLive();
}

void SnapshotsPage::showState()
{
    if (!m_deskGuard)
        return;
    const bool open = m_desk.state() == session::LinkState::Open && !m_desk.isTesting();
    const auto& now = m_pane->model().plan();
    const std::size_t count = now ? jobs::plannedWrites(*now).size() : 0;
    const bool bundle = m_browser->bundle() != nullptr;
    const std::vector<SnapshotSelection> selectedSnapshots = m_browser->selectedSnapshots();
    m_take->setEnabled(open && entry() != nullptr && !m_snapshots.isTaking());
    m_bundle->setEnabled(open && !m_desk.servos().empty() && !m_snapshots.isTaking());
    m_saveCopy->setEnabled(!selectedSnapshots.empty() && !bundle);
    m_note->setEnabled(m_browser->selectedHistoryRow().has_value());
    m_remove->setEnabled(!m_browser->selectedNumbers().empty());
    m_write->setText(count == 0   ? tr("Write ticked rows")
                     : count == 1 ? tr("Write 1 ticked row")
                                  : tr("Write %1 ticked rows").arg(count));
    m_write->setAccessibleName(m_write->text());
    m_write->setEnabled(open && count > 0 && !m_writing);
    m_dryRun->setEnabled(now.has_value());
    m_applyToSeveral->setText(bundle ? tr("Restore the bundle…") : tr("Several servos…"));
    m_applyToSeveral->setAccessibleName(m_applyToSeveral->text());
    m_applyToSeveral->setEnabled(open && !m_writing && (bundle || !selectedSnapshots.empty()));
    m_template->setEnabled(
        !selectedSnapshots.empty() && !selectedSnapshots.front().snapshot->isTemplate &&
        record::profileOf(*selectedSnapshots.front().snapshot, m_desk.catalog()));
    m_identity->setEnabled(now.has_value());
    const bool torque = now && torqueIsOn(*now);
    m_order->setText(count == 0 ? QString()
                     : torque
                         ? tr("Torque goes off first and stays off. Limits, mode, gains; the lock "
                              "last. Every row is read back; Undo stays possible.")
                         : tr("Limits, mode, gains; the lock last. Every row is read back; Undo "
                              "stays possible."));
}

/// Servos come and go; the menu is made when it is opened.
void SnapshotsPage::fillColumns()
{
    m_columns->clear();
    QAction* factory = m_columns->addAction(tr("Factory default"));
    factory->setCheckable(true);
    factory->setChecked(m_factory);
    connect(factory, &QAction::toggled, this, [this](bool on) {
        m_factory = on;
        refresh();
    });
    m_columns->addSeparator();
    for (const session::ServoRef ref : m_desk.servos()) {
        const session::ServoEntry* other = m_desk.servo(ref);
        if (ref == m_selection.current() || !other->servo.profile)
            continue;
        QAction* action = m_columns->addAction(servoTitle(*other));
        action->setCheckable(true);
        action->setChecked(m_others.count(ref) > 0);
        connect(action, &QAction::toggled, this, [this, ref](bool on) {
            if (on) {
                m_others.insert(ref);
                m_desk.readTable(ref);
            } else {
                m_others.erase(ref);
            }
            refresh();
        });
    }
}

void SnapshotsPage::showHistorySnapshot(std::int64_t number)
{
    m_browser->selectNumber(number);
}

void SnapshotsPage::showTable(session::SharedSnapshot table, const QString& title)
{
    m_browser->add(std::move(table), title);
}

void SnapshotsPage::changeEvent(QEvent* event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange && m_order != nullptr) {
        retranslate();
        refresh();
    }
}

void SnapshotsPage::dragEnterEvent(QDragEnterEvent* event)
{
    if (event->mimeData()->hasUrls())
        event->acceptProposedAction();
}

void SnapshotsPage::dropEvent(QDropEvent* event)
{
    for (const QUrl& url : event->mimeData()->urls()) {
        if (url.isLocalFile())
            m_snapshots.open(url.toLocalFile());
    }
}

void SnapshotsPage::showEvent(QShowEvent* event)
{
    QWidget::showEvent(event);
    m_age.start();
    onServoSelected();
}

void SnapshotsPage::hideEvent(QHideEvent* event)
{
    QWidget::hideEvent(event);
    m_age.stop();
    if (m_deskGuard)
        updateLive();
}
} // namespace ui
