// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/memory/memory_output.h"

#include "files/file_error.h"

#include <QApplication>
#include <QClipboard>
#include <QFileDialog>
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

MemoryOutput::MemoryOutput(session::Desk& desk, const MemoryModel& model, QTableView& view)
    : QObject(&view)
    , m_desk(desk)
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
    const session::ServoEntry* entry = m_desk.servo(m_model.servo());
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
        return tl::unexpected(record::noFileNameError(memoryOutputOperation));
    QSaveFile file(path);
    const QByteArray bytes = isHtmlPath(path) ? toHtml(sheet) : toCsv(sheet);
    if (!file.open(QIODevice::WriteOnly | QIODevice::Unbuffered) ||
        !record::writeAll(file, bytes) || !file.commit())
        return tl::unexpected(record::fileError(memoryOutputOperation, file));
    return {};
}

/// The table as it is when the command is given, not when the dialog is answered.
void MemoryOutput::exportTable()
{
    const auto all = sheet(false);
    const session::ServoEntry* entry = m_desk.servo(m_model.servo());
    if (!all || entry == nullptr)
        return;
    const QString csvFilter = tr("Table for spreadsheets (*.csv)");
    const QString htmlFilter = tr("Page to read or print (*.html)");
    auto* dialog = new QFileDialog(&m_view, tr("Export the memory table"));
    dialog->setObjectName(QStringLiteral("exportDialog"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setAcceptMode(QFileDialog::AcceptSave);
    dialog->setNameFilters({csvFilter, htmlFilter});
    dialog->setDefaultSuffix(csv.mid(1));
    dialog->selectFile(memoryFileName(*entry, QDateTime::currentDateTime()) + csv);
    connect(dialog, &QFileDialog::filterSelected, dialog,
            [dialog, htmlFilter](const QString& filter) {
                dialog->setDefaultSuffix(filter == htmlFilter ? html.mid(1) : csv.mid(1));
            });
    connect(dialog, &QFileDialog::fileSelected, this, [this, all](const QString& path) {
        const auto done = save(*all, path);
        if (done)
            Q_EMIT saved(path);
        else
            Q_EMIT failed(done.error());
    });
    dialog->open();
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
