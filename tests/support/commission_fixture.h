// SPDX-License-Identifier: GPL-3.0-or-later
// A commissioning line on simulated time with a hand that plugs servos in and out as the line asks,
// and that can be changed by the test. One thread.
#pragma once

#include "jobs/commission/commission.h"
#include "jobs/restore/take_snapshot.h"
#include "support/sim_fixture.h"

#include <QTemporaryDir>

namespace support {
/// A template with these values, from a servo of this model.
inline snapshot::Snapshot
templateOf(const char* model, const std::vector<std::pair<const char*, std::int64_t>>& values)
{
    SimFixture other(QString::fromLatin1(model) + QStringLiteral("@1"));
    auto context = other.context();
    device::Servo servo = other.servo(1);
    snapshot::Snapshot snapshot = *jobs::takeSnapshot(context, servo, QStringLiteral("test"));
    std::vector<snapshot::SnapshotRegister> rows;
    for (const auto& value : values) {
        snapshot::SnapshotRegister row = *snapshot.find(QString::fromLatin1(value.first));
        row.raw = value.second;
        rows.push_back(row);
    }
    snapshot.registers = rows;
    snapshot.isTemplate = true;
    return snapshot;
}

class CommissionFixture {
public:
    explicit CommissionFixture(const QString& servos = QStringLiteral("line"))
        : fixture(servos)
    {
        spec.automatic = true;
        for (int id = 11; id < 40; ++id)
            spec.ids.push_back(id);
        fixture.withBus([](sim::VirtualBus& wire) {
            if (!wire.hasHotplugQueue())
                wire.makeHotplugQueue();
        });
    }

    QString csv() const { return folder.filePath(QStringLiteral("batch.csv")); }

    /// Until the bag is empty, the line ends by itself, or `hand` requests a stop.
    base::Result<jobs::CommissionEnd> run()
    {
        auto opened = results::openCommissionBatch(csv());
        if (!opened)
            return tl::unexpected(opened.error());
        batch = *opened;
        jobs::CommissionCallbacks callbacks;
        callbacks.onChange = [this](const jobs::CommissionView& view) { changed(view); };
        callbacks.onRow = [this](const results::CommissionRow&) {
            // A reported step is on the disk already.
            const auto kept = results::openCommissionBatch(csv());
            savedInTime = savedInTime && kept && kept->rows == batch.rows;
        };
        callbacks.answer = [this] { return answer ? answer() : jobs::CommissionAnswer::None; };
        callbacks.save = [this](const device::Context&,
                                device::Servo& servo) -> base::Result<QString> {
            saved.push_back(servo.id);
            const QString name = QStringLiteral("table-%1").arg(saved.size());
            if (!savesSnapshotFiles)
                return name;
            const QString file = folder.filePath(name);
            return snapshot::saveSnapshot(jobs::snapshotOf(servo, QStringLiteral("test")), file)
                .map([&] { return file; });
        };
        callbacks.name = name;
        return jobs::commission(fixture.context(), spec, batch, csv(), callbacks);
    }

    /// Another start of the program: only the files and the journal are left of the one before.
    void restart()
    {
        fixture.reconnect(1'000'000);
        views.clear();
    }

    void connectNext()
    {
        const auto place =
            fixture.withBus([](sim::VirtualBus& wire) { return wire.connectNext(); });
        if (!place)
            fixture.stop().request();
        else
            current = *place;
        pluggedAt = fixture.clock().now();
    }
    void unplugAll()
    {
        fixture.withBus([](sim::VirtualBus& wire) { wire.unplugAll(); });
    }
    void plug(std::size_t place)
    {
        fixture.withBus([place](sim::VirtualBus& wire) { wire.plug(place); });
    }
    sim::VirtualServo& servoAt(std::size_t place)
    {
        return *fixture.withBus([place](sim::VirtualBus& wire) { return wire.servos()[place]; });
    }
    bool isAnyPlugged()
    {
        return fixture.withBus([](sim::VirtualBus& wire) {
            for (std::size_t place = 0; place < wire.servos().size(); ++place) {
                if (wire.isPlugged(place))
                    return true;
            }
            return false;
        });
    }
    bool hasSeen(jobs::CommissionStep step) const
    {
        return std::any_of(views.begin(), views.end(),
                           [step](const auto& view) { return view.step == step; });
    }
    bool hasSeen(jobs::CommissionObstacle obstacle) const
    {
        return std::any_of(views.begin(), views.end(),
                           [obstacle](const auto& view) { return view.obstacle == obstacle; });
    }

    SimFixture fixture;
    QTemporaryDir folder;
    jobs::CommissionSpec spec;
    results::CommissionBatch batch;
    std::vector<jobs::CommissionView> views;
    std::vector<base::Duration> spans; ///< plugged in to "unplug"
    std::vector<int> saved;            ///< IDs of servos whose table was saved
    std::function<jobs::CommissionAnswer()> answer;
    std::function<base::Result<void>(const device::Servo&, const QString&, bool)> name;
    /// True: this view has been dealt with, the usual hand rests.
    std::function<bool(const jobs::CommissionView&)> onView;
    bool savedInTime = true;
    bool savesSnapshotFiles = false; ///< its tables are files
    std::size_t current = 0;
    base::Duration pluggedAt{};

private:
    void changed(const jobs::CommissionView& view)
    {
        views.push_back(view);
        if (onView && onView(view))
            return;
        if (view.step == jobs::CommissionStep::Waiting && !isAnyPlugged()) {
            connectNext();
        } else if (view.step == jobs::CommissionStep::Unplug) {
            spans.push_back(fixture.clock().now() - pluggedAt);
            unplugAll();
        }
    }
};
} // namespace support
