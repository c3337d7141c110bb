// SPDX-License-Identifier: GPL-3.0-or-later
// What the arm commands share: the arm of --arm with the servos of its joints as they are, and
// their calibration as a table and as JSON. Main thread (translated texts).
#pragma once

#include "cli/run.h"
#include "jobs/arm/joint_template.h"
#include "jobs/arm/lerobot_check.h"
#include "snapshot/snapshot.h"
#include "transport/stdin_reader.h"

namespace cli {
inline constexpr Option armOption{
    "--arm",
    QT_TRANSLATE_NOOP("cli",
                      "so101 (default), so101-leader, lekiwi, six-joint, or a file with an arm"),
    "ARM"};

base::Result<jobs::Arm> armOf(const Values& values);

inline constexpr Option jointOption{
    "--joint", QT_TRANSLATE_NOOP("cli", "only these joints: NAME,NAME (default: all)"), "NAMES"};

inline constexpr Option yesOption{
    "--yes", QT_TRANSLATE_NOOP("cli", "do not ask before torque off and writing")};

/// Waits for the user, who has read what was printed before.
class EnterKey {
public:
    explicit EnterKey(Run& run)
        : m_run(run)
    {}
    /// False: stopped, or nothing more can be typed. What was typed before does not count.
    bool wait();
    /// Whether it has been pressed since the last call, or nothing more can be typed.
    bool wasPressed() { return m_input.readLine().has_value() || !m_input.isOpen(); }

private:
    Run& m_run;
    transport::StdinReader m_input;
};

struct ArmJoint {
    jobs::Joint joint;
    std::optional<device::Servo> servo{}; ///< with readJoint(); none: no reply
    bool isLeader = false;                ///< jobs::Arm::isLeader

    std::optional<jobs::JointCalibration> calibration() const;
};

/// With the servos of all joints. NoReply only if none of them replies.
base::Result<std::vector<ArmJoint>> findJoints(Run& run, const Values& values);
/// NoReply with the ID of the first joint that does not reply; NotSupported if one has no limits.
base::Result<void> requireJoints(const std::vector<ArmJoint>& joints);

/// Those of --joint, or all; wheels, which have no range, are left out.
base::Result<std::vector<ArmJoint>> selectJoints(const Values& values,
                                                 std::vector<ArmJoint> joints);

/// Each template onto the servo with its ID, or with --dry-run only its plan; prints the result.
/// `document`: what it begins with.
base::Result<Exit> writeTemplates(Run& run, const Values& values,
                                  const std::vector<snapshot::Snapshot>& templates,
                                  const QString& source, Json document = Json::object());

/// {"name","id","kind","model","firmware","position","homing_offset","range_min","range_max"}
Json jsonJoint(const ArmJoint& one);
/// A joint and what is to be written: "850 → 1033".
struct JointPlan {
    jobs::Joint joint;
    QString remark{}; ///< on the range, and other settings that are written
    std::optional<jobs::JointCalibration> now{};
    std::optional<jobs::JointCalibration> next{}; ///< none: stays as it is
};
/// "operating_mode 1 → 0, phase 28 → 12"; empty: all are set.
QString changesText(const std::vector<jobs::SettingChange>& changes);
QString plansText(const std::vector<JointPlan>& plans);
QString jointsText(const std::vector<ArmJoint>& joints);
std::vector<jobs::JointServo> servosOf(const std::vector<ArmJoint>& joints);
/// What LeRobot would refuse, leaves behind or writes, with the remedy; each a line.
QStringList remarksOn(const std::vector<ArmJoint>& joints);

/// As LeRobot's file has them: what was read from the servos.
std::vector<jobs::LerobotJoint> lerobotJoints(const std::vector<ArmJoint>& joints);
} // namespace cli
