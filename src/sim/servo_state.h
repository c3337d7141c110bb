// SPDX-License-Identifier: GPL-3.0-or-later
// The inside of a VirtualServo, shared by the files that implement it: requests, writes and their
// effects, motion, feedback. Not for anybody else. Owned by its VirtualServo; one thread.
#pragma once

#include "sim/controller.h"
#include "sim/encoder.h"
#include "sim/mechanics.h"
#include "sim/protection.h"
#include "sim/virtual_servo.h"

namespace sim {
constexpr double slowestShown = 50; ///< step/s, the resolution of the measured speed

struct VirtualServo::State {
    State(catalog::ProfilePtr profile, const ServoConfig& config);

    // servo_factory.cpp
    void fillFactoryValues();

    // servo_power.cpp
    std::optional<ServoAnswer> handle(const ServoRequest& request);
    void switchOff();
    void switchOn();
    void restart(); ///< by request: deaf for the reboot time
    void loadDefaults();
    void loadGains();
    void takeBaud();
    bool alive() const { return powered && rebootLeft.count() == 0; }
    base::Duration replyDelay() const;
    base::Duration writeTime() const;

    // feetech_front.cpp
    Hears hears(int id, std::uint8_t instruction) const;
    std::optional<ServoAnswer> handleFeetech(const ServoRequest& request);
    std::optional<ServoAnswer> answer(base::ByteView data = {}) const;
    std::optional<ServoAnswer> acknowledge(const ServoRequest& request, int oldId, int oldLevel);
    std::optional<ServoAnswer> ping(const ServoRequest& request) const;
    std::optional<ServoAnswer> readTable(base::ByteView params);
    bool execute(const ServoRequest& request);
    void syncWrite(base::ByteView params);
    bool hold(base::ByteView params);
    void carryOutHeld();
    bool calibrate(base::ByteView params);

    // modbus_front.cpp
    std::optional<ServoAnswer> handleModbus(const ServoRequest& request);
    std::optional<std::uint8_t> refusal(const ServoRequest& request) const;
    std::optional<std::uint8_t> refusesWrite(const ServoRequest& request) const;
    bool withinSheet(int address, base::ByteView data) const;

    // lx_front.cpp
    std::optional<ServoAnswer> handleLx(const ServoRequest& request);
    std::optional<ServoAnswer> readLx(const ServoRequest& request);
    void writeLx(std::uint8_t command, base::ByteView params);
    bool acceptsLx(const catalog::Block& block, base::ByteView params) const;
    void startStored();
    void stopMove();

    // servo_writes.cpp
    void write(int address, base::ByteView data);
    base::Bytes taken(int address, base::ByteView data) const;
    void restore();
    void backup();
    void makePresent(int position);
    void applyChanges(int address, int count);
    void followId();
    void changeMode(DriveMode before);
    void switchTorque(int before);
    void resetFaults();
    void command(bool energise);
    void setTorque(int value);
    double commandDirection() const;

    // servo_motion.cpp
    void advance(base::Duration dt);
    void tick();
    void measure();
    void control();
    void watch();
    bool sleeps() const;
    double readPosition() const;
    void rebase();
    double positionGoal() const;
    double topSpeed() const;
    double wantedSpeed() const;
    double worn(double topSpeed, double direction) const;
    double drive(double limit);
    double holdGoal(double limit);
    double holdBentGoal(double limit);
    double senseOfSensor() const { return encoder.endless() && settings.reversed ? -1.0 : 1.0; }
    double withinCurrentLimit(double wanted) const;
    void holdHere();

    // servo_feedback.cpp
    void publish();
    double readingNoise() const;
    double sensedCurrent() const; ///< 6.5 mA units
    int shownStatus() const;
    int shownMoving() const;
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

    std::int64_t counted = 0;  ///< encoder steps through all turns
    std::int64_t turnBase = 0; ///< multiple of a turn: position counts from here since power-on
    double position = 0;       ///< steps, in the servo's own coordinate
    double speed = 0;          ///< step/s, smoothed for the loops
    double shownSpeed = 0;     ///< step/s, smoothed for register 58
    double duty = 0;           ///< towards larger positions positive
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

    struct Held {
        int address = 0;
        base::Bytes data;
    };
    std::optional<Held> held; ///< REG WRITE waiting for ACTION
    bool moveStored = false;  ///< LX: 7 waiting for 11
};
} // namespace sim
