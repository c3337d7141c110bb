// SPDX-License-Identifier: GPL-3.0-or-later
// What is shown. The parts are made in snapshots_page_build.cpp, the deeds are in
// snapshots_page_deeds.cpp.
#include "ui/pages/snapshots_page.h"

#include "record/factory_snapshot.h"
#include "session/reading_age.h"
#include "ui/dialogs/task_words.h"
#include "ui/models/servo_row.h"
#include "ui/pages/snapshot_pane.h"
#include "ui/pages/snapshot_shelf.h"
#include "ui/widgets/banner.h"

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

constexpr base::Duration readEvery = 500ms;

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
    return entry.tableRead && !entry.silent && tableAge(entry, now) <= session::maxReadingAge;
}

bool sameParts(const std::vector<session::FeedPart>& one,
               const std::vector<session::FeedPart>& other)
{
    return std::equal(one.begin(), one.end(), other.begin(), other.end(),
                      [](const session::FeedPart& a, const session::FeedPart& b) {
                          return a.servo == b.servo && a.slowKeys == b.slowKeys;
                      });
}
} // namespace

SnapshotsPage::SnapshotsPage(Bench& bench, session::Settings& settings, QWidget* parent)
    : QWidget(parent)
    , m_desk(bench.desk)
    , m_deskLives(&bench.desk)
    , m_archive(bench.archive)
    , m_selection(bench.selection)
    , m_settings(settings)
    , m_snapshots(bench.desk, bench.archive)
{
    setObjectName(QStringLiteral("snapshotsPage"));
    setAcceptDrops(true);
    build();
    connectAll();
    retranslate();
    servoChosen();
}

const session::ServoEntry* SnapshotsPage::entry() const
{
    const session::ServoEntry* found = m_desk.servo(m_selection.current());
    return found != nullptr && found->servo.profile ? found : nullptr;
}

/// Compared is what was really read: the table is read anew when a servo is looked at.
void SnapshotsPage::servoChosen()
{
    if (!m_deskLives)
        return;
    if (isVisible() && entry() != nullptr && !m_writing)
        m_desk.readTable(m_selection.current());
    refreshSoon();
}

void SnapshotsPage::refreshSoon()
{
    if (isVisible() && !m_refresh.isActive())
        m_refresh.start();
}

ComparedTable SnapshotsPage::servoTable(session::ServoRef ref) const
{
    const session::ServoEntry* servo = m_desk.servo(ref);
    if (servo == nullptr || !servo->servo.profile)
        return {};
    const base::Duration now = m_desk.now();
    const QString title =
        isCurrent(*servo, now) ? tr("ID %1 now").arg(servo->servo.id)
        : servo->tableRead
            ? QStringLiteral("ID %1 · %2").arg(servo->servo.id).arg(agoWords(tableAge(*servo, now)))
            : QStringLiteral("ID %1").arg(servo->servo.id);
    return {title, servoTitle(*servo), m_snapshots.now(ref), servo->servo.profile};
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
        const QString ago = agoWords(tableAge(*servo, now));
        lines << (!servo->tableRead ? tr("ID %1 · not read yet").arg(servo->servo.id)
                  : servo->silent ? tr("ID %1 · no answer · read %2").arg(servo->servo.id).arg(ago)
                                  : tr("ID %1 · read %2").arg(servo->servo.id).arg(ago));
    }
    return lines;
}

/// Other programs may write too, and a servo may be exchanged for one of the same model.
void SnapshotsPage::updateLive()
{
    std::vector<session::FeedPart> parts;
    std::set<session::ServoRef> shown = m_others;
    shown.insert(m_selection.current());
    for (const session::ServoRef ref : shown) {
        const session::ServoEntry* servo = isVisible() ? m_desk.servo(ref) : nullptr;
        if (servo != nullptr && servo->servo.profile && servo->tableRead)
            parts.push_back({ref, {}, settingsOf(*servo)});
    }
    if (sameParts(parts, m_live))
        return;
    m_live = parts;
    m_desk.wish(QStringLiteral("snapshots"), {std::move(parts), readEvery});
}

std::vector<ComparedTable> SnapshotsPage::tables(const std::vector<ShelfChoice>& chosen) const
{
    std::vector<ComparedTable> all;
    if (entry() != nullptr)
        all.push_back(servoTable(m_selection.current()));
    for (const ShelfChoice& one : chosen)
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
                               : m_snapshots.factory(*all.front().table);
        if (factory)
            all.push_back({tr("Factory"), tr("Default of this model, as far as it is known"),
                           factory, all.front().profile});
    }
    return all;
}

