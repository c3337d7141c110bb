// SPDX-License-Identifier: GPL-3.0-or-later
// Reads catalog files into definitions: later entries replace earlier ones, and whatever cannot be
// used costs a warning instead of the start-up. Hostile files cost one warning. One thread.
#pragma once

#include "catalog/definition.h"

#include <QHash>
#include <QJsonArray>

#include <functional>
#include <set>

namespace catalog {
class Loader {
public:
    void addFile(const QString& path);
    void addFolder(const QString& path); ///< *.json by name; a folder that is absent is empty

    /// Ties the parts together; call once, after the last file.
    Catalog::LoadResult finish();

private:
    void addContent(const QJsonObject& object);
    void addMap(const QJsonValue& row, const QString& where);
    void addSeries(const QJsonValue& row, const QString& where);
    void applyProtocol(SeriesDef& series) const;
    void addModel(const QJsonValue& row, const QString& where);
    void addFirmware(const QJsonValue& row, const QString& where);
    void forEachRow(const QJsonObject& object, const char* name,
                    const std::function<void(const QJsonValue&, const QString&)>& add);
    void warn(const QString& where, const QString& detail);

    Catalog::Data m_data;
    std::vector<LoadWarning> m_warnings;
    QString m_file;
    std::set<QString> m_modelsOfFile; ///< by what identifies them
    QHash<QString, QString> m_files;  ///< where the latest "series STS" or "model STS3215" stands
    int m_fileWarnings = 0;
};
} // namespace catalog
