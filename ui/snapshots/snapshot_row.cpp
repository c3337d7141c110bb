// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/snapshots/snapshot_row.h"

#include "text/translate.h"

#include <QDir>

#include <algorithm>

namespace ui {
using text::translate;

namespace {
QString timeText(const QDateTime& at)
{
    const QDateTime local = at.toLocalTime();
    const bool today = local.date() == QDate::currentDate();
    return today ? local.toString(QStringLiteral("HH:mm:ss"))
                 : local.toString(QStringLiteral("yyyy-MM-dd HH:mm"));
}

QString reasonText(history::SnapshotReason reason)
{
    switch (reason) {
    case history::SnapshotReason::Automatic:
        return translate("SnapshotRow", "before a change");
    case history::SnapshotReason::Manual:
        return translate("SnapshotRow", "manual");
    case history::SnapshotReason::Bundle:
        return translate("SnapshotRow", "bundle");
    case history::SnapshotReason::Commission:
        return translate("SnapshotRow", "before commissioning");
    }
    return {};
}

QString originText(const QString& firmware, const QString& port)
{
    return translate("SnapshotRow", "firmware %1, port %2").arg(firmware, port);
}

struct RowText {
    QString title;
    QString details;
    QString time; ///< empty: a template has none
    QStringList tip;
};

RowText textOf(const SnapshotItem& item)
{
    const QString dot = QStringLiteral(" · ");
    if (item.bundle)
        return {item.title,
                translate("SnapshotRow", "%n servo(s)", nullptr, int(item.bundle->servos.size())),
                timeText(item.bundle->at),
                {item.bundle->note}};
    if (item.kept) {
        const history::HistorySnapshot& kept = *item.kept;
        const QString reason = reasonText(kept.reason);
        return {QStringLiteral("%1 · ID %2").arg(kept.model).arg(kept.servoId),
                kept.label.isEmpty() ? reason : kept.label,
                timeText(kept.at),
                {reason, kept.note, originText(kept.firmware, kept.port)}};
    }
    if (!item.snapshot)
        return {};
    const snapshot::Snapshot& table = *item.snapshot;
    const int rows = int(table.registers.size());
    return {item.title,
            QStringLiteral("%1 · ID %2").arg(table.servo.model).arg(table.servo.id) +
                (table.isTemplate
                     ? dot + translate("SnapshotRow", "template, %n row(s)", nullptr, rows)
                     : QString()),
            table.isTemplate ? QString() : timeText(table.at),
            {table.note, originText(table.servo.firmware, table.port)}};
}
} // namespace

QString SnapshotItem::name() const
{
    if (!kept)
        return title;
    return kept->label.isEmpty() ? timeText(kept->at) : kept->label;
}

SnapshotRow::SnapshotRow(std::shared_ptr<SnapshotItem> item)
    : m_item(std::move(item))
{
    updateText();
}

SnapshotItem* SnapshotRow::itemOf(const QTreeWidgetItem* row)
{
    return row != nullptr ? static_cast<const SnapshotRow*>(row)->m_item.get() : nullptr;
}

void SnapshotRow::updateText()
{
    RowText words = textOf(*m_item);
    const QString path = m_item->path.isEmpty() && m_item->kept ? m_item->kept->file : m_item->path;
    words.tip << QDir::toNativeSeparators(path);
    words.tip.push_front(words.time);
    words.tip.removeAll(QString());
    setText(0, words.title + QLatin1Char('\n') + words.details);
    setText(1, words.time);
    setTextAlignment(1, Qt::AlignRight | Qt::AlignVCenter);
    for (const int column : {0, 1})
        setToolTip(column, QStringLiteral("%1\n%2\n%3")
                               .arg(words.title, words.details, words.tip.join(QLatin1Char('\n'))));
    for (int i = 0; i < childCount(); ++i)
        static_cast<SnapshotRow*>(child(i))->updateText();
}

bool matchesSearch(const history::HistorySnapshot& row, const QStringList& words)
{
    const QString all = QStringLiteral("%1 ID %2 %3 %4 %5 %6")
                            .arg(row.model)
                            .arg(row.servoId)
                            .arg(row.label, row.note, row.file, reasonText(row.reason));
    return std::all_of(words.begin(), words.end(), [&](const QString& word) {
        return all.contains(word, Qt::CaseInsensitive);
    });
}
} // namespace ui
