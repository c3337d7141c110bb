// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tasks/intents_model.h"

#include "jobs/restore/restore.h"
#include "text/language.h"
#include "text/notice_text.h"
#include "text/translate.h"

namespace ui {
using base::IntentKind;
using jobs::Finding;
using text::translate;

namespace {
QString intentTimeText(const base::Intent& intent)
{
    return intent.at.toLocalTime().toString(QStringLiteral("yyyy-MM-dd hh:mm:ss"));
}

QString intentServoText(const base::Intent& intent, const catalog::Profile& profile)
{
    return QStringLiteral("%1 · %2").arg(translate("ServoTasks", "ID %1").arg(intent.servo.id),
                                         profile.modelName);
}

QString intentChangesText(const base::Intent& intent, const catalog::Profile& profile)
{
    QStringList changes;
    for (const base::JournalItem& item : intent.items) {
        const QString name = text::registerName(&profile, item.key);
        // The results of centering and restoring are not known in advance.
        changes << (item.oldRaw == item.newRaw
                        ? QStringLiteral("%1 = %2").arg(name).arg(item.oldRaw)
                        : QStringLiteral("%1 %2 → %3").arg(name).arg(item.oldRaw).arg(item.newRaw));
    }
    return text::joinItems(changes);
}

QString lockLabel(const std::optional<bool>& open)
{
    return text::lockLabel(!open   ? QStringLiteral("unknown")
                           : *open ? QStringLiteral("open")
                                   : QStringLiteral("closed"));
}

} // namespace

IntentsModel::IntentsModel(const catalog::Catalog& catalog, QObject* parent)
    : QAbstractTableModel(parent)
    , m_catalog(catalog)
{}

QString IntentsModel::cell(const jobs::RecoveryResult& one, IntentColumn column) const
{
    const base::Intent& intent = one.before.intent;
    const catalog::ProfilePtr profile = profileOf(m_catalog, intent.servo);
    switch (column) {
    case IntentColumn::When:
        return intentTimeText(intent);
    case IntentColumn::Servo:
        return intentServoText(intent, *profile);
    case IntentColumn::What:
        return intentLabel(intent);
    case IntentColumn::Change:
        return intentChangesText(intent, *profile);
    case IntentColumn::Found:
        return findingText(one.before.finding);
    case IntentColumn::Lock:
        return lockLabel(one.before.lockOpen);
    case IntentColumn::Count:
        break;
    }
    return {};
}

QString IntentsModel::line(const base::Intent& intent) const
{
    constexpr int enough = 160;
    const catalog::ProfilePtr profile = profileOf(m_catalog, intent.servo);
    QString changes = intentChangesText(intent, *profile);
    if (changes.size() > enough)
        changes = changes.left(enough) + QStringLiteral("…");
    const QString line = translate("ServoTasks", "%1, %2: %3, port %4, %5")
                             .arg(intentServoText(intent, *profile), intentLabel(intent), changes,
                                  intent.servo.port, intentTimeText(intent));
    return intent.isActiveElsewhere
               ? QStringLiteral("%1 – %2").arg(line, findingText(Finding::UnderWay))
               : line;
}

QString IntentsModel::toolTipText(const jobs::RecoveryResult& one) const
{
    QStringList lines;
    for (int column = 0; column < columnCount(); ++column) {
        lines << QStringLiteral("%1: %2").arg(
            headerData(column, Qt::Horizontal, Qt::DisplayRole).toString(),
            cell(one, static_cast<IntentColumn>(column)));
    }
    return lines.join(QLatin1Char('\n'));
}

catalog::ProfilePtr profileOf(const catalog::Catalog& catalog, const base::ServoIdentity& servo)
{
    catalog::Identity identity;
    identity.firmwareMajor = servo.firmwareMajor;
    identity.firmwareMinor = servo.firmwareMinor;
    identity.modelMajor = servo.modelMajor;
    identity.modelMinor = servo.modelMinor;
    identity.protocol = servo.protocol;
    return catalog.resolve(identity);
}

QString intentLabel(const base::Intent& intent)
{
    switch (intent.kind) {
    case IntentKind::Write:
        return translate("ServoTasks", "write");
    case IntentKind::SetId:
        return translate("ServoTasks", "set ID");
    case IntentKind::SetBaud:
        return translate("ServoTasks", "set baud rate");
    case IntentKind::Mode:
        return translate("ServoTasks", "change mode");
    case IntentKind::Calibrate:
        return translate("ServoTasks", "set midpoint");
    case IntentKind::Restore:
        return jobs::isSnapshotRestore(intent)
                   ? translate("ServoTasks", "restore a snapshot")
                   : translate("ServoTasks", "reset to factory defaults");
    case IntentKind::Identify:
        return translate("ServoTasks", "blink LED");
    case IntentKind::Trial:
        return translate("ServoTasks", "change settings for a test");
    case IntentKind::Undo:
        return translate("ServoTasks", "undo");
    }
    return {};
}

QString findingText(Finding finding)
{
    switch (finding) {
    case Finding::AllOld:
        return translate("ServoTasks", "the old values");
    case Finding::AllNew:
        return translate("ServoTasks", "the new values");
    case Finding::Mixed:
        return translate("ServoTasks", "some old and some new values");
    case Finding::OtherServo:
        return translate("ServoTasks", "different servo or values; skipped");
    case Finding::NoReply:
        return translate("ServoTasks", "no reply");
    case Finding::Unreadable:
        return translate("ServoTasks", "replies cannot be decoded");
    case Finding::UnderWay:
        return translate("ServoTasks", "still in progress in another program");
    case Finding::Replaced:
        return translate("ServoTasks", "value has changed in the meantime; left as is");
    }
    return {};
}

void IntentsModel::setIntents(std::vector<jobs::RecoveryResult> intents)
{
    beginResetModel();
    m_intents = std::move(intents);
    endResetModel();
}

void IntentsModel::remove(const QString& uuid)
{
    for (int row = 0; row < rowCount(); ++row) {
        if (at(row)->before.intent.uuid != uuid)
            continue;
        beginRemoveRows({}, row, row);
        m_intents.erase(m_intents.begin() + row);
        endRemoveRows();
        return;
    }
}

const jobs::RecoveryResult* IntentsModel::at(int row) const
{
    const bool known = row >= 0 && row < static_cast<int>(m_intents.size());
    return known ? &m_intents[static_cast<std::size_t>(row)] : nullptr;
}

void IntentsModel::retranslate()
{
    Q_EMIT headerDataChanged(Qt::Horizontal, 0, columnCount() - 1);
    if (rowCount() > 0)
        Q_EMIT dataChanged(index(0, 0), index(rowCount() - 1, columnCount() - 1));
}

int IntentsModel::rowCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : static_cast<int>(m_intents.size());
}

