// SPDX-License-Identifier: GPL-3.0-or-later
// One register of a servo's memory table, as data (resources/models). Immutable; any thread.
// "raw" is always the number after sign decoding; physical value = raw × scale, in unit.
#pragma once

#include <QString>

#include <cstdint>
#include <optional>
#include <vector>

namespace catalog {
/// A text in the two languages of the program.
struct Text {
    QString en;
    QString zh;
    const QString& in(bool chinese) const { return chinese && !zh.isEmpty() ? zh : en; }
};

enum class Area : std::uint8_t { Eprom, Sram, Feedback, Factory };
enum class Access : std::uint8_t { ReadOnly, ReadWrite };

enum class Encoding : std::uint8_t {
    Unsigned,
    SignBit,        ///< `signBit` set = negative, the bits below are the magnitude
    SignBit11Ext12, ///< STS offset: sign in bit 11, bit 12 adds 2048 to the magnitude
    TwosComplement,
    Bits,
    Enum,
};

/// What a register is for, the same for every family: pages, charts and jobs ask by role.
enum class Role : std::uint8_t {
    None,
    FirmwareMajor,
    FirmwareMinor,
    ByteOrder,
    ModelMajor,
    ModelMinor,
    Id,
    BaudRate,
    ReturnDelay,
    ResponseLevel,
    MinAngle,
    MaxAngle,
    MaxTemperature,
    MaxVoltage,
    MinVoltage,
    MaxTorque,
    Phase,
    UnloadCondition,
    LedCondition,
    PositionP,
    PositionI,
    PositionD,
    StartupForce,
    IntegralLimit,
    CwDeadZone,
    CcwDeadZone,
    ProtectionCurrent,
    AngleResolution,
    PositionOffset,
    OperatingMode,
    ProtectionTorque,
    ProtectionTime,
    OverloadTorque,
    SpeedP,
    SpeedI,
    OvercurrentTime,
    TorqueSwitch,
    Acceleration,
    GoalPosition,
    GoalPwm,
    GoalTime,
    GoalCurrent, ///< HLS 44: a limit, or the target in current mode
    GoalSpeed,
    TorqueLimit,
    Lock,
    PresentPosition,
    PresentSpeed,
    PresentLoad,
    PresentVoltage,
    PresentTemperature,
    PresentCurrent,
    AsyncFlag,
    Status,
    Moving,
    ActiveGoal,
    FaultReset,
    Led,
    StoredGoal, ///< LX: what Op::Action starts
    StoredTime,
};

/// A named number of an enum, or a named bit of a bit field (`value` = bit number).
struct NamedValue {
    int value = 0;
    QString key; ///< stable word for the command line: "position", "overload", "1000000"
    Text name;
};

enum class TorqueOff : std::uint8_t {
    NotNeeded,
    Needed,       ///< torque must be off while this is written
    WhenBothZero, ///< only when minimum and maximum both become 0 (multi-turn)
};

/// A different meaning chosen by another register of the same servo (phase bit 2, mode, limits).
/// Fields that are not set keep the register's own.
struct Variant {
    QString whenKey;        ///< register that decides
    std::int64_t mask = -1; ///< compared bits
    std::int64_t equals = 0;
    std::optional<double> scale;
    std::optional<QString> unit;
    std::optional<Encoding> encoding;
    std::optional<int> signBit;
    std::optional<std::int64_t> min;
    std::optional<std::int64_t> max;
    std::optional<Text> name;
    bool andBothLimitsZero = false; ///< SCS motor mode: 9 = 11 = 0 instead of whenKey
};

/// Registers that travel together (LX command pairs): one read brings all of them, and a write
/// carries all of them, so changing one means reading, changing and writing the block.
struct Block {
    int offset = 0;
    int size = 0;
    int writeOffset = 0;
    bool operator==(const Block&) const = default;
};

/// Whether a value written survives power-off.
enum class Persistence : std::uint8_t {
    ByArea,    ///< EPROM and factory rows do while the lock is open, others do not
    Kept,      ///< always, according to the sheet (LX)
    Lost,      ///< never
    AfterSave, ///< only after the save command
    NotStated, ///< not stated in the sheet
};

struct Register {
    QString key;
    int address = 0;     ///< as the sheet has it: byte, Modbus register, LX read command
    int offset = 0;      ///< where reads find it, in bytes of the table (protocol/request.h)
    int writeOffset = 0; ///< where writes go; differs from `offset` with LX only
    std::optional<Block> block;
    int saveOffset = -1; ///< LX: an empty write here makes the value stay
    Persistence persistence = Persistence::ByArea;
    int size = 1;
    Role role = Role::None;
    Area area = Area::Eprom;
    Access access = Access::ReadOnly;
    Encoding encoding = Encoding::Unsigned;
    int signBit = 0;
    std::optional<std::int64_t> defaultRaw; ///< nullopt: not known, never "different"
    std::optional<std::int64_t> min;        ///< binds new values only
    std::optional<std::int64_t> max;
    std::optional<std::int64_t> warnAbove; ///< accepted, with a warning
    QString unit;
    double scale = 1.0;
    QString scaleBy; ///< key of a register whose raw multiplies the scale (angle resolution)
    std::vector<NamedValue> values;
    std::vector<Variant> variants;
    Text name;
    Text help;
    QString source;
    bool identity = false;
    bool dangerous = false;
    bool motion = false; ///< writing it may move or energize the servo
    TorqueOff torqueOff = TorqueOff::NotNeeded;
    bool writable() const { return access == Access::ReadWrite; }
    bool eprom() const { return area == Area::Eprom; }
};

QString areaName(Area area); ///< "EPROM", "SRAM", "FEEDBACK", "FACTORY"
std::optional<Area> areaFromName(const QString& name);
QString accessName(Access access); ///< "ro", "rw"
std::optional<Access> accessFromName(const QString& name);
} // namespace catalog
