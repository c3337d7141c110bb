// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/app/auto_selection.h"

namespace ui {
AutoSelection::AutoSelection(session::Workbench& workbench, Selection& selection, QObject* parent)
    : QObject(parent)
    , m_workbench(workbench)
    , m_selection(selection)
{
    const session::ServoRegistry* registry = &workbench.registry();
    connect(registry, &session::ServoRegistry::servoAdded, this, &AutoSelection::onServoAdded);
    connect(registry, &session::ServoRegistry::servoRemoved, &selection, &Selection::remove);
    connect(registry, &session::ServoRegistry::servosCleared, this,
            [this] { m_selection.select(0); });
    connect(registry, &session::ServoRegistry::servoChanged, this, &AutoSelection::onServoChanged);
    connect(&workbench.search(), &session::SearchService::searchChanged, this,
            &AutoSelection::onSearchChanged);
}

void AutoSelection::request(std::optional<int> id, bool selectFirst)
{
    m_requestedId = id;
    m_selectFirst = selectFirst && !id;
    m_workbench.search().setExpectedId(id);
}

void AutoSelection::onServoAdded(session::ServoRef added)
{
    const session::ServoEntry* servo = m_workbench.registry().servo(added);
    if (servo == nullptr || m_selection.current() != 0)
        return;
    if (m_requestedId ? servo->servo.id == *m_requestedId : m_selectFirst) {
        request(std::nullopt, false);
        m_selection.select(added);
    }
}

void AutoSelection::onSearchChanged()
{
    if (m_workbench.search().isSearching())
        return;
    const auto& order = m_workbench.registry().order();
    if (m_selection.current() == 0 && !m_requestedId && order.size() == 1)
        m_selection.select(order.front());
    const session::ServoEntry* shown = m_workbench.registry().servo(m_selection.current());
    if (shown != nullptr && shown->servo.profile && !shown->hasFullTable)
        m_workbench.writes().readTable(m_selection.current());
}

/// After a reconnect no search ends: a servo is read when it has proven to be there again.
void AutoSelection::onServoChanged(session::ServoRef changed)
{
    const session::ServoEntry* entry = m_workbench.registry().servo(changed);
    if (changed != m_selection.current() || entry == nullptr || !m_workbench.link().isReconnect())
        return;
    if (m_workbench.link().state() == session::LinkState::Open && entry->servo.profile &&
        !entry->silent && !entry->hasFullTable && !entry->isReadingTable && !entry->readError)
        m_workbench.writes().readTable(changed);
}
} // namespace ui
