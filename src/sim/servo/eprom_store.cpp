// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/servo/eprom_store.h"

#include <QFile>
#include <QFileInfo>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryFile>

#include <filesystem>

namespace sim {
namespace {
constexpr int formatVersion = 1;
constexpr qint64 maxFileSize = 1'000'000;

QString formatName()
{
    return QStringLiteral("servodesk-sim-eprom");
}

tl::unexpected<base::Error> invalidFile(const QString& path, const QString& why)
{
    return base::fail(base::ErrorCode::FileFormat, QStringLiteral("state"),
                      QStringLiteral("%1: %2").arg(path, why));
}

std::vector<base::Bytes> imagesOf(VirtualBus& bus)
{
    std::vector<base::Bytes> images;
    for (const VirtualServo* servo : bus.servos())
        images.push_back(servo->epromImage());
    return images;
}

QByteArray toJson(VirtualBus& bus, const std::vector<base::Bytes>& images)
{
    QJsonArray servos;
    for (std::size_t i = 0; i < images.size(); ++i)
        servos.append(QJsonObject{
            {QStringLiteral("model"), bus.servos()[i]->profile().modelName},
            {QStringLiteral("eprom"), base::toHex(images[i])},
        });
    return QJsonDocument(QJsonObject{
                             {QStringLiteral("format"), formatName()},
                             {QStringLiteral("version"), formatVersion},
                             {QStringLiteral("servos"), servos},
                         })
        .toJson();
}

/// The reason for a failure, which leaves the old file as it was. Unlike QSaveFile, it does not
/// wait for the disk, which would keep the servos silent for as long as the disk is busy.
QString replaceFile(const QString& path, const QByteArray& text)
{
    const QFileInfo existing(path);
    if (existing.exists() && !existing.isWritable())
        return QStringLiteral("not writable");
    const QString target = existing.exists() ? existing.canonicalFilePath() : path;
    QTemporaryFile file(target + QStringLiteral(".XXXXXX"));
    if (!file.open() || file.write(text) != text.size() || !file.flush())
        return file.errorString();
    file.setPermissions(existing.exists() ? existing.permissions()
                                          : QFile::ReadOwner | QFile::WriteOwner |
                                                QFile::ReadGroup | QFile::ReadOther);
    const QString name = file.fileName();
    file.close();
    std::error_code failed;
    std::filesystem::rename(name.toStdU16String(), target.toStdU16String(), failed);
    if (failed)
        return QString::fromStdString(failed.message());
    file.setAutoRemove(false);
    return {};
}

base::Result<std::vector<base::Bytes>> fromJson(const QByteArray& text, const QString& path,
                                                VirtualBus& bus)
{
    const QJsonObject file = QJsonDocument::fromJson(text).object();
    if (file[QLatin1String("format")].toString() != formatName() ||
        file[QLatin1String("version")].toInt() != formatVersion)
        return invalidFile(path, QStringLiteral("no state of servodesk-sim"));
    const QJsonArray entries = file[QLatin1String("servos")].toArray();
    const auto servos = bus.servos();
    if (entries.size() != static_cast<qsizetype>(servos.size()))
        return invalidFile(path, QStringLiteral("holds %1 servos, this bus has %2")
                                     .arg(entries.size())
                                     .arg(servos.size()));
    std::vector<base::Bytes> images;
    for (std::size_t i = 0; i < servos.size(); ++i) {
        const QJsonObject entry = entries[static_cast<qsizetype>(i)].toObject();
        const QString model = entry[QLatin1String("model")].toString();
        const QString place = QStringLiteral("servo %1").arg(i + 1);
        if (model != servos[i]->profile().modelName)
            return invalidFile(path, QStringLiteral("%1 is a %2, on this bus a %3")
                                         .arg(place, model, servos[i]->profile().modelName));
        auto image = base::fromHex(entry[QLatin1String("eprom")].toString());
        if (!image || image->size() != servos[i]->epromImage().size())
            return invalidFile(path, QStringLiteral("%1: damaged EPROM").arg(place));
        images.push_back(std::move(*image));
    }
    return images;
}
} // namespace

base::Result<EpromStore> EpromStore::open(const QString& path, VirtualBus& bus)
{
    EpromStore store(path, bus);
    if (QFile::exists(path)) {
        if (auto loaded = store.load(); !loaded)
            return tl::unexpected(loaded.error());
    }
    if (auto saved = store.saveChanges(); !saved)
        return tl::unexpected(saved.error());
    return store;
}

base::Result<void> EpromStore::load()
{
    QFile file(m_path);
    if (!QFileInfo(m_path).isFile())
        return base::fail(base::ErrorCode::FileUnreadable, QStringLiteral("state"),
                          QStringLiteral("%1: not a regular file").arg(m_path));
    if (!file.open(QIODevice::ReadOnly))
        return base::fail(base::ErrorCode::FileUnreadable, QStringLiteral("state"),
                          QStringLiteral("%1: %2").arg(m_path, file.errorString()));
    if (file.size() > maxFileSize)
        return invalidFile(m_path, QStringLiteral("no state of servodesk-sim"));
    auto images = fromJson(file.readAll(), m_path, *m_bus);
    if (!images)
        return tl::unexpected(images.error());
    const auto servos = m_bus->servos();
    for (std::size_t i = 0; i < servos.size(); ++i) {
        if (!servos[i]->setEpromImage((*images)[i]))
            return invalidFile(m_path, QStringLiteral("servo %1: damaged EPROM").arg(i + 1));
    }
    m_saved = std::move(*images);
    return {};
}

base::Result<void> EpromStore::saveChanges()
{
    auto images = imagesOf(*m_bus);
    if (images == m_saved)
        return {};
    if (const QString why = replaceFile(m_path, toJson(*m_bus, images)); !why.isEmpty())
        return base::fail(base::ErrorCode::FileUnwritable, QStringLiteral("state"),
                          QStringLiteral("%1: %2").arg(m_path, why));
    m_saved = std::move(images);
    return {};
}
} // namespace sim