/// What was ticked by hand stays so while servo and snapshot are the same.
void SnapshotsPage::rememberTicks()
{
    const auto& now = m_pane->model().plan();
    if (m_showing || !now)
        return;
    for (const jobs::RestoreRow& row : now->rows)
        m_ticks[row.key] = row.ticked;
}

std::optional<jobs::RestorePlan> SnapshotsPage::plan(const std::vector<ShelfChoice>& chosen)
{
    const session::ServoEntry* servo = entry();
    const bool known = servo != nullptr && servo->tableRead && !chosen.empty();
    const record::Snapshot* source = known ? chosen.front().snapshot.get() : nullptr;
    const session::ServoRef about = known ? m_selection.current() : 0;
    if (source != m_ticked || about != m_tickedServo)
        m_ticks.clear();
    m_ticked = source;
    m_tickedServo = about;
    if (!known)
        return std::nullopt;
    jobs::RestoreChoice choice;
    choice.identity = m_identity->isChecked();
    jobs::RestorePlan made = jobs::planRestore(servo->servo, *source, choice);
    jobs::tickTemporary(made, device::temporaryValues(servo->history, servo->servo), false);
    for (const auto& [key, on] : m_ticks)
        (void)made.tick(key, on);
    return made;
}

QString SnapshotsPage::nothingWords() const
{
    if (entry() == nullptr)
        return tr("Choose a servo in the list, or a snapshot at the left.");
    if (!entry()->tableRead)
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

QString SnapshotsPage::titleWords(const std::vector<ShelfChoice>& chosen) const
{
    if (const session::SharedBundle bundle = m_shelf->bundle())
        return tr("Bundle with %1 servos; choose one of them to compare it")
            .arg(bundle->servos.size());
    const QString servo = entry() != nullptr ? servoTitle(*entry()) : QString();
    if (chosen.empty())
        return servo;
    const record::Snapshot& table = *chosen.front().snapshot;
    const QDateTime at = table.at.toLocalTime();
    QStringList about{chosen.front().title,
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
    if (!m_deskLives)
        return;
    m_showing = true;
    const std::vector<ShelfChoice> chosen = m_shelf->chosen();
    auto wanted = plan(chosen);
    m_pane->show(titleWords(chosen), tables(chosen), std::move(wanted), nothingWords(), ages());
    m_showing = false;
    showState();
    updateLive();
}

void SnapshotsPage::showState()
{
    if (!m_deskLives)
        return;
    const bool open = m_desk.state() == session::LinkState::Open && !m_desk.testing();
    const auto& now = m_pane->model().plan();
    const std::size_t count = now ? jobs::writesOf(*now).size() : 0;
    const bool bundle = m_shelf->bundle() != nullptr;
    const std::vector<ShelfChoice> chosen = m_shelf->chosen();
    m_take->setEnabled(open && entry() != nullptr && !m_snapshots.taking());
    m_bundle->setEnabled(open && !m_desk.servos().empty() && !m_snapshots.taking());
    m_saveCopy->setEnabled(!chosen.empty() && !bundle);
    m_note->setEnabled(m_shelf->onlyKept().has_value());
    m_remove->setEnabled(!m_shelf->chosenNumbers().empty());
    m_write->setText(count == 0   ? tr("Write ticked rows")
                     : count == 1 ? tr("Write 1 ticked row")
                                  : tr("Write %1 ticked rows").arg(count));
    m_write->setAccessibleName(m_write->text());
    m_write->setEnabled(open && count > 0 && !m_writing);
    m_dryRun->setEnabled(now.has_value());
    m_several->setText(bundle ? tr("Restore the bundle…") : tr("Several servos…"));
    m_several->setAccessibleName(m_several->text());
    m_several->setEnabled(open && !m_writing && (bundle || !chosen.empty()));
    m_template->setEnabled(!chosen.empty() && !chosen.front().snapshot->isTemplate &&
                           record::profileOf(*chosen.front().snapshot, m_desk.catalog()));
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

void SnapshotsPage::showKept(std::int64_t number)
{
    m_shelf->choose(number);
}

void SnapshotsPage::showTable(session::SharedSnapshot table, const QString& title)
{
    m_shelf->add(std::move(table), title);
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
    servoChosen();
}

void SnapshotsPage::hideEvent(QHideEvent* event)
{
    QWidget::hideEvent(event);
    m_age.stop();
    if (m_deskLives)
        updateLive();
}
} // namespace ui
