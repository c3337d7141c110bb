// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/arm_servos.h"
#include "cli/commands.h"
#include "cli/input/arguments.h"
#include "cli/output/report_text.h"
#include "cli/output/restore_text.h"
#include "cli/output/table.h"
#include "cli/translate.h"
#include "jobs/arm/calibration.h"
#include "jobs/arm/record_ranges.h"
#include "session/snapshot/safety_snapshot.h"
#include "text/arm_text.h"
#include "text/language.h"

#include <algorithm>
#include <cmath>

namespace cli {
namespace {
using jobs::JointRange;

constexpr Option secondsOption{
    "--seconds", QT_TRANSLATE_NOOP("cli", "recording time (default: until Enter)"), "S"};
constexpr Option middleOption{
    "--middle-here", QT_TRANSLATE_NOOP("cli", "the pose at the end of the recording becomes the "
                                              "middle (default: the middle of each range)")};

/// Simulated joints are moved while it lives; real ones are moved by the user.
class HandMotion {
public:
    explicit HandMotion(session::Connection& connection)
        : m_connection(connection)
    {
        m_connection.moveSimulatedServosByHand(true);
    }
    ~HandMotion() { m_connection.moveSimulatedServosByHand(false); }
    HandMotion(const HandMotion&) = delete;
    HandMotion& operator=(const HandMotion&) = delete;

private:
    session::Connection& m_connection;
};

class ArmCalibration {
public:
    ArmCalibration(Run& run, const Values& values)
        : m_run(run)
        , m_values(values)
    {}

    base::Result<Exit> run()
    {
        if (const auto collected = collect(); !collected)
            return tl::unexpected(collected.error());
        m_run.console().printMessage(translate(
            "cli", "Torque will be turned off, so the arm drops: hold it. Then move every "
                   "joint through its whole range, in any order."));
        if (m_isMiddleHere)
            m_run.console().printMessage(
                translate("cli", "End with every joint in its middle position."));
        if (!confirm(translate("cli", "Press Enter to begin.")))
            return stopped();
        if (const auto recorded = record(); !recorded)
            return tl::unexpected(recorded.error());
        return write();
    }

private:
    base::Result<void> collect()
    {
        m_isYes = m_values.has(yesOption.flag);
        m_isMiddleHere = m_values.has(middleOption.flag);
        if (const auto seconds = m_values.option(secondsOption.flag)) {
            const auto number = parsePositive(*seconds);
            if (!number)
                return tl::unexpected(number.error());
            m_length = base::Duration(std::llround(1e6 * *number));
        }
        if (m_isYes && !m_length)
            return badArgument(translate("cli", "--yes needs --seconds"));
        auto joints = findJoints(m_run, m_values);
        if (!joints)
            return tl::unexpected(joints.error());
        auto selected = selectJoints(m_values, std::move(*joints));
        if (!selected)
            return tl::unexpected(selected.error());
        if (const auto all = requireJoints(*selected); !all)
            return all;
        for (ArmJoint& one : *selected) {
            m_servos.push_back(std::move(*one.servo));
            m_joints.push_back(one.joint);
        }
        return {};
    }

    bool confirm(const QString& question)
    {
        if (m_isYes)
            return true;
        m_run.console().printMessage(question);
        return m_enter.wait();
    }

    static tl::unexpected<base::Error> stopped()
    {
        return base::fail(base::ErrorCode::Stopped, QStringLiteral("arm"));
    }

    base::Result<void> record()
    {
        const auto context = m_run.context();
        const auto connection = m_run.connect();
        if (!context || !connection)
            return tl::unexpected(context ? connection.error() : context.error());
        const HandMotion hand(**connection);
        if (!m_length)
            m_run.console().printMessage(
                translate("cli", "Press Enter when every joint has been moved."));
        base::Clock& clock = context->bus.clock();
        const base::Duration start = clock.now();
        const auto recorded = jobs::recordRanges(*context, m_servos, [&](const auto& ranges) {
            show(ranges);
            if (m_length)
                return clock.now() - start < *m_length;
            return !m_enter.wasPressed();
        });
        if (!recorded)
            return tl::unexpected(recorded.error());
        if (m_run.stop().isRequested())
            return stopped();
        m_ranges = *recorded;
        return {};
    }

    /// In place, on a terminal.
    void show(const std::vector<JointRange>& ranges)
    {
        constexpr auto interval = std::chrono::milliseconds(100);
        const auto now = std::chrono::steady_clock::now();
        if (!m_run.console().isStdoutTerminal() || now < m_nextShown)
            return;
        m_nextShown = now + interval;
        const QStringList lines = table(ranges).text().split(QLatin1Char('\n'), Qt::SkipEmptyParts);
        m_run.console().rewrite(m_shownLines, lines);
        m_shownLines = static_cast<int>(lines.size());
    }

