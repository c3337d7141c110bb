// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalog/loader.h"

#include "catalog/definition_readers.h"
#include "catalog/json_fields.h"
#include "catalog/map_check.h"
#include "catalog/register_location.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QJsonDocument>

#include <algorithm>

namespace catalog {
namespace {
constexpr qint64 maxFileSize = 4 * 1024 * 1024;
constexpr int maxRows = 4096;
constexpr int maxRegisters = 512;
constexpr int maxFileWarnings = 50;

/// The content, or nullopt with the reason in `errorText`. Only regular files: a pipe or a device
/// in the user's folder would never end.
std::optional<QByteArray> readFileContent(const QString& path, QString& errorText)
{
    QFile file(path);
    if (!path.startsWith(QLatin1Char(':')) && !QFileInfo(path).isFile()) {
        errorText = QStringLiteral("not a readable file");
        return std::nullopt;
    }
    if (!file.open(QIODevice::ReadOnly)) {
        errorText = file.errorString();
        return std::nullopt;
    }
    QByteArray content = file.read(maxFileSize + 1);
    if (file.error() != QFileDevice::NoError) {
        errorText = file.errorString();
        return std::nullopt;
    }
    if (content.size() > maxFileSize) {
        errorText = QStringLiteral("larger than %1 bytes").arg(maxFileSize);
        return std::nullopt;
    }
    return content;
}

template <typename T, typename Same>
void insertOrReplace(std::vector<T>& list, T item, Same same)
{
    const auto it = std::find_if(list.begin(), list.end(), same);
    if (it == list.end())
        list.push_back(std::move(item));
    else
        *it = std::move(item);
}

QString rowTitle(const QJsonValue& row)
{
    for (const char* name : {"key", "name", "id"}) {
        const QString title = row.toObject().value(QLatin1String(name)).toString();
        if (!title.isEmpty())
            return QLatin1Char(' ') + title.left(60);
    }
    return {};
}

QString seriesTitle(const SeriesDef& series)
{
    return QStringLiteral("series ") + series.key.left(60);
}

QString modelTitle(const ModelEntry& model)
{
    return QStringLiteral("model ") + model.name.left(60);
}
} // namespace

void Loader::warn(const QString& where, const QString& detail)
{
    ++m_fileWarnings;
    if (m_fileWarnings < maxFileWarnings)
        m_warnings.push_back({m_file, where, detail});
    else if (m_fileWarnings == maxFileWarnings)
        m_warnings.push_back({m_file, {}, QStringLiteral("and more of the kind")});
}

void Loader::addFile(const QString& path)
{
    m_file = path;
    m_fileWarnings = 0;
    m_modelsOfFile.clear();
    QString errorText;
    const auto content = readFileContent(path, errorText);
    if (!content)
        return warn({}, errorText);
    QJsonParseError error;
    const QJsonDocument document = QJsonDocument::fromJson(*content, &error);
    if (error.error != QJsonParseError::NoError)
        return warn(QStringLiteral("byte %1").arg(error.offset), error.errorString());
    if (!document.isObject())
        return warn({}, QStringLiteral("the outermost value is not an object"));
    addContent(document.object());
}

void Loader::addFolder(const QString& path)
{
    const QFileInfo info(path);
    if (info.exists() && !(info.isDir() && info.isReadable())) {
        m_file = path;
        m_fileWarnings = 0;
        return warn({}, QStringLiteral("not a readable folder"));
    }
    const QDir folder(path);
    // QDir::System lists dangling links and pipes too: each gets a warning.
    const auto entries = folder.entryInfoList(
        {QStringLiteral("*.json")},
        QDir::AllEntries | QDir::System | QDir::Hidden | QDir::NoDotAndDotDot, QDir::Name);
    for (const QFileInfo& entry : entries)
        addFile(entry.filePath());
}

void Loader::forEachRow(const QJsonObject& object, const char* name,
                        const std::function<void(const QJsonValue&, const QString&)>& add)
{
    const QJsonValue list = object.value(QLatin1String(name));
    if (list.isUndefined())
        return;
    if (!list.isArray())
        return warn(QLatin1String(name), QStringLiteral("not a list"));
    const QJsonArray rows = list.toArray();
    if (rows.size() > maxRows)
        return warn(QLatin1String(name), QStringLiteral("more than %1 rows").arg(maxRows));
    for (int i = 0; i < rows.size(); ++i)
        add(rows.at(i),
            QStringLiteral("%1[%2]%3").arg(QLatin1String(name)).arg(i).arg(rowTitle(rows.at(i))));
}

void Loader::addContent(const QJsonObject& object)
{
    static const QStringList known{QStringLiteral("maps"),    QStringLiteral("series"),
                                   QStringLiteral("models"),  QStringLiteral("firmware"),
                                   QStringLiteral("comment"), QStringLiteral("$schema")};
    for (const QString& name : object.keys()) {
        if (!known.contains(name))
            warn(name.left(60), QStringLiteral("unknown member"));
    }
    forEachRow(object, "maps",
               [this](const auto& row, const QString& where) { addMap(row, where); });
    forEachRow(object, "series",
               [this](const auto& row, const QString& where) { addSeries(row, where); });
    forEachRow(object, "models",
               [this](const auto& row, const QString& where) { addModel(row, where); });
    forEachRow(object, "firmware",
               [this](const auto& row, const QString& where) { addFirmware(row, where); });
}

void Loader::addMap(const QJsonValue& value, const QString& where)
{
    JsonFields fields(value);
    MapDef map;
    map.key = fields.string("key");
    map.protocol = readProtocol(fields);
    const QJsonArray rows = fields.array("registers");
    if (!fields.errorText().isEmpty())
        return warn(where, fields.errorText());
    if (rows.size() > maxRegisters)
        return warn(where, QStringLiteral("more than %1 registers").arg(maxRegisters));
    for (int i = 0; i < rows.size(); ++i) {
        QString errorText;
        auto row = readRegister(rows.at(i), map.protocol, errorText);
        if (row)
            map.rows.push_back(std::move(*row));
        else
            warn(QStringLiteral("registers[%1]%2").arg(i).arg(rowTitle(rows.at(i))), errorText);
    }
    removeConflicts(map, [this](const QString& key, const QString& reason) {
        warn(QStringLiteral("registers ") + key, reason);
    });
    if (map.rows.empty())
        return warn(where, QStringLiteral("no usable register"));
    assignBlocks(map);
    m_data.maps[map.key] = std::move(map);
}

void Loader::addSeries(const QJsonValue& value, const QString& where)
{
    QString errorText;
    auto series = readSeries(value, errorText);
    if (!series)
        return warn(where, errorText);
    applyProtocol(*series);
    if (series->protocol == base::Protocol::Feetech && !series->from)
        return warn(where, QStringLiteral("\"firmware\" is missing"));
    const QString key = series->key;
    m_files[seriesTitle(*series)] = m_file;
    insertOrReplace(m_data.series, std::move(*series),
                    [&](const SeriesDef& other) { return other.key == key; });
}

/// A series has the protocol of its map; its own member counts while the map is unknown.
void Loader::applyProtocol(SeriesDef& series) const
{
    const auto map = m_data.maps.find(series.map);
    if (map != m_data.maps.end())
        series.protocol = map->second.protocol;
}

void Loader::addModel(const QJsonValue& value, const QString& where)
{
    QString errorText;
    const auto model = readModel(value, errorText);
    if (!model)
        return warn(where, errorText);
    const auto isSame = [&](const ModelEntry& other) {
        if (model->major < 0)
            return other.major < 0 &&
                   normalizedModelName(other.name) == normalizedModelName(model->name);
        return other.major == model->major && other.minor == model->minor &&
               other.byteOrder == model->byteOrder;
    };
    const auto old = std::find_if(m_data.models.begin(), m_data.models.end(), isSame);
    const QString identity = model->major < 0 ? normalizedModelName(model->name)
                                              : QStringLiteral("%1.%2 %3")
                                                    .arg(model->major)
                                                    .arg(model->minor)
                                                    .arg(static_cast<int>(model->byteOrder));
    // A later file may replace a model of an earlier one; twice in one file is a slip.
    if (!m_modelsOfFile.insert(identity).second)
        warn(where, QStringLiteral("replaces %1 of the same file").arg(modelTitle(*old)));
    m_files[modelTitle(*model)] = m_file;
    insertOrReplace(m_data.models, *model, isSame);
}

void Loader::addFirmware(const QJsonValue& value, const QString& where)
{
    QString errorText;
    auto firmware = readFirmware(value, errorText);
    if (!firmware)
        return warn(where, errorText);
    m_data.firmware.push_back(std::move(*firmware));
}

Catalog::LoadResult Loader::finish()
{
    m_fileWarnings = 0;
    for (SeriesDef& series : m_data.series) {
        applyProtocol(series);
        if (!series.map.isEmpty() && m_data.maps.find(series.map) == m_data.maps.end()) {
            const QString title = seriesTitle(series);
            m_file = m_files.value(title);
            warn(title, QStringLiteral("there is no map \"%1\"").arg(series.map.left(60)));
            series.map.clear();
        }
    }
    for (ModelEntry& model : m_data.models) {
        const auto it = std::find_if(m_data.series.begin(), m_data.series.end(),
                                     [&](const SeriesDef& s) { return s.key == model.series; });
        if (it != m_data.series.end()) {
            model.line = it->line;
        } else if (model.supported) {
            const QString title = modelTitle(model);
            m_file = m_files.value(title);
            warn(title, QStringLiteral("there is no series \"%1\"").arg(model.series.left(60)));
        }
    }
    return {Catalog(std::make_shared<const Catalog::Data>(std::move(m_data))),
            std::move(m_warnings)};
}
} // namespace catalog
