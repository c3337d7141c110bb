// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/desk_work.h"

#include <algorithm>

namespace session {
namespace {
/// True when the journal has an open intent of this port: without one nobody need be asked.
base::Result<bool> anyOpen(const device::Context& context)
{
    const auto open = context.journal.open();
    if (!open)
        return tl::unexpected(open.error());
    const QString port = context.bus.portName();
    return std::any_of(open->begin(), open->end(),
                       [&](const base::Intent& intent) { return intent.servo.port == port; });
}
} // namespace

void Desk::lookForIntents()
{
    recoverIntents(jobs::RecoverAction::Look, {});
}

void Desk::settleIntent(const QString& uuid, jobs::RecoverAction action)
{
    recoverIntents(action, uuid);
}

void Desk::recoverIntents(jobs::RecoverAction action, const QString& uuid)
{
    const auto found = std::make_shared<std::vector<jobs::Recovered>>();
    const auto work = std::make_shared<Work>();
    work->task.name = QStringLiteral("recover");
    work->task.quiet = action == jobs::RecoverAction::Look;
    work->task.work = [action, uuid, found](TaskContext& task) -> base::Result<void> {
        const auto open = anyOpen(task.device);
        if (!open)
            return tl::unexpected(open.error());
        if (!*open)
            return {};
        auto recovered = jobs::recover(task.device, action, false, uuid);
        if (!recovered)
            return tl::unexpected(recovered.error());
        *found = std::move(*recovered);
        return {};
    };
    work->merged = [this, found](Work& ended) {
        if (ended.error)
            tell({.kind = Event::Kind::Failed, .error = ended.error});
        Q_EMIT openIntents(*found);
    };
    enqueue(work);
}

void Desk::forgetIntent(const QString& uuid)
{
    m_openThread->start([this, uuid] {
        const auto ended = m_session.journal().end(uuid, {QStringLiteral("abandoned"), {}});
        m_inbox.post([this, ended] {
            if (!ended)
                tell({.kind = Event::Kind::Failed, .error = ended.error()});
            else
                lookForIntents();
        });
    });
}
} // namespace session
