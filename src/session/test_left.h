// SPDX-License-Identifier: GPL-3.0-or-later
// What a test has left in its servos: torque it could not prove to be off, a motion it could not
// end, settings it could not put back. While there is any the registers concerned are read
// regularly, and each is forgotten once a reading proves it over, whoever has mended it. Beside
// Desk, which must outlive it; main thread.
#pragma once

#include "jobs/sweep.h"
#include "session/desk.h"

namespace session {
class TestLeft final : public QObject {
    Q_OBJECT

public:
    /// `user`: the name of its wish for readings.
    TestLeft(Desk& desk, const QString& user, QObject* parent = nullptr);

    void forget();
    /// `notices`: those with NoticeCode::SettingNotPutBack count.
    void take(std::vector<jobs::TorqueLeft> torque, const device::Notices& notices);

    const std::vector<jobs::TorqueLeft>& torque() const { return m_torque; }
    const device::Notices& settings() const { return m_settings; }
    bool empty() const { return m_torque.empty() && m_settings.empty(); }

Q_SIGNALS:
    void changed(); ///< something of it is over

private:
    void note(int id);
    void watch();
    void check(ServoRef ref);
    bool concerns(const device::Servo& servo) const;

    Desk& m_desk;
    QString m_user;
    std::vector<jobs::TorqueLeft> m_torque;
    device::Notices m_settings;
    std::map<int, base::ServoIdentity> m_servos; ///< by ID; they may enter the list anew
    base::Duration m_since{};                    ///< desk clock: only what is read later proves
    bool m_watched = false;                      ///< it has a wish
};
} // namespace session
