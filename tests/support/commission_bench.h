// SPDX-License-Identifier: GPL-3.0-or-later
// A commissioning line on simulated time with a hand that plugs servos in and out as the line asks,
// and that may be told to do otherwise. One thread.
#pragma once

#include "jobs/commission.h"
#include "jobs/snapshot.h"
#include "support/sim_bench.h"

#include <QTemporaryDir>

namespace support {
/// A template with these values, from a servo of this model.
inline record::Snapshot templateOf(const char* model,
                                   const std::vector<std::pair<const char*, std::int64_t>>& values)
{
    SimBench other(QString::fromLatin1(model) + QStringLiteral("@1"));
    auto context = other.context();
    device::Servo servo = other.servo(1);
    record::Snapshot snapshot = *jobs::takeSnapshot(context, servo, QStringLiteral("test"));
    std::vector<record::SnapshotRegister> rows;
    for (const auto& value : values) {
        record::SnapshotRegister row = *snapshot.find(QString::fromLatin1(value.first));
        row.raw = value.second;
        rows.push_back(row);
    }
    snapshot.registers = rows;
    snapshot.isTemplate = true;
    return snapshot;
}

class CommissionBench {
public:
    explicit CommissionBench(const QString& servos = QStringLiteral("line"))
        : bench(servos)
    {
        spec.automatic = true;
        for (int id = 11; id < 40; ++id)
            spec.ids.push_back(id);
        bench.withWire([](sim::VirtualBus& wire) {
            if (!wire.isBag())
                wire.makeBag();
        });
    }

    QString csv() const { return folder.filePath(QStringLiteral("batch.csv")); }

    /// Until the bag is empty, the line ends by itself, or `hand` requests a stop.
    base::Result<jobs::CommissionEnd> run()
    {
        auto opened = record::openCommissionBatch(csv());
        if (!opened)
            return tl::unexpected(opened.error());
        batch = *opened;
        jobs::CommissionHooks hooks;
        hooks.onChange = [this](const jobs::CommissionView& view) { changed(view); };
        hooks.onRow = [this](const record::CommissionRow&) {
            // What is told is on the disk already.
            const auto kept = record::openCommissionBatch(csv());
            keptInTime = keptInTime && kept && kept->rows == batch.rows;
        };
        hooks.answer = [this] { return answer ? answer() : jobs::CommissionAnswer::None; };
        hooks.save = [this](const device::Context&, device::Servo& servo) -> base::Result<QString> {
            saved.push_back(servo.id);
            const QString name = QStringLiteral("table-%1").arg(saved.size());
            if (!keepsTables)
                return name;
            const QString file = folder.filePath(name);
            return record::saveSnapshot(jobs::snapshotOf(servo, QStringLiteral("test")), file)
                .map([&] { return file; });
        };
        hooks.name = name;
        return jobs::commission(bench.context(), spec, batch, csv(), hooks);
    }

    /// Another start of the program: only the files and the journal are left of the one before.
    void restart()
    {
        bench.reconnect(1'000'000);
        views.clear();
    }

    void plugNext()
    {
        const auto place = bench.withWire([](sim::VirtualBus& wire) { return wire.plugNext(); });
        if (!place)
            bench.stop().request();
        else
            current = *place;
        pluggedAt = bench.clock().now();
    }
    void unplugAll()
    {
        bench.withWire([](sim::VirtualBus& wire) { wire.unplugAll(); });
    }
    void plug(std::size_t place)
    {
        bench.withWire([place](sim::VirtualBus& wire) { wire.plug(place); });
    }
    sim::VirtualServo& servoAt(std::size_t place)
    {
        return *bench.withWire([place](sim::VirtualBus& wire) { return wire.servos()[place]; });
    }
    bool somebodyPlugged()
    {
        return bench.withWire([](sim::VirtualBus& wire) {
            for (std::size_t place = 0; place < wire.servos().size(); ++place) {
                if (wire.plugged(place))
                    return true;
            }
            return false;
        });
    }
    bool saw(jobs::CommissionStep step) const
    {
        return std::any_of(views.begin(), views.end(),
                           [step](const auto& view) { return view.step == step; });
    }
    bool saw(jobs::CommissionObstacle obstacle) const
    {
        return std::any_of(views.begin(), views.end(),
                           [obstacle](const auto& view) { return view.obstacle == obstacle; });
    }

    SimBench bench;
    QTemporaryDir folder;
    jobs::CommissionSpec spec;
    record::CommissionBatch batch;
    std::vector<jobs::CommissionView> views;
    std::vector<base::Duration> spans; ///< plugged in to "unplug"
    std::vector<int> saved;            ///< IDs of servos whose table was saved
    std::function<jobs::CommissionAnswer()> answer;
    std::function<base::Result<void>(const device::Servo&, const QString&, bool)> name;
    /// True: this view has been dealt with, the usual hand rests.
    std::function<bool(const jobs::CommissionView&)> hand;
    bool keptInTime = true;
    bool keepsTables = false; ///< its tables are files
    std::size_t current = 0;
    base::Duration pluggedAt{};

private:
    void changed(const jobs::CommissionView& view)
    {
        views.push_back(view);
        if (hand && hand(view))
            return;
        if (view.step == jobs::CommissionStep::Waiting && !somebodyPlugged()) {
            plugNext();
        } else if (view.step == jobs::CommissionStep::Unplug) {
            spans.push_back(bench.clock().now() - pluggedAt);
            unplugAll();
        }
    }
};
} // namespace support
