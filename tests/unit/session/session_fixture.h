// SPDX-License-Identifier: GPL-3.0-or-later
// The bench behind the window on a simulated bus, for tests of the workbench. Main thread.
#pragma once

#include "session/workbench.h"
#include "sim/host/sim_link.h"
#include "support/temporary_data_folder.h"
#include "support/waiting.h"

#include <QtTest>

using session::LinkState;
using session::ServoRef;
using session::Workbench;

inline const QString position = QStringLiteral("present_position");

struct SessionFixture {
    explicit SessionFixture(const QString& port = QStringLiteral("sim:demo"))
        : opened(open(port))
    {}

    bool open(const QString& port)
    {
        workbench.link().connectTo({.name = port});
        return support::waitFor([this] { return workbench.link().state() == LinkState::Open; });
    }
    /// The port: it is lost and closed.
    bool lose()
    {
        withBus([](sim::VirtualBus& bus) { bus.cutLink(); });
        return support::waitFor([this] {
            return workbench.link().state() == LinkState::Lost &&
                   workbench.link().connection() == nullptr;
        });
    }
    /// The few IDs in use, unless told otherwise.
    bool search(const jobs::ScanSpec& spec = {.firstId = 0, .lastId = 10, .bauds = {}})
    {
        workbench.search().start(spec);
        return support::waitFor([this] { return !workbench.search().isSearching(); });
    }
    ServoRef at(int id, base::Protocol protocol = base::Protocol::Feetech) const
    {
        return workbench.registry().findServo(protocol, id);
    }
    const session::ServoEntry& entry(ServoRef ref) const
    {
        return *workbench.registry().servo(ref);
    }
    QByteArray troubles() const
    {
        QByteArray all;
        for (const ServoRef ref : workbench.registry().order()) {
            for (const auto& [key, row] : entry(ref).writes) {
                if (row.error)
                    all += key.toUtf8() + ": " + base::errorName(row.error->code).toUtf8() + " " +
                           row.error->detail.toUtf8() + "; ";
            }
        }
        return all;
    }
    bool waitUntilIdle()
    {
        return support::waitFor([this] { return !workbench.tasks().isBusy(); });
    }
    bool write(ServoRef ref, const QString& key, std::int64_t raw, bool temporary = false)
    {
        workbench.writes().write(ref, {{{key, raw}}, temporary, device::Consent::confirmed()});
        return waitUntilIdle();
    }
    std::optional<std::int64_t> raw(ServoRef ref, const QString& key) const
    {
        return entry(ref).servo.raw(key);
    }
    std::optional<device::WriteOutcome> outcome(ServoRef ref, const QString& key) const
    {
        const auto& writes = entry(ref).writes;
        return writes.count(key) > 0 ? writes.at(key).outcome : std::nullopt;
    }
    template <typename Function>
    void withBus(Function&& function)
    {
        workbench.link().connection()->simulation()->with(std::forward<Function>(function));
    }

    support::TemporaryDataFolder dataFolder; ///< before the session
    session::Session session;
    Workbench workbench{session};
    bool opened;
};

inline const QString minAngle = QStringLiteral("min_angle_limit");
inline const QString positionP = QStringLiteral("position_p");
inline const QString user = QStringLiteral("test");
