// SPDX-License-Identifier: GPL-3.0-or-later
// What the history page does.
#include "session/history/history_server_choice.h"
#include "ui/history/history_page.h"
#include "ui/history/history_server_dialog.h"
#include "ui/widgets/banner.h"
#include "ui/widgets/note_dialog.h"

#include <QDir>
#include <QFileDialog>
#include <QFileInfo>

namespace ui {
using record::HistoryKind;

namespace {
const QString folderKey = QStringLiteral("history/folder");
}

void HistoryPage::openTable()
{
    if (m_table.kind() == HistoryKind::Runs) {
        Q_EMIT previousTestsRequested();
        return;
    }
    const auto row = current();
    if (!row)
        return;
    m_banner->hideMessage();
    const HistoryLine line = m_table.lineAt(*row);
    if (m_table.kind() == HistoryKind::Snapshots)
        openSnapshot(line.number);
    else if (m_table.kind() == HistoryKind::Writes)
        openTableAt(line);
}

void HistoryPage::openSnapshot(std::int64_t number)
{
    if (!isRemote()) {
        Q_EMIT snapshotRequested(number);
        return;
    }
    historyService().loadSnapshot(
        number, this, [this](const base::Result<session::SharedSnapshot>& loaded) {
            if (!loaded) {
                showError(loaded.error());
                return;
            }
            const QString label = (*loaded)->label;
            Q_EMIT tableRequested(*loaded, label.isEmpty() ? tr("from the server") : label);
        });
}

/// Just before the write: what one would go back to.
void HistoryPage::openTableAt(const HistoryLine& line)
{
    historyService().tableAt(
        m_catalog, line.servo, line.at.addMSecs(-1), this,
        [this, line](const base::Result<record::TableState>& point) {
            if (!point) {
                showError(point.error());
                return;
            }
            const QString title =
                tr("before %1")
                    .arg(line.at.toLocalTime().toString(QStringLiteral("yyyy-MM-dd HH:mm:ss")));
            Q_EMIT tableRequested(std::make_shared<const record::Snapshot>(point->table), title);
            if (!point->unknown.isEmpty()) {
                m_banner->showMessage([keys = point->unknown] {
                    return BannerText{Tone::Warn,
                                      tr("Some registers are not known for that moment."),
                                      tr("What changed them was not recorded: %1.")
                                          .arg(keys.join(QStringLiteral(", "))),
                                      tr("They are left alone when the table is restored.")};
                });
            } else if (point->changedId) {
                m_banner->showMessage([changed = *point->changedId] {
                    return BannerText{
                        Tone::Warn, tr("The servo had ID %1 at that moment.").arg(changed.id),
                        tr("Its ID was changed on %1.")
                            .arg(changed.at.toLocalTime().toString(
                                QStringLiteral("yyyy-MM-dd HH:mm:ss"))),
                        tr("What was written to it with that ID is in the history of servo ID "
                           "%1, not in this table.")
                            .arg(changed.id)};
                });
            }
        });
}

void HistoryPage::editLabel()
{
    const auto row = current();
    if (!row)
        return;
    const HistoryLine line = m_table.lineAt(*row);
    const HistoryKind kind = m_table.kind();
    auto* dialog = new NoteDialog(line.label, line.note, this);
    dialog->setNoteVisible(kind == HistoryKind::Snapshots);
    connect(dialog, &NoteDialog::accepted, this, [this, dialog, kind, number = line.number] {
        if (kind == HistoryKind::Snapshots)
            m_local.setSnapshotNote(number, dialog->label(), dialog->note());
        else
            m_local.setServoLabel(number, dialog->label());
    });
    dialog->open();
}

void HistoryPage::exportList()
{
    auto* dialog = new QFileDialog(this, tr("Export the history"));
    dialog->setObjectName(QStringLiteral("historyFileDialog"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setAcceptMode(QFileDialog::AcceptSave);
    dialog->setNameFilters({tr("Table for spreadsheets (*.csv)"), tr("Data (*.json)")});
    dialog->setDefaultSuffix(QStringLiteral("csv"));
    dialog->setDirectory(m_settings.pageValue(folderKey, QDir::homePath()).toString());
    dialog->selectFile(
        QStringLiteral("history-%1.csv").arg(record::historyKindName(m_table.kind())));
    connect(dialog, &QFileDialog::fileSelected, this, [this](const QString& path) {
        m_settings.setPageValue(folderKey, QFileInfo(path).absolutePath());
        const bool csv = !path.endsWith(QLatin1StringView(".json"), Qt::CaseInsensitive);
        historyService().exportTo(
            path, csv, {m_table.kind()}, filter(), this,
            [this, path](const base::Result<std::int64_t>& rows) {
                if (!rows) {
                    showError(rows.error());
                    return;
                }
                m_banner->showMessage([path, count = *rows] {
                    return BannerText{
                        Tone::Good,
                        tr("%1 rows saved: %2").arg(count).arg(QDir::toNativeSeparators(path))};
                });
            });
    });
    dialog->open();
}

void HistoryPage::setServer()
{
    auto* dialog = new HistoryServerDialog(m_settings, m_sender, this);
    connect(dialog, &HistoryServerDialog::accepted, this, [this] {
        m_server.reset(); // another one perhaps
        setViewing(isVisible());
        loadFilterValues();
        query();
    });
    dialog->open();
}

void HistoryPage::showError(const base::Error& error)
{
    m_banner->showMessage(error);
}
} // namespace ui
