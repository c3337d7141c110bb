// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/common/file_dialog.h"

#include "session/settings.h"

#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QRegularExpression>
#include <QStandardPaths>

namespace ui {
namespace {
/// "servo.json" of "Snapshot (*.servo.json)".
QString suffixOf(const QString& filter)
{
    static const QRegularExpression pattern(QStringLiteral(R"(\*\.([\w.]+))"));
    return pattern.match(filter).captured(1);
}

QFileDialog* createDialog(QWidget* parent, const FileRequest& request, FileChosen chosen,
                          QFileDialog::FileMode mode)
{
    auto* dialog = new QFileDialog(parent, request.title);
    dialog->setObjectName(request.objectName);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setFileMode(mode);
    dialog->setNameFilters(request.filters);
    if (request.settings != nullptr)
        dialog->setDirectory(rememberedFolder(*request.settings, request.folderKey));
    const auto choose = [settings = request.settings, key = request.folderKey,
                         chosen = std::move(chosen)](const QString& path) {
        if (settings != nullptr)
            settings->setPageValue(key, QFileInfo(path).absolutePath());
        chosen(path);
    };
    if (mode == QFileDialog::ExistingFiles)
        QObject::connect(dialog, &QFileDialog::filesSelected, parent,
                         [choose](const QStringList& paths) {
                             for (const QString& path : paths)
                                 choose(path);
                         });
    else
        QObject::connect(dialog, &QFileDialog::fileSelected, parent, choose);
    return dialog;
}
} // namespace

QString reportFolderKey()
{
    return QStringLiteral("sweep/report_folder");
}

QString recordingFolderKey()
{
    return QStringLiteral("trend/record_folder");
}

QString rememberedFolder(const session::Settings& settings, const QString& key)
{
    const QString documents = QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation);
    for (const QString& folder : {settings.pageValue(key, QString()).toString(), documents}) {
        if (!folder.isEmpty() && QFileInfo(folder).isDir())
            return folder;
    }
    return QDir::homePath();
}

void askForSavePath(QWidget* parent, const FileRequest& request, FileChosen chosen)
{
    QFileDialog* dialog = createDialog(parent, request, std::move(chosen), QFileDialog::AnyFile);
    dialog->setAcceptMode(QFileDialog::AcceptSave);
    dialog->setOption(QFileDialog::DontConfirmOverwrite, !request.asksBeforeOverwrite);
    dialog->setDefaultSuffix(suffixOf(request.filters.value(0)));
    QObject::connect(dialog, &QFileDialog::filterSelected, dialog, [dialog](const QString& filter) {
        dialog->setDefaultSuffix(suffixOf(filter));
    });
    if (!request.fileName.isEmpty())
        dialog->selectFile(request.fileName);
    dialog->open();
}

void askForFile(QWidget* parent, const FileRequest& request, FileChosen chosen)
{
    createDialog(parent, request, std::move(chosen), QFileDialog::ExistingFile)->open();
}

void askForFiles(QWidget* parent, const FileRequest& request, FileChosen chosen)
{
    createDialog(parent, request, std::move(chosen), QFileDialog::ExistingFiles)->open();
}
} // namespace ui
