// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/dialogs/intents_model.h"

#include "text/notice_words.h"
#include "text/translate.h"

#include <QLocale>

namespace ui {
using base::IntentKind;
using jobs::Finding;
using text::translate;

namespace {
QString whenWord(const base::Intent& intent)
{
    return QLocale::system().toString(intent.at.toLocalTime(), QLocale::ShortFormat);
}

QString servoWord(const base::Intent& intent)
{
    return translate("ServoTasks", "ID %1").arg(intent.servo.id);
}

QString changesWord(const base::Intent& intent)
{
    QStringList changes;
    for (const base::JournalItem& item : intent.items) {
        // What centring and restoring lead to is not known beforehand.
        changes
            << (item.oldRaw == item.newRaw
                    ? QStringLiteral("%1 = %2").arg(item.key).arg(item.oldRaw)
                    : QStringLiteral("%1 %2 → %3").arg(item.key).arg(item.oldRaw).arg(item.newRaw));
    }
    return changes.join(QStringLiteral(", "));
}

QString lockWord(const std::optional<bool>& open)
{
    return text::lockWord(!open   ? QStringLiteral("unknown")
                          : *open ? QStringLiteral("open")
                                  : QStringLiteral("closed"));
}

QString cell(const jobs::Recovered& one, IntentColumn column)
{
    const base::Intent& intent = one.before.intent;
    switch (column) {
    case IntentColumn::When:
        return whenWord(intent);
    case IntentColumn::Servo:
        return servoWord(intent);
    case IntentColumn::What:
        return intentWord(intent.kind);
    case IntentColumn::Change:
        return changesWord(intent);
    case IntentColumn::Found:
        return findingWord(one.before.finding);
    case IntentColumn::Lock:
        return lockWord(one.before.lockOpen);
    case IntentColumn::Count:
        break;
    }
    return {};
}

QString everything(const jobs::Recovered& one)
{
    QStringList lines;
    for (int column = 0; column < static_cast<int>(IntentColumn::Count); ++column)
        lines << cell(one, static_cast<IntentColumn>(column));
    return lines.join(QLatin1Char('\n'));
}
} // namespace

QString intentWord(IntentKind kind)
{
    switch (kind) {
    case IntentKind::Write:
        return translate("ServoTasks", "write");
    case IntentKind::SetId:
        return translate("ServoTasks", "set ID");
    case IntentKind::SetBaud:
        return translate("ServoTasks", "set baud rate");
    case IntentKind::Mode:
        return translate("ServoTasks", "change of mode");
    case IntentKind::Calibrate:
        return translate("ServoTasks", "centre here");
    case IntentKind::Restore:
        return translate("ServoTasks", "restore defaults");
    case IntentKind::Identify:
        return translate("ServoTasks", "identify");
    }
    return {};
}

QString findingWord(Finding finding)
{
    switch (finding) {
    case Finding::AllOld:
        return translate("ServoTasks", "nothing of it was written");
    case Finding::AllNew:
        return translate("ServoTasks", "all of it was written");
    case Finding::Mixed:
        return translate("ServoTasks", "part of it was written");
    case Finding::OtherServo:
        return translate("ServoTasks", "another servo, or other values: hands off");
    case Finding::NoAnswer:
        return translate("ServoTasks", "it does not answer");
    }
    return {};
}

void IntentsModel::setIntents(std::vector<jobs::Recovered> intents)
{
    beginResetModel();
    m_intents = std::move(intents);
    endResetModel();
}

const jobs::Recovered* IntentsModel::at(int row) const
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
    const jobs::Recovered& one = m_intents[static_cast<std::size_t>(index.row())];
    if (role == Qt::DisplayRole)
        return cell(one, static_cast<IntentColumn>(index.column()));
    if (role == Qt::ToolTipRole)
        return everything(one);
    return {};
}

QVariant IntentsModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation != Qt::Horizontal || (role != Qt::DisplayRole && role != Qt::ToolTipRole))
        return {};
    switch (static_cast<IntentColumn>(section)) {
    case IntentColumn::When:
        return translate("ServoTasks", "When");
    case IntentColumn::Servo:
        return translate("ServoTasks", "Servo");
    case IntentColumn::What:
        return translate("ServoTasks", "What");
    case IntentColumn::Change:
        return translate("ServoTasks", "Change");
    case IntentColumn::Found:
        return translate("ServoTasks", "Found now");
    case IntentColumn::Lock:
        return translate("ServoTasks", "EPROM lock");
    case IntentColumn::Count:
        break;
    }
    return {};
}
} // namespace ui
