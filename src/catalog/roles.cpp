// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/enum_names.h"
#include "catalog/json_fields.h"

namespace catalog {
namespace {
constexpr base::EnumName<Role> roleNames[]{
    {Role::None, "none"},
    {Role::FirmwareMajor, "firmware_major"},
    {Role::FirmwareMinor, "firmware_minor"},
    {Role::ByteOrder, "byte_order"},
    {Role::ModelMajor, "model_major"},
    {Role::ModelMinor, "model_minor"},
    {Role::Id, "id"},
    {Role::BaudRate, "baud_rate"},
    {Role::ReturnDelay, "return_delay"},
    {Role::ResponseLevel, "response_level"},
    {Role::MinAngle, "min_angle"},
    {Role::MaxAngle, "max_angle"},
    {Role::MaxTemperature, "max_temperature"},
    {Role::MaxVoltage, "max_voltage"},
    {Role::MinVoltage, "min_voltage"},
    {Role::MaxTorque, "max_torque"},
    {Role::Phase, "phase"},
    {Role::UnloadCondition, "unload_condition"},
    {Role::LedCondition, "led_condition"},
    {Role::PositionP, "position_p"},
    {Role::PositionI, "position_i"},
    {Role::PositionD, "position_d"},
    {Role::StartupForce, "startup_force"},
    {Role::IntegralLimit, "integral_limit"},
    {Role::CwDeadZone, "cw_dead_zone"},
    {Role::CcwDeadZone, "ccw_dead_zone"},
    {Role::ProtectionCurrent, "protection_current"},
    {Role::AngleResolution, "angle_resolution"},
    {Role::PositionOffset, "position_offset"},
    {Role::OperatingMode, "operating_mode"},
    {Role::ProtectionTorque, "protection_torque"},
    {Role::ProtectionTime, "protection_time"},
    {Role::OverloadTorque, "overload_torque"},
    {Role::SpeedP, "speed_p"},
    {Role::SpeedI, "speed_i"},
    {Role::OvercurrentTime, "overcurrent_time"},
    {Role::TorqueSwitch, "torque_switch"},
    {Role::Acceleration, "acceleration"},
    {Role::GoalPosition, "goal_position"},
    {Role::GoalPwm, "goal_pwm"},
    {Role::GoalTime, "goal_time"},
    {Role::GoalCurrent, "goal_current"},
    {Role::GoalSpeed, "goal_speed"},
    {Role::TorqueLimit, "torque_limit"},
    {Role::Lock, "lock"},
    {Role::PresentPosition, "present_position"},
    {Role::PresentSpeed, "present_speed"},
    {Role::PresentLoad, "present_load"},
    {Role::PresentVoltage, "present_voltage"},
    {Role::PresentTemperature, "present_temperature"},
    {Role::PresentCurrent, "present_current"},
    {Role::AsyncFlag, "async_flag"},
    {Role::Status, "status"},
    {Role::Moving, "moving"},
    {Role::ActiveGoal, "active_goal"},
    {Role::FaultReset, "fault_reset"},
    {Role::Led, "led"},
    {Role::StoredGoal, "stored_goal"},
    {Role::StoredTime, "stored_time"},
};
} // namespace

std::optional<Role> roleFromName(const QString& name)
{
    return base::valueOf(roleNames, name);
}
} // namespace catalog