    Table table(const std::vector<JointRange>& ranges) const
    {
        Table table({translate("cli", "Joint"), translate("cli", "ID"), translate("cli", "Now"),
                     translate("cli", "Range"), translate("cli", "State")});
        table.alignRight({1, 2, 3});
        for (std::size_t i = 0; i < m_joints.size(); ++i) {
            table.add({m_joints[i].name, QString::number(m_joints[i].id),
                       QString::number(ranges[i].reading),
                       QString::number(degrees(i, ranges[i]), 'f', 0) + QStringLiteral("°"),
                       text::jointStateText(ranges[i].state)});
        }
        return table;
    }

    double degrees(std::size_t index, const JointRange& range) const
    {
        const catalog::Profile& profile = *m_servos[index].profile;
        return static_cast<double>(range.high - range.low) * profile.angleRangeDeg.value_or(360.0) /
               profile.stepsPerTurn;
    }

    JointPlan plan(std::size_t index, const std::optional<jobs::JointCalibration>& values) const
    {
        QStringList remarks{QStringLiteral("%1°").arg(degrees(index, m_ranges[index]), 0, 'f', 0),
                            text::jointStateText(m_ranges[index].state)};
        const device::Servo& servo = m_servos[index];
        const QString settings = changesText(
            jobs::changesOf(servo, jobs::positionSettings(servo, m_joints[index].kind)));
        if (values && !settings.isEmpty())
            remarks << settings;
        return {m_joints[index], text::joinItems(remarks), jobs::calibrationIn(m_servos[index]),
                values};
    }

    static Json jsonPlan(const JointPlan& plan, const JointRange& range, double degrees)
    {
        const auto value = [&](int jobs::JointCalibration::*field) {
            return plan.next ? Json((*plan.next).*field) : Json();
        };
        return Json::object()
            .add("name", plan.joint.name)
            .add("id", plan.joint.id)
            .add("state", base::jointStateName(range.state))
            .add("range_degrees", degrees)
            .add("homing_offset", value(&jobs::JointCalibration::homingOffset))
            .add("range_min", value(&jobs::JointCalibration::rangeMin))
            .add("range_max", value(&jobs::JointCalibration::rangeMax));
    }

    /// What could not be calibrated stays as it is, and fails the command.
    base::Result<Exit> write()
    {
        std::vector<snapshot::Snapshot> templates;
        std::vector<JointPlan> plans;
        Json::Array joints;
        QString failures;
        for (std::size_t i = 0; i < m_joints.size(); ++i) {
            const auto middle =
                m_isMiddleHere ? std::optional(m_ranges[i].now) : std::optional<std::int64_t>{};
            const auto values =
                jobs::calibrationOf(m_servos[i], m_joints[i].kind, m_ranges[i], middle);
            plans.push_back(plan(i, values ? std::optional(*values) : std::nullopt));
            joints.push_back(jsonPlan(plans.back(), m_ranges[i], degrees(i, m_ranges[i])));
            if (values)
                templates.push_back(jobs::calibrationTemplate(m_servos[i], m_joints[i].kind,
                                                              *values, session::programName()));
            else
                failures += m_joints[i].name + QStringLiteral(": ") + errorText(values.error());
        }
        m_run.console().print(plansText(plans));
        if (!failures.isEmpty())
            m_run.console().printMessage(failures.trimmed());
        if (!m_values.has(dryRunOption.flag) && !templates.empty()) {
            const int count = static_cast<int>(templates.size());
            if (!confirm(translate("cli", "Press Enter to write offset and limits of %n joint(s).",
                                   nullptr, count)))
                return stopped();
        }
        const auto written = writeTemplates(m_run, m_values, templates, QString(),
                                            Json::object().add("joints", std::move(joints)));
        return written && *written == Exit::Success && !failures.isEmpty() ? Exit::Failed : written;
    }

    Run& m_run;
    const Values& m_values;
    bool m_isYes = false;
    bool m_isMiddleHere = false;
    std::optional<base::Duration> m_length;
    std::vector<jobs::Joint> m_joints;
    std::vector<device::Servo> m_servos; ///< of the joints
    std::vector<JointRange> m_ranges;
    EnterKey m_enter{m_run};
    std::chrono::steady_clock::time_point m_nextShown;
    int m_shownLines = 0;
};

base::Result<Exit> runCalibrate(Run& run, const Values& values)
{
    return ArmCalibration(run, values).run();
}
} // namespace

Command armCalibrateCommand()
{
    return {"arm calibrate",
            QT_TRANSLATE_NOOP("cli", "calibrate a robot arm by moving its joints by hand: torque "
                                     "off, record the ranges, write offsets and limits, and set "
                                     "position mode with single-turn feedback where needed"),
            {},
            {armOption, jointOption, middleOption, secondsOption, yesOption, dryRunOption},
            runCalibrate};
}
} // namespace cli
