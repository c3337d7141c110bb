// SPDX-License-Identifier: GPL-3.0-or-later
#include "snapshot/bundle.h"

#include "files/json_duplicates.h"
#include "files/json_format.h"
#include "files/json_text.h"
#include "files/text_file.h"
#include "snapshot/snapshot_json_reader.h"

#include <QSet>

#include <algorithm>

namespace snapshot {
namespace {
const QLatin1String bundleFormat("servodesk-bundle");
constexpr int bundleVersion = 1;
constexpr qint64 maxBundleFileSize = 64 * 1024 * 1024; ///< 254 servos with long notes are 4 MB
const QString loadBundleOperation = QStringLiteral("load-bundle");

std::vector<Snapshot> readServos(const files::JsonReader& json)
{
    std::vector<Snapshot> servos;
    QSet<QString> seen;
    for (const files::JsonReader& one : json.objects("servos")) {
        servos.push_back(readSnapshot(one));
        const SnapshotServo& servo = servos.back().servo;
        const QString who = servo.protocol + QLatin1Char(' ') + QString::number(servo.id);
        if (seen.contains(who))
            one.reportError("servo", QStringLiteral("ID %1 is there twice").arg(servo.id));
        seen.insert(who);
    }
    return servos;
}

base::Result<Bundle> fail(const QString& detail)
{
    return base::fail(base::ErrorCode::FileFormat, loadBundleOperation, detail);
}
} // namespace

QByteArray encodeBundle(const Bundle& bundle)
{
    std::vector<const Snapshot*> servos;
    for (const Snapshot& servo : bundle.servos)
        servos.push_back(&servo);
    std::stable_sort(servos.begin(), servos.end(), [](const Snapshot* a, const Snapshot* b) {
        return std::tie(a->servo.id, a->servo.protocol) < std::tie(b->servo.id, b->servo.protocol);
    });
    QByteArray text = "{\n  \"format\": " + files::jsonText(bundleFormat) +
                      ",\n  \"version\": " + QByteArray::number(bundleVersion) +
                      ",\n  \"program\": " + files::jsonText(bundle.program) +
                      ",\n  \"time\": " + files::jsonText(bundle.at.toUTC().toString(Qt::ISODate)) +
                      ",\n  \"label\": " + files::jsonText(bundle.label) +
                      ",\n  \"note\": " + files::jsonText(bundle.note) +
                      ",\n  \"port\": " + files::jsonText(bundle.port) + ",\n  \"servos\": [";
    const char* separator = "\n    ";
    for (const Snapshot* servo : servos) {
        text += separator + encodeSnapshot(*servo).trimmed().replace("\n", "\n    ");
        separator = ",\n    ";
    }
    return text + "\n  ]\n}\n";
}

base::Result<Bundle> decodeBundle(const QByteArray& text)
{
    const auto document = files::parseJson(text);
    if (!document)
        return fail(document.error());
    if (const QString twice = files::findDuplicateKey(text); !twice.isEmpty())
        return fail(twice);
    files::JsonReadError readError;
    const files::JsonReader json(*document, readError);
    files::checkFormat(json, bundleFormat, bundleVersion, QStringLiteral("not a ServoDesk bundle"));
    Bundle bundle;
    bundle.program = json.text("program");
    bundle.at = json.time("time");
    bundle.label = json.text("label");
    bundle.note = json.text("note");
    bundle.port = json.text("port");
    bundle.servos = readServos(json);
    if (readError.isSet())
        return fail(readError.text());
    return bundle;
}

base::Result<void> saveBundle(const Bundle& bundle, const QString& path)
{
    return files::saveTextFile(QStringLiteral("save-bundle"), encodeBundle(bundle), path);
}

base::Result<Bundle> loadBundle(const QString& path)
{
    const auto text = files::readTextFile(loadBundleOperation, path, maxBundleFileSize);
    if (!text)
        return tl::unexpected(text.error());
    auto bundle = decodeBundle(*text);
    if (!bundle)
        bundle.error().detail = path + QStringLiteral(": ") + bundle.error().detail;
    return bundle;
}
} // namespace snapshot
