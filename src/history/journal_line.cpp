// SPDX-License-Identifier: GPL-3.0-or-later
#include "history/journal_line.h"

#include "files/json_reader.h"

#include <QJsonDocument>

namespace history {
namespace {
constexpr int journalVersion = 1;

/// Lines of versions with one protocol only do not name it.
base::Protocol readProtocol(const files::JsonReader& json)
{
    return json.contains("protocol") ? json.enumValue("protocol", base::protocolFromName)
                                     : base::Protocol::Feetech;
}

base::ServoIdentity readServo(const files::JsonReader& json)
{
    base::ServoIdentity servo;
    servo.id = json.smallInteger("id");
    servo.modelMajor = json.smallInteger("model_major");
    servo.modelMinor = json.smallInteger("model_minor");
    servo.firmwareMajor = json.smallInteger("firmware_major");
    servo.firmwareMinor = json.smallInteger("firmware_minor");
    servo.map = json.text("map");
    servo.port = json.text("port");
    servo.baud = json.smallInteger("baud");
    servo.protocol = readProtocol(json);
    return servo;
}

BeginLine readBegin(const files::JsonReader& json)
{
    BeginLine line;
    base::Intent& intent = line.intent;
    intent.uuid = json.nonEmptyText("uuid");
    intent.at = json.time("at");
    intent.kind = json.enumValue("kind", base::intentKindFromName);
    intent.temporary = json.flag("temporary");
    intent.lockOpened = json.flag("lock_opened");
    intent.servo = readServo(json.object("servo"));
    for (const files::JsonReader& item : json.objects("items")) {
        intent.items.push_back({item.nonEmptyText("key"), item.smallInteger("address"),
                                item.integer("old"), item.integer("new")});
    }
    return line;
}

FactLine readFact(const files::JsonReader& json)
{
    return {readServo(json.object("servo")), json.nonEmptyText("name"), json.integers("values"),
            json.time("at")};
}
} // namespace

base::Result<JournalLine> decodeJournalLine(const QByteArray& text)
{
    const QString operation = QStringLiteral("journal");
    files::JsonReadError readError;
    const auto document = files::parseJson(text);
    if (!document)
        return base::fail(base::ErrorCode::FileFormat, operation, document.error());
    const files::JsonReader json(*document, readError);
    JournalLine line;
    if (const int version = json.smallInteger("v"); version != journalVersion) {
        json.reportError("v", QStringLiteral("format version %1 is not known").arg(version));
    } else if (const QString type = json.text("type"); type == QLatin1String("begin")) {
        line = readBegin(json);
    } else if (type == QLatin1String("end")) {
        line = EndLine{json.nonEmptyText("uuid"),
                       {json.text("outcome"), json.text("detail")},
                       json.time("at")};
    } else if (type == QLatin1String("keep")) {
        line = readFact(json);
    } else {
        json.reportError("type", QStringLiteral("unknown word \"%1\"").arg(type));
    }
    if (readError.isSet())
        return base::fail(base::ErrorCode::FileFormat, operation, readError.text());
    return line;
}
} // namespace history
