// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/output/report_text.h"
#include "cli/tour/tour.h"
#include "cli/translate.h"
#include "text/language.h"

#include <algorithm>
#include <cmath>

namespace cli {
using catalog::Role;

namespace {
constexpr int barCells = 48;
constexpr int valueCells = 8;
constexpr base::Duration traceInterval = std::chrono::milliseconds(120);
constexpr base::Duration arrivalTimeout = std::chrono::seconds(20);

/// A line with a mark at the position of the shaft between its limits.
QString bar(double fraction)
{
    const int column =
        static_cast<int>(std::lround(std::clamp(fraction, 0.0, 1.0) * (barCells - 1)));
    QString line(barCells, QLatin1Char('.'));
    line[column] = QLatin1Char('#');
    return QLatin1Char('|') + line + QLatin1Char('|');
}
} // namespace

base::Result<void> Tour::moveTo(std::int64_t goal)
{
    const auto ready = context();
    device::MoveCommand order{&m_servo, QString::number(goal)};
    order.speed = QStringLiteral("8rpm"); // slow enough to watch
    auto plan = device::planMove(*ready, order);
    if (!plan)
        return tl::unexpected(plan.error());
    std::vector<device::MovePlan> plans{std::move(*plan)};
    base::Clock& clock = ready->bus.clock();
    const base::Duration start = clock.now();
    if (const auto sent = device::sendMoves(*ready, plans, device::MoveMethod::Write); !sent)
        return sent;
    const catalog::Register& position = *m_servo.profile->byRole(Role::PresentPosition);
    const catalog::ValueFormat meaning = m_servo.meaning(position);
    const double low = catalog::toPhysical(m_servo.raw(Role::MinAngle).value_or(0), meaning);
    const double high = catalog::toPhysical(m_servo.raw(Role::MaxAngle).value_or(1), meaning);
    base::Duration next{};
    const auto trace = [&](const device::MoveProgress& progress) {
        const base::Duration now = clock.now() - start;
        if (!progress.position || now < next)
            return;
        next = now + traceInterval;
        print(QStringLiteral("  %1 s  %2  %3")
                  .arg(std::chrono::duration<double>(now).count(), 5, 'f', 2)
                  .arg(padded(formatValueText(m_servo, position), valueCells, true),
                       bar((*progress.position - low) / (high - low))));
    };
    const auto arrived = device::waitForArrival(*ready, plans, arrivalTimeout, trace);
    if (!arrived)
        return arrived;
    const double elapsed = std::chrono::duration<double>(clock.now() - start).count();
    print(translate("cli", "Goal %1, reached %2 after %3 s")
              .arg(catalog::formatValue(goal, position, meaning, text::isUiChinese()),
                   formatValueText(m_servo, position))
              .arg(elapsed, 0, 'f', 2));
    m_moves.push_back(Json::object()
                          .add("goal", goal)
                          .add("position", m_servo.raw(position))
                          .add("seconds", elapsed));
    return {};
}

base::Result<void> Tour::move()
{
    chapter(translate("cli", "Move servo %1 and watch it").arg(m_servo.id));
    if (const auto on = device::setTorque(*context(), m_servo, device::Torque::On); !on)
        return on;
    const std::int64_t low = m_servo.raw(Role::MinAngle).value_or(0);
    const std::int64_t high = m_servo.raw(Role::MaxAngle).value_or(0);
    const std::int64_t middle = (low + high) / 2;
    const std::int64_t swing = (high - low) / 8;
    for (const std::int64_t goal : {middle - swing, middle + swing}) {
        if (const auto moved = moveTo(goal); !moved)
            return moved;
    }
    if (const auto off = device::setTorque(*context(), m_servo, device::Torque::Off); !off)
        return off;
    if (!m_run.console().isJson())
        m_run.console().print(m_run.takeNotices());
    return {};
}
} // namespace cli
