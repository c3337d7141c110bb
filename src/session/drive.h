// SPDX-License-Identifier: GPL-3.0-or-later
// Drives the servos that were chosen: goals, torque, modes, the torque limit. Beside Desk, on the
// main thread, never waits. While a goal is on its way to the wire the next one waits here, and a
// newer one takes its place: a drag never queues up. Nothing is sent that was not asked for; what
// is out of the limits is refused with the reason (failed). After an emergency stop everything but
// torque is refused until torque is switched on again; Desk sees to that.
#pragma once

#include "device/mode.h"
#include "device/motion.h"
#include "session/desk.h"

namespace session {
/// As device::MoveOrder, for each of the chosen servos; a field a servo's family or mode has not
/// is not given. Text as typed: "2048", "90deg", "30rpm", "20%".
struct MoveWish {
    QString goal;
    std::optional<QString> speed{};
    std::optional<QString> acceleration{};
    std::optional<QString> time{};    ///< ms
    std::optional<QString> current{}; ///< HLS: the current limit of a move
    device::MoveHow how = device::MoveHow::Write;
};

class Drive final : public QObject {
    Q_OBJECT

public:
    explicit Drive(Desk& desk, QObject* parent = nullptr);

    /// The first is the one whose limits and mode the page shows. Forgets a goal that waits here.
    void setServos(const std::vector<ServoRef>& servos);
    const std::vector<ServoRef>& servos() const { return m_servos; }

    /// Several servos go by sync write or by held writes; by plain writes one after the other.
    /// Async only leaves the goals in the servos: execute() starts them.
    void move(const MoveWish& wish);
    /// Step mode: the last step once more.
    void again();
    void execute();
    int held() const; ///< servos with a goal of ours that waits for execute()

    void setTorque(device::Torque torque);
    void halt(); ///< ends the motion, torque stays on
    void switchMode(const QString& mode);
    /// What switchMode would do, worked out from reads only; modePlanned follows, or failed.
    void planMode(const QString& mode);
    void setTorqueLimit(std::int64_t raw); ///< the RAM register (48; SCS 16)

    bool busy() const; ///< something is on its way

Q_SIGNALS:
    void changed(); ///< servos, held(), busy()
    void sent();    ///< a goal has arrived
    void modePlanned(const device::ModePlan& plan);
    void failed(const base::Error& error);
    void noted(const device::Notices& notices);

private:
    void sendNext();

    Desk& m_desk;
    std::vector<ServoRef> m_servos;
    std::optional<MoveWish> m_next;
    std::optional<MoveWish> m_last;
    int m_running = 0;
};
} // namespace session
