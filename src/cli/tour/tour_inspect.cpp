// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/bus_search.h"
#include "cli/output/report_text.h"
#include "cli/tour/tour.h"
#include "cli/translate.h"
#include "device/motion/motion.h"
#include "device/reader.h"
#include "session/snapshot/safety_snapshot.h"
#include "text/language.h"
#include "text/notice_text.h"

namespace cli {
using catalog::Role;

namespace {
constexpr int lastNewId = 20; ///< the whole bus was searched in the first chapter
} // namespace

base::Result<void> Tour::search()
{
    chapter(
        translate("cli", "Search the bus: send a PING to each of the 254 IDs; nothing is written"));
    auto report = jobs::scan(*context(), {});
    if (!report)
        return tl::unexpected(report.error());
    if (report->stopped)
        return base::fail(base::ErrorCode::Stopped, QStringLiteral("tour"));
    m_found = std::move(*report);
    Table table({translate("cli", "ID"), translate("cli", "Model"), translate("cli", "Firmware"),
                 translate("cli", "Register map"), translate("cli", "Alarms")});
    table.alignRight({0});
    for (const jobs::FoundServo& found : m_found.found) {
        const catalog::Profile* profile = found.servo.profile.get();
        table.add({QString::number(found.servo.id),
                   profile != nullptr ? profile->modelName : QStringLiteral("?"),
                   profile != nullptr ? profile->identity.firmware() : QStringLiteral("?"),
                   profile != nullptr ? profile->mapKey : QStringLiteral("?"),
                   text::statusText(found.servo.status, profile)});
    }
    m_run.console().print(table.text());
    print(translate("cli", "%n servo(s) found in %1 s", nullptr, int(m_found.found.size()))
              .arg(std::chrono::duration<double>(m_found.elapsed).count(), 0, 'f', 2));
    return chooseServo();
}

/// The first servo without alarms in position mode that has the registers of the tour.
base::Result<void> Tour::chooseServo()
{
    for (const jobs::FoundServo& found : m_found.found) {
        device::Servo servo = found.servo;
        const bool suits = servo.profile != nullptr && servo.profile->writable &&
                           servo.status == 0 &&
                           servo.profile->byRole(Role::MaxTemperature) != nullptr &&
                           servo.profile->byRole(Role::LedCondition) != nullptr;
        if (!suits)
            continue;
        if (const auto read = device::readAll(*context(), servo); !read)
            return tl::unexpected(read.error());
        const catalog::Mode* mode = servo.mode();
        if (mode == nullptr || mode->key != QLatin1String("position"))
            continue;
        m_servo = std::move(servo);
        return {};
    }
    return base::fail(
        base::ErrorCode::NotSupported, QStringLiteral("tour"),
        translate("cli", "no servo on this bus is in position mode and free of alarms"));
}

base::Result<void> Tour::showMemory()
{
    chapter(translate("cli", "Memory table of servo %1, %2 (excerpt)")
                .arg(m_servo.id)
                .arg(servoTitle(m_servo)));
    if (const auto read = device::readAll(*context(), m_servo); !read)
        return tl::unexpected(read.error());
    std::vector<const catalog::Register*> rows;
    for (const Role role :
         {Role::Id, Role::BaudRate, Role::MinAngle, Role::MaxAngle, Role::MaxTemperature,
          Role::LedCondition, Role::PositionP, Role::OperatingMode, Role::TorqueSwitch, Role::Lock,
          Role::PresentPosition, Role::PresentVoltage, Role::PresentTemperature}) {
        if (const catalog::Register* reg = m_servo.profile->byRole(role))
            rows.push_back(reg);
    }
    m_run.console().print(registerTable(m_servo, rows).text());
    print(translate("cli", "%n register(s) in the table", nullptr,
                    int(m_servo.profile->registers.size())));
    return {};
}

base::Result<void> Tour::saveSnapshot()
{
    chapter(translate("cli", "A snapshot before any change"));
    const auto context = m_run.context();
    if (!context)
        return tl::unexpected(context.error());
    const auto file = session::saveSafetySnapshot(*context, m_servo);
    if (!file)
        return tl::unexpected(file.error());
    m_snapshotFile = *file;
    auto saved = snapshot::loadSnapshot(*file);
    if (!saved)
        return tl::unexpected(saved.error());
    m_before = std::move(*saved);
    print(translate("cli", "%n register(s) saved to %1", nullptr, int(m_before.registers.size()))
              .arg(m_snapshotFile));
    return {};
}

base::Result<void> Tour::explainAlarms()
{
    chapter(translate("cli", "Alarms and how to clear them"));
    bool any = false;
    for (const jobs::FoundServo& found : m_found.found) {
        if (found.servo.profile == nullptr)
            continue;
        auto now = device::identify(*context(), found.servo.id);
        if (!now)
            return tl::unexpected(now.error());
        any = any || now->status != 0;
        device::addAlarmNotices(*context(), *now);
    }
    const QString lines = m_run.console().isJson() ? QString() : m_run.takeNotices();
    m_run.console().print(any ? lines
                              : translate("cli", "No servo reports an alarm.") + QLatin1Char('\n'));
    return {};
}

/// The first day of a robot arm, on a bus of its own.
base::Result<void> Tour::showNewServos()
{
    chapter(translate("cli", "Six new servos: all have ID 1 and reply at the same time"));
    session::PortRequest request;
    request.name = QStringLiteral("sim:new-arm");
    const auto connection = m_run.session().connect(request);
    if (!connection)
        return tl::unexpected(connection.error());
    device::Notices notices;
    jobs::ScanSpec spec;
    spec.lastId = lastNewId;
    const auto report = jobs::scan((*connection)->context(m_run.stop(), notices), spec);
    if (!report)
        return tl::unexpected(report.error());
    for (const jobs::FoundServo& found : report->found) {
        m_duplicatesSuspected |= found.duplicateSuspected;
        print(QStringLiteral("  ID %1: %2").arg(found.servo.id).arg(scanNote(found)));
    }
    m_run.console().print(scanRemarks(*report));
    return {};
}
} // namespace cli