int IntentsModel::columnCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : static_cast<int>(IntentColumn::Count);
}

QVariant IntentsModel::data(const QModelIndex& index, int role) const
{
    if (!checkIndex(index, CheckIndexOption::IndexIsValid))
        return {};
    const jobs::RecoveryResult& one = m_intents[static_cast<std::size_t>(index.row())];
    if (role == Qt::DisplayRole)
        return cell(one, static_cast<IntentColumn>(index.column()));
    if (role == Qt::ToolTipRole)
        return toolTipText(one);
    return {};
}

QVariant IntentsModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation != Qt::Horizontal || (role != Qt::DisplayRole && role != Qt::ToolTipRole))
        return {};
    switch (static_cast<IntentColumn>(section)) {
    case IntentColumn::When:
        return translate("ServoTasks", "Time");
    case IntentColumn::Servo:
        return translate("ServoTasks", "Servo");
    case IntentColumn::What:
        return translate("ServoTasks", "Operation");
    case IntentColumn::Change:
        return translate("ServoTasks", "Change");
    case IntentColumn::Found:
        return translate("ServoTasks", "Current state");
    case IntentColumn::Lock:
        return translate("ServoTasks", "EPROM lock");
    case IntentColumn::Count:
        break;
    }
    return {};
}
} // namespace ui
