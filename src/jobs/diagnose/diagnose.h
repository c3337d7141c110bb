// SPDX-License-Identifier: GPL-3.0-or-later
// Why does a servo not reply? Probes an open bus: what comes without being asked for, the servos at
// this rate and at the others, how many replies are lost or damaged, how late they are, two servos
// with one ID, response level 0. Only reads and PINGs. The bus ends at the rate it had. Job thread.
// Errors: LinkLost, Preempted, Held; RateUnsupported when the old rate cannot be set again.
// Source: fault table of the data sheets.
#pragma once

#include "base/diagnosis.h"
#include "jobs/scan/scan.h"

namespace jobs {
struct DiagnosisSpec {
    std::vector<int> bauds;                  ///< tried if nothing is found at the present one, or
                                             ///< if something comes there
    std::vector<base::Protocol> protocols{}; ///< the ones selected; empty: all
    QString adapter{};                       ///< what the system knows about it
    QString otherPrograms{};                 ///< that have the port open too
    std::optional<int> latencyTimer{};       ///< of the adapter, in milliseconds
};

struct DiagnosisReport {
    base::Diagnosis diagnosis;
    std::vector<FoundServo> found;
};

/// `onEvidence` gets each piece as soon as it is known.
base::Result<DiagnosisReport>
diagnose(const device::Context& context, const DiagnosisSpec& spec, const ProgressFn& progress = {},
         const std::function<void(const base::Evidence&)>& onEvidence = {});

/// Of a port that could not be opened.
base::Cause causeOf(const base::Error& error);
} // namespace jobs
