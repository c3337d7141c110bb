// SPDX-License-Identifier: GPL-3.0-or-later
#include "history/journal_line.h"

#include "files/json_reader.h"

#include <QJsonDocument>

namespace record {
namespace {
constexpr int journalVersion = 1;

/// Lines from before there was more than one language do not name it.
base::Protocol readProtocol(const JsonReader& json)
{
    if (!json.contains("protocol"))
        return base::Protocol::Feetech;
    const QString name = json.text("protocol");
    const auto found = base::protocolFromName(name);
    if (!found)
        json.reportError("protocol", QStringLiteral("unknown word \"%1\"").arg(name));
    return found.value_or(base::Protocol::Feetech);
}

base::ServoIdentity readServo(const JsonReader& json)
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

base::IntentKind readKind(const JsonReader& json)
{
    const QString name = json.text("kind");
    const auto found = base::intentKindFromName(name);
    if (!found)
        json.reportError("kind", QStringLiteral("unknown word \"%1\"").arg(name));
    return found.value_or(base::IntentKind::Write);
}

BeginLine readBegin(const JsonReader& json)
{
    BeginLine line;
    base::Intent& intent = line.intent;
    intent.uuid = json.nonEmptyText("uuid");
    intent.at = json.time("at");
    intent.kind = readKind(json);
    intent.temporary = json.flag("temporary");
    intent.lockOpened = json.flag("lock_opened");
    intent.servo = readServo(json.object("servo"));
    for (const JsonReader& item : json.objects("items")) {
        intent.items.push_back({item.nonEmptyText("key"), item.smallInteger("address"),
                                item.integer("old"), item.integer("new")});
    }
    return line;
}

FactLine readFact(const JsonReader& json)
{
    return {readServo(json.object("servo")), json.nonEmptyText("name"), json.integers("values"),
            json.time("at")};
}
} // namespace

base::Result<JournalLine> decodeJournalLine(const QByteArray& text)
{
    const QString operation = QStringLiteral("journal");
    JsonReadError readError;
    const auto document = parseJson(text);
    if (!document)
        return base::fail(base::ErrorCode::FileFormat, operation, document.error());
    const JsonReader json(*document, readError);
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
} // namespace record
