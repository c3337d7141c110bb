// SPDX-License-Identifier: GPL-3.0-or-later
// The guided tour: shows the functions of the program on a simulated bus, with the jobs of the
// other commands. Every printed value was read over the simulated bus. Main thread. Each chapter is
// one function; an error ends the tour.
#pragma once

#include "cli/run.h"
#include "device/motion/motion.h"
#include "jobs/scan/scan.h"
#include "snapshot/snapshot.h"

namespace cli {
class Tour {
public:
    explicit Tour(Run& run)
        : m_run(run)
    {}

    base::Result<Exit> run();

private:
    base::Result<void> search();
    base::Result<void> chooseServo();
    base::Result<void> showMemory();
    base::Result<void> saveSnapshot();
    base::Result<void> changeSafely();
    base::Result<void> powerCycleServos();
    base::Result<void> restoreValues();
    base::Result<void> move();
    base::Result<void> explainAlarms();
    base::Result<void> showNewServos();
    base::Result<void> summarize();

    base::Result<device::Context> context() { return m_run.context(); }
    base::Result<void> writeAndShow(const QString& key, std::int64_t raw, bool temporary);
    base::Result<void> moveTo(std::int64_t goal);
    base::Result<void> awaitServo();
    void showWire();
    void print(const QString& text);
    void chapter(const QString& title);

    Run& m_run;
    int m_chapter = 0;
    jobs::ScanReport m_found;
    device::Servo m_servo;
    snapshot::Snapshot m_before;
    QString m_snapshotFile;
    std::int64_t m_persistentValue = 0; ///< raw, written permanently
    std::int64_t m_temporaryValue = 0;  ///< raw, written temporarily
    bool m_persistentSurvived = false;
    bool m_temporaryReset = false;
    bool m_duplicatesSuspected = false; ///< among the new servos
    QStringList m_differing;            ///< EPROM keys whose values have changed at the end
    Json::Array m_moves;
};
} // namespace cli
