// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/output/report_text.h"
#include "cli/tour/tour.h"
#include "cli/translate.h"
#include "device/reader.h"
#include "text/language.h"

namespace cli {
using catalog::Role;

namespace {
/// Servos reboot within a second; none needs longer than this.
constexpr int maxRestartTries = 40;

const catalog::Register& persistentRegister(const device::Servo& servo)
{
    return *servo.profile->byRole(Role::MaxTemperature);
}

const catalog::Register& temporaryRegister(const device::Servo& servo)
{
    return *servo.profile->byRole(Role::LedCondition);
}
} // namespace

base::Result<void> Tour::writeAndShow(const QString& key, std::int64_t raw, bool temporary)
{
    m_run.context()->bus.takeTrace();
    device::WriteOptions options;
    options.temporary = temporary;
    const auto report = device::write(*context(), m_servo, {{key, raw}}, options);
    if (!report)
        return tl::unexpected(report.error());
    m_run.console().print(writeText(m_servo, *report));
    if (report->isSuccessful())
        return {};
    base::Error error;
    error.code = base::ErrorCode::Refused;
    error.id = m_servo.id;
    error.registerKey = key;
    return tl::unexpected(report->writes.front().error.value_or(error));
}

base::Result<void> Tour::changeSafely()
{
    chapter(translate("cli", "Change two values: one kept after power-off, one lost at power-off"));
    const catalog::Register& kept = persistentRegister(m_servo);
    const catalog::Register& temporary = temporaryRegister(m_servo);
    constexpr std::int64_t cooler = 5;
    m_persistentValue = m_servo.raw(kept).value_or(0) - cooler;
    m_temporaryValue = m_servo.raw(temporary).value_or(0) ^ 1; // the voltage bit
    if (const auto done = writeAndShow(kept.key, m_persistentValue, false); !done)
        return done;
    print(translate("cli", "On the bus: settings read, EPROM unlocked, value written and read "
                           "back, EPROM locked and checked."));
    showWire();
    return writeAndShow(temporary.key, m_temporaryValue, true);
}

base::Result<void> Tour::awaitServo()
{
    for (int i = 0; i < maxRestartTries; ++i) {
        if (const auto there = device::identify(*context(), m_servo.id); there)
            return device::readAll(*context(), m_servo);
        if (m_run.stop().isRequested())
            return base::fail(base::ErrorCode::Stopped, QStringLiteral("tour"));
    }
    return base::fail(base::ErrorCode::NoReply, QStringLiteral("tour"), {}, m_servo.id);
}

base::Result<void> Tour::powerCycleServos()
{
    chapter(translate("cli", "Turn the power to all servos off and on again"));
    const auto connection = m_run.connect();
    if (!(*connection)->powerCycle())
        return base::fail(base::ErrorCode::NotSupported, QStringLiteral("tour"));
    if (const auto back = awaitServo(); !back)
        return back;
    Table table({translate("cli", "Key"), translate("cli", "Written"),
                 translate("cli", "After power-off"), translate("cli", "Result")});
    const auto row = [&](const catalog::Register& reg, std::int64_t written, bool survived) {
        table.add({reg.key,
                   catalog::formatValue(written, reg, m_servo.meaning(reg), text::isUiChinese()),
                   catalog::formatValue(m_servo.raw(reg).value_or(0), reg, m_servo.meaning(reg),
                                        text::isUiChinese()),
                   survived ? translate("cli", "kept") : translate("cli", "lost")});
    };
    const catalog::Register& kept = persistentRegister(m_servo);
    const catalog::Register& temporary = temporaryRegister(m_servo);
    m_persistentSurvived = m_servo.raw(kept) == m_persistentValue;
    m_temporaryReset = m_servo.raw(temporary) != m_temporaryValue;
    row(kept, m_persistentValue, m_persistentSurvived);
    row(temporary, m_temporaryValue, !m_temporaryReset);
    m_run.console().print(table.text());
    return {};
}

base::Result<void> Tour::restoreValues()
{
    chapter(translate("cli", "Restore the old value"));
    const catalog::Register& kept = persistentRegister(m_servo);
    constexpr std::int64_t none = -1;
    std::int64_t before = none;
    for (const snapshot::SnapshotRegister& row : m_before.registers) {
        if (row.key == kept.key)
            before = row.raw.value_or(none);
    }
    if (const auto done = writeAndShow(kept.key, before, false); !done)
        return done;
    if (const auto read = device::readAll(*context(), m_servo); !read)
        return read;
    for (const snapshot::SnapshotRegister& row : m_before.registers) {
        if (row.area == catalog::Area::Eprom && row.raw != m_servo.raw(row.key))
            m_differing << row.key;
    }
    return {};
}
} // namespace cli
