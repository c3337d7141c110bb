// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/memory/servo_history_model.h"

#include "text/language.h"
#include "ui/memory/memory_text.h"

#include <QLocale>

namespace ui {
namespace {
/// The result as a sign; the tooltip has the text.
QString outcomeSymbol(const QString& end, bool temporary)
{
    if (end == QLatin1String("done"))
        return temporary ? QStringLiteral("◷") : QStringLiteral("✓");
    if (end == QLatin1String("undone"))
        return QStringLiteral("↶");
    return end.isEmpty() ? QStringLiteral("…") : QStringLiteral("✗");
}
} // namespace

bool ServoHistoryModel::Line::operator==(const Line& other) const
{
    return uuid == other.uuid && end == other.end && item.key == other.item.key &&
           item.newRaw == other.item.newRaw;
}

std::vector<ServoHistoryModel::Line> ServoHistoryModel::linesOf(const session::ServoEntry& entry)
{
    std::vector<Line> lines;
    for (auto it = entry.history.rbegin(); it != entry.history.rend(); ++it) {
        const base::Intent& intent = it->intent;
        const QString end = it->end ? it->end->outcome : QString();
        for (const base::JournalItem& item : intent.items)
            lines.push_back({intent.uuid, intent.at, intent.kind, intent.temporary, end, item});
    }
    return lines;
}

void ServoHistoryModel::setEntry(const session::ServoEntry* entry)
{
    std::vector<Line> fresh = entry != nullptr ? linesOf(*entry) : std::vector<Line>();
    const session::ServoRef ref = entry != nullptr ? entry->ref : 0;
    const catalog::ProfilePtr profile = entry != nullptr ? entry->servo.profile : nullptr;
    if (ref == m_ref && profile == m_profile && fresh == m_lines)
        return;
    beginResetModel();
    m_ref = ref;
    m_profile = profile;
    m_lines = std::move(fresh);
    endResetModel();
}

void ServoHistoryModel::retranslate()
{
    if (!m_lines.empty())
        Q_EMIT dataChanged(index(0), index(rowCount() - 1));
}

int ServoHistoryModel::rowCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : static_cast<int>(m_lines.size());
}

QString ServoHistoryModel::valueText(const Line& line, std::int64_t raw) const
{
    const catalog::Register* reg = m_profile ? m_profile->find(line.item.key) : nullptr;
    if (reg == nullptr)
        return QString::number(raw);
    return catalog::formatValue(raw, *reg,
                                catalog::valueFormat(*reg, *m_profile, catalog::noLookup),
                                ::text::isUiChinese());
}

QString ServoHistoryModel::text(const Line& line) const
{
    const catalog::Register* reg = m_profile ? m_profile->find(line.item.key) : nullptr;
    const QString name = reg != nullptr ? reg->name.in(::text::isUiChinese()) : line.item.key;
    const QDateTime at = line.at.toLocalTime();
    const bool today = at.date() == QDate::currentDate();
    const QString change =
        QStringLiteral("%1 %2 → %3")
            .arg(name, valueText(line, line.item.oldRaw), valueText(line, line.item.newRaw));
    return QStringLiteral("%1  %2 %3")
        .arg(at.toString(today ? QStringLiteral("HH:mm:ss") : QStringLiteral("yyyy-MM-dd HH:mm")),
             line.kind == base::IntentKind::Undo ? tr("Undo: %1").arg(change) : change,
             outcomeSymbol(line.end, line.temporary));
}

QString ServoHistoryModel::tip(const Line& line) const
{
    QString outcomeText;
    if (line.end.isEmpty())
        outcomeText = tr("Not finished: still being written, or interrupted.");
    else if (line.end == QLatin1String("undone"))
        outcomeText = tr("Started, then undone: the old value was restored.");
    else if (line.end == QLatin1String("abandoned"))
        outcomeText = tr("Abandoned: neither finished nor undone.");
    else if (line.end != QLatin1String("done"))
        outcomeText = tr("The write did not end as expected.");
    else if (line.temporary)
        outcomeText = tr("Written temporarily: lost at power-off.");
    else
        outcomeText = tr("Written and read back.");
    const auto both = [&](std::int64_t raw) {
        const QString number = QString::number(qint64(raw));
        const QString words = valueText(line, raw);
        return words == number ? number : QStringLiteral("%1 (%2)").arg(words, number);
    };
    return QStringLiteral("%1\n%2: %3 → %4\n%5")
        .arg(QLocale().toString(line.at.toLocalTime(), QLocale::LongFormat), line.item.key,
             both(line.item.oldRaw), both(line.item.newRaw), outcomeText);
}

QVariant ServoHistoryModel::data(const QModelIndex& index, int role) const
{
    if (!index.isValid())
        return {};
    const Line& line = m_lines[static_cast<std::size_t>(index.row())];
    if (role == Qt::DisplayRole)
        return text(line);
    if (role == Qt::ToolTipRole)
        return tip(line);
    return {};
}
} // namespace ui
