// SPDX-License-Identifier: GPL-3.0-or-later
// The inside of a VirtualServo, shared by the files that implement it: requests, writes and their
// effects, motion, feedback. Not for anybody else. Owned by its VirtualServo; one thread.
#pragma once

#include "sim/servo/controller.h"
#include "sim/servo/encoder.h"
#include "sim/servo/mechanics.h"
#include "sim/servo/protection.h"
#include "sim/servo/virtual_servo.h"

namespace sim {
constexpr double minReportedSpeed = 50; ///< step/s, the resolution of the measured speed

struct VirtualServo::State {
    State(catalog::ProfilePtr profile, const ServoConfig& config);

    // servo_factory.cpp
    void fillFactoryValues();

    // servo_power.cpp
    std::optional<ServoReply> handle(const ServoRequest& request);
    void switchOff();
    void switchOn();
    void restart(); ///< by request: deaf for the reboot time
    void loadDefaults();
    void loadGains();
    void loadBaud();
    bool isRunning() const { return powered && rebootLeft.count() == 0; }
    base::Duration replyDelay() const;
    base::Duration writeTime() const;

    // feetech_front.cpp
    AddressMatch addressMatch(int id, std::uint8_t instruction) const;
    std::optional<ServoReply> handleFeetech(const ServoRequest& request);
    std::optional<ServoReply> makeReply(base::ByteView data = {}) const;
    std::optional<ServoReply> acknowledge(const ServoRequest& request, int oldId, int oldLevel);
    std::optional<ServoReply> ping(const ServoRequest& request) const;
    std::optional<ServoReply> readTable(base::ByteView params);
    bool execute(const ServoRequest& request);
    void syncWrite(base::ByteView params);
    bool storePendingWrite(base::ByteView params);
    void executePendingWrite();
    bool calibrate(base::ByteView params);

    // modbus_front.cpp
    std::optional<ServoReply> handleModbus(const ServoRequest& request);
    std::optional<std::uint8_t> refusal(const ServoRequest& request) const;
    std::optional<std::uint8_t> writeException(const ServoRequest& request) const;
    bool isWithinLimits(int address, base::ByteView data) const;

    // lx_front.cpp
    std::optional<ServoReply> handleLx(const ServoRequest& request);
    std::optional<ServoReply> readLx(const ServoRequest& request);
    void writeLx(std::uint8_t command, base::ByteView params);
    bool acceptsLx(const catalog::Block& block, base::ByteView params) const;
    void startStored();
    void stopMove();

    // servo_writes.cpp
    void write(int address, base::ByteView data);
    base::Bytes acceptedBytes(int address, base::ByteView data) const;
    void restore();
    void backup();
    void setPresentPosition(int position);
    void applyChanges(int address, int count);
    void copyIdToSecondary();
    void changeMode(DriveMode before);
    void switchTorque(int before);
    void resetFaults();
    void command(bool energize);
    void setTorque(int value);
    double commandDirection() const;

    // servo_motion.cpp
    void advance(base::Duration dt);
    void tick();
    void measure();
    void control();
    void updateProtection();
    bool isIdle() const;
    double readPosition() const;
    void resetTurnBase();
    double positionGoal() const;
    double topSpeed() const;
    double requestedSpeed() const;
    double limitByWear(double topSpeed, double direction) const;
    double drive(double limit);
    double holdGoal(double limit);
    double holdDefectGoal(double limit);
    double sensorSign() const { return encoder.isContinuous() && settings.reversed ? -1.0 : 1.0; }
    double limitCurrent(double wanted) const;
    void holdPresentPosition();

    // servo_feedback.cpp
    void updateFeedback();
    double readingNoise() const;
    double sensedCurrent() const; ///< 6.5 mA units
    int reportedStatus() const;
    int reportedMoving() const;
    bool led() const;

    catalog::ProfilePtr profile;
    ServoConfig config;
    ServoTraits traits;
    ServoType type;
    RegisterMap map;
    Field secondaryId; ///< HLS
    Memory memory;
    Mechanics mechanics;
    Encoder encoder;
    Settings settings;
    Controller controller;
    Protection protection;

    bool powered = true;
    int baud = 1000000;
    base::Duration rebootLeft{}; ///< until it runs again
    base::Duration deafLeft{};   ///< EPROM write, if it is deaf meanwhile
    base::Duration pending{};    ///< time not yet worth a tick
    std::uint64_t ticks = 0;
    bool epromWritten = false; ///< by the request being handled

    std::int64_t encoderCount = 0; ///< encoder steps through all turns
    std::int64_t turnBase = 0;     ///< multiple of a turn: position counts from here since power-on
    double position = 0;           ///< steps, in the servo's own coordinate
    double speed = 0;              ///< step/s, smoothed for the loops
    double reportedSpeed = 0;      ///< step/s, smoothed for register 58
    double duty = 0;               ///< towards larger positions positive
    Bridge bridge = Bridge::Open;
    double celsius = 25;
    double volts = 0; ///< as the voltage registers count

    double stepGoal = 0;            ///< step mode: where the sum of all moves leads
    double timedSpeed = 0;          ///< SCS, LX: speed that makes the running time of this move
    std::optional<double> restGoal; ///< holds here instead of at the goal register
    bool goalWritten = false;       ///< since power-up
    bool moving = false;
    int stillTicks = 0; ///< path ended and shaft still
    int restTicks = 0;  ///< mechanics at rest with an open bridge
    Load restLoad;      ///< the load it came to rest under

    struct PendingWrite {
        int address = 0;
        base::Bytes data;
    };
    std::optional<PendingWrite> pendingWrite; ///< REG WRITE waiting for ACTION
    bool moveStored = false;                  ///< LX: 7 waiting for 11
};
} // namespace sim
