// SPDX-License-Identifier: GPL-3.0-or-later
// Interrupted changes as the command line shows them: those that were compared with a servo, and
// those that were not, with what to type. Pure, but for a look whether a port is there;
// any thread.
#pragma once

#include "cli/output/json.h"
#include "cli/output/table.h"
#include "jobs/recover/recover.h"

namespace cli {
Json jsonRecovered(const jobs::RecoveryResult& one);
Table recoveredTable(const std::vector<jobs::RecoveryResult>& all, jobs::RecoveryAction action);
/// What the table only counts, one a line.
QString changesBelow(const base::Intent& intent);
/// A change that was given up unread: what it concerned, and that the lock may be open.
QString discardedText(const base::Intent& intent);
Json jsonDiscarded(const base::Intent& intent);
/// What was not written although it reads another value than was asked for.
QString notWrittenLine(const jobs::RecoveryResult& one);
/// One that was named although its own port is there: nothing proves that it is the same servo.
QString userConfirmedText(const jobs::RecoveryResult& one, const QString& port);

/// Changes that were not compared with a servo, and how to get at each.
struct UncheckedChanges {
    std::vector<base::Intent> intents{};
    QString port{};     ///< of this run; empty where none was named
    bool isOpen = true; ///< that port

    bool hasRealPort() const
    {
        return isOpen && !port.isEmpty() && !port.startsWith(QLatin1String("sim:"));
    }
    /// On this port: the adapter may only have another name now.
    QString commandForThisPort() const
    {
        return QStringLiteral("servodesk-cli recover --any-port --port %1")
            .arg(hasRealPort() ? port : QStringLiteral("PORT"));
    }
    QString command() const;
    Json json() const;
    void addTo(Json& document, const char* name) const; ///< the changes only, if there are any
    QString advice() const;
    QString text(const QString& title) const;
};
/// What to type, of the first of them that has something.
void addRecoverCommand(Json& document, const UncheckedChanges& first,
                       const UncheckedChanges& second = {});

QString otherPortsTitle();
} // namespace cli
