// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/memory/memory_output.h"

#include "files/file_error.h"
#include "ui/common/file_dialog.h"

#include <QApplication>
#include <QClipboard>
#include <QPrintDialog>
#include <QPrinter>
#include <QSaveFile>
#include <QTableView>
#include <QTextDocument>

namespace ui {
namespace {
const QString memoryOutputOperation = QStringLiteral("export");
const QString csv = QStringLiteral(".csv");
const QString html = QStringLiteral(".html");

bool isHtmlPath(const QString& path)
{
    return path.endsWith(html, Qt::CaseInsensitive) ||
           path.endsWith(QLatin1String(".htm"), Qt::CaseInsensitive);
}
} // namespace

MemoryOutput::MemoryOutput(session::ServoRegistry& registry, const MemoryModel& model,
                           QTableView& view)
    : QObject(&view)
    , m_registry(registry)
    , m_model(model)
    , m_view(view)
{}

std::vector<int> MemoryOutput::shownRows(bool selectedOnly) const
{
    std::vector<int> rows;
    const QAbstractItemModel* shown = m_view.model();
    for (int i = 0; i < shown->rowCount(); ++i) {
        if (selectedOnly && !m_view.selectionModel()->isRowSelected(i))
            continue;
        const QString key = shown->index(i, 0).data(MemoryModel::KeyRole).toString();
        rows.push_back(m_model.rowOf(key));
    }
    return rows;
}

std::optional<TableSheet> MemoryOutput::sheet(bool selectedOnly) const
{
    const session::ServoEntry* entry = m_registry.servo(m_model.servo());
    if (entry == nullptr || m_model.rowCount() == 0)
        return std::nullopt;
    return memorySheet(m_model, shownRows(selectedOnly), *entry, QDateTime::currentDateTime());
}

void MemoryOutput::copyRows()
{
    const auto selected = sheet(true);
    if (selected && !selected->rows.empty())
        QApplication::clipboard()->setText(toTsv(*selected));
}

base::Result<void> MemoryOutput::save(const TableSheet& sheet, const QString& path)
{
    if (path.isEmpty())
        return tl::unexpected(files::noFileNameError(memoryOutputOperation));
    QSaveFile file(path);
    const QByteArray bytes = isHtmlPath(path) ? toHtml(sheet) : toCsv(sheet);
    if (!file.open(QIODevice::WriteOnly | QIODevice::Unbuffered) || !files::writeAll(file, bytes) ||
        !file.commit())
        return tl::unexpected(files::fileError(memoryOutputOperation, file));
    return {};
}

/// The table at the time of the command, not when the dialog is accepted.
void MemoryOutput::exportTable()
{
    const auto all = sheet(false);
    const session::ServoEntry* entry = m_registry.servo(m_model.servo());
    if (!all || entry == nullptr)
        return;
    askForSavePath(
        &m_view,
        {QStringLiteral("exportDialog"),
         tr("Export the memory table"),
         {tr("Table for spreadsheets (*.csv)"), tr("Web page to view or print (*.html)")},
         memoryFileName(*entry, QDateTime::currentDateTime()) + csv},
        [this, all](const QString& path) {
            const auto done = save(*all, path);
            if (done)
                Q_EMIT saved(path);
            else
                Q_EMIT failed(done.error());
        });
}

void MemoryOutput::printTable()
{
    const auto all = sheet(false);
    if (!all)
        return;
    const auto printer = std::make_shared<QPrinter>(QPrinter::HighResolution);
    printer->setDocName(all->title);
    auto* dialog = new QPrintDialog(printer.get(), &m_view);
    dialog->setObjectName(QStringLiteral("printDialog"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    // The connection keeps the printer as long as the dialog uses it.
    connect(dialog, &QDialog::accepted, dialog, [printer, all] {
        QTextDocument page;
        page.setHtml(QString::fromUtf8(toHtml(*all)));
        page.print(printer.get());
    });
    dialog->open();
}
} // namespace ui
