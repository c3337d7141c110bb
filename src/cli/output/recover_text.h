// SPDX-License-Identifier: GPL-3.0-or-later
// The texts and JSON of interrupted changes: those that were compared with a servo, and those that
// were not, with the command for them. Pure except for checking whether a port exists; any thread.
#pragma once

#include "cli/output/json.h"
#include "cli/output/table.h"
#include "jobs/recover/recover.h"

namespace cli {
Json jsonRecovered(const jobs::RecoveryResult& one);
Table recoveredTable(const std::vector<jobs::RecoveryResult>& all, jobs::RecoveryAction action);
/// The changes that the table only counts, one per line.
QString changesBelow(const base::Intent& intent);
/// A change that was discarded without reading: its registers, and whether the lock may be open.
QString discardedText(const base::Intent& intent);
Json jsonDiscarded(const base::Intent& intent);
/// The registers that were not written although their values differ; empty: none.
QString notWrittenLine(const jobs::RecoveryResult& one);
/// For a change that the user named although its own port exists: nothing proves that it is the
/// same servo.
QString userConfirmedText(const jobs::RecoveryResult& one, const QString& port);

/// Changes that were not compared with a servo, and the commands for them.
struct UncheckedChanges {
    std::vector<base::Intent> intents{};
    QString port{};     ///< of this run; empty: none was given
    bool isOpen = true; ///< whether this port is open

    bool hasRealPort() const
    {
        return isOpen && !port.isEmpty() && !port.startsWith(QLatin1String("sim:"));
    }
    /// For this port, because the adapter may only have got another name.
    QString commandForThisPort() const
    {
        return QStringLiteral("servodesk-cli recover --any-port --port %1")
            .arg(hasRealPort() ? port : QStringLiteral("PORT"));
    }
    QString command() const;
    Json json() const;
    void addTo(Json& document, const char* name) const; ///< nothing if there are no changes
    QString advice() const;
    QString text(const QString& title) const;
};
/// Adds the command of `first`, or of `second` if `first` has none.
void addRecoverCommand(Json& document, const UncheckedChanges& first,
                       const UncheckedChanges& second = {});

QString otherPortsTitle();
} // namespace cli
