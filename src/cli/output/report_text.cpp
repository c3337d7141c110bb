// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/output/report_text.h"

#include "cli/output/table.h"
#include "cli/translate.h"
#include "text/error_text.h"
#include "text/language.h"
#include "text/notice_text.h"

namespace cli {
namespace {
/// The option that gives the consent of the user.
QString consentOption(const base::Error& error)
{
    return error.operation == QLatin1String("clear-alarm") ? QStringLiteral("--move")
                                                           : QStringLiteral("--dangerous");
}

/// Adds the option, because the text layer does not know how consent is given here.
QString remedyFor(const base::Error& error, const QString& remedy)
{
    if (error.code != base::ErrorCode::NeedsConsent)
        return remedy;
    return text::joinSentences(
        {remedy, translate("cli", "On the command line, use the option %1 to confirm.")
                     .arg(consentOption(error))});
}

/// The next command, which the text layer does not know.
QString commandHint(const base::Error& error)
{
    if (error.operation == QLatin1String("history-server"))
        return {}; // not about a servo
    switch (error.code) {
    case base::ErrorCode::NoReply:
    case base::ErrorCode::Garbled:
        return QStringLiteral("servodesk-cli scan --bauds all");
    case base::ErrorCode::NeedsConsent:
        return consentOption(error);
    case base::ErrorCode::PortMissing:
        return QStringLiteral("servodesk-cli ports");
    case base::ErrorCode::LockOpen:
    case base::ErrorCode::LinkLost:
        return QStringLiteral("servodesk-cli recover");
    case base::ErrorCode::UnknownRegister:
        return QStringLiteral("servodesk-cli dump ID");
    case base::ErrorCode::BadArgument:
        return QStringLiteral("servodesk-cli --help");
    default:
        return {};
    }
}

/// "1000000" is a number although it names an enum value.
Json keyOrNumber(const QString& key)
{
    bool whole = false;
    const qlonglong number = key.toLongLong(&whole);
    return whole ? Json(std::int64_t{number}) : Json(key);
}

Json bitKeys(std::int64_t raw, const catalog::Register& reg)
{
    QStringList keys;
    for (int bit = 0; bit < reg.size * 8; ++bit) {
        if ((raw >> bit & 1) == 0)
            continue;
        QString key = QStringLiteral("bit%1").arg(bit);
        for (const catalog::NamedValue& value : reg.values)
            key = value.value == bit ? value.key : key;
        keys << key;
    }
    return keys;
}

QString numberOrDash(const std::optional<std::int64_t>& number)
{
    return number ? QString::number(*number) : noValue();
}
} // namespace

QString servoTitle(const device::Servo& servo)
{
    const catalog::Profile& profile = *servo.profile;
    if (profile.identity.firmwareMajor < 0) // it does not report its model
        return profile.modelName;
    if (profile.modelName.contains(profile.identity.modelId())) // a model without a name
        return translate("cli", "%1, firmware %2")
            .arg(profile.modelName, profile.identity.firmware());
    return translate("cli", "%1 (%2), firmware %3")
        .arg(profile.modelName, profile.identity.modelId(), profile.identity.firmware());
}

QString formatValueText(const device::Servo& servo, const catalog::Register& reg)
{
    const auto raw = servo.raw(reg);
    return raw ? catalog::formatValue(*raw, reg, servo.meaning(reg), text::isUiChinese())
               : noValue();
}

QString formatUnit(const device::Servo& servo, const catalog::Register& reg)
{
    return servo.meaning(reg).unit;
}

Json jsonValue(const device::Servo& servo, const catalog::Register& reg)
{
    const auto raw = servo.raw(reg);
    if (!raw)
        return {};
    const catalog::ValueFormat meaning = servo.meaning(reg);
    if (meaning.encoding == catalog::Encoding::Bits)
        return bitKeys(*raw, reg);
    if (meaning.encoding == catalog::Encoding::Enum) {
        for (const catalog::NamedValue& value : reg.values) {
            if (value.value == *raw)
                return keyOrNumber(value.key);
        }
        return *raw;
    }
    return meaning.scale == 1.0 ? Json(*raw) : Json(catalog::toPhysical(*raw, meaning));
}

Json jsonAlarms(std::uint8_t status, const catalog::Profile* profile)
{
    return text::reportsAlarms(profile) ? Json(text::statusKeys(status, profile)) : Json();
}

Json jsonRegister(const device::Servo& servo, const catalog::Register& reg)
{
    return Json::object()
        .add("key", reg.key)
        .add("address", reg.address)
        .add("raw", servo.raw(reg))
        .add("value", jsonValue(servo, reg))
        .add("unit", formatUnit(servo, reg))
        .add("area", catalog::areaName(reg.area))
        .add("access", catalog::accessName(reg.access));
}

Table registerTable(const device::Servo& servo,
                    const std::vector<const catalog::Register*>& registers)
{
    Table table({translate("cli", "Address"), translate("cli", "Key"), translate("cli", "Register"),
                 translate("cli", "Value"), translate("cli", "Raw"), translate("cli", "Area"),
                 translate("cli", "Access")});
    table.alignRight({0, 4});
    for (const catalog::Register* reg : registers) {
        table.add({QString::number(reg->address), reg->key,
                   text::localized(servo.meaning(*reg).name), formatValueText(servo, *reg),
                   numberOrDash(servo.raw(*reg)), text::areaLabel(reg->area),
                   text::accessLabel(reg->access)});
    }
    return table;
}

Json jsonWrites(const device::WriteReport& report)
{
    Json::Array writes;
    for (const device::WriteResult& result : report.writes) {
        Json one = Json::object();
        one.add("key", result.key)
            .add("address", result.address)
            .add("old", result.oldRaw)
            .add("new", result.newRaw)
            .add("read_back", result.readBack)
            .add("outcome", device::outcomeName(result.outcome));
        if (result.error)
            one.add("error", jsonError(*result.error));
        writes.push_back(std::move(one));
    }
    return Json::object()
        .add("id", report.id)
        .add("writes", std::move(writes))
        .add("lock", device::lockName(report.lock));
}

QString writeText(const device::Servo& servo, const device::WriteReport& report)
{
    Table table({translate("cli", "Address"), translate("cli", "Key"), translate("cli", "Old"),
                 translate("cli", "New"), translate("cli", "Read back"),
                 translate("cli", "Result")});
    table.alignRight({0, 2, 3, 4});
    const auto shown = [&servo](const QString& key, const std::optional<std::int64_t>& raw) {
        const catalog::Register* reg = servo.profile->find(key);
        return raw && reg != nullptr
                   ? catalog::formatValue(*raw, *reg, servo.meaning(*reg), text::isUiChinese())
                   : numberOrDash(raw);
    };
    QString why;
    for (const device::WriteResult& result : report.writes) {
        table.add({QString::number(result.address), result.key, shown(result.key, result.oldRaw),
                   shown(result.key, result.newRaw), shown(result.key, result.readBack),
                   text::outcomeLabel(device::outcomeName(result.outcome))});
        if (result.error)
            why += text::describe(*result.error).message + QLatin1Char('\n');
    }
    return table.text() +
           translate("cli", "EPROM lock: %1").arg(text::lockLabel(device::lockName(report.lock))) +
           QLatin1Char('\n') + why;
}

Json jsonError(const base::Error& error)
{
    const text::Description words = text::describe(error);
    Json json = Json::object()
                    .add("code", base::errorName(error.code))
                    .add("message", words.message)
                    .add("cause", words.cause)
                    .add("remedy", remedyFor(error, words.remedy));
    if (error.id >= 0)
        json.add("id", error.id);
    if (!error.registerKey.isEmpty())
        json.add("key", error.registerKey);
    const QString hint = commandHint(error);
    if (!hint.isEmpty())
        json.add("try", hint);
    return json;
}

QString errorText(const base::Error& error)
{
    const text::Description words = text::describe(error);
    QStringList lines{words.message};
    // A typing error needs no cause.
    if (error.operation != QLatin1String("arguments")) {
        lines << translate("cli", "  Likely cause: %1").arg(words.cause)
              << translate("cli", "  Remedy: %1").arg(remedyFor(error, words.remedy));
    }
    const QString hint = commandHint(error);
    if (!hint.isEmpty())
        lines << translate("cli", "  Example: %1").arg(hint);
    return lines.join(QLatin1Char('\n'));
}
} // namespace cli
