// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalog/json_fields.h"

#include <algorithm>
#include <iterator>

namespace catalog {
namespace {
struct RoleName {
    const char* name;
    Role role;
};

constexpr RoleName roleNames[] = {
    {"none", Role::None},
    {"firmware_major", Role::FirmwareMajor},
    {"firmware_minor", Role::FirmwareMinor},
    {"byte_order", Role::ByteOrder},
    {"model_major", Role::ModelMajor},
    {"model_minor", Role::ModelMinor},
    {"id", Role::Id},
    {"baud_rate", Role::BaudRate},
    {"return_delay", Role::ReturnDelay},
    {"response_level", Role::ResponseLevel},
    {"min_angle", Role::MinAngle},
    {"max_angle", Role::MaxAngle},
    {"max_temperature", Role::MaxTemperature},
    {"max_voltage", Role::MaxVoltage},
    {"min_voltage", Role::MinVoltage},
    {"max_torque", Role::MaxTorque},
    {"phase", Role::Phase},
    {"unload_condition", Role::UnloadCondition},
    {"led_condition", Role::LedCondition},
    {"position_p", Role::PositionP},
    {"position_i", Role::PositionI},
    {"position_d", Role::PositionD},
    {"startup_force", Role::StartupForce},
    {"integral_limit", Role::IntegralLimit},
    {"cw_dead_zone", Role::CwDeadZone},
    {"ccw_dead_zone", Role::CcwDeadZone},
    {"protection_current", Role::ProtectionCurrent},
    {"angle_resolution", Role::AngleResolution},
    {"position_offset", Role::PositionOffset},
    {"operating_mode", Role::OperatingMode},
    {"protection_torque", Role::ProtectionTorque},
    {"protection_time", Role::ProtectionTime},
    {"overload_torque", Role::OverloadTorque},
    {"speed_p", Role::SpeedP},
    {"speed_i", Role::SpeedI},
    {"overcurrent_time", Role::OvercurrentTime},
    {"torque_switch", Role::TorqueSwitch},
    {"acceleration", Role::Acceleration},
    {"goal_position", Role::GoalPosition},
    {"goal_pwm", Role::GoalPwm},
    {"goal_time", Role::GoalTime},
    {"goal_current", Role::GoalCurrent},
    {"goal_speed", Role::GoalSpeed},
    {"torque_limit", Role::TorqueLimit},
    {"lock", Role::Lock},
    {"present_position", Role::PresentPosition},
    {"present_speed", Role::PresentSpeed},
    {"present_load", Role::PresentLoad},
    {"present_voltage", Role::PresentVoltage},
    {"present_temperature", Role::PresentTemperature},
    {"present_current", Role::PresentCurrent},
    {"async_flag", Role::AsyncFlag},
    {"status", Role::Status},
    {"moving", Role::Moving},
    {"active_goal", Role::ActiveGoal},
    {"fault_reset", Role::FaultReset},
    {"led", Role::Led},
    {"stored_goal", Role::StoredGoal},
    {"stored_time", Role::StoredTime},
};
} // namespace

Role roleFromName(const QString& name, bool& known)
{
    const auto* it =
        std::find_if(std::begin(roleNames), std::end(roleNames),
                     [&](const RoleName& entry) { return name == QLatin1String(entry.name); });
    known = it != std::end(roleNames);
    return known ? it->role : Role::None;
}
} // namespace catalog
