// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/commands.h"
#include "cli/input/arguments.h"
#include "cli/output/report_text.h"
#include "cli/output/table.h"
#include "cli/run.h"
#include "cli/translate.h"
#include "device/motion/motion.h"
#include "device/write_access.h"
#include "text/error_text.h"
#include "text/language.h"
#include "text/notice_text.h"

namespace cli {
namespace {
using catalog::Role;

const catalog::Register* registerOf(const device::Servo& servo, Role role)
{
    return servo.profile->byRole(role);
}

QString formatRole(const device::Servo& servo, Role role)
{
    const catalog::Register* reg = registerOf(servo, role);
    return reg != nullptr ? formatValueText(servo, *reg) : noValue();
}

Json jsonRole(const device::Servo& servo, Role role)
{
    const catalog::Register* reg = registerOf(servo, role);
    return reg != nullptr ? jsonValue(servo, *reg) : Json();
}

QString lineKey(catalog::Line line)
{
    switch (line) {
    case catalog::Line::Ttl:
        return QStringLiteral("ttl");
    case catalog::Line::Rs485:
        return QStringLiteral("rs485");
    case catalog::Line::Unknown:
        break;
    }
    return QStringLiteral("unknown");
}

Json jsonInfo(const device::Servo& servo)
{
    const catalog::Profile& profile = *servo.profile;
    const catalog::Mode* mode = servo.mode();
    const catalog::Register* position = registerOf(servo, Role::PresentPosition);
    return Json::object()
        .add("id", servo.id)
        .add("port", servo.port)
        .add("protocol", base::protocolName(profile.protocol))
        .add("model", profile.modelName)
        .add("model_id", profile.identity.modelId())
        .add("model_known", profile.modelKnown)
        .add("series", profile.series)
        .add("map", profile.mapKey)
        .add("firmware", profile.identity.firmware())
        .add("line", lineKey(profile.line))
        .add("baud", servo.baud)
        .add("mode", mode != nullptr ? Json(mode->key) : Json())
        .add("torque", jsonRole(servo, Role::TorqueSwitch))
        .add("lock", jsonRole(servo, Role::Lock))
        .add("status", jsonAlarms(servo.status, &profile))
        .add("voltage", jsonRole(servo, Role::PresentVoltage))
        .add("temperature", jsonRole(servo, Role::PresentTemperature))
        .add("position", jsonRole(servo, Role::PresentPosition))
        .add("position_unit", position != nullptr ? Json(formatUnit(servo, *position)) : Json());
}

QString infoText(const device::Servo& servo)
{
    const catalog::Profile& profile = *servo.profile;
    const catalog::Mode* mode = servo.mode();
    Table table({translate("cli", "Servo %1").arg(servo.id), servoTitle(servo)});
    const auto row = [&table](const QString& name, const QString& value) {
        table.add({name, value});
    };
    row(translate("cli", "Model known"),
        profile.modelKnown ? translate("cli", "yes") : translate("cli", "no, only the family"));
    row(translate("cli", "Family, register map"),
        profile.series.isEmpty() ? profile.mapKey
                                 : QStringLiteral("%1, %2").arg(profile.series, profile.mapKey));
    row(translate("cli", "Protocol, bus type"),
        QStringLiteral("%1, %2").arg(base::protocolName(profile.protocol),
                                     text::lineLabel(profile.line)));
    row(translate("cli", "Port, baud rate"),
        QStringLiteral("%1, %2").arg(servo.port).arg(servo.baud));
    row(translate("cli", "Mode"),
        mode != nullptr ? text::localized(mode->name) : translate("cli", "unknown"));
    row(translate("cli", "Torque"), formatRole(servo, Role::TorqueSwitch));
    row(translate("cli", "EPROM lock"), formatRole(servo, Role::Lock));
    row(translate("cli", "Position"), formatRole(servo, Role::PresentPosition));
    row(translate("cli", "Voltage"), formatRole(servo, Role::PresentVoltage));
    row(translate("cli", "Temperature"), formatRole(servo, Role::PresentTemperature));
    row(translate("cli", "Alarms"), text::statusText(servo.status, &profile));
    return table.text();
}

base::Result<Exit> runInfo(Run& run, const Values& values)
{
    auto servo = run.servo(values);
    if (!servo)
        return tl::unexpected(servo.error());
    const auto context = run.context();
    if (const auto read = device::readAll(*context, *servo); !read)
        return tl::unexpected(read.error());
    device::addAlarmNotices(*context, *servo);
    run.reportDuplicates(*servo);
    const auto obstacle = device::writeObstacle(*servo);
    QString text = infoText(*servo);
    if (obstacle) {
        const text::Description words = text::describe(*obstacle);
        text += QStringLiteral("%1\n%2\n%3\n").arg(words.message, words.cause, words.remedy);
    }
    const catalog::Register* lock = registerOf(*servo, Role::Lock);
    if (lock != nullptr && servo->raw(*lock) == 0) {
        text += (run.hasOpenChange(servo->id)
                     ? translate("cli", "The EPROM is unlocked because a change to this servo was "
                                        "interrupted. To finish or undo the change: %1")
                           .arg(run.recoverCommand())
                     : translate("cli", "The EPROM is unlocked. To lock it: servodesk-cli write "
                                        "%1 lock=1")
                           .arg(servo->id)) +
                QLatin1Char('\n');
    }
    Json info = jsonInfo(*servo);
    info.add("not_writable", obstacle ? Json(base::errorName(obstacle->code)) : Json());
    run.finish(std::move(info), text);
    return Exit::Success;
}
} // namespace

Command infoCommand()
{
    return {
        "info",
        QT_TRANSLATE_NOOP("cli", "show the model and state of a servo and how to clear its alarms"),
        {servoIdArgument},
        {},
        runInfo};
}
} // namespace cli
