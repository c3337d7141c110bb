// SPDX-License-Identifier: GPL-3.0-or-later
#include "jobs/arm/lerobot_file.h"

#include "files/json_duplicates.h"
#include "files/json_reader.h"
#include "files/text_file.h"

#include <QDir>
#include <QDirIterator>
#include <QFileInfo>
#include <QJsonDocument>

#include <algorithm>

namespace jobs {
namespace {
const QString lerobotOperation = QStringLiteral("lerobot-file");
constexpr qint64 maxLerobotFileSize = 1024 * 1024;

LerobotJoint decodeJoint(const files::JsonReader& json, const QString& name)
{
    return {name,
            json.smallInteger("id"),
            json.smallInteger("drive_mode"),
            {json.smallInteger("homing_offset"), json.smallInteger("range_min"),
             json.smallInteger("range_max")}};
}

tl::expected<LerobotFile, QString> decode(const QByteArray& text)
{
    const auto object = files::parseJson(text);
    if (!object)
        return tl::unexpected(object.error());
    if (const QString twice = files::findDuplicateKey(text); !twice.isEmpty())
        return tl::unexpected(twice);
    LerobotFile file;
    file.document = *object;
    files::JsonReadError error;
    for (auto it = object->begin(); it != object->end(); ++it) {
        if (!it->isObject())
            return tl::unexpected(it.key() + QStringLiteral(": expected a joint"));
        file.joints.push_back(decodeJoint({it->toObject(), error, it.key()}, it.key()));
    }
    if (file.joints.empty())
        return tl::unexpected(QStringLiteral("no joints in it"));
    if (error.isSet())
        return tl::unexpected(error.text());
    std::stable_sort(file.joints.begin(), file.joints.end(),
                     [](const auto& a, const auto& b) { return a.id < b.id; });
    const auto same = std::adjacent_find(file.joints.begin(), file.joints.end(),
                                         [](const auto& a, const auto& b) { return a.id == b.id; });
    if (same != file.joints.end())
        return tl::unexpected(QStringLiteral("two joints have the ID %1").arg(same->id));
    return file;
}

QString lerobotFolder()
{
    if (const QString set = qEnvironmentVariable("HF_LEROBOT_CALIBRATION"); !set.isEmpty())
        return set;
    if (const QString home = qEnvironmentVariable("HF_LEROBOT_HOME"); !home.isEmpty())
        return home + QStringLiteral("/calibration");
    return QDir::homePath() + QStringLiteral("/.cache/huggingface/lerobot/calibration");
}
} // namespace

const LerobotJoint* LerobotFile::find(const QString& name) const
{
    const auto found = std::find_if(joints.begin(), joints.end(),
                                    [&](const LerobotJoint& one) { return one.name == name; });
    return found == joints.end() ? nullptr : &*found;
}

base::Result<LerobotFile> loadLerobotFile(const QString& path)
{
    const auto text = files::readTextFile(lerobotOperation, path, maxLerobotFileSize);
    if (!text)
        return tl::unexpected(text.error());
    auto file = decode(*text);
    if (!file)
        return base::fail(base::ErrorCode::FileFormat, lerobotOperation,
                          path + QStringLiteral(": ") + file.error());
    return std::move(*file);
}

base::Result<LerobotFile> lerobotFileFor(const QString& path, std::vector<LerobotJoint> joints)
{
    LerobotFile file;
    if (QFileInfo::exists(path)) {
        auto existing = loadLerobotFile(path);
        if (!existing)
            return existing;
        file = std::move(*existing);
    }
    for (LerobotJoint& one : joints) {
        if (const LerobotJoint* before = file.find(one.name))
            one.driveMode = before->driveMode;
    }
    for (const LerobotJoint& before : file.joints) {
        const bool isOurs = std::any_of(joints.begin(), joints.end(),
                                        [&](const auto& one) { return one.name == before.name; });
        if (!isOurs)
            return base::fail(
                base::ErrorCode::FileFormat, lerobotOperation,
                QStringLiteral("%1: %2 is not a joint of this arm").arg(path, before.name));
    }
    file.joints = std::move(joints);
    return file;
}

base::Result<void> saveLerobotFile(const LerobotFile& file, const QString& path)
{
    QJsonObject document = file.document;
    for (const LerobotJoint& joint : file.joints) {
        QJsonObject object = document[joint.name].toObject();
        object[QLatin1String("id")] = joint.id;
        object[QLatin1String("drive_mode")] = joint.driveMode;
        object[QLatin1String("homing_offset")] = joint.calibration.homingOffset;
        object[QLatin1String("range_min")] = joint.calibration.rangeMin;
        object[QLatin1String("range_max")] = joint.calibration.rangeMax;
        document[joint.name] = object;
    }
    return files::saveTextFile(lerobotOperation, QJsonDocument(document).toJson(), path);
}

QStringList findLerobotFiles()
{
    QStringList files;
    QDirIterator found(lerobotFolder(), {QStringLiteral("*.json")}, QDir::Files,
                       QDirIterator::Subdirectories);
    while (found.hasNext())
        files << found.next();
    files.sort();
    return files;
}
} // namespace jobs
