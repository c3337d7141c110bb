// SPDX-License-Identifier: GPL-3.0-or-later
// Sets up one servo that was confirmed: snapshot, template, ID, baud rate, midpoint and health, in
// this order, and its name in the history. The servo is in the file of the batch before the first
// write, so that it is known wherever it is left. Internal to jobs; the job's thread. An error is
// that of the step in which it ended.
#pragma once

#include "jobs/commission/commission_display.h"
#include "jobs/commission/commission_progress.h"

namespace jobs {
class CommissionSetup {
public:
    CommissionSetup(const device::Context& context, const CommissionSpec& spec,
                    const CommissionCallbacks& callbacks, CommissionProgress& progress,
                    CommissionDisplay& display)
        : m_context(context)
        , m_spec(spec)
        , m_callbacks(callbacks)
        , m_progress(progress)
        , m_display(display)
    {}

    base::Result<void> run(CommissionWork& work, CommissionView& view);
    QString labelOf(const CommissionWork& work) const;
    /// Once more only where the label has changed.
    base::Result<void> saveName(CommissionWork& work, const QString& label) const;

private:
    base::Result<void> begin(CommissionWork& work, CommissionView& view);
    base::Result<void> resume(CommissionWork& work);
    base::Result<void> saveBefore(CommissionWork& work, CommissionView& view);
    base::Result<void> assignId(CommissionWork& work);

    const device::Context& m_context;
    const CommissionSpec& m_spec;
    const CommissionCallbacks& m_callbacks;
    CommissionProgress& m_progress;
    CommissionDisplay& m_display;
};
} // namespace jobs
