// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/snapshots/compare_tables.h"

#include "session/polling/max_reading_age.h"
#include "session/snapshot/snapshots.h"
#include "snapshot/factory_snapshot.h"
#include "ui/snapshots/snapshot_browser.h"
#include "ui/widgets/rate_text.h"
#include "ui/widgets/task_text.h"

#include <QMenu>

namespace ui {
namespace {
using namespace std::chrono_literals;

constexpr base::Duration readInterval = 500ms;

/// The settings that the servo has: those that were read with its whole table.
std::vector<const catalog::Register*> settingsOf(const session::ServoEntry& entry)
{
    std::vector<const catalog::Register*> settings;
    for (const catalog::Register& reg : entry.servo.profile->registers) {
        if (reg.writable() && entry.servo.raw(reg))
            settings.push_back(&reg);
    }
    return settings;
}

QStringList keysOf(const std::vector<const catalog::Register*>& registers)
{
    QStringList keys;
    for (const catalog::Register* reg : registers)
        keys << reg->key;
    return keys;
}

/// Of the setting that was read first.
base::Duration tableAge(const session::ServoEntry& entry, base::Duration now)
{
    base::Duration oldest = now;
    for (const catalog::Register* reg : settingsOf(entry))
        oldest = std::min(oldest, entry.servo.image.readAt(reg->offset).value_or(now));
    return now - oldest;
}

bool isCurrent(const session::ServoEntry& entry, base::Duration now)
{
    return entry.hasFullTable && !entry.silent && tableAge(entry, now) <= session::maxReadingAge;
}

bool isSameSubscription(const std::vector<session::SubscriptionItem>& one,
                        const std::vector<session::SubscriptionItem>& other)
{
    return std::equal(one.begin(), one.end(), other.begin(), other.end(),
                      [](const session::SubscriptionItem& a, const session::SubscriptionItem& b) {
                          return a.servo == b.servo && a.slowKeys == b.slowKeys;
                      });
}
} // namespace

CompareTables::CompareTables(AppContext& appContext, QObject* parent)
    : QObject(parent)
    , m_workbench(appContext.workbench)
    , m_workbenchGuard(&appContext.workbench)
    , m_selection(appContext.selection)
{
    session::ServoRegistry& registry = m_workbench.registry();
    const auto changed = [this](session::ServoRef ref) {
        if (ref == m_selection.current() || m_others.count(ref) > 0)
            Q_EMIT servoChanged();
    };
    connect(&registry, &session::ServoRegistry::servoChanged, this, changed);
    connect(&registry, &session::ServoRegistry::tableChanged, this, changed);
    connect(&registry, &session::ServoRegistry::servoRemoved, this,
            [this](session::ServoRef ref) { m_others.erase(ref); });
}

const session::ServoEntry* CompareTables::servo() const
{
    const session::ServoEntry* found = m_workbench.registry().servo(m_selection.current());
    return found != nullptr && found->servo.profile ? found : nullptr;
}

std::set<session::ServoRef> CompareTables::servos() const
{
    std::set<session::ServoRef> all = m_others;
    all.insert(m_selection.current());
    return all;
}

CompareColumn CompareTables::columnOf(session::ServoRef ref) const
{
    const session::ServoEntry* entry = m_workbench.registry().servo(ref);
    if (entry == nullptr || !entry->servo.profile)
        return {};
    const base::Duration now = m_workbench.now();
    const int id = entry->servo.id;
    const QString title =
        isCurrent(*entry, now) ? tr("ID %1 now").arg(id)
        : entry->hasFullTable
            ? QStringLiteral("ID %1 · %2").arg(id).arg(timeAgoText(tableAge(*entry, now)))
            : QStringLiteral("ID %1").arg(id);
    return {title, servoTitle(*entry), m_workbench.snapshots().currentSnapshot(ref),
            entry->servo.profile};
}

std::vector<CompareColumn>
CompareTables::columns(const std::vector<SnapshotSelection>& snapshots) const
{
    std::vector<CompareColumn> all;
    if (servo() != nullptr)
        all.push_back(columnOf(m_selection.current()));
    for (const SnapshotSelection& one : snapshots)
        all.push_back({one.title, one.tip, one.snapshot,
                       snapshot::profileOf(*one.snapshot, m_workbench.catalog())});
    for (const session::ServoRef ref : m_others) {
        if (ref != m_selection.current() && m_workbench.registry().servo(ref) != nullptr)
            all.push_back(columnOf(ref));
    }
    if (m_factory && !all.empty()) {
        const session::SharedSnapshot factory =
            servo() != nullptr ? std::make_shared<const snapshot::Snapshot>(
                                     snapshot::factorySnapshot(*servo()->servo.profile))
                               : m_workbench.snapshots().factorySnapshot(*all.front().table);
        if (factory)
            all.push_back({tr("Factory default"), tr("Factory default of this model, where known"),
                           factory, all.front().profile});
    }
    return all;
}

QStringList CompareTables::ages() const
{
    QStringList lines;
    const base::Duration now = m_workbench.now();
    for (const session::ServoRef ref : servos()) {
        const session::ServoEntry* entry = m_workbench.registry().servo(ref);
        if (entry == nullptr || !entry->servo.profile || isCurrent(*entry, now))
            continue;
        const int id = entry->servo.id;
        const QString ago = timeAgoText(tableAge(*entry, now));
        lines << (!entry->hasFullTable ? tr("ID %1 · not read yet").arg(id)
                  : entry->silent      ? tr("ID %1 · no reply · read %2").arg(id).arg(ago)
                                       : tr("ID %1 · read %2").arg(id).arg(ago));
    }
    return lines;
}

/// Other programs may write too, and a servo may be replaced by one of the same model.
void CompareTables::setActive(bool active)
{
    if (!m_workbenchGuard)
        return;
    std::vector<session::SubscriptionItem> items;
    for (const session::ServoRef ref : servos()) {
        const session::ServoEntry* entry = active ? m_workbench.registry().servo(ref) : nullptr;
        if (entry != nullptr && entry->servo.profile && entry->hasFullTable)
            items.push_back({ref, {}, keysOf(settingsOf(*entry))});
    }
    if (isSameSubscription(items, m_subscribed))
        return;
    m_subscribed = items;
    m_workbench.polling().subscribe(QStringLiteral("snapshots"), {std::move(items), readInterval});
}

void CompareTables::fillMenu(QMenu& menu)
{
    menu.clear();
    const auto add = [&menu](const QString& text, bool on) {
        QAction* action = menu.addAction(text);
        action->setCheckable(true);
        action->setChecked(on);
        return action;
    };
    connect(add(tr("Factory default"), m_factory), &QAction::toggled, this, [this](bool on) {
        m_factory = on;
        Q_EMIT selectionChanged();
    });
    menu.addSeparator();
    for (const session::ServoRef ref : m_workbench.registry().order()) {
        const session::ServoEntry* other = m_workbench.registry().servo(ref);
        if (ref == m_selection.current() || !other->servo.profile)
            continue;
        connect(add(servoTitle(*other), m_others.count(ref) > 0), &QAction::toggled, this,
                [this, ref](bool on) { selectOther(ref, on); });
    }
}

void CompareTables::selectOther(session::ServoRef ref, bool on)
{
    if (on) {
        m_others.insert(ref);
        m_workbench.writes().readTable(ref);
    } else {
        m_others.erase(ref);
    }
    Q_EMIT selectionChanged();
}
} // namespace ui
