// SPDX-License-Identifier: GPL-3.0-or-later
// The file dialog as every page opens it: it does not block, deletes itself when it closes, and
// remembers its folder in the settings. Owned by its parent; the window's thread; the caller of
// `chosen` reads or writes the file and reports what fails.
#pragma once

#include <QString>
#include <QStringList>

#include <functional>

class QWidget;

namespace session {
class Settings;
}

namespace ui {
struct FileRequest {
    QString objectName;
    QString title;
    QStringList filters;   ///< "Table (*.csv)"; when saving, the suffix follows the selected one
    QString fileName = {}; ///< proposed; may have a folder
    session::Settings* settings = nullptr; ///< null: the folder is not remembered
    QString folderKey = {};                ///< in the settings
    bool asksBeforeOverwrite = true;       ///< when saving
};

/// Settings keys of the folders that more than one page uses.
QString reportFolderKey();    ///< reports of sweep and step tests
QString recordingFolderKey(); ///< recordings and pictures of the trend chart

using FileChosen = std::function<void(const QString& path)>;

/// The folder remembered under `key`; the user's documents, or home, where there is none (any
/// more).
QString rememberedFolder(const session::Settings& settings, const QString& key);

void askForSavePath(QWidget* parent, const FileRequest& request, FileChosen chosen);
void askForFile(QWidget* parent, const FileRequest& request, FileChosen chosen);
/// `chosen` is called once for each file.
void askForFiles(QWidget* parent, const FileRequest& request, FileChosen chosen);
} // namespace ui
